//! `elastomericBearingBoucWen` in the plane.

use super::bouc_wen::{self, ShearParameters};
use super::link::Link;
use crate::element::{Answer, Element, ElementError, Mass, Motion, Nature, Snapshot, frame_force_labels};
use crate::material::{Slot, Strain};
use crate::probe::Probe;
use crate::words::Words;

/// Bouc-Wen bearing in the plane: shear by [`ShearParameters`], axial force and moment by uniaxial materials.
#[derive(Clone, Debug)]
pub struct BoucWen2d {
    shear: ShearParameters,
    link: Link<6, 3>,
    /// Axial and rotational material.
    materials: [Slot; 2],
    mass: f64,
    rayleigh: bool,
    state_len: usize,
}

crate::words! {
    /// Shear history, and what recorders read.
    struct Shear {
        u: f64,
        z: f64,
        q: f64,
        k: f64,
    }
}

impl BoucWen2d {
    /// From the law, the kinematics, and the materials (with their tags) for axial force and moment.
    pub fn new(
        shear: ShearParameters,
        link: Link<6, 3>,
        materials: [(crate::material::Material, i32); 2],
        mass: f64,
        rayleigh: bool,
    ) -> Self {
        let [p, m] = materials;
        let axial = Slot::new(p.0, p.1, Shear::LEN);
        let moment = Slot::new(m.0, m.1, Shear::LEN + axial.len());
        let state_len = Shear::LEN + axial.len() + moment.len();
        Self { shear, link, materials: [axial, moment], mass, rayleigh, state_len }
    }

    /// Shear force, consistent stiffness and hysteretic parameter at displacement `u`.
    fn shear(&self, c: &Shear, u: f64) -> Result<Shear, ElementError> {
        let p = &self.shear;
        let (hardening, k_hardening) = p.hardening(u);
        let d = (u - c.u) * p.k0 / p.qd;
        if d == 0.0 {
            // At rest the step may go on either way: the tangent of continued loading, as at the end of the last step.
            return Ok(Shear { u, z: c.z, q: p.qd * c.z + hardening, k: c.k });
        }
        let ([z], [[dz]]) = p.hysteresis([c.z], [d])?;
        Ok(Shear { u, z, q: p.qd * z + hardening, k: p.k0 * dz + k_hardening })
    }

    fn initial_stiffness(&self) -> [[f64; 3]; 3] {
        let [axial, moment] = &self.materials;
        let mut k = [[0.0; 3]; 3];
        k[0][0] = axial.material.initial_tangent();
        k[1][1] = self.shear.k0 + self.shear.k2;
        k[2][2] = moment.material.initial_tangent();
        k
    }
}

impl Element for BoucWen2d {
    fn class(&self) -> &'static str {
        "ElastomericBearingBoucWen2d"
    }
    fn dofs(&self) -> usize {
        6
    }
    fn state_len(&self) -> usize {
        self.state_len
    }
    fn init(&self, state: &mut [f64]) {
        Shear { k: self.shear.k0 + self.shear.k2, ..Shear::default() }.write(state);
        self.materials.iter().for_each(|m| m.init(state));
    }
    fn nature(&self) -> Nature {
        Nature {
            linear: false,
            symmetric: false,
            viscous: self.materials.iter().any(|m| m.material.is_viscous()),
            elapses: self.materials.iter().any(|m| m.material.depends_on_time()),
            rayleigh: self.rayleigh,
        }
    }

    fn respond(
        &self,
        motion: &Motion<'_>,
        committed: &[f64],
        trial: &mut [f64],
        answer: Answer<'_>,
    ) -> Result<(), ElementError> {
        let u = self.link.deformation(motion.disp);
        let rate = self.link.deformation(motion.vel);
        let strain = |i: usize| Strain { value: u[i], rate: rate[i], dt: motion.dt };
        let axial = self.materials[0].update(committed, strain(0), trial)?;
        let shear = self.shear(&Shear::read(committed), u[1])?;
        shear.write(trial);
        let moment = self.materials[1].update(committed, strain(2), trial)?;
        let q = [axial.value, shear.q, moment.value];
        self.link.add_force(&q, motion.disp, answer.force);
        if let Some(tangent) = answer.tangent {
            let k = [[axial.tangent, 0.0, 0.0], [0.0, shear.k, 0.0], [0.0, 0.0, moment.tangent]];
            self.link.add_tangent(&k, &q, motion.disp, tangent);
        }
        if let Some(damping) = answer.damping {
            let c = [[axial.damping, 0.0, 0.0], [0.0; 3], [0.0, 0.0, moment.damping]];
            self.link.add_basic(&c, damping);
        }
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        self.link.add_basic(&self.initial_stiffness(), tangent);
    }

    fn mass(&self) -> Mass {
        bouc_wen::end_masses(self.mass, 3, 2)
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        if let ["material", n, rest @ ..] = words {
            let i = n.parse::<usize>().ok().filter(|i| (1..=2).contains(i))? - 1;
            return Some(self.materials[i].probe(rest)?.inside(&[bouc_wen::MATERIAL, i as u32]));
        }
        bouc_wen::probe(words, 1)
    }

    fn probe_names(&self) -> &'static [&'static str] {
        bouc_wen::PROBES
    }

    fn force_labels(&self) -> Vec<String> {
        frame_force_labels(self.dofs())
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        let shear = Shear::read(s.state);
        match path[0] {
            bouc_wen::LOCAL_FORCE => self.link.local_force(s.force, out),
            bouc_wen::LOCAL_DISP => self.link.local_force(s.disp, out),
            bouc_wen::DEFORMATION => out.copy_from_slice(&self.link.deformation(s.disp)),
            bouc_wen::BASIC_FORCE => {
                out.copy_from_slice(&[self.materials[0].stress(s.state), shear.q, self.materials[1].stress(s.state)]);
            }
            bouc_wen::HYSTERETIC => out[0] = shear.z,
            bouc_wen::BASIC_STIFFNESS => out[0] = shear.k,
            _ => self.materials[path[1] as usize].read(&path[2..], s.state, out),
        }
    }
}

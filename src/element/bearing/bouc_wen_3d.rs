//! `elastomericBearingBoucWen` in space, with coupled shear.

use super::bouc_wen::{self, ShearParameters};
use super::link::Link;
use crate::element::{Answer, Element, ElementError, Mass, Motion, Nature, Snapshot, frame_force_labels};
use crate::material::{Material, Slot, Strain};
use crate::probe::Probe;
use crate::words::Words;

/// Bouc-Wen bearing in space: coupled shear by [`ShearParameters`]; axial force, torsion and two moments by uniaxial
/// materials.
#[derive(Clone, Debug)]
pub struct BoucWen3d {
    shear: ShearParameters,
    link: Link<12, 6>,
    /// Axial, torsion, rotation about y, rotation about z.
    materials: [Slot; 4],
    mass: f64,
    rayleigh: bool,
    state_len: usize,
}

crate::words! {
    /// Shear history, and what recorders read.
    struct Shear {
        u: [f64; 2],
        z: [f64; 2],
        q: [f64; 2],
        k: [f64; 4],
    }
}

/// The basic directions of the four materials.
const DIRECTIONS: [usize; 4] = [0, 3, 4, 5];

impl BoucWen3d {
    /// From the law, the kinematics, and the materials (with their tags) for axial force, torsion and the moments
    /// about y and z.
    pub fn new(
        shear: ShearParameters,
        link: Link<12, 6>,
        materials: [(Material, i32); 4],
        mass: f64,
        rayleigh: bool,
    ) -> Self {
        let mut state_len = Shear::LEN;
        let materials = materials.map(|(m, tag)| {
            let slot = Slot::new(m, tag, state_len);
            state_len += slot.len();
            slot
        });
        Self { shear, link, materials, mass, rayleigh, state_len }
    }

    /// Shear forces, consistent stiffness and hysteretic parameters at displacement `u`.
    fn shear(&self, c: &Shear, u: [f64; 2]) -> Result<Shear, ElementError> {
        let p = &self.shear;
        let (h0, k0) = p.hardening(u[0]);
        let (h1, k1) = p.hardening(u[1]);
        let scale = p.k0 / p.qd;
        let d = [(u[0] - c.u[0]) * scale, (u[1] - c.u[1]) * scale];
        if d == [0.0; 2] {
            // At rest: the tangent of the end of the last step.
            return Ok(Shear { u, q: [p.qd * c.z[0] + h0, p.qd * c.z[1] + h1], ..*c });
        }
        let (z, [row0, row1]) = p.hysteresis(c.z, d)?;
        Ok(Shear {
            u,
            z,
            q: [p.qd * z[0] + h0, p.qd * z[1] + h1],
            k: [p.k0 * row0[0] + k0, p.k0 * row0[1], p.k0 * row1[0], p.k0 * row1[1] + k1],
        })
    }

    fn initial_stiffness(&self) -> [[f64; 6]; 6] {
        let mut k = [[0.0; 6]; 6];
        for (slot, &i) in self.materials.iter().zip(&DIRECTIONS) {
            k[i][i] = slot.material.initial_tangent();
        }
        k[1][1] = self.shear.k0 + self.shear.k2;
        k[2][2] = k[1][1];
        k
    }
}

impl Element for BoucWen3d {
    fn class(&self) -> &'static str {
        "ElastomericBearingBoucWen3d"
    }
    fn dofs(&self) -> usize {
        12
    }
    fn state_len(&self) -> usize {
        self.state_len
    }
    fn init(&self, state: &mut [f64]) {
        let k = self.shear.k0 + self.shear.k2;
        Shear { k: [k, 0.0, 0.0, k], ..Shear::default() }.write(state);
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
        let mut q = [0.0; 6];
        let mut k = [[0.0; 6]; 6];
        let mut c = [[0.0; 6]; 6];
        for (slot, &i) in self.materials.iter().zip(&DIRECTIONS) {
            let s = slot.update(committed, Strain { value: u[i], rate: rate[i], dt: motion.dt }, trial)?;
            q[i] = s.value;
            k[i][i] = s.tangent;
            c[i][i] = s.damping;
        }
        let shear = self.shear(&Shear::read(committed), [u[1], u[2]])?;
        shear.write(trial);
        [q[1], q[2]] = shear.q;
        [k[1][1], k[1][2], k[2][1], k[2][2]] = shear.k;
        self.link.add_force(&q, motion.disp, answer.force);
        if let Some(tangent) = answer.tangent {
            self.link.add_tangent(&k, &q, motion.disp, tangent);
        }
        if let Some(damping) = answer.damping {
            self.link.add_basic(&c, damping);
        }
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        self.link.add_basic(&self.initial_stiffness(), tangent);
    }

    fn mass(&self) -> Mass {
        bouc_wen::end_masses(self.mass, 6, 3)
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        if let ["material", n, rest @ ..] = words {
            let i = n.parse::<usize>().ok().filter(|i| (1..=4).contains(i))? - 1;
            return Some(self.materials[i].probe(rest)?.inside(&[bouc_wen::MATERIAL, i as u32]));
        }
        bouc_wen::probe(words, 2)
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
                for (slot, &i) in self.materials.iter().zip(&DIRECTIONS) {
                    out[i] = slot.stress(s.state);
                }
                out[1..3].copy_from_slice(&shear.q);
            }
            bouc_wen::HYSTERETIC => out.copy_from_slice(&shear.z),
            bouc_wen::BASIC_STIFFNESS => out.copy_from_slice(&shear.k),
            _ => self.materials[path[1] as usize].read(&path[2..], s.state, out),
        }
    }
}

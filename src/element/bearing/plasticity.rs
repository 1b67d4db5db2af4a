//! `elastomericBearingPlasticity` in the plane and in space.

use super::bouc_wen;
use super::link::Link;
use crate::element::{Answer, Element, ElementError, Mass, Motion, Nature, Snapshot, frame_force_labels};
use crate::material::{Material, Slot, Strain};
use crate::probe::Probe;
use crate::words::Words;

/// Shear law: an elastic, perfectly plastic part with a circular yield surface of radius q_d and stiffness k₀, beside
/// the hardening springs k₂ u + k₃ sign(u) |u|^μ of each direction; solved by return mapping, which is exact (Simo and
/// Hughes, 1998, section 3.3).
#[derive(Clone, Debug, PartialEq)]
pub struct PlasticShear {
    /// Elastic stiffness of the hysteretic part k₀ = (1-α₁) k_init.
    pub k0: f64,
    /// Characteristic strength q_d.
    pub qd: f64,
    /// Stiffness of the linear hardening k₂ = α₁ k_init.
    pub k2: f64,
    /// Stiffness of the nonlinear hardening k₃ = α₂ k_init.
    pub k3: f64,
    /// Exponent of the nonlinear hardening μ.
    pub mu: f64,
}

crate::words! {
    /// Shear history (plastic displacement), and what recorders read.
    struct Shear {
        plastic: [f64; 2],
        q: [f64; 2],
        k: [f64; 4],
    }
}

impl PlasticShear {
    fn hardening(&self, u: f64) -> (f64, f64) {
        if self.k3 == 0.0 {
            return (self.k2 * u, self.k2);
        }
        let p = u.abs().powf(self.mu - 1.0);
        (self.k2 * u + self.k3 * p * u, self.k2 + self.k3 * self.mu * p)
    }

    /// State at displacement `u`; in the plane the second direction is at rest.
    fn step(&self, c: &Shear, u: [f64; 2]) -> Shear {
        let ((h0, k0), (h1, k1)) = (self.hardening(u[0]), self.hardening(u[1]));
        let trial = [self.k0 * (u[0] - c.plastic[0]), self.k0 * (u[1] - c.plastic[1])];
        let size = trial[0].hypot(trial[1]);
        if size <= self.qd {
            return Shear {
                plastic: c.plastic,
                q: [trial[0] + h0, trial[1] + h1],
                k: [self.k0 + k0, 0.0, 0.0, self.k0 + k1],
            };
        }
        let n = [trial[0] / size, trial[1] / size];
        let slip = (size - self.qd) / self.k0;
        // On the yield surface only the part across the force is stiff.
        let k = self.k0 * self.qd / size;
        Shear {
            plastic: [c.plastic[0] + slip * n[0], c.plastic[1] + slip * n[1]],
            q: [self.qd * n[0] + h0, self.qd * n[1] + h1],
            k: [k * n[1] * n[1] + k0, -k * n[0] * n[1], -k * n[0] * n[1], k * n[0] * n[0] + k1],
        }
    }

    fn virgin(&self) -> Shear {
        self.step(&Shear::default(), [0.0; 2])
    }
}

/// Bearing with plastic shear and `M` uniaxial materials for the other basic directions: axial force and moment in the
/// plane (`N` = 6, `B` = 3, `M` = 2); axial force, torsion and the moments about y and z in space (12, 6, 4).
#[derive(Clone, Debug)]
pub struct PlasticBearing<const N: usize, const B: usize, const M: usize> {
    shear: PlasticShear,
    link: Link<N, B>,
    materials: [Slot; M],
    mass: f64,
    rayleigh: bool,
    state_len: usize,
}

/// In the plane.
pub type Plasticity2d = PlasticBearing<6, 3, 2>;
/// In space.
pub type Plasticity3d = PlasticBearing<12, 6, 4>;

impl<const N: usize, const B: usize, const M: usize> PlasticBearing<N, B, M> {
    /// Number of directions of shear.
    const SHEARS: usize = B - M;

    /// From the law, the kinematics, and the materials (with their tags) in the order of the basic directions.
    pub fn new(
        shear: PlasticShear,
        link: Link<N, B>,
        materials: [(Material, i32); M],
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

    /// Materials with their basic directions.
    fn springs(&self) -> impl Iterator<Item = (usize, &Slot)> {
        self.materials.iter().enumerate().map(|(i, m)| (if i == 0 { 0 } else { i + Self::SHEARS }, m))
    }

    fn add_shear(s: &Shear, q: &mut [f64; B], k: &mut [[f64; B]; B]) {
        for i in 0..Self::SHEARS {
            q[1 + i] = s.q[i];
            for j in 0..Self::SHEARS {
                k[1 + i][1 + j] = s.k[2 * i + j];
            }
        }
    }
}

impl<const N: usize, const B: usize, const M: usize> Element for PlasticBearing<N, B, M> {
    fn class(&self) -> &'static str {
        if N == 6 { "ElastomericBearingPlasticity2d" } else { "ElastomericBearingPlasticity3d" }
    }
    fn dofs(&self) -> usize {
        N
    }
    fn state_len(&self) -> usize {
        self.state_len
    }
    fn init(&self, state: &mut [f64]) {
        self.shear.virgin().write(state);
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
        let (mut q, mut k, mut c) = ([0.0; B], [[0.0; B]; B], [[0.0; B]; B]);
        for (i, slot) in self.springs() {
            let s = slot.update(committed, Strain { value: u[i], rate: rate[i], dt: motion.dt }, trial)?;
            (q[i], k[i][i], c[i][i]) = (s.value, s.tangent, s.damping);
        }
        let across = [u[1], if Self::SHEARS == 2 { u[2] } else { 0.0 }];
        let shear = self.shear.step(&Shear::read(committed), across);
        shear.write(trial);
        Self::add_shear(&shear, &mut q, &mut k);
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
        let (mut q, mut k) = ([0.0; B], [[0.0; B]; B]);
        for (i, slot) in self.springs() {
            k[i][i] = slot.material.initial_tangent();
        }
        Self::add_shear(&self.shear.virgin(), &mut q, &mut k);
        self.link.add_basic(&k, tangent);
    }

    fn mass(&self) -> Mass {
        bouc_wen::end_masses(self.mass, N / 2, if N == 6 { 2 } else { 3 })
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        if let ["material", n, rest @ ..] = words {
            let i = n.parse::<usize>().ok().filter(|i| (1..=M).contains(i))? - 1;
            return Some(self.materials[i].probe(rest)?.inside(&[bouc_wen::MATERIAL, i as u32]));
        }
        bouc_wen::probe(words, Self::SHEARS).filter(|_| !words[0].starts_with(['h', 'z']))
    }

    fn probe_names(&self) -> &'static [&'static str] {
        &[
            "localForce",
            "basicForce",
            "localDisplacement",
            "deformation",
            "basicDeformation",
            "basicStiffness",
            "material",
        ]
    }

    fn force_labels(&self) -> Vec<String> {
        frame_force_labels(N)
    }

    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        let shear = Shear::read(s.state);
        match path[0] {
            bouc_wen::LOCAL_FORCE => self.link.local_force(s.force, out),
            bouc_wen::LOCAL_DISP => self.link.local_force(s.disp, out),
            bouc_wen::DEFORMATION => out.copy_from_slice(&self.link.deformation(s.disp)),
            bouc_wen::BASIC_FORCE => {
                self.springs().for_each(|(i, slot)| out[i] = slot.stress(s.state));
                out[1..=Self::SHEARS].copy_from_slice(&shear.q[..Self::SHEARS]);
            }
            bouc_wen::BASIC_STIFFNESS => out.copy_from_slice(&shear.k[..Self::SHEARS * Self::SHEARS]),
            _ => self.materials[path[1] as usize].read(&path[2..], s.state, out),
        }
    }
}

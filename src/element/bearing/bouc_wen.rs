//! What the Bouc-Wen bearings in the plane and in space share: parameters, the hysteretic law, responses.

use crate::element::{ElementError, Mass};
use crate::probe::Probe;

/// Shear law of `elastomericBearingBoucWen`: q = q_d z + k₂ u + k₃ sign(u) |u|^μ, with
/// ż = (k₀/q_d) [A u̇ - z |z|^(η-2) (z·u̇) (γ + β sign(z·u̇))], A = 1.
///
/// Casciati (1989) and Nagarajaiah, Reinhorn and Constantinou (1991), as in OpenSees; backward Euler over a step.
#[derive(Clone, Debug, PartialEq)]
pub struct ShearParameters {
    /// Elastic stiffness of the hysteretic part k₀ = (1-α₁) k_init.
    pub k0: f64,
    /// Characteristic strength q_d.
    pub qd: f64,
    /// Post-yield stiffness of the linear hardening part k₂ = α₁ k_init.
    pub k2: f64,
    /// Post-yield stiffness of the nonlinear hardening part k₃ = α₂ k_init.
    pub k3: f64,
    /// Exponent of the nonlinear hardening μ.
    pub mu: f64,
    /// Yielding exponent η.
    pub eta: f64,
    /// First loop shape parameter β.
    pub beta: f64,
    /// Second loop shape parameter γ.
    pub gamma: f64,
    /// Newton steps allowed for z.
    pub max_iterations: u32,
    /// Tolerance on z.
    pub tolerance: f64,
}

impl ShearParameters {
    /// Force of the hardening springs and its derivative.
    #[inline]
    pub(super) fn hardening(&self, u: f64) -> (f64, f64) {
        if self.k3 == 0.0 {
            return (self.k2 * u, self.k2);
        }
        let p = u.abs().powf(self.mu - 1.0);
        (self.k2 * u + self.k3 * p * u, self.k2 + self.k3 * self.mu * p)
    }

    /// The shape factor γ + β sign(z·Δu).
    #[inline]
    pub(super) fn shape(&self, work: f64) -> f64 {
        if work > 0.0 {
            self.gamma + self.beta
        } else if work < 0.0 {
            self.gamma - self.beta
        } else {
            self.gamma
        }
    }

    /// |z|^(η-2), without the cost of `powf` for the usual exponent; |z| is kept off zero for η < 2.
    #[inline]
    pub(super) fn power(&self, norm: f64) -> f64 {
        if self.eta == 2.0 { 1.0 } else { norm.max(f64::EPSILON).powf(self.eta - 2.0) }
    }

    pub(super) fn no_root(&self) -> ElementError {
        ElementError(format!(
            "found no hysteretic parameter z within {} iterations (option -iter)",
            self.max_iterations
        ))
    }
}

/// Half of the mass at each end, translations only.
pub(super) fn end_masses(mass: f64, per_node: usize, translations: usize) -> Mass {
    if mass == 0.0 {
        return Mass::None;
    }
    let mut m = vec![0.0; 2 * per_node];
    for node in 0..2 {
        m[node * per_node..node * per_node + translations].fill(0.5 * mass);
    }
    Mass::Lumped(m)
}

pub(super) const LOCAL_FORCE: u32 = 2;
pub(super) const BASIC_FORCE: u32 = 3;
pub(super) const LOCAL_DISP: u32 = 4;
pub(super) const DEFORMATION: u32 = 5;
pub(super) const HYSTERETIC: u32 = 6;
pub(super) const BASIC_STIFFNESS: u32 = 8;
pub(super) const MATERIAL: u32 = 9;

pub(super) const PROBES: &[&str] = &[
    "localForce",
    "basicForce",
    "localDisplacement",
    "deformation",
    "basicDeformation",
    "hystereticParameter",
    "basicStiffness",
    "material",
];

/// The responses by name; `shears` is 1 in the plane and 2 in space.
pub(super) fn probe(words: &[&str], shears: usize) -> Option<Probe> {
    let plane = shears == 1;
    let basic = if plane { 3 } else { 6 };
    let numbered = |stem: &str, n: usize| (1..=n).map(|i| format!("{stem}{i}")).collect::<Vec<_>>();
    let ends = |names: &[&str]| (1..=2).flat_map(|e| names.iter().map(move |n| format!("{n}_{e}"))).collect::<Vec<_>>();
    Some(match *words.first()? {
        "localForce" | "localForces" => {
            Probe::new(LOCAL_FORCE, ends(if plane { &["N", "V", "M"] } else { &["N", "Vy", "Vz", "T", "My", "Mz"] }))
        }
        "basicForce" | "basicForces" => Probe::new(BASIC_FORCE, numbered("qb", basic)),
        "localDisplacement" | "localDisplacements" => Probe::new(
            LOCAL_DISP,
            ends(if plane { &["ux", "uy", "rz"] } else { &["ux", "uy", "uz", "rx", "ry", "rz"] }),
        ),
        "deformation" | "deformations" | "basicDeformation" | "basicDeformations" | "basicDisplacement"
        | "basicDisplacements" => Probe::new(DEFORMATION, numbered("ub", basic)),
        "hystereticParameter" | "hystParameter" | "hystereticParam" | "hystParam" | "z" => {
            Probe::new(HYSTERETIC, if plane { vec!["z".to_owned()] } else { numbered("z", 2) })
        }
        "kb" | "basicStiff" | "basicStiffness" => {
            Probe::new(BASIC_STIFFNESS, if plane { vec!["kb22"] } else { vec!["kb22", "kb23", "kb32", "kb33"] })
        }
        _ => return None,
    })
}

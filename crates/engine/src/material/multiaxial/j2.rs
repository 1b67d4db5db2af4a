//! Plasticity of von Mises with isotropic hardening: `J2Plasticity`.

use super::plain_methods::plain_methods;
use super::simplified_j2::{deviator, isotropic_stiffness, norm};
use super::{Multiaxial, SOLID, Tangent};
use crate::material::{MaterialError, MaterialResult, MultiaxialResult};
use crate::state_struct;
use crate::state_struct::StateStruct;

/// Plasticity of von Mises with the yield stress q(ξ) = σ∞ + (σ0 - σ∞) e^(-δ ξ) + H ξ and a linear viscosity (Simo and
/// Hughes, 1998, Computational Inelasticity, box 3.2).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct J2Plasticity {
    /// Bulk modulus, stress.
    pub bulk: f64,
    /// Shear modulus, stress.
    pub shear: f64,
    /// First yield stress σ0.
    pub yield_stress: f64,
    /// Saturated yield stress σ∞.
    pub saturated: f64,
    /// Rate of saturation δ.
    pub delta: f64,
    /// Linear hardening modulus H, stress.
    pub hardening: f64,
    /// Viscosity η, stress times time; 0 for none.
    pub viscosity: f64,
    /// Mass per volume.
    pub rho: f64,
}

state_struct! {
    /// History of a point.
    pub(super) struct J2State {
        /// Plastic strains as components of a tensor.
        plastic: [f64; SOLID],
        /// Equivalent plastic strain ξ.
        equivalent: f64,
    }
}

/// Largest number of Newton's iterations for the plastic multiplier.
const MAX_ITERATIONS: usize = 25;
/// Share of the yield stress below which a stress counts as zero.
const TOLERANCE: f64 = 1e-8;
/// Share of the plastic multiplier that is taken. It keeps the stress a little outside of the yield surface, as in
/// OpenSees.
const RETURNED: f64 = 1.0 - 1e-8;

impl J2Plasticity {
    fn yield_at(&self, xi: f64) -> f64 {
        self.saturated + (self.yield_stress - self.saturated) * (-self.delta * xi).exp() + self.hardening * xi
    }
    fn slope_at(&self, xi: f64) -> f64 {
        -self.delta * (self.yield_stress - self.saturated) * (-self.delta * xi).exp() + self.hardening
    }

    /// Plastic multiplier for the norm of the trial stress.
    fn multiplier(&self, norm: f64, xi: f64, viscous: f64) -> MaterialResult<f64> {
        let root = (2.0f64 / 3.0).sqrt();
        let mut gamma = 0.0;
        for _ in 0..MAX_ITERATIONS {
            let at = xi + root * gamma;
            let residual = norm - 2.0 * self.shear * gamma - root * self.yield_at(at) - viscous * gamma;
            let slope = -2.0 * self.shear - 2.0 / 3.0 * self.slope_at(at) - viscous;
            gamma -= residual / slope;
            if residual.abs() <= TOLERANCE * self.yield_stress {
                return Ok(gamma * RETURNED);
            }
        }
        Err(MaterialError(format!("J2Plasticity has no yield stress after {MAX_ITERATIONS} iterations")))
    }
}

crate::watches_columns!(J2Plasticity => nothing);

impl Multiaxial<SOLID> for J2Plasticity {
    plain_methods! { SOLID: is_symmetric reinforcement shown_stress of_length probe }
    fn state_len(&self) -> usize {
        J2State::LEN
    }
    fn init(&self, state: &mut [f64]) {
        J2State::default().write(state);
    }
    fn is_linear(&self) -> bool {
        false
    }
    fn depends_on_time(&self) -> bool {
        self.viscosity > 0.0
    }
    fn density(&self) -> f64 {
        self.rho
    }

    fn update(&self, committed: &[f64], e: &[f64; SOLID], dt: f64, next: &mut [f64]) -> MultiaxialResult<SOLID> {
        let mut state = J2State::read(committed);
        let (strain, trace) = deviator(e);
        let trial: [f64; SOLID] = std::array::from_fn(|i| 2.0 * self.shear * (strain[i] - state.plastic[i]));
        let norm = norm(&trial);
        let root = (2.0f64 / 3.0).sqrt();
        let (mut stress, mut tangent) = (trial, isotropic_stiffness(self.bulk, self.shear));
        if norm > root * self.yield_at(state.equivalent) {
            let viscous = if self.viscosity > 0.0 && dt > 0.0 { self.viscosity / dt } else { 0.0 };
            let gamma = self.multiplier(norm, state.equivalent, viscous)?;
            let normal = trial.map(|s| s / norm);
            state.plastic.iter_mut().zip(normal).for_each(|(p, n)| *p += gamma * n);
            state.equivalent += root * gamma;
            stress = std::array::from_fn(|i| 2.0 * self.shear * (strain[i] - state.plastic[i]));
            let theta = 2.0 * self.shear + 2.0 / 3.0 * self.slope_at(state.equivalent) + viscous;
            let square = 4.0 * self.shear * self.shear;
            let turning = square * gamma / norm;
            tangent = isotropic_stiffness(self.bulk, self.shear - 0.5 * turning);
            for (row, a) in tangent.iter_mut().zip(normal) {
                row.iter_mut().zip(normal).for_each(|(k, b)| *k += (turning - square / theta) * a * b);
            }
        }
        stress[..3].iter_mut().for_each(|s| *s += self.bulk * trace);
        state.write(next);
        if stress.iter().all(|s| s.is_finite()) {
            return Ok((stress, tangent));
        }
        Err(MaterialError("J2Plasticity has no stress at these strains: its parameters are out of range".into()))
    }

    fn initial_tangent(&self) -> Tangent<SOLID> {
        isotropic_stiffness(self.bulk, self.shear)
    }
}

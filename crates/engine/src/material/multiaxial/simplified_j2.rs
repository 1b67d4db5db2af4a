//! Plasticity of von Mises with linear hardening: `Simplified3DJ2` and `PlaneStressSimplifiedJ2`.

use super::plain_methods::plain_methods;
use super::{Multiaxial, SOLID, Tangent};
use crate::material::{MaterialError, MultiaxialResult};
use crate::state_struct;
use crate::state_struct::StateStruct;

/// Plasticity of von Mises with linear isotropic and kinematic hardening (Simo and Hughes, 1998, Computational Inelasticity,
/// box 3.1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SimplifiedJ2 {
    /// Shear modulus, stress.
    pub shear: f64,
    /// Bulk modulus, stress.
    pub bulk: f64,
    /// First yield stress.
    pub yield_stress: f64,
    /// Modulus of kinematic hardening, stress.
    pub kinematic: f64,
    /// Modulus of isotropic hardening, stress.
    pub isotropic: f64,
}

state_struct! {
    /// History of a point, as components of tensors.
    pub(super) struct PlasticState {
        /// Plastic strains.
        plastic: [f64; SOLID],
        /// Back stresses.
        back: [f64; SOLID],
        /// Growth of the yield stress.
        growth: f64,
    }
}

/// Elastic stiffness of a bulk modulus and a shear modulus.
pub(super) fn isotropic_stiffness(bulk: f64, shear: f64) -> Tangent<SOLID> {
    let mut k = [[0.0; SOLID]; SOLID];
    for (i, row) in k.iter_mut().enumerate() {
        if i < 3 {
            row[..3].fill(bulk - 2.0 / 3.0 * shear);
            row[i] += 2.0 * shear;
        } else {
            row[i] = shear;
        }
    }
    k
}

/// Deviatoric strains as components of a tensor, and the change of volume.
pub(super) fn deviator(e: &[f64; SOLID]) -> ([f64; SOLID], f64) {
    let trace: f64 = e[..3].iter().sum();
    (std::array::from_fn(|i| if i < 3 { e[i] - trace / 3.0 } else { 0.5 * e[i] }), trace)
}

/// Norm of a symmetric tensor.
pub(super) fn norm(t: &[f64; SOLID]) -> f64 {
    t.iter().enumerate().map(|(i, t)| if i < 3 { t * t } else { 2.0 * t * t }).sum::<f64>().sqrt()
}

crate::watches_columns!(SimplifiedJ2 => nothing);

impl Multiaxial<SOLID> for SimplifiedJ2 {
    plain_methods! { SOLID: is_symmetric depends_on_time reinforcement shown_stress of_length probe }
    fn state_len(&self) -> usize {
        PlasticState::LEN
    }
    fn init(&self, state: &mut [f64]) {
        PlasticState::default().write(state);
    }
    fn is_linear(&self) -> bool {
        false
    }
    fn density(&self) -> f64 {
        0.0
    }

    fn update(&self, committed: &[f64], e: &[f64; SOLID], _: f64, next: &mut [f64]) -> MultiaxialResult<SOLID> {
        let mut state = PlasticState::read(committed);
        let (strain, trace) = deviator(e);
        let double = 2.0 * self.shear;
        let mut stress: [f64; SOLID] = std::array::from_fn(|i| double * (strain[i] - state.plastic[i]));
        let relative: [f64; SOLID] = std::array::from_fn(|i| stress[i] - state.back[i]);
        let size = norm(&relative);
        let root = (2.0f64 / 3.0).sqrt();
        let beyond = size - root * (self.yield_stress + state.growth);
        let mut tangent = isotropic_stiffness(self.bulk, self.shear);
        if beyond > 0.0 {
            let resistance = double + 2.0 / 3.0 * (self.isotropic + self.kinematic);
            let gamma = beyond / resistance;
            let normal = relative.map(|s| s / size);
            for (i, n) in normal.iter().enumerate() {
                state.plastic[i] += gamma * n;
                state.back[i] += 2.0 / 3.0 * self.kinematic * gamma * n;
                stress[i] -= double * gamma * n;
            }
            state.growth += root * self.isotropic * gamma;
            let turning = double * gamma / size;
            tangent = isotropic_stiffness(self.bulk, self.shear * (1.0 - turning));
            for (row, a) in tangent.iter_mut().zip(normal) {
                row.iter_mut().zip(normal).for_each(|(k, b)| *k += double * (turning - double / resistance) * a * b);
            }
        }
        stress[..3].iter_mut().for_each(|s| *s += self.bulk * trace);
        state.write(next);
        if stress.iter().all(|s| s.is_finite()) {
            return Ok((stress, tangent));
        }
        Err(MaterialError("plasticity has no stress at these strains: its parameters are out of range".into()))
    }

    fn initial_tangent(&self) -> Tangent<SOLID> {
        isotropic_stiffness(self.bulk, self.shear)
    }
}

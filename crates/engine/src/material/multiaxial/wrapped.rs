//! Laws in space around others: an initial strain, and a weighted sum.

use super::plain_methods::{inner_methods, plain_methods};
use super::{Multiaxial, SOLID, SharedMultiaxial, Tangent, WeightedLaws};
use crate::material::{MaterialError, MaterialResult, MultiaxialResult};
use crate::numeric::axpy;
use nalgebra::{SMatrix, SVector};
use std::sync::Arc;

/// Largest number of Newton's iterations for the strain of a stress.
const MAX_ITERATIONS: usize = 100;
/// Residual stress over the stress.
const TOLERANCE: f64 = 1e-14;

/// Strain at which a virgin law has a stress, by Newton's method.
///
/// # Errors
/// The law has no stress on the way, no stiffness, or does not reach the stress.
pub fn strain_of_stress(law: &SharedMultiaxial<SOLID>, stress: &[f64; SOLID]) -> MaterialResult<[f64; SOLID]> {
    let mut state = vec![0.0; law.state_len()];
    law.init(&mut state);
    let (mut next, mut strain) = (state.clone(), [0.0; SOLID]);
    let size = stress.iter().fold(0.0f64, |m, s| m.max(s.abs()));
    let (mut tangent, mut now) = (law.initial_tangent(), [0.0; SOLID]);
    for _ in 0..MAX_ITERATIONS {
        let left = SVector::<f64, SOLID>::from_fn(|i, _| stress[i] - now[i]);
        if left.amax() <= TOLERANCE * size {
            return Ok(strain);
        }
        let stiffness = SMatrix::<f64, SOLID, SOLID>::from_fn(|i, j| tangent[i][j]);
        let Some(step) = stiffness.lu().solve(&left) else {
            return Err(MaterialError("the material has no stiffness on the way to the initial stress".into()));
        };
        if step.amax() <= f64::EPSILON * strain.iter().fold(0.0f64, |m, e| m.max(e.abs())) {
            return Ok(strain);
        }
        strain.iter_mut().zip(&step).for_each(|(e, d)| *e += d);
        (now, tangent) = law.update(&state, &strain, 0.0, &mut next)?;
    }
    Err(MaterialError("the material does not reach the initial stress".into()))
}

/// A law with strains added to those of its owner.
#[derive(Clone, Debug)]
pub struct InitialStrain {
    /// The law.
    pub law: SharedMultiaxial<SOLID>,
    /// Strains at rest.
    pub strain: [f64; SOLID],
}

crate::watches_columns!(InitialStrain => |s| in [&s.law]);

#[deny(clippy::missing_trait_methods)]
impl Multiaxial<SOLID> for InitialStrain {
    fn is_linear(&self) -> bool {
        false
    }
    inner_methods! { law: storage is_symmetric properties responses }
    fn update(&self, committed: &[f64], e: &[f64; SOLID], dt: f64, next: &mut [f64]) -> MultiaxialResult<SOLID> {
        self.law.update(committed, &std::array::from_fn(|i| e[i] + self.strain[i]), dt, next)
    }
    fn initial_tangent(&self) -> Tangent<SOLID> {
        self.law.initial_tangent()
    }
    fn shown_stress(&self, next: &[f64], stress: [f64; SOLID]) -> [f64; SOLID] {
        self.law.shown_stress(next, stress)
    }
    fn of_length(&self, length: f64) -> Option<SharedMultiaxial<SOLID>> {
        Some(Arc::new(Self { law: self.law.of_length(length)?, ..self.clone() }))
    }
}

/// Laws with one strain, whose stresses add up with weights.
#[derive(Clone, Debug)]
pub struct ParallelSolids {
    /// The laws with their weights.
    pub laws: WeightedLaws,
}

crate::watches_columns!(ParallelSolids => |s| in [&s.laws]);

#[deny(clippy::missing_trait_methods)]
impl Multiaxial<SOLID> for ParallelSolids {
    plain_methods! { SOLID: shown_stress }
    inner_methods! { laws: storage is_linear is_symmetric properties responses }
    fn update(
        &self,
        mut committed: &[f64],
        e: &[f64; SOLID],
        dt: f64,
        mut next: &mut [f64],
    ) -> MultiaxialResult<SOLID> {
        let (mut stress, mut tangent) = ([0.0; SOLID], [[0.0; SOLID]; SOLID]);
        for (law, weight) in self.laws.iter() {
            let (own, rest) = committed.split_at(law.state_len());
            let (trial, after) = next.split_at_mut(law.state_len());
            let (s, k) = law.update(own, e, dt, trial)?;
            axpy(*weight, &s, &mut stress);
            tangent.iter_mut().zip(&k).for_each(|(out, row)| axpy(*weight, row, out));
            (committed, next) = (rest, after);
        }
        Ok((stress, tangent))
    }
    fn of_length(&self, length: f64) -> Option<SharedMultiaxial<SOLID>> {
        Some(Arc::new(Self { laws: self.laws.of_length(length)? }))
    }
    fn initial_tangent(&self) -> Tangent<SOLID> {
        let mut tangent = [[0.0; SOLID]; SOLID];
        for (law, weight) in self.laws.iter() {
            tangent.iter_mut().zip(&law.initial_tangent()).for_each(|(out, row)| axpy(*weight, row, out));
        }
        tangent
    }
}

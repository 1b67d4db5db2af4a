//! Materials in parallel.

use crate::material::wrapper::wrapper::{Wrapped, Wrapper};
use crate::material::{Material, MaterialResult, Slot, Strain, Stress, UniaxialTraits};
use crate::probe::Probe;

/// Materials with the same strain. The stress is the sum of their stresses, each multiplied by its factor.
pub type Parallel = Wrapped<WeightedSum>;

/// Factors of the stresses of [`Parallel`].
#[derive(Clone, Debug)]
pub struct WeightedSum {
    factors: Vec<f64>,
}

impl Parallel {
    /// From materials with their tags, and a factor for each.
    pub fn new(materials: Vec<(Material, i32)>, factors: Vec<f64>) -> Self {
        Self::around(WeightedSum { factors }, materials)
    }
}

impl Wrapper for WeightedSum {
    const NAME: &'static str = "Parallel";
    const HEADER: usize = 0;
    const NUMBERED: bool = true;

    fn init(&self, _: &mut [f64], _: &[Slot]) {}
    fn update(&self, inner: &[Slot], committed: &[f64], strain: Strain, next: &mut [f64]) -> MaterialResult<Stress> {
        let mut sum = Stress::default();
        for (slot, factor) in inner.iter().zip(&self.factors) {
            let s = slot.update(committed, strain, next)?;
            sum.value += factor * s.value;
            sum.tangent += factor * s.tangent;
            sum.damping += factor * s.damping;
        }
        Ok(sum)
    }
    fn initial_tangent(&self, inner: &[Slot]) -> f64 {
        inner.iter().zip(&self.factors).map(|(slot, factor)| factor * slot.material.initial_tangent()).sum()
    }
    fn traits(&self, inner: UniaxialTraits) -> UniaxialTraits {
        inner
    }
    fn has_failed(&self, _: &[f64]) -> bool {
        false
    }
    fn shown_strain(&self, _: &[Slot], strain: f64, _: &[f64]) -> f64 {
        strain
    }
    fn probe(&self, inner: &[Slot], word: &str) -> Option<Probe> {
        (word == "stresses").then(|| Probe::new(0, inner.iter().map(|_| "sigma11")))
    }
    fn read(&self, inner: &[Slot], _: u32, state: &[f64], out: &mut [f64]) {
        out.iter_mut().zip(inner).for_each(|(o, slot)| *o = slot.stress(state));
    }
}

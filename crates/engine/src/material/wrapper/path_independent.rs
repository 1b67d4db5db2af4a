//! A law without its history.

use crate::material::wrapper::wrapper::{Wrapped, Wrapper};
use crate::material::{Material, MaterialResult, Slot, Strain, Stress, UniaxialTraits};
use crate::probe::Probe;

/// A law that is virgin at each strain: its stress is that of one step from zero.
pub type PathIndependent = Wrapped<Virgin>;

/// Holds the law of [`PathIndependent`] in its virgin state.
#[derive(Clone, Copy, Debug)]
pub struct Virgin;

impl PathIndependent {
    /// From a material, given with its tag.
    pub fn new(material: (Material, i32)) -> Self {
        Self::around(Virgin, [material])
    }
}

impl Wrapper for Virgin {
    const NAME: &'static str = "PathIndependent";
    const HEADER: usize = 0;
    const NUMBERED: bool = false;

    fn init(&self, _: &mut [f64], _: &[Slot]) {}
    fn update(&self, inner: &[Slot], committed: &[f64], strain: Strain, next: &mut [f64]) -> MaterialResult<Stress> {
        let stress = inner[0].update(committed, strain, next)?;
        inner[0].keep_history(committed, next);
        Ok(stress)
    }
    fn initial_tangent(&self, inner: &[Slot]) -> f64 {
        inner[0].material.initial_tangent()
    }
    fn traits(&self, inner: UniaxialTraits) -> UniaxialTraits {
        inner
    }
    // The history of the law inside never changes: it does not fail at a limit of its column either.
    fn has_failed(&self, _: &[f64]) -> bool {
        true
    }
    fn shown_strain(&self, inner: &[Slot], strain: f64, state: &[f64]) -> f64 {
        inner[0].shown(strain, state)
    }
    fn probe(&self, _: &[Slot], _: &str) -> Option<Probe> {
        None
    }
    fn read(&self, _: &[Slot], _: u32, _: &[f64], _: &mut [f64]) {}
}

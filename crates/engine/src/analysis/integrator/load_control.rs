//! Steps of the load factor.

use super::{Adaptive, Integrator};
use crate::analysis::failure::Failure;
use crate::analysis::system::{Coefficients, System};

/// `integrator LoadControl`: the load factor (domain time) grows by a given increment.
#[derive(Clone, Debug)]
pub struct LoadControl {
    step: f64,
    adaptive: Adaptive,
    last_iterations: usize,
}

impl LoadControl {
    /// From the increment and how it may change.
    pub fn new(step: f64, adaptive: Adaptive) -> Self {
        // The first step is not scaled.
        let last_iterations = adaptive.desired_iterations;
        Self { step, adaptive, last_iterations }
    }
}

impl Integrator for LoadControl {
    fn name(&self) -> &'static str {
        "LoadControl"
    }
    fn is_static(&self) -> bool {
        true
    }

    fn only_adds(&self) -> bool {
        true
    }

    fn fixed_increment(&self) -> Option<f64> {
        (self.adaptive.min == self.adaptive.max).then_some(self.adaptive.min)
    }

    fn divides(&self) -> bool {
        true
    }

    fn begin(&mut self, s: &mut System<'_>, part: f64) -> Result<(), Failure> {
        s.coefficients = Coefficients { k: 1.0, c: 0.0, m: 0.0 };
        self.step = self.adaptive.next(self.step, self.last_iterations);
        s.apply_loads(s.old.time + part * self.step)
    }

    fn update(&mut self, s: &mut System<'_>, correction: &mut [f64]) -> Result<(), Failure> {
        s.add_correction(correction, s.coefficients);
        Ok(())
    }

    fn commit(&mut self, _: &mut System<'_>, iterations: usize) -> Result<(), Failure> {
        self.last_iterations = iterations;
        Ok(())
    }
}

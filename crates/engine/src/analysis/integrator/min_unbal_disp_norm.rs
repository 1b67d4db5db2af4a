//! Steps of the load factor with least corrections.

use super::reference_load::ReferenceLoad;
use super::{Adaptive, Integrator};
use crate::analysis::failure::Failure;
use crate::analysis::system::System;
use crate::numeric::{axpy, dot};

/// In which sense a step begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sense {
    /// As the last step went.
    LastStep,
    /// Up where the reference load does work on the displacement under it, down where it takes some: as the sign of the
    /// tangent's determinant does, it changes at a limit point.
    Stiffness,
}

/// `integrator MinUnbalDispNorm`: the load factor grows by a given increment at first, then so that each correction of
/// the displacements is least (Chan, 1988).
#[derive(Clone, Debug)]
pub struct MinUnbalDispNorm {
    increment: f64,
    adaptive: Adaptive,
    sense: Sense,
    last_iterations: usize,
    reference: ReferenceLoad,
    step_factor: f64,
    last_factor: f64,
    /// Displacement of the first point of a step.
    first: Vec<f64>,
    /// Displacement of the equations since the begin of the step; before it, that of the last step.
    step: Vec<f64>,
    /// The tangent of the last step was singular.
    plateau: bool,
}

impl MinUnbalDispNorm {
    /// From the first increment and how it may change, and the sense of the steps.
    pub fn new(increment: f64, adaptive: Adaptive, sense: Sense) -> Self {
        Self {
            increment,
            adaptive,
            sense,
            last_iterations: adaptive.desired_iterations,
            reference: ReferenceLoad::default(),
            step_factor: 0.0,
            last_factor: 0.0,
            first: vec![],
            step: vec![],
            plateau: false,
        }
    }

    /// Growth of the load factor at first where the tangent is singular, or was: in the direction of the last step, and by
    /// no more than its displacement, since a load factor that cannot grow has no increment.
    fn along_plateau(&self) -> f64 {
        let unit = &self.reference.unit;
        let (last, size) = (dot(&self.step, &self.step).sqrt(), dot(unit, unit).sqrt());
        let increment = if last > 0.0 { self.increment.abs().min(last / size) } else { self.increment.abs() };
        if dot(&self.step, unit) < 0.0 { -increment } else { increment }
    }
}

impl Integrator for MinUnbalDispNorm {
    fn name(&self) -> &'static str {
        "MinUnbalDispNorm"
    }
    fn is_static(&self) -> bool {
        true
    }
    fn elapses(&self) -> bool {
        false
    }

    fn prepare(&mut self, s: &mut System<'_>) -> Result<(), Failure> {
        self.first.resize(s.work.b.len(), 0.0);
        self.step.resize(s.work.b.len(), 0.0);
        self.reference.prepare(s)
    }

    fn begin(&mut self, s: &mut System<'_>, _: f64) -> Result<(), Failure> {
        self.reference.begin(s)?;
        self.increment = self.adaptive.next(self.increment, self.last_iterations);
        let unit = &self.reference.unit;
        let down = match self.sense {
            Sense::LastStep => self.last_factor < 0.0,
            Sense::Stiffness => dot(&self.reference.load, unit) < 0.0,
        };
        self.step_factor = if down { -self.increment } else { self.increment };
        if s.is_on_plateau() || self.plateau {
            self.step_factor = self.along_plateau();
        }
        self.first.iter_mut().zip(unit).for_each(|(x, u)| *x = self.step_factor * u);
        self.step.copy_from_slice(&self.first);
        self.reference.advance(s, self.step_factor, &self.first)
    }

    fn update(&mut self, s: &mut System<'_>, correction: &mut [f64]) -> Result<(), Failure> {
        self.reference.solve(s)?;
        let unit = &self.reference.unit;
        let factor = -dot(unit, correction) / dot(unit, unit);
        axpy(factor, unit, correction);
        axpy(1.0, correction, &mut self.step);
        self.step_factor += factor;
        self.reference.advance(s, factor, correction)
    }

    fn commit(&mut self, s: &mut System<'_>, iterations: usize) -> Result<(), Failure> {
        self.plateau = s.is_on_plateau();
        self.last_iterations = iterations;
        self.last_factor = self.step_factor;
        Ok(())
    }
}

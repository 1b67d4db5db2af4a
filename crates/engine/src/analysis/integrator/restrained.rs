//! Implicit integrators for hybrid simulation, whose corrections are kept small.

use super::Integrator;
use crate::analysis::failure::Failure;
use crate::analysis::system::System;

/// Measure that keeps corrections small.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Restraint {
    /// Each is multiplied by a factor.
    Factor(f64),
    /// None is larger than this in a p-norm; the largest entry counts for p not greater than 0.
    Limit {
        /// Largest norm.
        size: f64,
        /// p.
        norm: i32,
    },
}

impl Restraint {
    fn factor(self, x: &[f64]) -> f64 {
        match self {
            Self::Factor(factor) => factor,
            Self::Limit { size, norm } => {
                let found = if norm > 0 {
                    x.iter().map(|x| x.abs().powi(norm)).sum::<f64>().powf(1.0 / f64::from(norm))
                } else {
                    x.iter().fold(0.0f64, |m, x| m.max(x.abs()))
                };
                if found > size { size / found } else { 1.0 }
            }
        }
    }
}

/// An integrator with restrained corrections (Schellenberg, Mahin and Fenves, 2009): `NewmarkHSIncrReduct` and the like. The
/// test sees the corrections as they would have been.
#[derive(Clone, Debug)]
pub struct Restrained {
    name: &'static str,
    inner: Box<dyn Integrator>,
    restraint: Restraint,
    correction: Vec<f64>,
}

impl Restrained {
    /// Around another integrator.
    pub fn new(name: &'static str, inner: Box<dyn Integrator>, restraint: Restraint) -> Self {
        Self { name, inner, restraint, correction: vec![] }
    }
}

impl Integrator for Restrained {
    fn name(&self) -> &'static str {
        self.name
    }
    fn is_static(&self) -> bool {
        self.inner.is_static()
    }
    fn elapses(&self) -> bool {
        self.inner.elapses()
    }
    fn balances(&self) -> bool {
        self.inner.balances()
    }

    fn prepare(&mut self, s: &mut System<'_>) -> Result<(), Failure> {
        self.correction.resize(s.work.b.len(), 0.0);
        self.inner.prepare(s)
    }

    fn begin(&mut self, s: &mut System<'_>, dt: f64) -> Result<(), Failure> {
        self.inner.begin(s, dt)
    }

    fn update(&mut self, s: &mut System<'_>, correction: &mut [f64]) -> Result<(), Failure> {
        let factor = self.restraint.factor(correction);
        self.correction.copy_from_slice(correction);
        self.correction.iter_mut().for_each(|x| *x *= factor);
        self.inner.update(s, &mut self.correction)
    }

    fn commit(&mut self, s: &mut System<'_>, iterations: usize) -> Result<(), Failure> {
        self.inner.commit(s, iterations)
    }
}

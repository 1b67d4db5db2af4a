//! Implicit methods that weight the forces of both ends of a step.

use super::newmark::{Form, Newmark};
use super::{AlphaParameters, Integrator};
use crate::analysis::failure::Failure;
use crate::analysis::system::{Coefficients, System};

/// `integrator HHT_TP` and `HHTGeneralized_TP`: the methods of Hilber, Hughes and Taylor (1977) and of Chung and Hulbert
/// (1993) with their weights on the forces at both ends of a step, αf F(u, v) at its end and (1 - αf) F at its begin, where
/// [`Hht`](super::Hht) and [`GeneralizedAlpha`](super::GeneralizedAlpha) evaluate the force F once, at the weighted motion
/// (for the two see Erlicher, Bonaventura and Bursi, 2002). Linear models see no difference; elements see ends of steps only.
#[derive(Clone, Debug)]
pub struct Trapezoidal {
    name: &'static str,
    p: AlphaParameters,
    newmark: Newmark,
}

impl Trapezoidal {
    /// From its parameters.
    pub fn new(name: &'static str, p: AlphaParameters) -> Self {
        Self { name, p, newmark: Newmark::new(p.gamma, p.beta, Form::Displacement) }
    }
}

impl Integrator for Trapezoidal {
    fn name(&self) -> &'static str {
        self.name
    }
    fn prepare(&mut self, s: &mut System<'_>) -> Result<(), Failure> {
        s.hold_committed(1.0 - self.p.force, 1.0 - self.p.inertia)
    }

    fn begin(&mut self, s: &mut System<'_>, dt: f64) -> Result<(), Failure> {
        let AlphaParameters { inertia, force, .. } = self.p;
        self.newmark.begin(s, dt)?;
        let c = s.coefficients;
        s.coefficients = Coefficients { k: force * c.k, c: force * c.c, m: inertia * c.m };
        s.weigh_unbalance(force, inertia);
        Ok(())
    }

    fn update(&mut self, s: &mut System<'_>, correction: &mut [f64]) -> Result<(), Failure> {
        self.newmark.update(s, correction)
    }

    fn commit(&mut self, s: &mut System<'_>, _: usize) -> Result<(), Failure> {
        s.hold_unbalance(1.0 - self.p.force, 1.0 - self.p.inertia);
        Ok(())
    }
}

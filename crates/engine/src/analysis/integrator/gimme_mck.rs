//! No motion at all: the matrices of the model by themselves.

use super::Integrator;
use crate::analysis::failure::Failure;
use crate::analysis::system::{Coefficients, System};

/// `integrator GimmeMCK`: the tangent is k K + c C + m M, to be printed with `printA`, and nothing moves.
#[derive(Clone, Debug)]
pub struct GimmeMck(pub Coefficients);

impl Integrator for GimmeMck {
    fn name(&self) -> &'static str {
        "GimmeMCK"
    }
    fn elapses(&self) -> bool {
        false
    }
    fn balances(&self) -> bool {
        false
    }

    fn begin(&mut self, s: &mut System<'_>, _: f64) -> Result<(), Failure> {
        s.coefficients = self.0;
        s.apply_loads(s.old.time)
    }

    fn update(&mut self, _: &mut System<'_>, _: &mut [f64]) -> Result<(), Failure> {
        Ok(())
    }
}

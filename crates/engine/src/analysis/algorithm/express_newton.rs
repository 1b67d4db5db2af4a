//! A fixed number of corrections a step.

use super::{Algorithm, Iteration};
use crate::analysis::failure::Failure;
use crate::analysis::workspace::TangentMix;
use crate::solve::Use;

/// `algorithm ExpressNewton` (Xu, 2016): a number of corrections with one tangent, and no test.
#[derive(Clone, Debug)]
pub struct ExpressNewton {
    corrections: usize,
    mix: TangentMix,
    factor_once: bool,
    factored: bool,
}

impl ExpressNewton {
    /// With the number of corrections, the tangent (its factor included), and whether it is factored only once.
    pub fn new(corrections: usize, mix: TangentMix, factor_once: bool) -> Self {
        Self { corrections, mix, factor_once, factored: false }
    }
}

impl Algorithm for ExpressNewton {
    fn name(&self) -> &'static str {
        "ExpressNewton"
    }
    fn prepare(&mut self, _: &super::System<'_>) {
        self.factored = false;
    }
    fn solve(&mut self, it: &mut Iteration<'_, '_>) -> Result<usize, Failure> {
        it.system.form_unbalance(self.mix.current != 0.0 && !self.factored)?;
        if !self.factored {
            it.system.form_tangent(self.mix, Use::Often)?;
            self.factored = self.factor_once;
        }
        for _ in 0..self.corrections {
            it.system.solve()?;
            it.update()?;
            // After the last too: the elements must see the end of the step.
            it.system.form_unbalance(false)?;
        }
        Ok(self.corrections)
    }
}

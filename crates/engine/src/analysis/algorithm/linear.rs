//! One correction a step.

use super::{Algorithm, Iteration};
use crate::analysis::failure::Failure;
use crate::analysis::workspace::TangentMix;
use crate::solve::Use;

/// `algorithm Linear`: one correction and no test.
#[derive(Clone, Debug)]
pub struct Linear {
    mix: TangentMix,
    factor_once: bool,
    factored: bool,
}

impl Linear {
    /// With which tangent, and whether it is factored only once.
    pub fn new(mix: TangentMix, factor_once: bool) -> Self {
        Self { mix, factor_once, factored: false }
    }
}

impl Algorithm for Linear {
    fn name(&self) -> &'static str {
        "Linear"
    }
    fn iterates(&self) -> bool {
        false
    }
    fn prepare(&mut self, _: &super::System<'_>) {
        self.factored = false;
    }
    fn solve(&mut self, it: &mut Iteration<'_, '_>) -> Result<usize, Failure> {
        it.system.form_unbalance(self.mix.current != 0.0 && !self.factored)?;
        if !self.factored {
            it.system.form_tangent(self.mix, Use::Once)?;
            self.factored = self.factor_once;
        }
        it.system.solve()?;
        it.update()?;
        // The elements must see the end of the step, and someone may want to know what is left out of balance.
        it.system.form_unbalance(false)?;
        Ok(1)
    }
}

//! Newton's method with a new tangent in each iteration, and with one for the whole step.

use super::cycle::Cycle;
use super::{Algorithm, Iteration, TangentChoice};
use crate::analysis::failure::Failure;
use crate::analysis::workspace::TangentMix;
use crate::solve::Use;

/// `algorithm Newton`.
#[derive(Clone, Debug)]
pub struct Newton {
    choice: TangentChoice,
    /// Iterations of the last step. The next one is expected to take as many, and no tangents are made at its end; they
    /// are made up for where it takes more.
    pub(in crate::analysis) expected: usize,
    /// The last step was in balance as it began: of the next one the same is expected, and no tangents are made at its
    /// beginning either.
    balanced: bool,
}

impl Newton {
    /// With which tangents.
    pub fn new(choice: TangentChoice) -> Self {
        Self { choice, expected: usize::MAX, balanced: false }
    }
}

impl Algorithm for Newton {
    fn name(&self) -> &'static str {
        "Newton"
    }
    fn newton(&self) -> Option<&Newton> {
        (self.choice == TangentChoice::Always(TangentMix::CURRENT)).then_some(self)
    }
    fn forget(&mut self) {
        *self = Self::new(self.choice);
    }
    fn solve(&mut self, it: &mut Iteration<'_, '_>) -> Result<usize, Failure> {
        let wants = self.choice != TangentChoice::Always(TangentMix::INITIAL);
        it.system.form_unbalance(wants && !self.balanced)?;
        it.start_test();
        self.balanced = it.system.is_balanced();
        let mut cycle = Cycle::default();
        for iteration in 0.. {
            // The first correction is known to be zero, and to change nothing where it is only added.
            let none = iteration == 0 && self.balanced;
            if none {
                it.system.work.x.fill(0.0);
            } else {
                it.system.form_tangent(self.choice.at(iteration), Use::Once)?;
                it.system.solve()?;
            }
            if !(none && it.integrator.only_adds()) {
                it.update()?;
                it.form_unbalance(wants && iteration + 1 != self.expected)?;
            }
            if let Some(n) = it.judge_or_cycle(&mut cycle)? {
                self.expected = n;
                return Ok(n);
            }
        }
        unreachable!("the test ends the iterations")
    }
}

/// `algorithm ModifiedNewton`: one tangent for all iterations of a step, or of the analysis.
#[derive(Clone, Debug)]
pub struct ModifiedNewton {
    mix: TangentMix,
    factor_once: bool,
    factored: bool,
}

impl ModifiedNewton {
    /// With which tangent, and whether it is factored only once.
    pub fn new(mix: TangentMix, factor_once: bool) -> Self {
        Self { mix, factor_once, factored: false }
    }
}

impl Algorithm for ModifiedNewton {
    fn name(&self) -> &'static str {
        "ModifiedNewton"
    }
    fn prepare(&mut self, _: &super::System<'_>) {
        self.factored = false;
    }
    fn solve(&mut self, it: &mut Iteration<'_, '_>) -> Result<usize, Failure> {
        it.system.form_unbalance(self.mix.current != 0.0 && !self.factored)?;
        if !self.factored {
            it.system.form_tangent(self.mix, Use::Often)?;
        }
        self.factored = false;
        it.start_test();
        let mut cycle = Cycle::default();
        loop {
            it.system.solve()?;
            it.update()?;
            it.form_unbalance(false)?;
            if let Some(n) = it.judge_or_cycle(&mut cycle)? {
                self.factored = self.factor_once;
                return Ok(n);
            }
        }
    }
}

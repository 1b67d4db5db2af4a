//! Solution algorithms: how the equations of a step are brought into balance.

mod accelerated;
mod bfgs;
mod broyden;
mod cycle;
mod express_newton;
mod krylov;
mod line_search;
mod linear;
mod newton;
mod quasi_newton;
mod secant_newton;

use super::convergence::{Test, TestOutcome};
use super::failure::{Cause, Failure};
use super::integrator::Integrator;
use super::opensees::{Phase, Stage};
use super::system::System;
use super::workspace::TangentMix;
use cycle::Cycle;
use dyn_clone::DynClone;
use std::fmt;

pub use accelerated::Tangents;
pub use bfgs::bfgs;
pub use broyden::broyden;
pub use express_newton::ExpressNewton;
pub use krylov::krylov_newton;
pub use line_search::{LineSearch, NewtonLineSearch, SearchKind};
pub use linear::Linear;
pub use newton::{ModifiedNewton, Newton};
pub use secant_newton::secant_newton;

/// Equations, integrator and test of a step, for an algorithm.
pub struct Iteration<'a, 'b> {
    /// The equations.
    pub system: &'a mut System<'b>,
    /// Takes the corrections.
    pub integrator: &'a mut dyn Integrator,
    /// Judges them.
    pub test: &'a mut Test,
}

impl Iteration<'_, '_> {
    /// Give the integrator the correction in `system.work.x`.
    #[inline]
    pub fn update(&mut self) -> Result<(), Failure> {
        self.system.moved = true;
        self.system.work.enter(Stage::Correction);
        self.system.work.progress = (self.test.iteration + 1, self.test.max_iterations.max(1));
        let mut x = std::mem::take(&mut self.system.work.x);
        self.system.enter_phase(Phase::Within);
        let result = self.integrator.update(self.system, &mut x);
        self.system.impose_linked_rates();
        self.system.follow_correction();
        self.system.work.x = x;
        result
    }

    /// Work out the unbalance after the last correction, for the test to judge; with the element tangents if another is
    /// going to follow.
    #[inline]
    pub fn form_unbalance(&mut self, want_tangent: bool) -> Result<(), Failure> {
        let n = self.system.work.plan.map.equations;
        self.system.settled = self.test.accepts(&self.system.work.x[..n]);
        self.system.form_unbalance(want_tangent)
    }

    /// Begin the tests of a step, its first unbalance being formed.
    #[inline]
    pub fn start_test(&mut self) {
        let work = &self.system.work;
        self.test.start(&work.b[..work.plan.map.equations]);
    }

    /// Let the test judge the last correction and the unbalance after it; the number of iterations when it is passed.
    #[inline]
    pub fn judge(&mut self) -> Result<Option<usize>, Failure> {
        let work = &self.system.work;
        let n = work.plan.map.equations;
        match self.test.judge(&work.x[..n], &work.b[..n]) {
            TestOutcome::Converged => Ok(Some(self.test.iteration)),
            TestOutcome::Continue => Ok(None),
            TestOutcome::Failed => Err(self.not_converged()),
        }
    }

    /// The same for an algorithm whose iterations depend on the trial state alone: they end where they go in a circle.
    #[inline]
    fn judge_or_cycle(&mut self, cycle: &mut Cycle) -> Result<Option<usize>, Failure> {
        let done = self.judge()?;
        if done.is_none()
            && self.test.depends_on_last_iteration()
            && let Some(period) = cycle.watch(self.system)
        {
            let mut failure = self.not_converged();
            let place = failure.place.take().unwrap_or_default();
            failure.place = Some(format!("{place}; the last iterations alternate between {period} states"));
            return Err(failure);
        }
        Ok(done)
    }

    fn not_converged(&self) -> Failure {
        let cause = Cause::NotConverged {
            norm: self.test.last_norm(),
            tolerance: self.test.tolerance,
            iterations: self.test.iteration,
            test: self.test.measure.name(),
        };
        let place = self.system.worst(&self.system.work.b);
        self.system.failure(cause).at(place)
    }
}

/// A solution algorithm.
pub trait Algorithm: DynClone + fmt::Debug + Send {
    /// Name in the `algorithm` command.
    fn name(&self) -> &'static str;

    /// Itself, where it is Newton's method with the current tangent in each iteration.
    fn newton(&self) -> Option<&Newton> {
        None
    }

    /// It corrects until a test is passed, so that terms missing in the matrix cost no more than iterations.
    fn iterates(&self) -> bool {
        true
    }

    /// The model has changed.
    fn prepare(&mut self, _system: &System<'_>) {}

    /// Another state is committed than that of the last step: forget how that went.
    fn forget(&mut self) {}

    /// Solve the step that the integrator has begun; the number of iterations.
    fn solve(&mut self, it: &mut Iteration<'_, '_>) -> Result<usize, Failure>;
}

dyn_clone::clone_trait_object!(Algorithm);

/// Tangent of the iterations of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TangentChoice {
    /// One mix for all iterations.
    Always(TangentMix),
    /// The initial tangent in the first iteration, the current one after it.
    InitialThenCurrent,
    /// The current tangent in the first iteration, the initial one after it.
    CurrentThenInitial,
}

impl TangentChoice {
    /// The mix of an iteration, from 0.
    pub fn at(self, iteration: usize) -> TangentMix {
        match self {
            Self::Always(mix) => mix,
            Self::InitialThenCurrent if iteration == 0 => TangentMix::INITIAL,
            Self::CurrentThenInitial if iteration == 0 => TangentMix::CURRENT,
            Self::InitialThenCurrent => TangentMix::CURRENT,
            Self::CurrentThenInitial => TangentMix::INITIAL,
        }
    }
}

//! Derivatives of the response with respect to parameters of the model.
//!
//! Two analyses go beside the one of the script: in one the parameter is a little less, in the other a little more. They
//! make the same steps, solved to round-off, and the central difference of their responses is the derivative. Its error is of
//! the order of the square of the distance. Elements keep their histories in analyses of their own, so that a law needs no
//! derivative of its own.

use super::{Engine, Options, Setup};
use crate::analysis::algorithm::{Newton, TangentChoice};
use crate::analysis::convergence::{Measure, Test};
use crate::analysis::failure::{Cause, Failure};
use crate::analysis::state::State;
use crate::analysis::workspace::TangentMix;
use crate::model::Tag;
use crate::numeric::largest;
use std::collections::BTreeMap;

/// Corrections of displacements at which a step counts as solved, as a fraction of the largest displacement.
const SOLVED: f64 = 1e-13;
/// Corrections beyond this fraction are an error of the derivative.
const NOT_SOLVED: f64 = 1e-9;
/// Iterations more than the step of the script took.
const MORE_ITERATIONS: usize = 6;

/// The derivative with respect to one parameter.
#[derive(Debug)]
pub struct Derivative {
    /// Analyses with less and with more of it.
    ends: Box<[Engine; 2]>,
    /// Difference of the parameter between them.
    distance: f64,
    /// Reason why there is no derivative any more.
    failure: Option<Failure>,
}

impl Derivative {
    /// Of a number that is found in an engine.
    ///
    /// # Errors
    /// One of the two analyses has failed at an earlier step.
    pub fn of(&self, mut number: impl FnMut(&Engine) -> f64) -> Result<f64, Failure> {
        match &self.failure {
            Some(failure) => Err(failure.clone()),
            None => Ok((number(&self.ends[1]) - number(&self.ends[0])) / self.distance),
        }
    }
}

/// Derivatives by the tags of the parameters.
#[derive(Debug, Default)]
pub(super) struct Derivatives {
    all: BTreeMap<Tag, Derivative>,
    /// State of the analysis of the script that they belong to.
    state: State,
    /// Numbers of the last changes of model and analysis that they belong to.
    revisions: [u64; 2],
}

/// The parts of an analysis that solves its steps to round-off.
fn to_round_off(setup: &Setup) -> Setup {
    if !setup.algorithm.iterates() {
        return setup.clone();
    }
    let mut test = Test::new(Measure::DispIncr, 0.0, MORE_ITERATIONS);
    test.accept_unconverged = true;
    let algorithm = Newton::new(TangentChoice::Always(TangentMix::CURRENT));
    Setup { algorithm: Box::new(algorithm), test, integrator: setup.integrator.clone(), ..*setup }
}

impl Engine {
    /// An engine for an analysis beside this one, with the same model, state and parts of the analysis.
    pub fn beside(&self) -> Self {
        let options = Options { ladder: None, ..self.options.clone() };
        Self {
            model: self.model.clone(),
            committed: self.committed.clone(),
            trial: self.committed.clone(),
            led: self.led.clone(),
            setup: self.setup.as_ref().map(to_round_off),
            default_handler: self.default_handler,
            interrupt: self.interrupt.clone(),
            ..Self::new(options)
        }
    }

    /// Returns true if the derivatives belong to the model, the state and the analysis as they are.
    pub fn derivatives_are_current(&self) -> bool {
        let known = &self.derivatives;
        known.revisions == self.revisions() && (known.all.is_empty() || known.state == self.committed)
    }

    fn revisions(&self) -> [u64; 2] {
        [self.model.revision(), self.setup_revision]
    }

    /// Begin derivatives with respect to parameters: of each the tag, engines [`beside`](Engine::beside) this one with less and
    /// with more of it, and the difference. Derivatives so far stay: what has changed the state of this engine since the last step
    /// changes theirs likewise.
    pub fn set_derivatives(&mut self, parameters: impl IntoIterator<Item = (Tag, [Engine; 2], f64)>) {
        let mut known = std::mem::take(&mut self.derivatives);
        let same_analysis = known.revisions[1] == self.setup_revision;
        for (tag, mut ends, distance) in parameters {
            let mut failure = None;
            if let Some(old) = known.all.remove(&tag) {
                failure = old.failure;
                for (new, old) in ends.iter_mut().zip(*old.ends) {
                    new.go_on_from(old, &known.state, same_analysis);
                }
            }
            self.derivatives.all.insert(tag, Derivative { ends: Box::new(ends), distance, failure });
        }
        self.derivatives.state.clone_from(&self.committed);
        self.derivatives.revisions = self.revisions();
    }

    /// Take over the state of another end, of which the script's analysis was in state `then` and is in that of this engine now.
    fn go_on_from(&mut self, mut old: Self, then: &State, same_analysis: bool) {
        if same_analysis {
            self.setup = old.setup.take();
        }
        let mut own = old.committed.rearranged(&old.model, &self.model);
        own.multipliers = old.committed.multipliers;
        own.time = old.committed.time;
        own.shift(&then.rearranged(&old.model, &self.model), &self.committed);
        self.trial.clone_from(&own);
        self.committed = own;
    }

    /// The derivative with respect to a parameter.
    pub fn derivative(&self, parameter: Tag) -> Option<&Derivative> {
        self.derivatives.all.get(&parameter)
    }

    /// Let the derivatives follow a step that has been made.
    pub(super) fn step_derivatives(&mut self, length: f64) {
        if self.derivatives.all.is_empty() {
            return;
        }
        let mut known = std::mem::take(&mut self.derivatives);
        let changed = known.revisions != self.revisions();
        let iterations = self.setup.as_ref().map_or(0, |s| s.test.iteration) + MORE_ITERATIONS;
        let size = largest(&self.committed.disp);
        for derivative in known.all.values_mut().filter(|d| d.failure.is_none()) {
            let mut ends = derivative.ends.iter_mut();
            let done = ends.try_for_each(|end| end.step_to_round_off(length, iterations, size));
            derivative.failure = done.err().or_else(|| {
                let message = "the model changed between two steps of one \"analyze\"";
                changed.then(|| Failure::new(Cause::Model(message.into()), self.committed.time, -3))
            });
        }
        known.state.clone_from(&self.committed);
        self.derivatives = known;
    }

    /// One step, solved to round-off of displacements of a size.
    fn step_to_round_off(&mut self, length: f64, iterations: usize, size: f64) -> Result<(), Failure> {
        let iterates = self.setup.as_ref().is_some_and(|s| s.algorithm.iterates());
        if let Some(setup) = self.setup.as_mut().filter(|_| iterates) {
            (setup.test.tolerance, setup.test.max_iterations) = (SOLVED * size, iterations);
        }
        self.step_in_parts(length)?;
        match &self.setup {
            Some(Setup { test, .. }) if iterates && test.last_norm() > NOT_SOLVED * size => {
                let cause = Cause::NotConverged {
                    norm: test.last_norm(),
                    tolerance: NOT_SOLVED * size,
                    iterations: test.iteration,
                    test: test.measure.name(),
                };
                Err(Failure::new(cause, self.committed.time, -3))
            }
            _ => Ok(()),
        }
    }
}

impl State {
    /// Change the state by the difference of two states of another analysis of the same model. A number that is the same in
    /// both stays as it is.
    fn shift(&mut self, then: &Self, now: &Self) {
        if now.time != then.time {
            self.time += now.time - then.time;
        }
        for (own, then, now) in [
            (&mut self.disp, &then.disp, &now.disp),
            (&mut self.vel, &then.vel, &now.vel),
            (&mut self.accel, &then.accel, &now.accel),
            (&mut self.history, &then.history, &now.history),
        ] {
            for ((own, then), now) in own.iter_mut().zip(then).zip(now).filter(|((_, then), now)| then != now) {
                *own += now - then;
            }
        }
    }
}

//! `analyze` called once more: loops of a host make a step with each call, and ask for results between them.
//!
//! The checks before its first step have the same outcome as those of the call before, and are passed over.

use super::Run;
use crate::Outcome;
use crate::analysis::analyze::conclude;
use crate::analysis::plausibility;
use crate::call_numbers::next_number;
use crate::session::Session;
use crate::watch::Checked;
use hysteron_engine::analysis::{Failure, Kind};
use hysteron_tcl::{Call, Value};

/// Outcome of an analysis that was gone on with.
pub enum Continued {
    /// The steps are made, and nothing is to be said.
    Silent,
    /// [`Run::conclude`] has the messages and the code.
    Told(Result<(), Failure>),
}

impl Run {
    /// Make steps of the analysis that [`Run::call`] has made steps of this length of. `None`, and nothing is done, if there is
    /// no such analysis, or another command has been called since.
    ///
    /// A static analysis takes no `dt`. The receiver of progress is told of no step.
    pub fn continue_analysis(&mut self, steps: usize, dt: Option<f64>) -> Option<Continued> {
        let session = &mut self.interp.host;
        let dt = match (session.analysis_checks.passed?, dt) {
            (Checked { kind: Kind::Static, .. }, _) => 0.0,
            (checked, Some(dt)) if checked.dt == dt => dt,
            _ => return None,
        };
        let recorders = &mut session.output.recorders;
        let progress = recorders.progress.take();
        recorders.start(&mut session.engine);
        recorders.isolator_damping.begin(&session.engine);
        session.builder.loads_time = None;
        let done = session.engine.analyze(steps, dt, recorders);
        recorders.progress = progress;
        if done.is_ok() && is_silent(session) {
            session.last_failure = None;
            return Some(Continued::Silent);
        }
        session.analysis_checks.passed = None;
        Some(Continued::Told(done))
    }

    /// Give the messages about an analysis that was gone on with, and its code. `words` are those of its command.
    ///
    /// # Errors
    /// It was interrupted, or a warning is an error.
    #[cold]
    pub fn conclude(&mut self, done: Result<(), Failure>, words: &[Value]) -> Outcome {
        let (source, number) = next_number(&mut self.interp);
        conclude(&mut self.interp, &Call::numbered(words, source, number), done)
    }
}

/// Returns true if an analysis that has been made gives no message.
fn is_silent(session: &mut Session) -> bool {
    let recorders = &session.output.recorders;
    recorders.printed.is_empty()
        && recorders.by_tag.values().all(|r| r.recorder.missing.is_empty())
        && recorders.backbones.warning(None).is_none()
        && session.engine.imbalance.is_none()
        && session.engine.weak_pivot().is_none()
        && session.engine.overload().is_none()
        && plausibility::is_plausible(session)
}

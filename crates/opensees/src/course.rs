//! Course of a run whose last analysis waits for those of other runs.

use crate::Tcl;
use hysteron_tcl::{Call, Exception, Value};

/// Commands after the last analysis that need no results.
const ENDING: &[&str] = &["wipe", "wipeAnalysis", "setPrecision", "logFile"];

/// Course of a run whose last analysis waits, or is looked for.
#[derive(Clone, Copy, Debug, Default)]
pub struct Course {
    /// Number of the analysis that waits, from 1; 0 for none.
    waiting: u64,
    /// Analyses so far.
    analyses: u64,
    /// A command has followed the last analysis that may need its results.
    followed: bool,
    /// Number and length of the steps of the analysis that waits.
    steps: Option<(usize, f64)>,
}

impl Course {
    /// Of a run whose analysis of this number is to wait.
    pub fn until(analysis: u64) -> Self {
        Self { waiting: analysis, ..Self::default() }
    }

    /// Number of the last analysis; `None` where other commands follow it.
    pub fn last_analysis(&self) -> Option<u64> {
        (self.analyses > 0 && !self.followed).then_some(self.analyses)
    }

    /// Number and length of the steps of the analysis that waits, where the run has come to its end.
    pub(crate) fn waiting_steps(&self) -> Option<(usize, f64)> {
        if self.followed { None } else { self.steps }
    }

    /// An analysis begins. Returns true if it is to wait.
    pub(crate) fn begin_analysis(&mut self, steps: (usize, f64), can_wait: bool) -> bool {
        self.analyses += 1;
        self.followed = !can_wait;
        let waits = self.analyses == self.waiting && can_wait;
        self.steps = waits.then_some(steps);
        waits
    }
}

/// Note a command of a run whose course is followed; after an analysis that waits, the end of a run is let pass and any other
/// command stops it.
pub(crate) fn before_command(interp: &mut Tcl, call: &Call<'_>) -> Result<Option<Value>, Exception> {
    let Some(course) = &mut interp.host.course else { return Ok(None) };
    let ends = ENDING.contains(&call.name().trim_start_matches(':'));
    course.followed |= !ends;
    match course.steps {
        None => Ok(None),
        Some(_) if ends => Ok(Some(Value::EMPTY)),
        Some(_) => Err(Exception::Interrupted),
    }
}

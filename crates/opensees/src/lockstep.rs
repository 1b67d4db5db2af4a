//! Runs of one script with different parameters, whose last analyses are made side by side.
//!
//! A run comes to its last analysis and answers that it has been made. The script goes on to its end, which must not ask for
//! results. When all runs of a group have come so far, their analyses are made in vector instructions.

use crate::Tcl;
use crate::run::Run;
use hysteron_engine::analysis::{LockstepRows, Recorded, lockstep};
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
    /// Steps of the analysis that waits.
    steps: Option<usize>,
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

    /// An analysis begins. Returns true if it is to wait.
    pub(crate) fn begin_analysis(&mut self, steps: usize, can_wait: bool) -> bool {
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

impl Run {
    /// Steps of the analysis that the run waits with, having come to its end; `None` where it does not wait.
    pub fn waits(&self) -> Option<usize> {
        self.interp.host.course.filter(|c| !c.followed).and_then(|c| c.steps)
    }
}

/// Outcome of an analysis that waited.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Made {
    /// It has been made side by side with others.
    SideBySide,
    /// It has been made by itself.
    ByItself,
    /// It has not been made: the script is to be run anew, without waiting.
    No,
}

/// Make the analyses of runs that wait: of all side by side, or else of each by itself. The results are the same.
pub fn analyze(runs: &mut [&mut Run]) -> Vec<Made> {
    let mut all = vec![Made::No; runs.len()];
    // A script that has stopped before its analysis does not keep the others from going side by side.
    let waiting = runs.iter_mut().enumerate().filter(|(_, run)| run.waits().is_some());
    let (places, mut waiting): (Vec<usize>, Vec<&mut Run>) = waiting.map(|(i, run)| (i, &mut **run)).unzip();
    let made = side_by_side(&mut waiting);
    let made = made.unwrap_or_else(|| waiting.iter_mut().map(|run| by_itself(run)).collect());
    places.into_iter().zip(made).for_each(|(i, made)| all[i] = made);
    all
}

/// Make the analysis of a run by itself.
fn by_itself(run: &mut Run) -> Made {
    let Some(steps) = run.waits() else { return Made::No };
    let session = &mut run.interp.host;
    let done = session.engine.analyze(steps, 0.0, &mut session.output.recorders);
    if done.is_ok() { Made::ByItself } else { Made::No }
}

/// Make the analyses side by side; `None` where they are not made for it, and nothing has been done then.
fn side_by_side(runs: &mut [&mut Run]) -> Option<Vec<Made>> {
    let steps = runs.first()?.waits()?;
    let mut numbers: Option<Vec<(bool, Vec<Recorded>)>> = None;
    for run in runs.iter_mut() {
        let session = &mut run.interp.host;
        let recorders = &mut session.output.recorders;
        if !recorders.records_only() {
            return None;
        }
        let all = recorders.by_tag.values_mut().map(|r| r.recorder.numbers(&session.engine));
        let own: Option<Vec<_>> = all.collect();
        let own = own?;
        if run.waits() != Some(steps) || numbers.as_ref().is_some_and(|n| *n != own) {
            return None;
        }
        numbers = Some(own);
    }
    let numbers = numbers?;
    let mut engines = vec![];
    let mut recorders = vec![];
    for run in runs.iter_mut() {
        let session = &mut run.interp.host;
        engines.push(&mut session.engine);
        recorders.push(&mut session.output.recorders);
    }
    let all: Vec<Recorded> = numbers.iter().flat_map(|(_, numbers)| numbers).copied().collect();
    let mut made = vec![true; engines.len()];
    let mut take = |rows: &LockstepRows| {
        for (model, (recorders, made)) in recorders.iter_mut().zip(&mut made).enumerate() {
            let mut at = 0;
            for (r, (time, numbers)) in recorders.by_tag.values_mut().zip(&numbers) {
                let columns = at..at + numbers.len();
                at = columns.end;
                *made &= r.recorder.record_lockstep(rows, model, (*time, columns)).is_ok();
            }
        }
    };
    let failed = lockstep(&mut engines, steps, &all, &mut take)?;
    let of = |(made, failed): (bool, bool)| if made && !failed { Made::SideBySide } else { Made::No };
    Some(made.into_iter().zip(failed).map(of).collect())
}

//! Runs of one script with different parameters, whose last analyses are made side by side.
//!
//! A run comes to its last analysis and answers that it has been made. The script goes on to its end, which must not ask for
//! results. When all runs of a group have come so far, their analyses are made in vector instructions.

pub use crate::course::Course;
use crate::run::Run;
use hysteron_engine::analysis::{LockstepRows, Recorded, lockstep};

impl Run {
    /// Number and length of the steps of the analysis that the run waits with, having come to its end; `None` where it does
    /// not wait. Static steps have the length 0.
    pub fn waits(&self) -> Option<(usize, f64)> {
        self.interp.host.course.and_then(|course| course.waiting_steps())
    }
}

/// Outcome of an analysis that waited.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Execution {
    /// It has been made side by side with others.
    SideBySide,
    /// It has been made by itself.
    ByItself,
    /// It has not been made: the script is to be run anew, without waiting.
    No,
}

/// Make the analyses of runs that wait: of all side by side, or else of each by itself. The results are the same.
pub fn analyze(runs: &mut [&mut Run]) -> Vec<Execution> {
    let mut all = vec![Execution::No; runs.len()];
    // A script that has stopped before its analysis does not keep the others from going side by side.
    let waiting = runs.iter_mut().enumerate().filter(|(_, run)| run.waits().is_some());
    let (places, mut waiting): (Vec<usize>, Vec<&mut Run>) = waiting.map(|(i, run)| (i, &mut **run)).unzip();
    let made = side_by_side(&mut waiting);
    let made = made.unwrap_or_else(|| waiting.iter_mut().map(|run| by_itself(run)).collect());
    places.into_iter().zip(made).for_each(|(i, made)| all[i] = made);
    all
}

/// Make the analysis of a run by itself.
fn by_itself(run: &mut Run) -> Execution {
    let Some((steps, dt)) = run.waits() else { return Execution::No };
    let session = &mut run.interp.host;
    let done = session.engine.analyze(steps, dt, &mut session.output.recorders);
    if done.is_ok() { Execution::ByItself } else { Execution::No }
}

/// Make the analyses side by side; `None` where they are not made for it, and nothing has been done then.
fn side_by_side(runs: &mut [&mut Run]) -> Option<Vec<Execution>> {
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
    let of = |(made, failed): (bool, bool)| if made && !failed { Execution::SideBySide } else { Execution::No };
    Some(made.into_iter().zip(failed).map(of).collect())
}

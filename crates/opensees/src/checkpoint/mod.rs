//! Checkpoints of long time histories, and runs that go on from them.
//!
//! A run that goes on executes its script again. Its transient analyses are not computed as far as the journal knows them: rows
//! of recorders and results come from it, and so do the answers to commands that only ask. Where another command needs the
//! state of the engine, the journal has it.
//!
//! A state that is kept and one that is restored go on to the same bits, because what is remembered of earlier steps is forgotten
//! at the same steps in both runs: after fifty steps, and before a command that needs the state.

use crate::checks;
use crate::effect::Effect;
use crate::output::journal::format::{self, Ended, Event, Kept, Steps};
use crate::output::recorders::Recorders;
use crate::{Command, Outcome, Tcl, commands, warn};
use hysteron_engine::analysis::{Cause, Engine, Failure, Kind};
use hysteron_engine::bytes::checksum;
use hysteron_tcl::diagnostic::Diagnostic;
use hysteron_tcl::{Call, Exception, Value};

pub use crate::output::journal::{Journal, Keeping, Paths};

/// First bytes of a journal and of a checkpoint. The digest of the run follows.
pub const MAGICS: [&[u8]; 2] = [format::JOURNAL, format::CHECKPOINT];
/// Steps after which a state may be kept.
const PART: usize = 50;
/// Integrators whose next step depends on the state alone. Analyses with others are computed again.
const ONE_STEP: [&str; 5] = ["Newmark", "HHT", "GeneralizedAlpha", "WilsonTheta", "Collocation"];
/// Commands that neither need the state nor change it.
const SETTINGS: [&str; 5] = ["test", "algorithm", "reactions", "analyze", "version"];
const OTHER_COURSE: &str = "the script takes another course than before: does it depend on the clock?";

/// Read bytes as a journal, and as a checkpoint. Returns the number of events in either.
///
/// # Errors
/// They are neither.
pub fn events(bytes: &[u8], run: u64) -> Result<usize, &'static str> {
    format::journal(bytes, run).map(|events| events.len()).or_else(|_| format::read_checkpoint(bytes, run).map(|_| 1))
}

/// Keep a journal of what the commands of a script do. An earlier run's is used up first.
pub fn keep(interp: &mut Tcl, journal: Journal) {
    interp.host.output.recorders.journal = Some(Box::new(journal));
    for c in commands() {
        let run = match c.effect {
            _ if SETTINGS.contains(&c.name) => continue,
            Effect::Empties => wipe,
            Effect::Asks => ask,
            Effect::Nothing | Effect::Changes | Effect::ReadsState => change,
        };
        interp.register(c.name, run);
    }
}

fn command(call: &Call<'_>) -> Result<&'static Command, Exception> {
    let name = call.name();
    let name = name.rsplit("::").next().unwrap_or_default();
    let renamed = || Exception::error(format!("the command \"{name}\" was renamed, which checkpoints do not follow"));
    crate::command(name).ok_or_else(renamed)
}

fn refused(call: &Call<'_>, why: &str) -> Exception {
    Exception::diagnosed(Diagnostic::error(format!("checkpoint: {why}")).at(call.span(0), ""))
}

fn wipe(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    if let Some(journal) = &mut interp.host.output.recorders.journal {
        journal.forget_model();
    }
    (command(call)?.run)(interp, call)
}

/// A command that only asks: its answer comes from the journal, or goes there.
fn ask(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let command = command(call)?;
    let Some(journal) = interp.host.output.recorders.journal.as_mut().filter(|j| j.has_analysed) else {
        return (command.run)(interp, call);
    };
    let words = call
        .args()
        .iter()
        .fold(checksum(command.name.as_bytes()), |h, word| h.rotate_left(1) ^ checksum(word.as_str().as_bytes()));
    match journal.earlier.pop_front() {
        Some(Event::Answer { words: before, text }) if before == words => match text {
            Some(text) => Ok(Value::from(text)),
            None => (command.run)(interp, call),
        },
        Some(_) => Err(refused(call, OTHER_COURSE)),
        None => {
            let answer = (command.run)(interp, call);
            let text = answer.as_ref().ok().map(|value| value.as_str().into_owned());
            if let Some(journal) = &mut interp.host.output.recorders.journal {
                journal.add(&Event::Answer { words, text }).map_err(|why| refused(call, &why))?;
            }
            answer
        }
    }
}

/// A command that may need the state, or change it.
fn change(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let command = command(call)?;
    bring_up(interp).map_err(|why| refused(call, &why))?;
    (command.run)(interp, call)
}

/// Bring the engine to the state that the script believes it to have.
fn bring_up(interp: &mut Tcl) -> Result<(), String> {
    let (engine, recorders) = (&mut interp.host.engine, &mut interp.host.output.recorders);
    let Some(mut journal) = recorders.journal.take_if(|j| j.is_stale) else { return Ok(()) };
    let result = match journal.earlier.pop_front() {
        Some(Event::State(kept)) => restore(&journal, engine, recorders, kept),
        Some(_) => Err(OTHER_COURSE.to_owned()),
        None => {
            let kept = state(&journal, engine, recorders);
            journal.add(&Event::State(kept))
        }
    };
    (journal.is_stale, journal.since) = (false, 0);
    recorders.journal = Some(journal);
    result
}

fn state(journal: &Journal, engine: &mut Engine, recorders: &Recorders) -> Kept {
    let isolators = recorders.isolator_damping.energies();
    Kept { inputs: journal.inputs(), isolators, state: engine.save() }
}

fn restore(journal: &Journal, engine: &mut Engine, recorders: &mut Recorders, kept: Kept) -> Result<(), String> {
    if kept.inputs != journal.inputs() {
        return Err("the script, or a file that it reads, has changed since".into());
    }
    engine.restore_saved(kept.state)?;
    recorders.isolator_damping.go_on(engine, kept.isolators);
    Ok(())
}

/// Prepare an analysis. The engine has its state if it is computed, and not if the journal may know it.
pub(crate) fn before_analysis(interp: &mut Tcl, call: &Call<'_>) -> Result<(), Exception> {
    let session = &interp.host;
    if session.output.recorders.journal.is_none() {
        return Ok(());
    }
    if !is_kept(&session.engine) {
        return bring_up(interp).map_err(|why| refused(call, &why));
    }
    let mut recorders = session.output.recorders.by_tag.values();
    match recorders.find(|r| !r.recorder.can_repeat()) {
        Some(r) => {
            let file = r.file.as_deref().unwrap_or_default();
            Err(refused(call, &format!("the recorder of {file} writes more than rows, which are all it keeps")))
        }
        None => Ok(()),
    }
}

/// Warn, once, that there are no checkpoints any more.
pub(crate) fn warn_of_end(interp: &mut Tcl, call: &Call<'_>) -> Result<(), Exception> {
    let is_full = interp.host.output.recorders.journal.as_ref().is_some_and(|j| j.is_full());
    if !is_full || !interp.host.warnings.note(&checks::output::JOURNAL_FULL) {
        return Ok(());
    }
    let d = Diagnostic::warning(&checks::output::JOURNAL_FULL, "checkpoint: the run is longer than its journal may be");
    warn(interp, d.at(call.span(0), "no checkpoint is kept from here on"))
}

/// Returns true if the journal keeps what the analysis does.
fn is_kept(engine: &Engine) -> bool {
    engine.options.ladder.is_none()
        && engine.setup().is_some_and(|s| s.kind == Kind::Transient && ONE_STEP.contains(&s.integrator.name()))
}

/// Call of an analysis, which both runs must have in common.
#[derive(Clone, Copy)]
struct CheckpointRequest {
    steps: usize,
    dt: f64,
}

/// Make steps of an analysis as [`Engine::analyze`]. Those that the journal knows are not computed.
///
/// # Errors
/// The journal does not fit the run, or cannot be written.
pub(crate) fn analyze(
    engine: &mut Engine,
    recorders: &mut Recorders,
    steps: usize,
    dt: f64,
) -> Result<Result<(), Failure>, String> {
    let is_kept = is_kept(engine) && steps > 0;
    let Some(mut journal) = recorders.journal.take_if(|_| is_kept) else {
        return Ok(engine.analyze(steps, dt, recorders));
    };
    journal.calls += 1;
    journal.has_analysed = true;
    journal.rows.clear();
    let asked = CheckpointRequest { steps, dt };
    let replayed = replay(&mut journal, engine, recorders, asked);
    let begins = matches!(replayed, Ok(Replayed::Steps(0))) && journal.earlier.is_empty();
    if begins && journal.since == 0 && journal.is_due() {
        let kept = state(&journal, engine, recorders);
        journal.keep(&kept)?;
    }
    recorders.journal = Some(journal);
    match replayed? {
        Replayed::Ended(result) => Ok(result),
        Replayed::Steps(done) => compute(engine, recorders, asked, done),
    }
}

enum Replayed {
    Ended(Result<(), Failure>),
    Steps(usize),
}

/// Use what the journal knows of an analysis.
fn replay(
    journal: &mut Journal,
    engine: &mut Engine,
    recorders: &mut Recorders,
    asked: CheckpointRequest,
) -> Result<Replayed, String> {
    let mut done = 0;
    while let Some(event) = journal.earlier.pop_front() {
        let steps = match event {
            Event::Steps(steps) => steps,
            Event::Checkpoint(kept) => {
                restore(journal, engine, recorders, kept)?;
                break;
            }
            Event::Answer { .. } | Event::State(_) => return Err(OTHER_COURSE.into()),
        };
        let same = steps.call == journal.calls
            && (steps.asked, steps.dt.to_bits()) == (asked.steps as u64, asked.dt.to_bits())
            && (done as u64..=steps.asked).contains(&steps.done);
        if !same {
            return Err(OTHER_COURSE.into());
        }
        for row in steps.rows {
            let r = recorders.by_tag.get_mut(&row.recorder).ok_or("a recorder is missing")?;
            r.recorder.record_again(engine, row.time, row.numbers).map_err(|e| e.to_string())?;
        }
        recorders.printed.push_str(&steps.printed);
        journal.is_stale = true;
        journal.since = (journal.since + steps.done as usize - done) % PART;
        done = steps.done as usize;
        match steps.ended {
            Ended::Not => {}
            Ended::Done => return Ok(Replayed::Ended(Ok(()))),
            Ended::Failed(failure) => return Ok(Replayed::Ended(Err(failure.of(engine)))),
        }
    }
    Ok(Replayed::Steps(done))
}

/// Compute the steps that are left.
fn compute(
    engine: &mut Engine,
    recorders: &mut Recorders,
    asked: CheckpointRequest,
    mut done: usize,
) -> Result<Result<(), Failure>, String> {
    let mut printed = recorders.printed.len();
    loop {
        let since = recorders.journal.as_ref().map_or(0, |j| j.since);
        let part = (PART - since).min(asked.steps - done);
        let result = engine.analyze(part, asked.dt, recorders);
        if result.as_ref().is_err_and(|f| f.cause == Cause::Interrupted) {
            return Ok(result);
        }
        done += part;
        let Some(mut journal) = recorders.journal.take() else { return Ok(result) };
        journal.is_stale = true;
        journal.since = (since + part) % PART;
        if journal.since == 0 {
            engine.forget_work();
        }
        let ended = match &result {
            Err(failure) => Ended::Failed(failure.into()),
            Ok(()) if done == asked.steps => Ended::Done,
            Ok(()) => Ended::Not,
        };
        let has_ended = !matches!(ended, Ended::Not);
        if has_ended || journal.is_due() {
            journal.add_steps(Steps {
                call: journal.calls,
                asked: asked.steps as u64,
                dt: asked.dt,
                done: done as u64,
                ended,
                printed: recorders.printed.get(printed..).unwrap_or_default().to_owned(),
                rows: vec![],
            })?;
            printed = recorders.printed.len();
        }
        if !has_ended && journal.is_due() {
            let kept = state(&journal, engine, recorders);
            journal.keep(&kept)?;
        }
        recorders.journal = Some(journal);
        if has_ended {
            return Ok(result);
        }
    }
}

//! Checkpoints of long time histories, and runs that go on from them.
//!
//! A run that goes on executes its script again. Transient analyses are not computed as far as the journal knows them: rows of
//! recorders, the result and the state at the end come from it. All other commands act on that state as they did before.
//!
//! A state that is kept and one that is restored go on to the same bits. So every analysis is made in parts of [`PART`] steps,
//! after which what is remembered of earlier steps is forgotten, with or without a kill.

mod frame;

use crate::session::{PlacedRecorder, Recorders};
use frame::{Ended, Frame, Row};
use hysteron_engine::analysis::{Cause, Engine, Failure};
use hysteron_engine::model::Tag;
use hysteron_engine::record::RecordError;
use std::collections::BTreeMap;
use std::collections::VecDeque;
use std::fs::{File, OpenOptions};
use std::io::{Read as _, Seek as _, SeekFrom, Write as _};
use std::path::Path;
use std::time::{Duration, Instant};

pub use frame::{Checkpoints, parse};

/// Steps after which a state may be kept.
const PART: usize = 50;
/// Largest journal, in bytes. A larger one is not continued.
const MAX_SIZE: u64 = 4 << 30;
/// Integrators whose next step depends on the state alone. Analyses with others are computed again.
const ONE_STEP: [&str; 5] = ["Newmark", "HHT", "GeneralizedAlpha", "WilsonTheta", "Collocation"];

/// The journal of a run: checkpoints of an earlier one that are used up first, and new ones.
pub struct Journal {
    file: File,
    size: u64,
    interval: Duration,
    last: Instant,
    /// Checkpoints of the earlier run that are still to be used.
    earlier: VecDeque<Frame>,
    /// Digest of the files that the script has read so far.
    inputs: Box<dyn Fn() -> u64>,
    /// Analyses so far.
    calls: u64,
    /// Rows since the last checkpoint.
    rows: Vec<Row>,
    /// Checkpoints that are not written yet.
    pending: Vec<u8>,
}

impl Journal {
    /// Begin a journal for a run of this digest.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn create(path: &Path, run: u64, interval: Duration, inputs: Box<dyn Fn() -> u64>) -> Result<Self, String> {
        let cannot = |e: std::io::Error| format!("cannot write {}: {e}", path.display());
        // Made anew, so that no link under this name is followed.
        match std::fs::remove_file(path) {
            Err(e) if e.kind() != std::io::ErrorKind::NotFound => return Err(cannot(e)),
            _ => {}
        }
        let mut file = OpenOptions::new().write(true).create_new(true).open(path).map_err(cannot)?;
        let head = frame::head(run);
        file.write_all(&head).and_then(|()| file.sync_data()).map_err(cannot)?;
        Ok(Self::new(file, head.len() as u64, VecDeque::new(), interval, inputs))
    }

    /// Go on with the journal of an earlier run. What a kill has cut off its end is left out.
    ///
    /// # Errors
    /// There is none, or it is damaged, or that of another run.
    pub fn resume(path: &Path, run: u64, interval: Duration, inputs: Box<dyn Fn() -> u64>) -> Result<Self, String> {
        let cannot = |e: std::io::Error| format!("cannot resume from {}: {e}", path.display());
        let mut file = OpenOptions::new().read(true).write(true).open(path).map_err(cannot)?;
        let mut bytes = vec![];
        (&mut file).take(MAX_SIZE).read_to_end(&mut bytes).map_err(cannot)?;
        let refused = |why: &str| format!("cannot resume from {}: {why}", path.display());
        let found = parse(&bytes).map_err(refused)?;
        if found.run != run {
            return Err(refused("it is that of a run with other arguments, options or another version"));
        }
        file.set_len(found.length).and_then(|()| file.seek(SeekFrom::End(0))).map_err(cannot)?;
        Ok(Self::new(file, found.length, found.frames.into(), interval, inputs))
    }

    fn new(file: File, size: u64, earlier: VecDeque<Frame>, interval: Duration, inputs: Box<dyn Fn() -> u64>) -> Self {
        let (rows, pending) = (vec![], vec![]);
        Self { file, size, interval, last: Instant::now(), earlier, inputs, calls: 0, rows, pending }
    }

    /// Record the committed state, and note the rows.
    pub(crate) fn record(
        &mut self,
        recorders: &mut BTreeMap<Tag, PlacedRecorder>,
        engine: &mut Engine,
    ) -> Result<(), RecordError> {
        for (tag, r) in recorders {
            if r.recorder.record(engine)? {
                self.rows.push(Row {
                    recorder: *tag,
                    time: engine.state().time,
                    numbers: r.recorder.last_row().to_vec(),
                });
            }
        }
        Ok(())
    }

    fn is_due(&self) -> bool {
        self.last.elapsed() >= self.interval
    }

    /// Add a checkpoint, and write all of them if it is time to.
    fn add(&mut self, frame: &Frame) -> Result<(), String> {
        if self.size + self.pending.len() as u64 <= MAX_SIZE {
            self.pending.extend(frame.to_bytes());
        }
        if !self.is_due() {
            return Ok(());
        }
        let written = self.file.write_all(&self.pending).and_then(|()| self.file.sync_data());
        written.map_err(|e| format!("it cannot be written: {e}"))?;
        self.size += self.pending.len() as u64;
        self.pending.clear();
        self.last = Instant::now();
        Ok(())
    }
}

/// The call of an analysis, which both runs must have in common.
#[derive(Clone, Copy)]
struct Asked {
    steps: usize,
    dt: f64,
}

/// Make steps of a transient analysis as [`Engine::analyze`], as far as the journal does not know them.
///
/// # Errors
/// The journal does not fit the run, or cannot be written.
pub(crate) fn analyze(
    engine: &mut Engine,
    recorders: &mut Recorders,
    steps: usize,
    dt: f64,
) -> Result<Result<(), Failure>, String> {
    let one_step = engine.setup().is_some_and(|s| ONE_STEP.contains(&s.integrator.name()));
    let by_state_alone = one_step && engine.options.ladder.is_none() && steps > 0;
    let Some(mut journal) = recorders.journal.take().filter(|_| by_state_alone) else {
        return Ok(engine.analyze(steps, dt, recorders));
    };
    journal.calls += 1;
    let asked = Asked { steps, dt };
    let done = match replay(&mut journal, engine, recorders, asked) {
        Ok(Replayed::Ended(result)) => Ok(result),
        Ok(Replayed::Steps(done)) => {
            recorders.journal = Some(journal);
            return compute(engine, recorders, asked, done);
        }
        Err(why) => Err(why),
    };
    recorders.journal = Some(journal);
    done
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
    asked: Asked,
) -> Result<Replayed, String> {
    let mut done = 0;
    while let Some(frame) = journal.earlier.pop_front() {
        if frame.inputs != (journal.inputs)() {
            return Err("the script, or a file that it reads, has changed since".into());
        }
        let same = frame.call == journal.calls
            && (frame.steps, frame.dt.to_bits()) == (asked.steps as u64, asked.dt.to_bits())
            && frame.done <= frame.steps;
        if !same {
            return Err("the script takes another course than before: does it depend on the clock?".into());
        }
        for row in frame.rows {
            let r = recorders.by_tag.get_mut(&row.recorder).ok_or("a recorder is missing")?;
            r.recorder.record_again(engine, row.time, row.numbers).map_err(|e| e.to_string())?;
        }
        recorders.printed.push_str(&frame.printed);
        engine.restore_saved(frame.state)?;
        done = frame.done as usize;
        match frame.ended {
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
    asked: Asked,
    mut done: usize,
) -> Result<Result<(), Failure>, String> {
    let mut printed = recorders.printed.len();
    loop {
        let part = PART.min(asked.steps - done);
        let result = engine.analyze(part, asked.dt, recorders);
        if result.as_ref().is_err_and(|f| f.cause == Cause::Interrupted) {
            return Ok(result);
        }
        let state = engine.save();
        engine.restore_saved(state.clone())?;
        done += part;
        let Some(journal) = &mut recorders.journal else { return Ok(result) };
        let ended = match &result {
            Err(failure) => Ended::Failed(failure.into()),
            Ok(()) if done == asked.steps => Ended::Done,
            Ok(()) => Ended::Not,
        };
        let has_ended = !matches!(ended, Ended::Not);
        if has_ended || journal.is_due() {
            let frame = Frame {
                inputs: (journal.inputs)(),
                call: journal.calls,
                steps: asked.steps as u64,
                dt: asked.dt,
                done: done as u64,
                ended,
                printed: recorders.printed.get(printed..).unwrap_or_default().to_owned(),
                rows: std::mem::take(&mut journal.rows),
                state,
            };
            printed = recorders.printed.len();
            journal.add(&frame)?;
        }
        if has_ended {
            return Ok(result);
        }
    }
}

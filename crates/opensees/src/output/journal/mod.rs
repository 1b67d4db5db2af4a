//! The file of a run's events, and that of its last checkpoint.

pub(crate) mod format;

use self::format::{CHECKPOINT, Event, JOURNAL, Kept, Row, Steps, checkpoint, head, journal, read_checkpoint};
use crate::output::recorders::PlacedRecorder;
use hysteron_engine::analysis::Engine;
use hysteron_engine::bytes::Writer;
use hysteron_engine::model::Tag;
use hysteron_engine::record::RecordError;
use hysteron_files::{Access, File};
use std::collections::{BTreeMap, VecDeque};
use std::io::{ErrorKind, Read as _, Seek as _, SeekFrom, Write as _};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Largest journal, in bytes. There is no checkpoint of what comes after it.
const MAX_SIZE: u64 = 4 << 30;
/// Events that are held back, in bytes.
const MAX_PENDING: usize = 1 << 20;

/// Files of the checkpoints of a run.
#[derive(Clone, Debug)]
pub struct Paths {
    /// Events.
    pub journal: PathBuf,
    /// The last checkpoint.
    pub checkpoint: PathBuf,
}

impl Paths {
    /// Remove the files of a run that has come to its end.
    pub fn remove(&self) {
        for path in [&self.checkpoint, &self.journal] {
            // A file that stays is refused by a run with other arguments, and used up by the same.
            let _ = hysteron_files::remove(path);
        }
    }
}

/// The journal of a run: events of an earlier one that are used up first, and new ones.
pub struct Journal {
    paths: Paths,
    /// Digest of the run.
    run: u64,
    file: File,
    size: u64,
    interval: Duration,
    last: Instant,
    /// Events of the earlier run that are still to be used. The last one is its checkpoint.
    pub(crate) earlier: VecDeque<Event>,
    /// Digest of the files that the script has read so far.
    inputs: Box<dyn Fn() -> u64>,
    /// Analyses so far.
    pub(crate) calls: u64,
    /// Rows that are in no event yet.
    pub(crate) rows: Vec<Row>,
    /// Events that are not written yet.
    pending: Writer,
    is_full: bool,
    /// Answers depend on an analysis that the journal knows.
    pub(crate) has_analysed: bool,
    /// The state of the engine has changed since the last one in the journal.
    pub(crate) is_stale: bool,
    /// Steps since what is remembered of earlier ones was forgotten.
    pub(crate) since: usize,
}

/// Files and interval of checkpoints.
pub struct Keeping {
    /// Their files.
    pub paths: Paths,
    /// Digest of what the run depends on besides the files that it reads.
    pub run: u64,
    /// Time between two checkpoints.
    pub interval: Duration,
    /// Digest of the files that the script has read so far.
    pub inputs: Box<dyn Fn() -> u64>,
}

impl Journal {
    /// Begin a journal.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn create(keeping: Keeping) -> Result<Self, String> {
        let path = &keeping.paths.journal;
        let cannot = |e: std::io::Error| format!("cannot write {}: {e}", path.display());
        check_own(path, JOURNAL)?;
        check_own(&keeping.paths.checkpoint, CHECKPOINT)?;
        // Locked before the files of another run that is at work are touched.
        let mut file = hysteron_files::open_alone(path).map_err(cannot)?;
        match hysteron_files::remove(&keeping.paths.checkpoint) {
            Err(e) if e.kind() != ErrorKind::NotFound => return Err(cannot_write(&keeping.paths.checkpoint, &e)),
            _ => {}
        }
        file.set_len(0).map_err(cannot)?;
        let head = head(keeping.run);
        file.write_all(&head).and_then(|()| file.sync_data()).map_err(cannot)?;
        Ok(Self::new(keeping, file, head.len() as u64, VecDeque::new()))
    }

    /// Go on from the checkpoint of an earlier run; `None` if there is none. What came after it is left out.
    ///
    /// # Errors
    /// It is damaged, or that of another run.
    pub fn resume(keeping: Keeping) -> Result<Option<Self>, String> {
        let Paths { journal: path, checkpoint } = &keeping.paths;
        let refused = |path: &Path, why: &str| format!("cannot resume from {}: {why}", path.display());
        let bytes = match hysteron_files::read(checkpoint) {
            Err(e) if e.kind() == ErrorKind::NotFound => return Ok(None),
            other => other.map_err(|e| refused(checkpoint, &e.to_string()))?,
        };
        let (length, kept) = read_checkpoint(&bytes, keeping.run).map_err(|why| refused(checkpoint, why))?;
        let cannot = |e: std::io::Error| refused(path, &e.to_string());
        hysteron_files::link_info(path).map_err(cannot)?;
        let mut file = hysteron_files::open_alone(path).map_err(cannot)?;
        let mut bytes = vec![];
        (&mut file).take(length.min(MAX_SIZE)).read_to_end(&mut bytes).map_err(cannot)?;
        let mut events = journal(&bytes, keeping.run).map_err(|why| refused(path, why))?;
        if bytes.len() as u64 != length {
            return Err(refused(path, "it is damaged"));
        }
        events.push(Event::Checkpoint(kept));
        file.set_len(length).and_then(|()| file.seek(SeekFrom::End(0))).map_err(cannot)?;
        Ok(Some(Self::new(keeping, file, length, events.into())))
    }

    fn new(keeping: Keeping, file: File, size: u64, earlier: VecDeque<Event>) -> Self {
        let Keeping { paths, run, interval, inputs } = keeping;
        Self {
            paths,
            run,
            file,
            size,
            interval,
            last: Instant::now(),
            earlier,
            inputs,
            calls: 0,
            rows: vec![],
            pending: Writer::default(),
            is_full: false,
            has_analysed: false,
            is_stale: false,
            since: 0,
        }
    }

    /// Record the committed state, and note the rows.
    pub(crate) fn record(
        &mut self,
        recorders: &mut BTreeMap<Tag, PlacedRecorder>,
        engine: &mut Engine,
    ) -> Result<(), RecordError> {
        for (tag, r) in recorders {
            if r.recorder.record(engine)? {
                let (time, numbers) = (engine.state().time, r.recorder.last_row().to_vec());
                self.rows.push(Row { recorder: *tag, time, numbers });
            }
        }
        Ok(())
    }

    /// The model is gone, and all that was recorded of it.
    pub(crate) fn forget_model(&mut self) {
        (self.has_analysed, self.is_stale, self.since) = (false, false, 0);
        self.rows.clear();
    }

    /// Returns true if the engine has not the state of the steps that came last.
    pub(crate) fn repeats(&self) -> bool {
        self.is_stale && !self.earlier.is_empty()
    }

    pub(crate) fn is_due(&self) -> bool {
        !self.is_full && self.last.elapsed() >= self.interval
    }

    pub(crate) fn inputs(&self) -> u64 {
        (self.inputs)()
    }

    /// Add steps, with the rows that are noted.
    pub(crate) fn add_steps(&mut self, mut steps: Steps) -> Result<(), String> {
        steps.rows = std::mem::take(&mut self.rows);
        self.add(&Event::Steps(steps))
    }

    /// Add an event. A full journal takes none.
    pub(crate) fn add(&mut self, event: &Event) -> Result<(), String> {
        if self.is_full {
            return Ok(());
        }
        event.write(&mut self.pending);
        if self.pending.0.len() > MAX_PENDING { self.write() } else { Ok(()) }
    }

    fn write(&mut self) -> Result<(), String> {
        let mut block = Writer::default();
        block.block(&std::mem::take(&mut self.pending.0));
        self.is_full = self.size + block.0.len() as u64 > MAX_SIZE;
        if self.is_full {
            return Ok(());
        }
        self.file.write_all(&block.0).map_err(|e| cannot_write(&self.paths.journal, &e))?;
        self.size += block.0.len() as u64;
        Ok(())
    }

    /// Keep a checkpoint. It is valid once it has its name, and so has all that it depends on.
    pub(crate) fn keep(&mut self, kept: &Kept) -> Result<(), String> {
        self.write()?;
        if self.is_full {
            return Ok(());
        }
        self.file.sync_data().map_err(|e| cannot_write(&self.paths.journal, &e))?;
        let path = &self.paths.checkpoint;
        let bytes = checkpoint(self.run, self.size, kept);
        hysteron_files::write_durably(path, &bytes).map_err(|e| cannot_write(path, &e))?;
        self.last = Instant::now();
        Ok(())
    }

    /// Returns true if the run is longer than its journal may be.
    pub(crate) fn is_full(&self) -> bool {
        self.is_full
    }
}

/// Refuse to replace a file that is no file of checkpoints: it may be the script.
///
/// # Errors
/// There is such a file.
fn check_own(path: &Path, magic: &[u8]) -> Result<(), String> {
    let Ok(info) = hysteron_files::link_info(path) else { return Ok(()) };
    let mut first = vec![];
    if info.is_file() {
        let file = hysteron_files::open(path, Access { read: true, ..Access::default() });
        let read = file.and_then(|file| file.take(magic.len() as u64).read_to_end(&mut first));
        read.map_err(|e| cannot_write(path, &e))?;
    }
    // A link is replaced and not followed; a run that was killed at once has left an empty file.
    if info.file_type().is_symlink() || info.is_file() && magic.starts_with(&first) {
        return Ok(());
    }
    Err(format!("{} is no file of checkpoints, and would be replaced by one: give it another name", path.display()))
}

fn cannot_write(path: &Path, e: &std::io::Error) -> String {
    format!("cannot write {}: {e}", path.display())
}

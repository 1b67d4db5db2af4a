//! The journal and the checkpoint as bytes.
//!
//! The journal begins with a magic word and the digest of the run. Blocks of events follow, each with its length and a checksum,
//! so that one that was cut off is recognised. The checkpoint is a file of its own: a state, and the length of the journal then.

use hysteron_engine::analysis::{Cause, Engine, Failure, SavedState};
use hysteron_engine::bytes::{Reader, Writer};
use hysteron_engine::model::Tag;

pub(crate) const JOURNAL: &[u8; 8] = b"hystjr\x00\x01";
pub(crate) const CHECKPOINT: &[u8; 8] = b"hystcp\x00\x03";
/// A file that is none of ours.
const FOREIGN: &str = "it is no file of checkpoints of this version";
const DAMAGED: &str = "it is damaged";
const OF_ANOTHER_RUN: &str = "it is that of a run with other arguments, options or another version";

/// A row of a recorder.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Row {
    pub(crate) recorder: Tag,
    pub(crate) time: f64,
    pub(crate) numbers: Vec<f64>,
}

/// A failure as it can be written.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct WrittenFailure {
    kind: u64,
    numbers: [f64; 4],
    words: [String; 2],
    place: Option<String>,
    code: i32,
}

impl From<&Failure> for WrittenFailure {
    fn from(f: &Failure) -> Self {
        let none = || [String::new(), String::new()];
        let (kind, [a, b, c], words) = match &f.cause {
            Cause::NotConverged { norm, tolerance, iterations, .. } => {
                (0, [*norm, *tolerance, *iterations as f64], none())
            }
            Cause::NotFinite => (1, [0.0; 3], none()),
            Cause::Singular => (2, [0.0; 3], none()),
            Cause::OutOfMemory => (3, [0.0; 3], none()),
            Cause::Element { element, message } => (4, [0.0; 3], [element.clone(), message.clone()]),
            Cause::Model(message) => (5, [0.0; 3], [message.clone(), String::new()]),
            Cause::Interrupted => (6, [0.0; 3], none()),
        };
        Self { kind, numbers: [a, b, c, f.time], words, place: f.place.clone(), code: f.code }
    }
}

impl WrittenFailure {
    /// The failure, of an engine with the same convergence test.
    pub(crate) fn of(self, engine: &Engine) -> Failure {
        let ([norm, tolerance, iterations, time], [first, second]) = (self.numbers, self.words);
        let cause = match self.kind {
            0 => {
                let test = engine.setup().map_or("", |s| s.test.measure.name());
                Cause::NotConverged { norm, tolerance, iterations: iterations as usize, test }
            }
            1 => Cause::NotFinite,
            2 => Cause::Singular,
            3 => Cause::OutOfMemory,
            4 => Cause::Element { element: first, message: second },
            5 => Cause::Model(first),
            _ => Cause::Interrupted,
        };
        Failure::new(cause, time, self.code).at(self.place)
    }
}

/// End of a part of an analysis.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Ended {
    /// The analysis goes on.
    Not,
    Done,
    Failed(WrittenFailure),
}

/// Steps of a transient analysis.
#[derive(Clone, Debug)]
pub(crate) struct Steps {
    /// Number of the analysis.
    pub(crate) call: u64,
    /// Steps that the analysis was asked for.
    pub(crate) asked: u64,
    pub(crate) dt: f64,
    /// Steps of the analysis so far.
    pub(crate) done: u64,
    pub(crate) ended: Ended,
    pub(crate) printed: String,
    pub(crate) rows: Vec<Row>,
}

/// A state of the engine, and what belongs to it.
#[derive(Clone, Debug)]
pub(crate) struct Kept {
    /// Digest of the files that were read before.
    pub(crate) inputs: u64,
    /// Damping and force energies of the isolators.
    pub(crate) isolators: [f64; 2],
    pub(crate) state: SavedState,
}

/// An event of a run.
#[derive(Clone, Debug)]
pub(crate) enum Event {
    /// The result of a command that only asks; none if it raised an error.
    Answer {
        words: u64,
        text: Option<String>,
    },
    Steps(Steps),
    /// The state that a command needed.
    State(Kept),
    /// The state that a run goes on from. It stands in a file of its own.
    Checkpoint(Kept),
}

/// First bytes of the journal of a run.
pub(crate) fn head(run: u64) -> Vec<u8> {
    [&JOURNAL[..], &run.to_le_bytes()].concat()
}

/// Read the journal of a run.
///
/// # Errors
/// It is none, or damaged, or that of another run.
pub(crate) fn journal(bytes: &[u8], run: u64) -> Result<Vec<Event>, &'static str> {
    let mut r = Reader(bytes.strip_prefix(JOURNAL).ok_or(FOREIGN)?);
    if r.number().ok_or(FOREIGN)? != run {
        return Err(OF_ANOTHER_RUN);
    }
    let mut events = vec![];
    while !r.0.is_empty() {
        let content = r.block().ok_or(DAMAGED)?;
        let mut inner = Reader(content);
        while !inner.0.is_empty() {
            events.push(Event::read(&mut inner).ok_or(DAMAGED)?);
        }
    }
    Ok(events)
}

/// The checkpoint of a run whose journal has this length.
pub(crate) fn checkpoint(run: u64, length: u64, kept: &Kept) -> Vec<u8> {
    let mut content = Writer::default();
    content.number(length);
    kept.write(&mut content);
    let mut w = Writer([&CHECKPOINT[..], &run.to_le_bytes()].concat());
    w.block(&content.0);
    w.0
}

/// Read the checkpoint of a run: the length of the journal in bytes, and the state.
///
/// # Errors
/// It is none, or damaged, or that of another run.
pub(crate) fn read_checkpoint(bytes: &[u8], run: u64) -> Result<(u64, Kept), &'static str> {
    let mut r = Reader(bytes.strip_prefix(CHECKPOINT).ok_or(FOREIGN)?);
    if r.number().ok_or(FOREIGN)? != run {
        return Err(OF_ANOTHER_RUN);
    }
    let mut inner = Reader(r.block().ok_or(DAMAGED)?);
    let length = inner.number().ok_or(DAMAGED)?;
    Ok((length, Kept::read(&mut inner).ok_or(DAMAGED)?))
}

impl Kept {
    fn write(&self, w: &mut Writer) {
        w.number(self.inputs);
        self.isolators.iter().for_each(|x| w.float(*x));
        w.bytes(&self.state.to_bytes());
    }

    fn read(r: &mut Reader<'_>) -> Option<Self> {
        let (inputs, isolators) = (r.number()?, [r.float()?, r.float()?]);
        Some(Self { inputs, isolators, state: SavedState::from_bytes(r.bytes()?)? })
    }
}

impl Event {
    pub(crate) fn write(&self, w: &mut Writer) {
        match self {
            Self::Answer { words, text } => {
                w.0.push(if text.is_some() { 0 } else { 1 });
                w.number(*words);
                text.iter().for_each(|t| w.bytes(t.as_bytes()));
            }
            Self::Steps(steps) => {
                w.0.push(2);
                steps.write(w);
            }
            Self::State(kept) => {
                w.0.push(3);
                kept.write(w);
            }
            // It stands in a file of its own.
            Self::Checkpoint(_) => {}
        }
    }

    fn read(r: &mut Reader<'_>) -> Option<Self> {
        Some(match r.byte()? {
            0 => Self::Answer { words: r.number()?, text: Some(r.text()?) },
            1 => Self::Answer { words: r.number()?, text: None },
            2 => Self::Steps(Steps::read(r)?),
            3 => Self::State(Kept::read(r)?),
            _ => return None,
        })
    }
}

impl Row {
    fn write(&self, w: &mut Writer) {
        w.number(i64::from(self.recorder) as u64);
        w.float(self.time);
        w.floats(&self.numbers);
    }

    fn read(r: &mut Reader<'_>) -> Option<Self> {
        Some(Self { recorder: Tag::try_from(r.number()? as i64).ok()?, time: r.float()?, numbers: r.floats()? })
    }
}

impl WrittenFailure {
    fn write(&self, w: &mut Writer) {
        w.number(self.kind);
        self.numbers.iter().for_each(|x| w.float(*x));
        self.words.iter().for_each(|x| w.bytes(x.as_bytes()));
        w.number(u64::from(self.place.is_some()));
        self.place.iter().for_each(|p| w.bytes(p.as_bytes()));
        w.number(i64::from(self.code) as u64);
    }

    fn read(r: &mut Reader<'_>) -> Option<Self> {
        let kind = r.number()?;
        let numbers = [r.float()?, r.float()?, r.float()?, r.float()?];
        let words = [r.text()?, r.text()?];
        let place = if r.number()? == 1 { Some(r.text()?) } else { None };
        Some(Self { kind, numbers, words, place, code: r.number()? as i64 as i32 })
    }
}

impl Steps {
    fn write(&self, w: &mut Writer) {
        [self.call, self.asked, self.dt.to_bits(), self.done].into_iter().for_each(|x| w.number(x));
        match &self.ended {
            Ended::Not => w.number(0),
            Ended::Done => w.number(1),
            Ended::Failed(failure) => {
                w.number(2);
                failure.write(w);
            }
        }
        w.bytes(self.printed.as_bytes());
        w.number(self.rows.len() as u64);
        self.rows.iter().for_each(|row| row.write(w));
    }

    fn read(r: &mut Reader<'_>) -> Option<Self> {
        let (call, asked, dt, done) = (r.number()?, r.number()?, r.float()?, r.number()?);
        let ended = match r.number()? {
            0 => Ended::Not,
            1 => Ended::Done,
            2 => Ended::Failed(WrittenFailure::read(r)?),
            _ => return None,
        };
        let printed = r.text()?;
        let count = r.number()?;
        let rows = (0..count).map(|_| Row::read(r)).collect::<Option<_>>()?;
        Some(Self { call, asked, dt, done, ended, printed, rows })
    }
}

//! The journal and the checkpoint as bytes.
//!
//! The journal begins with a magic word and the digest of the run. Blocks of events follow, each with its length and a checksum,
//! so that one that was cut off is recognised. The checkpoint is a file of its own: a state, and the length of the journal then.

use hysteron_engine::analysis::{Cause, Engine, Failure, SavedState};
use hysteron_engine::model::Tag;

pub(super) const JOURNAL: &[u8; 8] = b"hystjr\x00\x01";
pub(super) const CHECKPOINT: &[u8; 8] = b"hystcp\x00\x02";
/// A file that is none of ours.
const FOREIGN: &str = "it is no file of checkpoints of this version";
const DAMAGED: &str = "it is damaged";
const OF_ANOTHER_RUN: &str = "it is that of a run with other arguments, options or another version";

/// A row of a recorder.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Row {
    pub(super) recorder: Tag,
    pub(super) time: f64,
    pub(super) numbers: Vec<f64>,
}

/// A failure as it can be written.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct WrittenFailure {
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
    pub(super) fn of(self, engine: &Engine) -> Failure {
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

/// How a part of an analysis ended.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Ended {
    /// The analysis goes on.
    Not,
    Done,
    Failed(WrittenFailure),
}

/// Steps of a transient analysis.
#[derive(Clone, Debug)]
pub(super) struct Steps {
    /// Number of the analysis.
    pub(super) call: u64,
    /// Steps that the analysis was asked for.
    pub(super) asked: u64,
    pub(super) dt: f64,
    /// Steps of the analysis so far.
    pub(super) done: u64,
    pub(super) ended: Ended,
    pub(super) printed: String,
    pub(super) rows: Vec<Row>,
}

/// A state of the engine, and what belongs to it.
#[derive(Clone, Debug)]
pub(super) struct Kept {
    /// Digest of the files that were read before.
    pub(super) inputs: u64,
    /// Damping and force energies of the isolators.
    pub(super) isolators: [f64; 2],
    pub(super) state: SavedState,
}

/// An event of a run.
#[derive(Clone, Debug)]
pub(super) enum Event {
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

/// FNV-1a: the same on every machine.
pub(super) fn checksum<'a>(bytes: impl IntoIterator<Item = &'a u8>) -> u64 {
    bytes.into_iter().fold(0xcbf2_9ce4_8422_2325, |h, b| (h ^ u64::from(*b)).wrapping_mul(0x0100_0000_01b3))
}

/// First bytes of the journal of a run.
pub(super) fn head(run: u64) -> Vec<u8> {
    [&JOURNAL[..], &run.to_le_bytes()].concat()
}

/// A block of the journal: length, content and checksum.
pub fn block(content: &[u8]) -> Vec<u8> {
    let mut w = Writer::default();
    w.bytes(content);
    w.number(checksum(content));
    w.0
}

/// Read the journal of a run.
///
/// # Errors
/// It is none, or damaged, or that of another run.
pub(super) fn journal(bytes: &[u8], run: u64) -> Result<Vec<Event>, &'static str> {
    let mut r = Reader(bytes.strip_prefix(JOURNAL).ok_or(FOREIGN)?);
    if r.number().ok_or(FOREIGN)? != run {
        return Err(OF_ANOTHER_RUN);
    }
    let mut events = vec![];
    while !r.0.is_empty() {
        let content = r.block().ok_or(DAMAGED)?;
        let mut inner = Reader(content);
        while !inner.0.is_empty() {
            events.push(inner.event().ok_or(DAMAGED)?);
        }
    }
    Ok(events)
}

/// The checkpoint of a run whose journal has this length.
pub(super) fn checkpoint(run: u64, length: u64, kept: &Kept) -> Vec<u8> {
    let mut w = Writer::default();
    w.number(length);
    w.kept(kept);
    [&CHECKPOINT[..], &run.to_le_bytes(), &block(&w.0)].concat()
}

/// Read the checkpoint of a run: the length of the journal in bytes, and the state.
///
/// # Errors
/// It is none, or damaged, or that of another run.
pub(super) fn read_checkpoint(bytes: &[u8], run: u64) -> Result<(u64, Kept), &'static str> {
    let mut r = Reader(bytes.strip_prefix(CHECKPOINT).ok_or(FOREIGN)?);
    if r.number().ok_or(FOREIGN)? != run {
        return Err(OF_ANOTHER_RUN);
    }
    let mut inner = Reader(r.block().ok_or(DAMAGED)?);
    let length = inner.number().ok_or(DAMAGED)?;
    Ok((length, inner.kept().ok_or(DAMAGED)?))
}

/// Numbers and texts one after the other.
#[derive(Default)]
pub(super) struct Writer(pub(super) Vec<u8>);

impl Writer {
    fn number(&mut self, x: u64) {
        self.0.extend(x.to_le_bytes());
    }

    fn bytes(&mut self, bytes: &[u8]) {
        self.number(bytes.len() as u64);
        self.0.extend(bytes);
    }

    fn kept(&mut self, kept: &Kept) {
        self.number(kept.inputs);
        kept.isolators.iter().for_each(|x| self.number(x.to_bits()));
        self.bytes(&kept.state.to_bytes());
    }

    pub(super) fn event(&mut self, event: &Event) {
        match event {
            Event::Answer { words, text } => {
                self.0.push(if text.is_some() { 0 } else { 1 });
                self.number(*words);
                text.iter().for_each(|t| self.bytes(t.as_bytes()));
            }
            Event::Steps(steps) => {
                self.0.push(2);
                self.steps(steps);
            }
            Event::State(kept) => {
                self.0.push(3);
                self.kept(kept);
            }
            Event::Checkpoint(_) => {}
        }
    }

    fn steps(&mut self, s: &Steps) {
        [s.call, s.asked, s.dt.to_bits(), s.done].into_iter().for_each(|x| self.number(x));
        match &s.ended {
            Ended::Not => self.number(0),
            Ended::Done => self.number(1),
            Ended::Failed(f) => {
                self.number(2);
                self.number(f.kind);
                f.numbers.iter().for_each(|x| self.number(x.to_bits()));
                f.words.iter().for_each(|x| self.bytes(x.as_bytes()));
                self.number(u64::from(f.place.is_some()));
                f.place.iter().for_each(|p| self.bytes(p.as_bytes()));
                self.number(i64::from(f.code) as u64);
            }
        }
        self.bytes(s.printed.as_bytes());
        self.number(s.rows.len() as u64);
        for row in &s.rows {
            self.number(i64::from(row.recorder) as u64);
            self.number(row.time.to_bits());
            self.bytes(&row.numbers.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<_>>());
        }
    }
}

struct Reader<'a>(&'a [u8]);

impl<'a> Reader<'a> {
    fn number(&mut self) -> Option<u64> {
        let (first, rest) = self.0.split_first_chunk()?;
        self.0 = rest;
        Some(u64::from_le_bytes(*first))
    }

    fn float(&mut self) -> Option<f64> {
        self.number().map(f64::from_bits)
    }

    fn bytes(&mut self) -> Option<&'a [u8]> {
        let n = usize::try_from(self.number()?).ok()?;
        let (first, rest) = self.0.split_at_checked(n)?;
        self.0 = rest;
        Some(first)
    }

    fn block(&mut self) -> Option<&'a [u8]> {
        let content = self.bytes()?;
        (self.number()? == checksum(content)).then_some(content)
    }

    fn text(&mut self) -> Option<String> {
        String::from_utf8(self.bytes()?.to_vec()).ok()
    }

    fn kept(&mut self) -> Option<Kept> {
        let (inputs, isolators) = (self.number()?, [self.float()?, self.float()?]);
        Some(Kept { inputs, isolators, state: SavedState::from_bytes(self.bytes()?)? })
    }

    fn event(&mut self) -> Option<Event> {
        let (kind, rest) = self.0.split_first()?;
        self.0 = rest;
        Some(match kind {
            0 => Event::Answer { words: self.number()?, text: Some(self.text()?) },
            1 => Event::Answer { words: self.number()?, text: None },
            2 => Event::Steps(self.steps()?),
            3 => Event::State(self.kept()?),
            _ => return None,
        })
    }

    fn row(&mut self) -> Option<Row> {
        let (recorder, time) = (Tag::try_from(self.number()? as i64).ok()?, self.float()?);
        let numbers = self.bytes()?.as_chunks().0.iter().map(|b| f64::from_le_bytes(*b)).collect();
        Some(Row { recorder, time, numbers })
    }

    fn failure(&mut self) -> Option<WrittenFailure> {
        let kind = self.number()?;
        let numbers = [self.float()?, self.float()?, self.float()?, self.float()?];
        let words = [self.text()?, self.text()?];
        let place = if self.number()? == 1 { Some(self.text()?) } else { None };
        Some(WrittenFailure { kind, numbers, words, place, code: self.number()? as i64 as i32 })
    }

    fn steps(&mut self) -> Option<Steps> {
        let (call, asked, dt, done) = (self.number()?, self.number()?, self.float()?, self.number()?);
        let ended = match self.number()? {
            0 => Ended::Not,
            1 => Ended::Done,
            2 => Ended::Failed(self.failure()?),
            _ => return None,
        };
        let printed = self.text()?;
        let count = self.number()?;
        let rows = (0..count).map(|_| self.row()).collect::<Option<_>>()?;
        Some(Steps { call, asked, dt, done, ended, printed, rows })
    }
}

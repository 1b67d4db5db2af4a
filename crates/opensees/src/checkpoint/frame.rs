//! Checkpoints as bytes.
//!
//! The file begins with a magic word and the digest of the run. Each checkpoint is its length, its content and a checksum, so that
//! one that was cut off is recognised.

use hysteron_engine::analysis::{Cause, Engine, Failure, SavedState};
use hysteron_engine::model::Tag;

const MAGIC: &[u8; 8] = b"hystcp\x00\x01";

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

/// How an analysis went on after a checkpoint.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Ended {
    Not,
    Done,
    Failed(WrittenFailure),
}

/// A checkpoint.
#[derive(Clone, Debug)]
pub(super) struct Frame {
    /// Digest of the files that were read before.
    pub(super) inputs: u64,
    /// Number of the analysis.
    pub(super) call: u64,
    pub(super) steps: u64,
    pub(super) dt: f64,
    /// Steps of the analysis so far.
    pub(super) done: u64,
    pub(super) ended: Ended,
    pub(super) printed: String,
    /// Rows since the checkpoint before.
    pub(super) rows: Vec<Row>,
    pub(super) state: SavedState,
}

/// Checkpoints of a file.
#[derive(Debug)]
pub struct Checkpoints {
    /// Digest of the run.
    pub run: u64,
    /// Length of the file up to the last whole checkpoint, in bytes.
    pub length: u64,
    pub(super) frames: Vec<Frame>,
}

impl Checkpoints {
    /// Number of checkpoints.
    pub fn count(&self) -> usize {
        self.frames.len()
    }
}

fn checksum(bytes: &[u8]) -> u64 {
    // FNV-1a.
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |h, b| (h ^ u64::from(*b)).wrapping_mul(0x0100_0000_01b3))
}

/// First bytes of the journal of a run.
pub(super) fn head(run: u64) -> Vec<u8> {
    [&MAGIC[..], &run.to_le_bytes()].concat()
}

/// Read the checkpoints of a file, up to the first that is cut off or damaged.
///
/// # Errors
/// It is no file of checkpoints.
pub fn parse(bytes: &[u8]) -> Result<Checkpoints, &'static str> {
    const NONE: &str = "it is no file of checkpoints of this version";
    let mut r = Reader(bytes.strip_prefix(MAGIC).ok_or(NONE)?);
    let run = r.number().ok_or(NONE)?;
    let (mut frames, mut rest) = (vec![], r.0);
    while let Some(frame) = r.bytes().and_then(|content| {
        let is_whole = r.number()? == checksum(content);
        if is_whole { Frame::from_bytes(content) } else { None }
    }) {
        frames.push(frame);
        rest = r.0;
    }
    Ok(Checkpoints { run, length: (bytes.len() - rest.len()) as u64, frames })
}

/// Numbers and texts one after the other.
#[derive(Default)]
struct Writer(Vec<u8>);

impl Writer {
    fn number(&mut self, x: u64) {
        self.0.extend(x.to_le_bytes());
    }
    fn bytes(&mut self, bytes: &[u8]) {
        self.number(bytes.len() as u64);
        self.0.extend(bytes);
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
    fn text(&mut self) -> Option<String> {
        String::from_utf8(self.bytes()?.to_vec()).ok()
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
}

impl Frame {
    /// Length, content and checksum.
    pub(super) fn to_bytes(&self) -> Vec<u8> {
        let mut w = Writer::default();
        [self.inputs, self.call, self.steps, self.dt.to_bits(), self.done].into_iter().for_each(|x| w.number(x));
        match &self.ended {
            Ended::Not => w.number(0),
            Ended::Done => w.number(1),
            Ended::Failed(f) => {
                w.number(2);
                w.number(f.kind);
                f.numbers.iter().for_each(|x| w.number(x.to_bits()));
                f.words.iter().for_each(|x| w.bytes(x.as_bytes()));
                w.number(u64::from(f.place.is_some()));
                f.place.iter().for_each(|p| w.bytes(p.as_bytes()));
                w.number(i64::from(f.code) as u64);
            }
        }
        w.bytes(self.printed.as_bytes());
        w.number(self.rows.len() as u64);
        for row in &self.rows {
            w.number(i64::from(row.recorder) as u64);
            w.number(row.time.to_bits());
            w.bytes(&row.numbers.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<_>>());
        }
        w.bytes(&self.state.to_bytes());
        let mut whole = Writer::default();
        whole.bytes(&w.0);
        whole.number(checksum(&w.0));
        whole.0
    }

    fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let mut r = Reader(bytes);
        let (inputs, call, steps, dt, done) = (r.number()?, r.number()?, r.number()?, r.float()?, r.number()?);
        let ended = match r.number()? {
            0 => Ended::Not,
            1 => Ended::Done,
            2 => Ended::Failed(r.failure()?),
            _ => return None,
        };
        let printed = r.text()?;
        let count = r.number()?;
        let rows = (0..count).map(|_| r.row()).collect::<Option<_>>()?;
        let state = SavedState::from_bytes(r.bytes()?)?;
        Some(Self { inputs, call, steps, dt, done, ended, printed, rows, state })
    }
}

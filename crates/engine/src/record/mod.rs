//! Recorders: responses that are written after each step.
//!
//! A recorder is a [`Source`] of rows and an [`Output`] that takes them, either as they come or as their envelope.

mod binary;
mod drift;
mod element;
mod envelope;
mod file;
mod missing;
mod node;
mod opensees;
mod output;
mod rms;
mod text;
mod xml;

use crate::analysis::{Engine, LockstepRows, Recorded};
use crate::series::Series;
use output::{TIME, TIME_OUTPUT};
use std::fmt;
use std::ops::Range;
use std::sync::Arc;

pub use drift::Drift;
pub use element::{ElementResponse, Known, Misspelled};
pub use envelope::Envelope;
pub use file::RowFile;
pub use missing::Missing;
pub use node::{NodeQuantity, NodeResponse};
pub use output::{Group, Layout, LiveFile, Memory, Output, Separator};
pub use rms::RootMeanSquare;

/// Reason why a recorder cannot go on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RecordError(pub String);

impl fmt::Display for RecordError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for RecordError {}

impl From<std::io::Error> for RecordError {
    fn from(e: std::io::Error) -> Self {
        Self(e.to_string())
    }
}

/// Source of rows.
pub trait Source: fmt::Debug + Send {
    /// Find what is to be recorded in the model as it is now; called before the first row and after every change of
    /// the model. Responses that are not there are left out, and named in `missing`.
    ///
    /// # Errors
    /// A response that an element does not have.
    fn find(&mut self, engine: &Engine, missing: &mut Vec<Missing>) -> Result<(), RecordError>;

    /// Names of the columns.
    fn labels(&self) -> Vec<String>;

    /// Groups of the columns, in their order.
    fn groups(&self, engine: &Engine) -> Vec<Group>;

    /// Append the row of the committed state.
    ///
    /// # Errors
    /// A response cannot be worked out.
    fn row(&mut self, engine: &mut Engine, row: &mut Vec<f64>) -> Result<(), RecordError>;

    /// Returns true if the committed state has another row, which is that of the next call of [`Source::row`].
    fn next_row(&mut self, _: &Engine) -> bool {
        false
    }

    /// Numbers of the committed state that make up the row, where it is made up of them, and the series that is added to
    /// each.
    fn numbers(&self, _: &Engine) -> Option<Vec<(Recorded, Option<Series>)>> {
        None
    }

    /// Returns true if the row is all that the source makes.
    fn makes_rows_only(&self) -> bool {
        true
    }
}

/// Use of the rows.
#[derive(Debug)]
enum Keep {
    /// All of them.
    History,
    /// Smallest, largest and largest absolute value of each column.
    Envelope(Envelope),
    /// Root mean square of each column. A step between two rows counts with the row before it, as in OpenSees.
    RootMeanSquare(RootMeanSquare),
}

/// Rows that are recorded.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cadence {
    /// Write the time before the columns (`-time`).
    pub time: bool,
    /// Least time between rows; zero records every step (`-dT`).
    pub dt: f64,
    /// Tolerance for round-off, as a fraction of `dt`: a row may come earlier by it (`-rTolDt`).
    pub tolerance: f64,
}

/// A recorder.
#[derive(Debug)]
pub struct Recorder {
    source: Box<dyn Source>,
    output: Box<dyn Output>,
    keep: Keep,
    cadence: Cadence,
    next: f64,
    found: Option<u64>,
    row: Vec<f64>,
    /// Times of several rows at once.
    due: Vec<f64>,
    /// Series that are added to columns of these rows.
    added: Vec<(usize, Series)>,
    /// An envelope is another one than the output has.
    changed: bool,
    /// Responses that are not in the model.
    pub missing: Vec<Missing>,
}

impl Recorder {
    /// Record every row.
    pub fn history(source: Box<dyn Source>, output: Box<dyn Output>, cadence: Cadence) -> Self {
        Self {
            source,
            output,
            keep: Keep::History,
            cadence,
            next: 0.0,
            found: None,
            row: vec![],
            due: vec![],
            added: vec![],
            changed: false,
            missing: vec![],
        }
    }

    /// Record the envelope.
    pub fn envelope(source: Box<dyn Source>, output: Box<dyn Output>, cadence: Cadence) -> Self {
        Self { keep: Keep::Envelope(Envelope::default()), ..Self::history(source, output, cadence) }
    }

    /// Record the root mean squares.
    pub fn root_mean_square(source: Box<dyn Source>, output: Box<dyn Output>, cadence: Cadence) -> Self {
        let cadence = Cadence { time: false, ..cadence };
        Self { keep: Keep::RootMeanSquare(RootMeanSquare::default()), ..Self::history(source, output, cadence) }
    }

    /// Record the committed state, if it is time to. Returns true if it was; then [`Recorder::last_row`] is its row.
    ///
    /// # Errors
    /// A response that is not there, or an output that cannot be written.
    #[inline]
    pub fn record(&mut self, engine: &mut Engine) -> Result<bool, RecordError> {
        let time = engine.state().time;
        if !self.is_due(time) {
            if let Keep::RootMeanSquare(mean) = &mut self.keep {
                mean.take(&self.row);
                self.changed = true;
            }
            return Ok(false);
        }
        self.find(engine)?;
        loop {
            if matches!(self.keep, Keep::History) {
                self.fill(engine)?;
            } else {
                self.row.clear();
                self.source.row(engine, &mut self.row)?;
            }
            self.keep_row(time)?;
            if !self.source.next_row(engine) {
                return Ok(true);
            }
        }
    }

    fn is_due(&self, time: f64) -> bool {
        let c = self.cadence;
        c.dt == 0.0 || time - self.next >= -c.dt * c.tolerance
    }

    /// Returns true if [`Recorder::record_again`] does what the record of a state does.
    pub fn can_repeat(&self) -> bool {
        self.source.makes_rows_only() && (self.cadence.dt == 0.0 || !matches!(self.keep, Keep::RootMeanSquare(_)))
    }

    /// The row that was recorded last.
    pub fn last_row(&self) -> &[f64] {
        &self.row
    }

    /// Record a row that an earlier run has recorded of this model at this time.
    ///
    /// # Errors
    /// As [`Recorder::record`].
    pub fn record_again(&mut self, engine: &Engine, time: f64, row: Vec<f64>) -> Result<(), RecordError> {
        self.find(engine)?;
        self.row = row;
        self.keep_row(time)
    }

    /// Numbers of the committed state that make up a row, as far as the output takes them, and before them true where the time
    /// is the first column that it takes. `None` where rows are not made up of such numbers, or not kept one by one.
    pub fn numbers(&mut self, engine: &Engine) -> Option<(bool, Vec<Recorded>)> {
        self.find(engine).ok()?;
        let all = matches!(self.keep, Keep::History).then(|| self.source.numbers(engine))??;
        let first = usize::from(self.cadence.time);
        let (time_first, all) = match self.output.columns() {
            None => (self.cadence.time, all),
            Some(columns) => {
                let numbers = columns.iter().filter(|c| **c >= first).map(|c| all.get(c - first).cloned());
                (self.cadence.time && columns.first() == Some(&0), numbers.collect::<Option<_>>()?)
            }
        };
        let (numbers, series): (Vec<_>, Vec<_>) = all.into_iter().unzip();
        let columns = series.into_iter().enumerate();
        self.added = columns.filter_map(|(i, s)| Some((i + usize::from(time_first), s?))).collect();
        Some((time_first, numbers))
    }

    /// Record steps of a model that is analysed side by side with others: the time if it is the first column, and the columns
    /// of its [`Recorder::numbers`] among the numbers that were recorded.
    ///
    /// # Errors
    /// An output that cannot be written.
    pub fn record_lockstep(
        &mut self,
        all: &LockstepRows,
        model: usize,
        (time_first, columns): (bool, Range<usize>),
    ) -> Result<(), RecordError> {
        let width = (all.numbers.len() / all.times.len().max(1)).max(1);
        let first = usize::from(time_first);
        let row_width = first + columns.len();
        self.row.clear();
        self.due.clear();
        if self.cadence.dt == 0.0 {
            // Column by column, in short loops: a study reads millions of rows.
            self.row.resize(all.times.len() * row_width, 0.0);
            self.due.extend_from_slice(&all.times);
            for column in 0..row_width {
                let rows = self.row.iter_mut().skip(column).step_by(row_width);
                if column < first {
                    rows.zip(&all.times).for_each(|(to, time)| *to = *time);
                } else {
                    let numbers = all.numbers.iter().skip(columns.start + column - first).step_by(width);
                    rows.zip(numbers).for_each(|(to, number)| *to = number.0[model]);
                }
            }
        } else {
            for (&time, numbers) in all.times.iter().zip(all.numbers.chunks_exact(width)) {
                if self.is_due(time) {
                    self.next = time + self.cadence.dt;
                    self.due.push(time);
                    self.row.extend(time_first.then_some(time));
                    self.row.extend(numbers[columns.clone()].iter().map(|n| n.0[model]));
                }
            }
        }
        for (column, series) in &self.added {
            let numbers = self.row.iter_mut().skip(*column).step_by(row_width);
            numbers.zip(&self.due).for_each(|(x, time)| *x += series.factor(*time));
        }
        self.output.rows(&self.due, &self.row)
    }

    #[inline]
    fn keep_row(&mut self, time: f64) -> Result<(), RecordError> {
        self.next = time + self.cadence.dt;
        match &mut self.keep {
            Keep::History => {
                self.output.at(time);
                self.output.row(&self.row)
            }
            Keep::Envelope(envelope) => {
                if envelope.take(time, &self.row) {
                    self.changed = true;
                    if self.output.wants_every_row() {
                        envelope.write(self.cadence.time, self.output.as_mut())?;
                    }
                }
                Ok(())
            }
            Keep::RootMeanSquare(mean) => {
                mean.take(&self.row);
                self.changed = true;
                Ok(())
            }
        }
    }

    /// An analysis starts from the committed state: pass it to an output that takes it.
    pub fn start(&mut self, engine: &mut Engine) {
        let time = engine.state().time;
        // A response that is not known before the first step is left out.
        if self.output.wants_start(time) && self.find(engine).and_then(|()| self.fill(engine)).is_ok() {
            self.output.start(time, &self.row);
        }
    }

    /// Look up what is to be recorded without recording it: `missing` names what is not in the model.
    pub fn look_up(&mut self, engine: &Engine) {
        self.missing.clear();
        // A response that an element does not have is in `missing` as well, or found with the first row.
        let _ = self.source.find(engine, &mut self.missing);
    }

    /// Find what is to be recorded, if the model has changed.
    fn find(&mut self, engine: &Engine) -> Result<(), RecordError> {
        if self.found == Some(engine.model().revision()) {
            return Ok(());
        }
        self.missing.clear();
        self.source.find(engine, &mut self.missing)?;
        self.found = Some(engine.model().revision());
        self.output.begin(&self.all_labels())?;
        self.output.describe(&self.all_groups(engine))
    }

    /// The row of the committed state, with the time where it is recorded.
    #[inline]
    fn fill(&mut self, engine: &mut Engine) -> Result<(), RecordError> {
        self.row.clear();
        if self.cadence.time {
            self.row.push(engine.state().time);
        }
        self.source.row(engine, &mut self.row)
    }

    fn all_labels(&self) -> Vec<String> {
        let labels = self.source.labels();
        let time = || TIME.to_owned();
        match (&self.keep, self.cadence.time) {
            (_, false) => labels,
            (Keep::History | Keep::RootMeanSquare(_), true) => std::iter::once(time()).chain(labels).collect(),
            (Keep::Envelope(_), true) => labels.into_iter().flat_map(|l| [time(), l]).collect(),
        }
    }

    fn all_groups(&self, engine: &Engine) -> Vec<Group> {
        let groups = self.source.groups(engine);
        match &self.keep {
            Keep::History => {
                let time = Group { name: TIME_OUTPUT, columns: vec![TIME.to_owned()], ..Group::default() };
                self.cadence.time.then_some(time).into_iter().chain(groups).collect()
            }
            Keep::Envelope(_) => groups.into_iter().map(|g| self.enveloped(g)).collect(),
            Keep::RootMeanSquare(_) => groups,
        }
    }

    /// Columns of a group in an envelope: with the times, one before each.
    fn enveloped(&self, group: Group) -> Group {
        let time = self.cadence.time;
        let columns = group.columns.into_iter();
        let columns = columns.flat_map(|c| [time.then(|| TIME.to_owned()), Some(c)]).flatten().collect();
        Group { columns, place: None, ..group }
    }

    /// Write what is left to write, and close the output.
    ///
    /// # Errors
    /// An output that cannot be written.
    pub fn finish(&mut self) -> Result<(), RecordError> {
        match &self.keep {
            Keep::History => {}
            Keep::Envelope(envelope) => envelope.write(self.cadence.time, self.output.as_mut())?,
            Keep::RootMeanSquare(mean) => mean.write(self.output.as_mut())?,
        }
        self.output.finish()
    }

    /// An analysis has ended: pass an envelope so far to an output that others read meanwhile.
    ///
    /// # Errors
    /// An output that cannot be written.
    pub fn pause(&mut self) -> Result<(), RecordError> {
        if !std::mem::take(&mut self.changed) || self.output.live().is_none() {
            return Ok(());
        }
        match &self.keep {
            Keep::History => Ok(()),
            Keep::Envelope(envelope) => envelope.write(self.cadence.time, self.output.as_mut()),
            Keep::RootMeanSquare(mean) => mean.write(self.output.as_mut()),
        }
    }

    /// The file of the output, if it is one that others read while it is written.
    pub fn live(&self) -> Option<Arc<dyn LiveFile>> {
        self.output.live()
    }

    /// Write out what is buffered.
    ///
    /// # Errors
    /// An output that cannot be written.
    pub fn flush(&mut self) -> Result<(), RecordError> {
        self.output.flush()
    }
}

//! Outputs of rows.

use super::RecordError;
use std::fmt;
use std::sync::{Arc, Mutex};

/// A file that others read while an output writes it.
pub trait LiveFile: fmt::Debug + Send + Sync {
    /// Show others all rows so far.
    ///
    /// # Errors
    /// It cannot be written.
    fn sync(&self) -> Result<(), RecordError>;
}

/// Takes rows of numbers.
pub trait Output: fmt::Debug + Send {
    /// Names of the columns of the rows that follow; called again when they change.
    ///
    /// # Errors
    /// It cannot be written.
    fn begin(&mut self, _labels: &[String]) -> Result<(), RecordError> {
        Ok(())
    }
    /// Groups of the columns of the rows that follow; called after [`Output::begin`].
    ///
    /// # Errors
    /// It cannot be written.
    fn describe(&mut self, _groups: &[Group]) -> Result<(), RecordError> {
        Ok(())
    }
    /// A row.
    ///
    /// # Errors
    /// It cannot be written.
    fn row(&mut self, row: &[f64]) -> Result<(), RecordError>;
    /// Columns that [`Output::rows`] takes, in rising order; `None` for all of them.
    fn columns(&self) -> Option<&[usize]> {
        None
    }
    /// Rows at their times, one after the other, of [`Output::columns`].
    ///
    /// # Errors
    /// It cannot be written.
    fn rows(&mut self, times: &[f64], rows: &[f64]) -> Result<(), RecordError> {
        let width = rows.len() / times.len().max(1);
        times.iter().enumerate().try_for_each(|(i, &time)| {
            self.at(time);
            self.row(&rows[i * width..(i + 1) * width])
        })
    }
    /// Returns true if it takes the state that an analysis starts from, at this time, which is no row.
    fn wants_start(&self, _time: f64) -> bool {
        false
    }
    /// The state that an analysis starts from, as a row.
    fn start(&mut self, _time: f64, _row: &[f64]) {}
    /// The time of the row that follows, whether or not it is in the row.
    fn at(&mut self, _time: f64) {}
    /// Forget the rows so far: an envelope is written anew.
    ///
    /// # Errors
    /// It cannot be written.
    fn restart(&mut self) -> Result<(), RecordError> {
        Ok(())
    }
    /// Rows must be visible to others at once (`-closeOnWrite`).
    fn wants_every_row(&self) -> bool {
        false
    }
    /// The file of the rows, if others read it while it is written. A wrapper has that of the output inside.
    fn live(&self) -> Option<Arc<dyn LiveFile>> {
        None
    }
    /// Write out what is buffered.
    ///
    /// # Errors
    /// It cannot be written.
    fn flush(&mut self) -> Result<(), RecordError> {
        Ok(())
    }
    /// No rows will follow.
    ///
    /// # Errors
    /// It cannot be written.
    fn finish(&mut self) -> Result<(), RecordError>;
}

/// Name of the column of times.
pub(super) const TIME: &str = "time";
/// Name of the group of it.
pub(super) const TIME_OUTPUT: &str = "TimeOutput";

/// Columns that belong to one node, element or pair of nodes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Group {
    /// Kind of their owner, as OpenSees' XML files name it: `NodeOutput`, `ElementOutput`, ...
    pub name: &'static str,
    /// Attributes of the owner, and their values.
    pub attributes: Vec<(&'static str, String)>,
    /// Coordinates of a node; they are in the heads of histories, and not in those of envelopes.
    pub place: Option<[f64; 3]>,
    /// Names of the columns.
    pub columns: Vec<String>,
}

/// Layout of a file of rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layout {
    /// A line of text a row.
    Text(Separator),
    /// OpenSees' XML: what the columns are, and then a line of text a row.
    Xml,
    /// Eight bytes a number, the smallest first; a line feed after each row.
    Binary,
}

/// Separator between the numbers of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Separator {
    /// A space, as OpenSees' `-file`.
    Space,
    /// A comma, as OpenSees' `-csv`.
    Comma,
}

/// Rows kept in memory, shared with whoever reads them.
#[derive(Clone, Debug, Default)]
pub struct Memory {
    rows: Arc<Mutex<Vec<Vec<f64>>>>,
}

impl Memory {
    /// The rows so far, taken out.
    pub fn take(&self) -> Vec<Vec<f64>> {
        self.rows.lock().map(|mut r| std::mem::take(&mut *r)).unwrap_or_default()
    }
}

impl Output for Memory {
    fn row(&mut self, row: &[f64]) -> Result<(), RecordError> {
        if let Ok(mut rows) = self.rows.lock() {
            rows.push(row.to_vec());
        }
        Ok(())
    }
    fn restart(&mut self) -> Result<(), RecordError> {
        self.take();
        Ok(())
    }
    fn finish(&mut self) -> Result<(), RecordError> {
        Ok(())
    }
}

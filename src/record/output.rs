//! Where rows go.

use super::RecordError;
use crate::io::number::Style;
use std::fmt;
use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

/// Takes rows of numbers.
pub trait Output: fmt::Debug + Send {
    /// Names of the columns of the rows that follow; called again when they change.
    ///
    /// # Errors
    /// It cannot be written.
    fn begin(&mut self, _labels: &[String]) -> Result<(), RecordError> {
        Ok(())
    }
    /// A row.
    ///
    /// # Errors
    /// It cannot be written.
    fn row(&mut self, row: &[f64]) -> Result<(), RecordError>;
    /// Forget the rows so far: an envelope is written anew.
    ///
    /// # Errors
    /// It cannot be written.
    fn restart(&mut self) -> Result<(), RecordError> {
        Ok(())
    }
    /// Whether rows must be visible to others at once (`-closeOnWrite`).
    fn wants_every_row(&self) -> bool {
        false
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

/// What stands between the numbers of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Separator {
    /// A space, as OpenSees' `-file`.
    Space,
    /// A comma, as OpenSees' `-csv`.
    Comma,
}

/// A text file with a line a row. It is written beside its place and put there when it is finished, so that nobody
/// sees half a file.
#[derive(Debug)]
pub struct TextFile {
    place: PathBuf,
    part: PathBuf,
    writer: Option<BufWriter<File>>,
    style: Style,
    separator: char,
    close_on_write: bool,
    line: String,
}

impl TextFile {
    /// Begin a file. With `close_on_write` every row goes to its place at once.
    ///
    /// # Errors
    /// It cannot be made.
    pub fn create(place: &Path, style: Style, separator: Separator, close_on_write: bool) -> Result<Self, RecordError> {
        let mut name = place.file_name().unwrap_or_default().to_owned();
        name.push(".part");
        let part = if close_on_write { place.to_path_buf() } else { place.with_file_name(name) };
        let separator = if separator == Separator::Space { ' ' } else { ',' };
        let mut file = Self {
            place: place.to_path_buf(),
            part,
            writer: None,
            style,
            separator,
            close_on_write,
            line: String::new(),
        };
        file.open()?;
        Ok(file)
    }

    fn open(&mut self) -> Result<(), RecordError> {
        let file =
            File::create(&self.part).map_err(|e| RecordError(format!("cannot write {}: {e}", self.part.display())))?;
        self.writer = Some(BufWriter::new(file));
        Ok(())
    }

    fn failed(&self, e: &std::io::Error) -> RecordError {
        RecordError(format!("cannot write {}: {e}", self.place.display()))
    }
}

impl Output for TextFile {
    fn row(&mut self, row: &[f64]) -> Result<(), RecordError> {
        self.line.clear();
        for (i, x) in row.iter().enumerate() {
            if i > 0 {
                self.line.push(self.separator);
            }
            self.style.push(*x, &mut self.line);
        }
        self.line.push('\n');
        let Some(w) = &mut self.writer else { return Ok(()) };
        let written = w.write_all(self.line.as_bytes());
        let written = if self.close_on_write { written.and_then(|()| w.flush()) } else { written };
        written.map_err(|e| self.failed(&e))
    }

    fn restart(&mut self) -> Result<(), RecordError> {
        self.open()
    }

    fn wants_every_row(&self) -> bool {
        self.close_on_write
    }

    fn flush(&mut self) -> Result<(), RecordError> {
        let flushed = self.writer.as_mut().map_or(Ok(()), Write::flush);
        flushed.map_err(|e| self.failed(&e))
    }

    fn finish(&mut self) -> Result<(), RecordError> {
        self.flush()?;
        if self.writer.take().is_some() && self.part != self.place {
            std::fs::rename(&self.part, &self.place).map_err(|e| self.failed(&e))?;
        }
        Ok(())
    }
}

impl Drop for TextFile {
    fn drop(&mut self) {
        // A recorder that was dropped without an end leaves its rows all the same.
        let _ = self.finish();
    }
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

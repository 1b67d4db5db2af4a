//! Files of rows, whatever their form.

use super::RecordError;
use super::output::{Group, Layout, Output};
use super::place::PlacedFile;
use super::{binary::Binary, text::Text, xml::Xml};
use crate::number_format::Style;
use std::fmt;
use std::path::Path;

/// Format of the rows of a file.
pub(super) trait Form: fmt::Debug + Send {
    /// Groups of the columns, as long as no row has been written.
    fn describe(&mut self, _groups: &[Group]) {}
    /// Text before the first row.
    fn head(&self) -> &[u8] {
        b""
    }
    /// Append a row.
    fn row(&self, row: &[f64], to: &mut Vec<u8>);
    /// Text after the last row.
    fn tail(&self) -> &[u8] {
        b""
    }
}

/// A file of rows in one of OpenSees' forms.
#[derive(Debug)]
pub struct RowFile {
    file: PlacedFile,
    form: Box<dyn Form>,
    /// The head has been written.
    begun: bool,
    bytes: Vec<u8>,
}

impl RowFile {
    /// Begin a file. With `close_on_write` every row goes to its place at once.
    ///
    /// # Errors
    /// It cannot be made.
    pub fn create(place: &Path, layout: Layout, style: Style, close_on_write: bool) -> Result<Self, RecordError> {
        let form: Box<dyn Form> = match layout {
            Layout::Text(separator) => Box::new(Text::new(style, separator)),
            Layout::Xml => Box::new(Xml::new(style)),
            Layout::Binary => Box::new(Binary),
        };
        Ok(Self { file: PlacedFile::create(place, close_on_write)?, form, begun: false, bytes: vec![] })
    }

    fn begin_rows(&mut self) -> Result<(), RecordError> {
        if std::mem::replace(&mut self.begun, true) { Ok(()) } else { self.file.write(self.form.head()) }
    }
}

impl Output for RowFile {
    fn describe(&mut self, groups: &[Group]) -> Result<(), RecordError> {
        // A file has one head, which does not follow columns that change with the model later on.
        if !self.begun {
            self.form.describe(groups);
        }
        Ok(())
    }

    fn row(&mut self, row: &[f64]) -> Result<(), RecordError> {
        self.begin_rows()?;
        self.bytes.clear();
        self.form.row(row, &mut self.bytes);
        self.file.write_row(&self.bytes)
    }

    fn restart(&mut self) -> Result<(), RecordError> {
        self.begun = false;
        self.file.restart()
    }

    fn wants_every_row(&self) -> bool {
        self.file.at_once()
    }

    fn flush(&mut self) -> Result<(), RecordError> {
        self.file.flush()
    }

    fn finish(&mut self) -> Result<(), RecordError> {
        if self.file.is_open() {
            self.begin_rows()?;
            self.file.write(self.form.tail())?;
        }
        self.file.finish()
    }
}

impl Drop for RowFile {
    fn drop(&mut self) {
        // A recorder that was dropped without an end leaves a whole file all the same.
        let _ = self.finish();
    }
}

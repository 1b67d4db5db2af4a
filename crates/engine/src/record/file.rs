//! Files of rows, whatever their form.

use super::RecordError;
use super::output::{Group, Layout, LiveFile, Output};
use super::{binary::Binary, text::Text, xml::Xml};
use crate::number_format::Style;
use hysteron_files::ResultFile;
use std::fmt;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

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
    file: Arc<SharedFile>,
    form: Box<dyn Form>,
    /// The head has been written.
    begun: bool,
    /// Every row goes to its place at once.
    at_once: bool,
}

/// The file itself, which whoever reads it may have written out meanwhile.
#[derive(Debug)]
struct SharedFile {
    place: PathBuf,
    file: Mutex<ResultFile>,
}

impl SharedFile {
    fn with<R>(&self, act: impl FnOnce(&mut ResultFile) -> std::io::Result<R>) -> Result<R, RecordError> {
        let mut file = self.file.lock().unwrap_or_else(PoisonError::into_inner);
        act(&mut file).map_err(|e| failed(&self.place, &e))
    }
}

impl LiveFile for SharedFile {
    fn sync(&self) -> Result<(), RecordError> {
        self.with(ResultFile::sync)
    }
}

fn failed(place: &Path, e: &std::io::Error) -> RecordError {
    RecordError(format!("cannot write {}: {e}", place.display()))
}

impl RowFile {
    /// Begin a file. With `close_on_write` every row goes to its place at once.
    ///
    /// # Errors
    /// It cannot be made, or another run writes it.
    pub fn create(place: &Path, layout: Layout, style: Style, close_on_write: bool) -> Result<Self, RecordError> {
        let form: Box<dyn Form> = match layout {
            Layout::Text(separator) => Box::new(Text::new(style, separator)),
            Layout::Xml => Box::new(Xml::new(style)),
            Layout::Binary => Box::new(Binary),
        };
        let file = ResultFile::create(place, close_on_write).map_err(|e| failed(place, &e))?;
        let file = Arc::new(SharedFile { place: place.to_owned(), file: Mutex::new(file) });
        Ok(Self { file, form, begun: false, at_once: close_on_write })
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
        let Self { file, form, begun, at_once } = self;
        let is_first = !std::mem::replace(begun, true);
        file.with(|file| {
            file.append(|bytes| {
                if is_first {
                    bytes.extend_from_slice(form.head());
                }
                form.row(row, bytes);
            })?;
            if *at_once { file.sync() } else { Ok(()) }
        })
    }

    fn restart(&mut self) -> Result<(), RecordError> {
        self.begun = false;
        self.file.with(|file| {
            file.begin_anew();
            Ok(())
        })
    }

    fn wants_every_row(&self) -> bool {
        self.at_once
    }

    fn live(&self) -> Option<Arc<dyn LiveFile>> {
        Some(self.file.clone())
    }

    fn flush(&mut self) -> Result<(), RecordError> {
        self.file.sync()
    }

    fn finish(&mut self) -> Result<(), RecordError> {
        let Self { file, form, begun, .. } = self;
        file.with(|file| {
            let head = if *begun { &b""[..] } else { form.head() };
            file.append(|bytes| {
                bytes.extend_from_slice(head);
                bytes.extend_from_slice(form.tail());
            })?;
            file.finish()
        })
    }
}

impl Drop for RowFile {
    fn drop(&mut self) {
        // A recorder that was dropped without an end leaves a whole file all the same.
        let _ = self.finish();
    }
}

//! Files that appear when they are finished.

use super::RecordError;
use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

/// A file that is written beside its place and put there when it is finished, so that nobody sees half a file.
#[derive(Debug)]
pub(super) struct PlacedFile {
    place: PathBuf,
    part: PathBuf,
    writer: Option<BufWriter<File>>,
    close_on_write: bool,
}

impl PlacedFile {
    /// Begin a file. With `close_on_write` every row goes to its place at once.
    pub(super) fn create(place: &Path, close_on_write: bool) -> Result<Self, RecordError> {
        let mut name = place.file_name().unwrap_or_default().to_owned();
        name.push(".part");
        let part = if close_on_write { place.to_path_buf() } else { place.with_file_name(name) };
        let mut file = Self { place: place.to_path_buf(), part, writer: None, close_on_write };
        file.restart()?;
        Ok(file)
    }

    /// Begin anew.
    pub(super) fn restart(&mut self) -> Result<(), RecordError> {
        let file = made_anew(&self.part).map_err(|e| self.failed(&e))?;
        self.writer = Some(BufWriter::new(file));
        Ok(())
    }

    /// Why it could not be written, under the name that it was to have.
    fn failed(&self, e: &std::io::Error) -> RecordError {
        RecordError(format!("cannot write {}: {e}", self.place.display()))
    }

    /// Rows go to the file's place at once.
    pub(super) fn at_once(&self) -> bool {
        self.close_on_write
    }

    /// Returns true if more can be written.
    pub(super) fn is_open(&self) -> bool {
        self.writer.is_some()
    }

    pub(super) fn write(&mut self, bytes: &[u8]) -> Result<(), RecordError> {
        let Some(w) = &mut self.writer else { return Ok(()) };
        let written = w.write_all(bytes);
        written.map_err(|e| self.failed(&e))
    }

    /// Write a whole row.
    pub(super) fn write_row(&mut self, bytes: &[u8]) -> Result<(), RecordError> {
        self.write(bytes)?;
        if self.close_on_write { self.flush() } else { Ok(()) }
    }

    pub(super) fn flush(&mut self) -> Result<(), RecordError> {
        let flushed = self.writer.as_mut().map_or(Ok(()), Write::flush);
        flushed.map_err(|e| self.failed(&e))
    }

    /// Put the file in its place.
    pub(super) fn finish(&mut self) -> Result<(), RecordError> {
        self.flush()?;
        if self.writer.take().is_some() && self.part != self.place {
            std::fs::rename(&self.part, &self.place).map_err(|e| self.failed(&e))?;
        }
        Ok(())
    }
}

/// A file that is made anew: a link under its name is removed, and not followed to what it points to.
fn made_anew(path: &Path) -> std::io::Result<File> {
    if std::fs::symlink_metadata(path).is_ok_and(|m| m.file_type().is_symlink()) {
        std::fs::remove_file(path)?;
    }
    File::create(path)
}

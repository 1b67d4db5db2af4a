//! Files of numbers as they are in memory.

use super::RecordError;
use super::output::Output;
use super::place::PlacedFile;
use std::path::Path;

/// A file of eight bytes a number, the smallest byte first, and a line feed after each row (OpenSees' `-binary`).
#[derive(Debug)]
pub struct BinaryFile {
    file: PlacedFile,
    bytes: Vec<u8>,
}

impl BinaryFile {
    /// Begin a file. With `close_on_write` every row goes to its place at once.
    ///
    /// # Errors
    /// It cannot be made.
    pub fn create(place: &Path, close_on_write: bool) -> Result<Self, RecordError> {
        Ok(Self { file: PlacedFile::create(place, close_on_write)?, bytes: vec![] })
    }
}

impl Output for BinaryFile {
    fn row(&mut self, row: &[f64]) -> Result<(), RecordError> {
        self.bytes.clear();
        for x in row {
            self.bytes.extend_from_slice(&x.to_le_bytes());
        }
        self.bytes.push(b'\n');
        self.file.write_row(&self.bytes)
    }

    fn restart(&mut self) -> Result<(), RecordError> {
        self.file.restart()
    }

    fn wants_every_row(&self) -> bool {
        self.file.at_once()
    }

    fn flush(&mut self) -> Result<(), RecordError> {
        self.file.flush()
    }

    fn finish(&mut self) -> Result<(), RecordError> {
        self.file.finish()
    }
}

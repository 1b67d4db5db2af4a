//! Destination of recorders.

use super::series::{FileSeries, NoSeries};
use hysteron_engine::number_format::Style;
use hysteron_engine::record::{Layout, Memory, Output, RecordError};
use std::path::Path;

/// Format of a recorder's file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FileFormat {
    /// Numbers.
    pub style: Style,
    /// Layout of the rows.
    pub layout: Layout,
    /// Every row at once.
    pub close_on_write: bool,
}

/// Destination of recorders: files, or the memory of a study.
pub trait Outputs {
    /// An output by the name the script gives it, and as a path that is not relative to anything.
    ///
    /// # Errors
    /// It cannot be made.
    fn create(&mut self, name: &str, path: &Path, format: FileFormat) -> Result<Box<dyn Output>, RecordError>;

    /// The place of a file and of a folder of its name without ending beside it, for recorders that write many files.
    /// By default nothing is kept.
    ///
    /// # Errors
    /// The folder cannot be made.
    fn series(&mut self, _name: &str, _path: &Path) -> Result<Box<dyn FileSeries>, RecordError> {
        Ok(Box::new(NoSeries))
    }
}

/// Outputs that are kept in memory and dropped: a check leaves the results of an earlier run as they are.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoFiles;

impl Outputs for NoFiles {
    fn create(&mut self, _: &str, _: &Path, _: FileFormat) -> Result<Box<dyn Output>, RecordError> {
        Ok(Box::new(Memory::default()))
    }
}

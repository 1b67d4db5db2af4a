//! Places for recorders that write many files.

use hysteron_engine::record::RecordError;
use std::fmt;
use std::path::{Path, PathBuf};

/// A file with a folder of its name beside it.
pub trait FileSeries: fmt::Debug + Send {
    /// Write a file into the folder, or the file beside it for `None`.
    ///
    /// # Errors
    /// It cannot be written.
    fn write(&mut self, name: Option<&str>, content: &str) -> Result<(), RecordError>;
}

/// A series that keeps nothing.
#[derive(Debug)]
pub(crate) struct NoSeries;

impl FileSeries for NoSeries {
    fn write(&mut self, _: Option<&str>, _: &str) -> Result<(), RecordError> {
        Ok(())
    }
}

/// A series on the disk.
#[derive(Debug)]
pub struct DiskSeries {
    file: PathBuf,
    folder: PathBuf,
}

impl DiskSeries {
    /// At the path of the file; the folder is made.
    ///
    /// # Errors
    /// The folder cannot be made.
    pub fn new(file: &Path) -> Result<Self, RecordError> {
        let folder = file.with_extension("");
        let made = std::fs::create_dir_all(&folder);
        made.map_err(|e| RecordError(format!("cannot make {}: {e}", folder.display())))?;
        Ok(Self { file: file.into(), folder })
    }
}

impl FileSeries for DiskSeries {
    fn write(&mut self, name: Option<&str>, content: &str) -> Result<(), RecordError> {
        let path = name.map_or_else(|| self.file.clone(), |name| self.folder.join(name));
        std::fs::write(&path, content).map_err(|e| RecordError(format!("cannot write {}: {e}", path.display())))
    }
}

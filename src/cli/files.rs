//! Recorders' files.

use hysteron::command::{FileFormat, Outputs};
use hysteron::record::{Memory, Output, RecordError, RowFile};
use std::path::Path;

/// Files of the system.
pub(super) struct SystemFiles;

impl Outputs for SystemFiles {
    fn create(&mut self, _: &str, path: &Path, f: FileFormat) -> Result<Box<dyn Output>, RecordError> {
        Ok(Box::new(RowFile::create(path, f.layout, f.style, f.close_on_write)?))
    }
}

/// A check writes nothing: results of an earlier run stay.
pub(super) struct NoFiles;

impl Outputs for NoFiles {
    fn create(&mut self, _: &str, _: &Path, _: FileFormat) -> Result<Box<dyn Output>, RecordError> {
        Ok(Box::new(Memory::default()))
    }
}

//! Recorders' files.

use hysteron::command::{FileFormat, Outputs};
use hysteron::record::{Memory, Output, RecordError, TextFile};
use std::path::Path;

/// Files of the system.
pub(super) struct SystemFiles;

impl Outputs for SystemFiles {
    fn create(&mut self, _: &str, path: &Path, f: FileFormat) -> Result<Box<dyn Output>, RecordError> {
        Ok(Box::new(TextFile::create(path, f.style, f.separator, f.close_on_write)?))
    }
}

/// A check writes nothing: results of an earlier run stay.
pub(super) struct NoFiles;

impl Outputs for NoFiles {
    fn create(&mut self, _: &str, path: &Path, _: FileFormat) -> Result<Box<dyn Output>, RecordError> {
        match path.parent() {
            Some(folder) if !folder.is_dir() => {
                Err(RecordError(format!("cannot write {}: there is no such folder", path.display())))
            }
            _ => Ok(Box::new(Memory::default())),
        }
    }
}

//! Files that are written: those of recorders, and results.

use hysteron::opensees::{FileFormat, Outputs};
use hysteron::record::{Memory, Output, RecordError, RowFile};
use std::fs;
use std::path::Path;
use std::time::Duration;

/// Time between checkpoints.
pub(super) const SAVE_EVERY: Duration = Duration::from_secs(5);

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

/// Write a file beside its place and put it there.
pub(super) fn place(path: &Path, text: &str) -> Result<(), String> {
    let beside = path.with_extension("part");
    let done = fs::write(&beside, text).and_then(|()| fs::rename(&beside, path));
    done.map_err(|e| format!("cannot write {}: {e}", path.display()))
}

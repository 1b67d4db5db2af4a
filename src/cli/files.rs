//! Recorders' files.

use hysteron::command::{FileFormat, Outputs};
use hysteron::record::{BinaryFile, Layout, Memory, Output, RecordError, TextFile, XmlFile};
use std::path::Path;

/// Files of the system.
pub(super) struct SystemFiles;

impl Outputs for SystemFiles {
    fn create(&mut self, _: &str, path: &Path, f: FileFormat) -> Result<Box<dyn Output>, RecordError> {
        Ok(match f.layout {
            Layout::Text(separator) => Box::new(TextFile::create(path, f.style, separator, f.close_on_write)?),
            Layout::Xml => Box::new(XmlFile::create(path, f.style, f.close_on_write)?),
            Layout::Binary => Box::new(BinaryFile::create(path, f.close_on_write)?),
        })
    }
}

/// A check writes nothing: results of an earlier run stay.
pub(super) struct NoFiles;

impl Outputs for NoFiles {
    fn create(&mut self, _: &str, _: &Path, _: FileFormat) -> Result<Box<dyn Output>, RecordError> {
        Ok(Box::new(Memory::default()))
    }
}

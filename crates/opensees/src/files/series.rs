//! Places for recorders that write many files.

use hysteron_engine::record::RecordError;
use std::fmt;
use std::path::{Path, PathBuf};

/// Ending of the files in the folder.
const ENDING: &str = ".vtu";

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
    /// At the path of the file; the folder is made. The file and the numbered ones that an earlier run has left are removed.
    ///
    /// # Errors
    /// The folder cannot be made, or is a link to another one.
    pub fn new(file: &Path) -> Result<Self, RecordError> {
        let folder = file.with_extension("");
        let cannot = |e: std::io::Error| RecordError(format!("cannot write into {}: {e}", folder.display()));
        hysteron_files::make_inner_folder(&folder).map_err(|e| RecordError(e.to_string()))?;
        let is_numbered = |name: &str| {
            name.strip_suffix(ENDING).is_some_and(|n| !n.is_empty() && n.bytes().all(|b| b.is_ascii_digit()))
        };
        let names = hysteron_files::list(&folder).map_err(cannot)?;
        let old = names.iter().filter(|n| is_numbered(n)).map(|n| folder.join(n));
        for path in old.chain(hysteron_files::link_info(file).is_ok().then(|| file.to_owned())) {
            hysteron_files::remove(&path).map_err(cannot)?;
        }
        Ok(Self { file: file.into(), folder })
    }
}

impl FileSeries for DiskSeries {
    fn write(&mut self, name: Option<&str>, content: &str) -> Result<(), RecordError> {
        let path = name.map_or_else(|| self.file.clone(), |name| self.folder.join(name));
        hysteron_files::write(&path, content).map_err(|e| RecordError(format!("cannot write {}: {e}", path.display())))
    }
}

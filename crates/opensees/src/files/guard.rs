//! Folders in which a script may write, and under `--sandbox` read.

use super::outputs::{FileFormat, Outputs};
use crate::files::series::FileSeries;
use hysteron_engine::record::{Output, RecordError};
use hysteron_tcl::{FileInfo, Files, OpenMode, Stream};
use std::io;
use std::path::{Path, PathBuf};
use std::rc::Rc;
use std::time::Duration;

/// Folders that a script may use.
#[derive(Debug)]
pub struct Guard {
    /// Folders that it may write into, without links.
    write: Vec<PathBuf>,
    /// Folders that it may read from; `None` for all.
    read: Option<Vec<PathBuf>>,
}

impl Guard {
    /// A script may write below these folders, which are there.
    ///
    /// # Errors
    /// A folder cannot be found.
    pub fn new<'a>(write: impl IntoIterator<Item = &'a Path>) -> io::Result<Self> {
        Ok(Self { write: write.into_iter().map(Path::canonicalize).collect::<Result<_, _>>()?, read: None })
    }

    /// A script may read below these folders only, and below those that it may write into.
    ///
    /// # Errors
    /// A folder cannot be found.
    pub fn read_only_below<'a>(mut self, folders: impl IntoIterator<Item = &'a Path>) -> io::Result<Self> {
        let more = folders.into_iter().map(Path::canonicalize).collect::<Result<Vec<_>, _>>()?;
        self.read = Some([self.write.clone(), more].concat());
        Ok(self)
    }

    fn check_write(&self, path: &str, follow: bool) -> io::Result<()> {
        if is_below(&resolved(path, follow)?, &self.write) {
            return Ok(());
        }
        let folder = path.rsplit_once('/').map_or("/", |(folder, _)| if folder.is_empty() { "/" } else { folder });
        let why = format!(
            "a script writes below the current folder only: \"--allow-write {folder}\" lets it write to {path}"
        );
        Err(io::Error::new(io::ErrorKind::PermissionDenied, why))
    }

    fn check_read(&self, path: &str, follow: bool) -> io::Result<()> {
        let Some(read) = &self.read else { return Ok(()) };
        if is_below(&resolved(path, follow)?, read) {
            return Ok(());
        }
        let why = format!("under --sandbox a script reads below the current folder and its own only, and not {path}");
        Err(io::Error::new(io::ErrorKind::PermissionDenied, why))
    }
}

fn is_below(path: &Path, folders: &[PathBuf]) -> bool {
    folders.iter().any(|f| path.starts_with(f))
}

/// A path without links, as far as it is there. With `follow`, a link under the name itself is followed too.
fn resolved(path: &str, follow: bool) -> io::Result<PathBuf> {
    let path = Path::new(path);
    let is_link = path.symlink_metadata().is_ok_and(|m| m.file_type().is_symlink());
    if follow && is_link {
        // A link to nothing would make a file where it points to.
        return path.canonicalize();
    }
    let mut rest = vec![];
    let mut at = path;
    loop {
        if !(at == path && is_link)
            && let Ok(found) = at.canonicalize()
        {
            return Ok(rest.iter().rev().fold(found, |whole, part| whole.join(part)));
        }
        match (at.parent(), at.file_name()) {
            (Some(parent), Some(name)) => {
                rest.push(name.to_owned());
                at = parent;
            }
            _ => return Ok(path.to_owned()),
        }
    }
}

/// Files that a guard is asked about first.
pub struct GuardedFiles {
    /// The files themselves.
    pub files: Box<dyn Files>,
    /// Folders that may be used.
    pub guard: Rc<Guard>,
}

#[deny(clippy::missing_trait_methods)]
impl Files for GuardedFiles {
    fn current_dir(&self) -> String {
        self.files.current_dir()
    }

    fn open(&mut self, path: &str, mode: OpenMode) -> io::Result<Box<dyn Stream>> {
        if mode.write || mode.append || mode.create || mode.truncate {
            self.guard.check_write(path, true)?;
        }
        if mode.read {
            self.guard.check_read(path, true)?;
        }
        self.files.open(path, mode)
    }

    fn info(&self, path: &str, follow: bool) -> io::Result<FileInfo> {
        self.guard.check_read(path, follow)?;
        self.files.info(path, follow)
    }

    fn list(&self, path: &str) -> io::Result<Vec<String>> {
        self.guard.check_read(path, true)?;
        self.files.list(path)
    }

    fn make_dir(&mut self, path: &str) -> io::Result<()> {
        self.guard.check_write(path, false)?;
        self.files.make_dir(path)
    }

    fn remove(&mut self, path: &str) -> io::Result<()> {
        self.guard.check_write(path, false)?;
        self.files.remove(path)
    }

    fn rename(&mut self, from: &str, to: &str) -> io::Result<()> {
        self.guard.check_write(from, false)?;
        self.guard.check_write(to, false)?;
        self.files.rename(from, to)
    }

    fn set_modified(&mut self, path: &str, time: Duration) -> io::Result<()> {
        self.guard.check_write(path, true)?;
        self.files.set_modified(path, time)
    }

    fn read(&mut self, path: &str) -> io::Result<Vec<u8>> {
        self.guard.check_read(path, true)?;
        self.files.read(path)
    }
}

/// Outputs of recorders that a guard is asked about first.
pub struct GuardedOutputs {
    /// The outputs themselves.
    pub outputs: Box<dyn Outputs>,
    /// Folders that may be used.
    pub guard: Rc<Guard>,
}

#[deny(clippy::missing_trait_methods)]
impl Outputs for GuardedOutputs {
    fn create(&mut self, name: &str, path: &Path, format: FileFormat) -> Result<Box<dyn Output>, RecordError> {
        // A recorder replaces its file and follows no link under its name.
        let text = hysteron_files::portable(path);
        let allowed = self.guard.check_write(&text, false);
        allowed.map_err(|e| RecordError(format!("cannot write {name}: {e}")))?;
        self.outputs.create(name, path, format)
    }

    fn series(&mut self, name: &str, path: &Path) -> Result<Box<dyn FileSeries>, RecordError> {
        for (place, follow) in [(path, false), (path.with_extension("").as_path(), true)] {
            let text = hysteron_files::portable(place);
            // The file is replaced. Others go into the folder, so that it must not be a link to elsewhere.
            let allowed = self.guard.check_write(&text, follow);
            allowed.map_err(|e| RecordError(format!("cannot write {name}: {e}")))?;
        }
        self.outputs.series(name, path)
    }
}

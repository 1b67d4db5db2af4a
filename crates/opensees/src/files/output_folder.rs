//! `hysteron run --out DIR`: what a script writes goes into a folder, what it reads is found where it was.
//!
//! A path in the current folder or below it, `results/disp.out` for instance, is written to `DIR/results/disp.out`. It is
//! read from there if the script has written it in this run, and from the current folder otherwise. Files of the current
//! folder are never changed: one that is appended to is copied first, one that is deleted is hidden. Other paths stay.

use super::outputs::{FileFormat, Outputs};
use crate::files::series::{DiskSeries, FileSeries};
use hysteron_engine::record::{Output, RecordError, RowFile};
use hysteron_tcl::{FileInfo, FileKind, Files, OpenMode, OsFiles, Stream};
use std::cell::RefCell;
use std::collections::BTreeSet;
use std::io;
use std::path::Path;
use std::rc::Rc;
use std::time::Duration;

/// The folder of the outputs. Clones share what has been written.
#[derive(Clone)]
pub struct OutputFolder {
    /// Current folder at the start of the script.
    base: String,
    /// Folder of the outputs.
    out: String,
    changes: Rc<RefCell<Changes>>,
}

/// Paths below the current folder, as the script names them.
#[derive(Default)]
struct Changes {
    /// Files and folders that the script has made.
    written: BTreeSet<String>,
    /// Files that the script has deleted.
    deleted: BTreeSet<String>,
}

/// Folder of a path.
fn parent(path: &str) -> &str {
    path.rsplit_once('/').map_or("", |(folder, _)| folder)
}

impl OutputFolder {
    /// Write into a folder, which is made with its parents if it is not there.
    ///
    /// # Errors
    /// The folder cannot be made.
    pub fn new(folder: &Path) -> io::Result<Self> {
        std::fs::create_dir_all(folder)?;
        let base = OsFiles.current_dir();
        let out = std::path::absolute(folder)?.to_string_lossy().replace('\\', "/");
        Ok(Self { base, out, changes: Rc::default() })
    }

    /// The path in the folder of the outputs; `None` for a path elsewhere.
    fn moved(&self, path: &str) -> Option<String> {
        let rest = path.strip_prefix(&self.base).filter(|r| r.starts_with('/'))?;
        Some(format!("{}{rest}", self.out))
    }

    fn is_written(&self, path: &str) -> bool {
        self.changes.borrow().written.contains(path)
    }

    /// Path under which a file is read.
    fn source(&self, path: &str) -> io::Result<String> {
        match self.moved(path) {
            Some(moved) if self.is_written(path) => Ok(moved),
            _ if self.changes.borrow().deleted.contains(path) => Err(io::ErrorKind::NotFound.into()),
            _ => Ok(path.to_owned()),
        }
    }

    /// Path under which a file is written, with its folder made where the script sees one.
    fn target(&self, path: &str) -> io::Result<String> {
        let Some(moved) = self.moved(path) else { return Ok(path.to_owned()) };
        if self.info(parent(path), true)?.kind != FileKind::Directory {
            return Err(io::ErrorKind::NotADirectory.into());
        }
        std::fs::create_dir_all(parent(&moved))?;
        if !self.is_written(path) {
            self.make_room(&moved)?;
        }
        let mut changes = self.changes.borrow_mut();
        changes.written.insert(path.to_owned());
        changes.deleted.remove(path);
        Ok(moved)
    }

    /// Make sure that a file of the folder is made anew: a link in its place is removed and a link to another folder refused,
    /// so that nothing is written to where they point.
    fn make_room(&self, moved: &str) -> io::Result<()> {
        let is_link = |p: &str| std::fs::symlink_metadata(p).is_ok_and(|m| m.file_type().is_symlink());
        let below = self.out.len() + 1;
        let ends = moved.match_indices('/').map(|(at, _)| at).filter(|at| *at >= below);
        if let Some(link) = ends.map(|at| &moved[..at]).find(|folder| is_link(folder)) {
            let why = format!("{link} is a link to another folder, which is not followed");
            return Err(io::Error::new(io::ErrorKind::PermissionDenied, why));
        }
        if is_link(moved) { std::fs::remove_file(moved) } else { Ok(()) }
    }

    fn forget(&self, path: &str) {
        let mut changes = self.changes.borrow_mut();
        changes.written.remove(path);
        changes.deleted.insert(path.to_owned());
    }
}

impl Files for OutputFolder {
    fn current_dir(&self) -> String {
        self.base.clone()
    }

    fn open(&mut self, path: &str, mode: OpenMode) -> io::Result<Box<dyn Stream>> {
        if !mode.write || self.moved(path).is_none() {
            return OsFiles.open(&self.source(path)?, mode);
        }
        let known = self.info(path, true).ok();
        match &known {
            Some(i) if i.kind == FileKind::Directory => return Err(io::ErrorKind::IsADirectory.into()),
            Some(_) if mode.exclusive => return Err(io::ErrorKind::AlreadyExists.into()),
            None if !mode.create => return Err(io::ErrorKind::NotFound.into()),
            _ => {}
        }
        let (was_written, source) = (self.is_written(path), self.source(path));
        let target = self.target(path)?;
        // A file of an earlier run must not be continued.
        if !was_written {
            match known {
                Some(_) if !mode.truncate => std::fs::copy(source?, &target).map(|_| ())?,
                _ => std::fs::write(&target, "")?,
            }
        }
        OsFiles.open(&target, OpenMode { exclusive: false, create: true, ..mode })
    }

    fn info(&self, path: &str, follow: bool) -> io::Result<FileInfo> {
        OsFiles.info(&self.source(path)?, follow)
    }

    fn list(&self, path: &str) -> io::Result<Vec<String>> {
        let changes = self.changes.borrow();
        let child = |name: &str| format!("{}/{name}", path.trim_end_matches('/'));
        let mut names: BTreeSet<String> = match OsFiles.list(path) {
            Ok(names) => names.into_iter().filter(|n| !changes.deleted.contains(&child(n))).collect(),
            Err(_) if changes.written.contains(path) => BTreeSet::new(),
            Err(e) => return Err(e),
        };
        let written = changes.written.iter().filter(|p| parent(p) == path.trim_end_matches('/'));
        let there = written.filter(|p| self.info(p, true).is_ok());
        names.extend(there.filter_map(|p| Some(p.rsplit_once('/')?.1.to_owned())));
        Ok(names.into_iter().collect())
    }

    fn make_dir(&mut self, path: &str) -> io::Result<()> {
        if self.info(path, true).is_ok() {
            return Err(io::ErrorKind::AlreadyExists.into());
        }
        std::fs::create_dir_all(self.target(path)?)
    }

    fn remove(&mut self, path: &str) -> io::Result<()> {
        if self.info(path, false)?.kind == FileKind::Directory && !self.list(path)?.is_empty() {
            return Err(io::ErrorKind::DirectoryNotEmpty.into());
        }
        if self.moved(path).is_none() || self.is_written(path) {
            OsFiles.remove(&self.source(path)?)?;
        }
        self.forget(path);
        Ok(())
    }

    fn rename(&mut self, from: &str, to: &str) -> io::Result<()> {
        let source = self.source(from)?;
        let is_folder = self.info(from, true)?.kind == FileKind::Directory;
        if is_folder && self.moved(from).is_some() {
            self.make_dir(to)?;
            for name in self.list(from)? {
                self.rename(&format!("{from}/{name}"), &format!("{to}/{name}"))?;
            }
            return self.remove(from);
        }
        let was_written = self.is_written(from);
        let target = self.target(to)?;
        if was_written || self.moved(from).is_none() {
            OsFiles.rename(&source, &target)?;
        } else {
            std::fs::copy(&source, &target)?;
        }
        self.forget(from);
        Ok(())
    }

    fn set_modified(&mut self, path: &str, time: Duration) -> io::Result<()> {
        if self.moved(path).is_some() && !self.is_written(path) {
            return self.info(path, true).map(|_| ());
        }
        OsFiles.set_modified(&self.source(path)?, time)
    }
}

impl Outputs for OutputFolder {
    fn create(&mut self, _: &str, path: &Path, f: FileFormat) -> Result<Box<dyn Output>, RecordError> {
        let path = path.to_string_lossy().replace('\\', "/");
        let target = self.target(&path).map_err(|e| RecordError(format!("cannot write {path}: {e}")))?;
        Ok(Box::new(RowFile::create(target.as_ref(), f.layout, f.style, f.close_on_write)?))
    }

    fn series(&mut self, _: &str, path: &Path) -> Result<Box<dyn FileSeries>, RecordError> {
        let path = path.to_string_lossy().replace('\\', "/");
        let cannot = |e: io::Error| RecordError(format!("cannot write {path}: {e}"));
        let target = self.target(&path).map_err(cannot)?;
        // A link in place of the folder is removed.
        self.target(path.strip_suffix(".pvd").unwrap_or(&path)).map_err(cannot)?;
        Ok(Box::new(DiskSeries::new(target.as_ref())?))
    }
}

#[cfg(test)]
mod tests {
    use super::{Changes, OutputFolder};
    use std::rc::Rc;

    #[test]
    fn paths_below_the_current_folder_are_moved() {
        let folder =
            OutputFolder { base: "/a/b".into(), out: "/c".into(), changes: Rc::<_>::new(Changes::default().into()) };
        assert_eq!(folder.moved("/a/b/d/x.out").as_deref(), Some("/c/d/x.out"));
        assert_eq!((folder.moved("/a/bc/x.out"), folder.moved("/a/x.out"), folder.moved("/a/b")), (None, None, None));
    }
}

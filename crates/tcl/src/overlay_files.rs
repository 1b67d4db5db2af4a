//! Files over other files: changes stay in memory, the files below are only read.

use std::collections::BTreeSet;
use std::io;
use std::time::Duration;

use super::files::{FileInfo, FileKind, Files, OpenMode, Stream};
use super::memory_files::{MemoryFiles, parent};

/// Files of the system, with a script's changes to them in memory only.
pub struct OverlayFiles {
    below: Box<dyn Files>,
    above: MemoryFiles,
    /// Files and folders below that have been removed, or hidden by others.
    gone: BTreeSet<String>,
    /// The folder in which an interpreter starts, where it is not that of the files below.
    folder: Option<String>,
}

impl OverlayFiles {
    /// Over some files, none changed yet.
    pub fn new(below: Box<dyn Files>) -> Self {
        Self { below, above: MemoryFiles::default(), gone: BTreeSet::new(), folder: None }
    }

    /// The same with another folder in which an interpreter starts.
    #[must_use]
    pub fn starting_in(self, folder: &str) -> Self {
        Self { folder: Some(folder.to_owned()), ..self }
    }

    /// The same with a text in the place of a file, which need not be there.
    #[must_use]
    pub fn with_text(self, path: &str, text: &str) -> Self {
        self.above.insert(path, text);
        self
    }

    /// Returns true if the file below, or a folder that holds it, has been removed.
    fn hidden(&self, path: &str) -> bool {
        let mut at = path;
        while at != "/" {
            if self.gone.contains(at) {
                return true;
            }
            at = parent(at);
        }
        false
    }

    fn check_parent(&self, path: &str) -> io::Result<()> {
        match self.info(parent(path), true)?.kind {
            FileKind::Directory => Ok(()),
            _ => Err(io::ErrorKind::NotADirectory.into()),
        }
    }
}

impl Files for OverlayFiles {
    fn current_dir(&self) -> String {
        self.folder.clone().unwrap_or_else(|| self.below.current_dir())
    }

    fn open(&mut self, path: &str, mode: OpenMode) -> io::Result<Box<dyn Stream>> {
        let known = self.info(path, true);
        let above = self.above.info(path, true).is_ok();
        match known {
            Ok(i) if i.kind == FileKind::Directory => return Err(io::ErrorKind::IsADirectory.into()),
            Ok(_) if mode.exclusive => return Err(io::ErrorKind::AlreadyExists.into()),
            Ok(_) if above => {}
            Ok(_) if !mode.write => return self.below.open(path, mode),
            Ok(_) => {
                let content = if mode.truncate { vec![] } else { self.below.read(path)? };
                self.above.insert(path, content);
            }
            Err(e) if !mode.create => return Err(e),
            Err(_) => {
                self.check_parent(path)?;
                self.above.insert(path, vec![]);
            }
        }
        self.above.open(path, OpenMode { exclusive: false, ..mode })
    }

    fn info(&self, path: &str, follow: bool) -> io::Result<FileInfo> {
        match self.above.info(path, follow) {
            Ok(info) => Ok(info),
            Err(_) if self.hidden(path) => Err(io::ErrorKind::NotFound.into()),
            Err(_) => self.below.info(path, follow),
        }
    }

    fn list(&self, path: &str) -> io::Result<Vec<String>> {
        if self.info(path, true)?.kind != FileKind::Directory {
            return Err(io::ErrorKind::NotADirectory.into());
        }
        let mut names: BTreeSet<String> = self.above.list(path).unwrap_or_default().into_iter().collect();
        if !self.hidden(path) {
            let child = |n: &String| format!("{}/{n}", path.trim_end_matches('/'));
            let below = self.below.list(path).unwrap_or_default();
            names.extend(below.into_iter().filter(|n| !self.gone.contains(&child(n))));
        }
        Ok(names.into_iter().collect())
    }

    fn make_dir(&mut self, path: &str) -> io::Result<()> {
        if self.info(path, true).is_ok() {
            return Err(io::ErrorKind::AlreadyExists.into());
        }
        self.check_parent(path)?;
        self.above.insert_dir(path);
        Ok(())
    }

    fn remove(&mut self, path: &str) -> io::Result<()> {
        if self.info(path, false)?.kind == FileKind::Directory && !self.list(path)?.is_empty() {
            return Err(io::ErrorKind::DirectoryNotEmpty.into());
        }
        if self.above.info(path, false).is_ok() {
            self.above.remove(path)?;
        }
        self.gone.insert(path.to_owned());
        Ok(())
    }

    fn rename(&mut self, from: &str, to: &str) -> io::Result<()> {
        self.check_parent(to)?;
        if self.info(from, true)?.kind == FileKind::Directory {
            self.make_dir(to)?;
            for name in self.list(from)? {
                self.rename(&format!("{from}/{name}"), &format!("{to}/{name}"))?;
            }
        } else {
            let content = self.read(from)?;
            self.above.insert(to, content);
        }
        self.remove(from)
    }

    /// What has not been changed is read below, in the way that is quickest there.
    fn read(&mut self, path: &str) -> io::Result<Vec<u8>> {
        match self.above.info(path, true) {
            Ok(_) => self.above.read(path),
            Err(_) if self.hidden(path) => Err(io::ErrorKind::NotFound.into()),
            Err(_) => self.below.read(path),
        }
    }

    fn set_modified(&mut self, path: &str, _: Duration) -> io::Result<()> {
        self.info(path, true).map(|_| ())
    }
}

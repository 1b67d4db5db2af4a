//! Files that a script reads, by their hashes.

use hysteron::tcl::{FileInfo, FileKind, Files, OpenMode, Stream};
use sha2::{Digest as _, Sha256};
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::io;
use std::rc::Rc;
use std::time::Duration;

/// Files that a script has read, and those that it has written.
#[derive(Default)]
struct Known {
    /// SHA-256 in hexadecimal digits of each file that was read, by its path.
    read: BTreeMap<String, String>,
    written: BTreeSet<String>,
}

/// The inputs of a run. Clones share what is known. A file that the script has written itself is no input.
#[derive(Clone, Default)]
pub(in crate::cli) struct Inputs(Rc<RefCell<Known>>);

impl Inputs {
    /// Path and hash of each file.
    pub(in crate::cli) fn rows(&self) -> Vec<(String, String)> {
        self.0.borrow().read.iter().map(|(path, hash)| (path.clone(), hash.clone())).collect()
    }

    /// The script writes a file.
    pub(super) fn written(&self, path: &str) {
        self.0.borrow_mut().written.insert(path.to_owned());
    }

    fn is_known(&self, path: &str) -> bool {
        let known = self.0.borrow();
        known.written.contains(path) || known.read.contains_key(path)
    }
}

/// Files that note what is read of them.
pub(super) struct ReadFiles {
    files: Box<dyn Files>,
    inputs: Inputs,
}

impl ReadFiles {
    /// Around other files.
    pub(super) fn new(files: Box<dyn Files>, inputs: Inputs) -> Self {
        Self { files, inputs }
    }

    fn note(&mut self, path: &str) {
        if self.inputs.is_known(path) {
            return;
        }
        let Ok(content) = self.files.read(path) else { return };
        let hash = Sha256::digest(&content).iter().fold(String::new(), |mut out, byte| {
            let _ = write!(out, "{byte:02x}");
            out
        });
        self.inputs.0.borrow_mut().read.insert(path.to_owned(), hash);
    }
}

#[deny(clippy::missing_trait_methods)]
impl Files for ReadFiles {
    fn current_dir(&self) -> String {
        self.files.current_dir()
    }

    fn open(&mut self, path: &str, mode: OpenMode) -> io::Result<Box<dyn Stream>> {
        if mode.write || mode.append {
            self.inputs.written(path);
        } else if mode.read && self.files.info(path, true).is_ok_and(|i| i.kind == FileKind::File) {
            self.note(path);
        }
        self.files.open(path, mode)
    }

    fn info(&self, path: &str, follow: bool) -> io::Result<FileInfo> {
        self.files.info(path, follow)
    }

    fn list(&self, path: &str) -> io::Result<Vec<String>> {
        self.files.list(path)
    }

    fn make_dir(&mut self, path: &str) -> io::Result<()> {
        self.files.make_dir(path)
    }

    fn remove(&mut self, path: &str) -> io::Result<()> {
        self.files.remove(path)
    }

    fn rename(&mut self, from: &str, to: &str) -> io::Result<()> {
        self.files.rename(from, to)
    }

    fn set_modified(&mut self, path: &str, time: Duration) -> io::Result<()> {
        self.files.set_modified(path, time)
    }

    fn read(&mut self, path: &str) -> io::Result<Vec<u8>> {
        if self.files.info(path, true).is_ok_and(|i| i.kind == FileKind::File) {
            self.note(path);
        }
        self.files.read(path)
    }
}

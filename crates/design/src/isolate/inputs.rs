//! Hashes of the files that a script reads, so that results of changed files are made again.

use super::JobOutcome;
use hysteron_tcl::{FileInfo, FileKind, Files, OpenMode, OsFiles, Stream};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::io;
use std::rc::Rc;
use std::time::Duration;

/// FNV-1a, the same on every machine.
pub(super) fn hash(bytes: impl Iterator<Item = u8>) -> u64 {
    bytes.fold(0xcbf2_9ce4_8422_2325, |h, b| (h ^ u64::from(b)).wrapping_mul(0x0100_0000_01b3))
}

/// Hashes by path. Clones share them.
#[derive(Clone, Default)]
pub(super) struct InputHashes(Rc<RefCell<BTreeMap<String, u64>>>);

impl InputHashes {
    pub(super) fn hashes(&self) -> Vec<(String, u64)> {
        self.0.borrow().iter().map(|(path, h)| (path.clone(), *h)).collect()
    }
}

/// Files of the system that note what is read.
pub(super) struct HashedFiles {
    files: OsFiles,
    inputs: InputHashes,
}

impl HashedFiles {
    pub(super) fn new(inputs: InputHashes) -> Self {
        Self { files: OsFiles, inputs }
    }
}

impl Files for HashedFiles {
    fn current_dir(&self) -> String {
        self.files.current_dir()
    }

    fn open(&mut self, path: &str, mode: OpenMode) -> io::Result<Box<dyn Stream>> {
        let reads = mode.read && !mode.write && !mode.append;
        let is_new = || !self.inputs.0.borrow().contains_key(path);
        if reads && self.files.info(path, true).is_ok_and(|i| i.kind == FileKind::File) && is_new() {
            let content = self.files.read(path)?;
            self.inputs.0.borrow_mut().insert(path.to_owned(), hash(content.into_iter()));
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
}

/// Returns true if no file that the analysis has read has changed since.
pub fn is_current(outcome: &JobOutcome) -> bool {
    let same = |(path, h): &(String, u64)| std::fs::read(path).is_ok_and(|content| hash(content.into_iter()) == *h);
    outcome.inputs.iter().all(same)
}

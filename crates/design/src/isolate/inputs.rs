//! Hashes of the files that a script reads, so that results of changed files are made again.

use hysteron_tcl::{FileInfo, FileKind, Files, OpenMode, Stream};
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
pub struct InputHashes(Rc<RefCell<BTreeMap<String, u64>>>);

impl InputHashes {
    /// Paths with the hashes of what was read.
    pub fn hashes(&self) -> Vec<(String, u64)> {
        self.0.borrow().iter().map(|(path, h)| (path.clone(), *h)).collect()
    }
}

/// Files that note what is read.
pub struct HashedFiles {
    files: Box<dyn Files>,
    inputs: InputHashes,
}

impl HashedFiles {
    /// Around other files.
    pub fn new(files: Box<dyn Files>, inputs: InputHashes) -> Self {
        Self { files, inputs }
    }

    /// Note the content of a file that is read for the first time.
    fn note(&mut self, path: &str) -> io::Result<()> {
        let is_new = || !self.inputs.0.borrow().contains_key(path);
        if self.files.info(path, true).is_ok_and(|i| i.kind == FileKind::File) && is_new() {
            let content = self.files.read(path)?;
            self.inputs.0.borrow_mut().insert(path.to_owned(), hash(content.into_iter()));
        }
        Ok(())
    }
}

#[deny(clippy::missing_trait_methods)]
impl Files for HashedFiles {
    fn current_dir(&self) -> String {
        self.files.current_dir()
    }

    fn open(&mut self, path: &str, mode: OpenMode) -> io::Result<Box<dyn Stream>> {
        if mode.read && !mode.write && !mode.append {
            self.note(path)?;
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
        self.note(path)?;
        self.files.read(path)
    }
}

/// Returns true if no file that an analysis has read has changed since.
pub fn is_current(inputs: &[(String, u64)]) -> bool {
    let same =
        |(path, h): &(String, u64)| hysteron_files::read(path).is_ok_and(|content| hash(content.into_iter()) == *h);
    inputs.iter().all(same)
}

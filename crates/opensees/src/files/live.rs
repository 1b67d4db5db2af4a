//! Files of recorders that are still at work, as the script and others see them.
//!
//! OpenSees writes the rows of recorders out at the end of each `analyze`. Here they are written out when somebody may look: when the
//! script touches a file, prints or waits, and at the end of an `analyze` some time after the last time. A script that makes ten
//! thousand steps one by one does not write ten thousand times.

use hysteron_engine::record::{LiveFile, RecordError};
use hysteron_tcl::{FileInfo, Files, OpenMode, Stream};
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::rc::Rc;
use std::sync::{Arc, Weak};
use std::time::{Duration, Instant};

/// Time from which on the rows of an `analyze` are written out at its end.
const INTERVAL: Duration = Duration::from_millis(20);

/// Files of the recorders of a run. Clones share them.
#[derive(Clone)]
pub(crate) struct LiveFiles(Rc<RefCell<Known>>);

struct Known {
    /// Files that others read while they are written, by path.
    files: BTreeMap<String, Weak<dyn LiveFile>>,
    /// Paths of recorders whose rows stay in memory. A file of this name is that of an earlier run.
    in_memory: BTreeSet<String>,
    /// There may be rows that are not written out.
    has_rows: bool,
    last: Instant,
}

impl Default for LiveFiles {
    fn default() -> Self {
        Self(Rc::new(RefCell::new(Known {
            files: BTreeMap::new(),
            in_memory: BTreeSet::new(),
            has_rows: false,
            last: Instant::now(),
        })))
    }
}

impl LiveFiles {
    /// A recorder begins to write this path: into a file, or without one.
    pub(crate) fn add(&self, path: &str, file: Option<&Arc<dyn LiveFile>>) {
        let mut known = self.0.borrow_mut();
        match file {
            Some(file) => {
                known.in_memory.remove(path);
                known.files.insert(path.to_owned(), Arc::downgrade(file));
            }
            None => {
                known.in_memory.insert(path.to_owned());
            }
        }
    }

    /// Rows may follow that are not written out.
    pub(crate) fn mark(&self) {
        self.0.borrow_mut().has_rows = true;
    }

    /// Write out all rows so far.
    ///
    /// # Errors
    /// A file cannot be written.
    pub(crate) fn sync(&self) -> Result<(), RecordError> {
        let mut known = self.0.borrow_mut();
        if !known.has_rows {
            return Ok(());
        }
        let mut result = Ok(());
        // An error of one file must not keep the others from being written.
        known.files.retain(|_, file| {
            let Some(file) = file.upgrade() else { return false };
            if let Err(e) = file.sync() {
                result = Err(e);
            }
            true
        });
        (known.has_rows, known.last) = (result.is_err(), Instant::now());
        result
    }

    /// The same at the end of an `analyze`, unless it was done a moment ago.
    ///
    /// # Errors
    /// As [`LiveFiles::sync`].
    pub(crate) fn sync_if_due(&self) -> Result<(), RecordError> {
        let is_due = { self.0.borrow().last.elapsed() >= INTERVAL };
        if is_due { self.sync() } else { Ok(()) }
    }

    fn show(&self) -> io::Result<()> {
        self.sync().map_err(|e| io::Error::other(e.to_string()))
    }

    fn is_in_memory(&self, path: &str) -> bool {
        self.0.borrow().in_memory.contains(path)
    }

    /// The script writes the path itself.
    fn forget(&self, path: &str) {
        self.0.borrow_mut().in_memory.remove(path);
    }
}

/// Files in which a script finds the rows of its own recorders, and none of an earlier run.
pub(crate) struct RecordedFiles {
    files: Box<dyn Files>,
    live: LiveFiles,
}

impl RecordedFiles {
    /// Around other files, with the recorders of a run.
    pub(crate) fn new(files: Box<dyn Files>, live: LiveFiles) -> Self {
        Self { files, live }
    }

    /// Refuse the file of a recorder whose rows are not in it.
    fn check_rows(&self, path: &str) -> io::Result<()> {
        if !self.live.is_in_memory(path) {
            return Ok(());
        }
        let why = format!(
            "the rows of the recorder of {path} stay in memory here: nodeDisp, eleResponse and the like have its numbers"
        );
        Err(io::Error::new(io::ErrorKind::NotFound, why))
    }
}

#[deny(clippy::missing_trait_methods)]
impl Files for RecordedFiles {
    fn current_dir(&self) -> String {
        self.files.current_dir()
    }

    fn open(&mut self, path: &str, mode: OpenMode) -> io::Result<Box<dyn Stream>> {
        self.live.show()?;
        if !mode.write {
            self.check_rows(path)?;
        }
        let stream = self.files.open(path, mode)?;
        if mode.write {
            self.live.forget(path);
        }
        let is_read_later = mode.read && self.live.0.borrow().files.contains_key(path);
        Ok(if is_read_later { Box::new(LiveStream { stream, live: self.live.clone() }) } else { stream })
    }

    fn info(&self, path: &str, follow: bool) -> io::Result<FileInfo> {
        self.live.show()?;
        self.check_rows(path)?;
        self.files.info(path, follow)
    }

    fn list(&self, path: &str) -> io::Result<Vec<String>> {
        self.live.show()?;
        let mut names = self.files.list(path)?;
        names.retain(|name| !self.live.is_in_memory(&format!("{}/{name}", path.trim_end_matches('/'))));
        Ok(names)
    }

    fn make_dir(&mut self, path: &str) -> io::Result<()> {
        self.files.make_dir(path)
    }

    fn remove(&mut self, path: &str) -> io::Result<()> {
        self.live.show()?;
        self.check_rows(path)?;
        self.files.remove(path)
    }

    fn rename(&mut self, from: &str, to: &str) -> io::Result<()> {
        self.live.show()?;
        self.check_rows(from)?;
        self.files.rename(from, to)?;
        self.live.forget(to);
        Ok(())
    }

    fn set_modified(&mut self, path: &str, time: Duration) -> io::Result<()> {
        self.check_rows(path)?;
        self.files.set_modified(path, time)
    }

    fn read(&mut self, path: &str) -> io::Result<Vec<u8>> {
        self.live.show()?;
        self.check_rows(path)?;
        self.files.read(path)
    }
}

/// An open file of a recorder: who reads on after an `analyze` finds its rows.
struct LiveStream {
    stream: Box<dyn Stream>,
    live: LiveFiles,
}

impl Read for LiveStream {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        self.live.show()?;
        self.stream.read(buffer)
    }
}

impl Write for LiveStream {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.stream.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.stream.flush()
    }
}

impl Seek for LiveStream {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.live.show()?;
        self.stream.seek(to)
    }
}

impl Stream for LiveStream {
    fn set_len(&mut self, length: u64) -> io::Result<()> {
        self.stream.set_len(length)
    }
}

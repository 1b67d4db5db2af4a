//! Files of rows that others read while they are written.

use crate::lock::{check_free, open_alone};
use std::ffi::OsString;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Seek as _, Write as _};
use std::path::{Path, PathBuf};

/// Bytes that are held back at most, but for a row that is longer.
const MAX_PENDING: usize = 8 << 10;

/// A file of rows with one writer.
///
/// It gets its name with the first [`ResultFile::sync`] that has rows, and has whole rows from then on. Before that it is a hidden
/// file beside its place. A file that stood under its name is gone as soon as this one begins. Dropped, it is finished.
#[derive(Debug)]
pub struct ResultFile {
    place: PathBuf,
    /// The hidden file beside it; `None` once it has its name.
    part: Option<PathBuf>,
    file: Option<File>,
    /// Whole rows that are not in the file yet.
    pending: Vec<u8>,
    /// What is in the file is replaced by what is pending.
    begins_anew: bool,
    /// The file has rows, or is to have.
    has_rows: bool,
    /// A device or a pipe, which takes what comes.
    is_special: bool,
}

/// Name of the hidden file of a result. One name for each, so that what a killed run has left is replaced.
fn part_of(place: &Path) -> PathBuf {
    /// Names of files have 255 bytes at most.
    const MAX_NAME: usize = 200;
    let name = place.file_name().unwrap_or_default();
    let mut part = OsString::from(".");
    match name.to_str().filter(|n| n.len() > MAX_NAME) {
        None => part.push(name),
        Some(long) => part.push(long.chars().take(MAX_NAME / 4).collect::<String>()),
    }
    part.push(".part");
    place.with_file_name(part)
}

impl ResultFile {
    /// Begin a file. With `at_once` it has its name from the beginning.
    ///
    /// # Errors
    /// It cannot be written, or another writer has it.
    pub fn create(place: &Path, at_once: bool) -> io::Result<Self> {
        let known = fs::symlink_metadata(place).ok().map(|m| m.file_type());
        if known.is_some_and(|t| t.is_dir()) {
            return Err(io::ErrorKind::IsADirectory.into());
        }
        let is_special = known.is_some_and(|t| !t.is_file() && !t.is_symlink());
        let mut made = Self {
            place: place.to_owned(),
            part: None,
            file: None,
            pending: vec![],
            begins_anew: false,
            has_rows: false,
            is_special,
        };
        if is_special {
            made.file = Some(OpenOptions::new().write(true).open(place)?);
            return Ok(made);
        }
        if known.is_some_and(|t| t.is_file()) {
            check_free(place)?;
        }
        let part = part_of(place);
        let file = open_alone(&part)?;
        file.set_len(0)?;
        (made.file, made.part) = (Some(file), Some(part));
        if known.is_some() {
            fs::remove_file(place)?;
        }
        if at_once {
            made.publish()?;
        }
        Ok(made)
    }

    /// Append a whole row, which `write` puts behind the bytes that it gets.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn append(&mut self, write: impl FnOnce(&mut Vec<u8>)) -> io::Result<()> {
        if self.file.is_none() {
            return Ok(());
        }
        let before = self.pending.len();
        // Once for all rows: steps of an analysis allocate nothing.
        self.pending.reserve(if before == 0 { MAX_PENDING } else { 0 });
        write(&mut self.pending);
        self.has_rows = true;
        let row = self.pending.len() - before;
        if self.pending.len() + row > MAX_PENDING { self.write_pending() } else { Ok(()) }
    }

    /// Replace all rows by those that follow.
    pub fn begin_anew(&mut self) {
        self.pending.clear();
        self.begins_anew = true;
    }

    /// Returns true if more can be written.
    pub fn is_open(&self) -> bool {
        self.file.is_some()
    }

    fn write_pending(&mut self) -> io::Result<()> {
        let Some(file) = &mut self.file else { return Ok(()) };
        if std::mem::take(&mut self.begins_anew) && !self.is_special {
            file.set_len(0)?;
            file.rewind()?;
        }
        let written = file.write_all(&self.pending);
        self.pending.clear();
        written
    }

    /// Give the file its name.
    fn publish(&mut self) -> io::Result<()> {
        if let Some(part) = &self.part {
            fs::rename(part, &self.place)?;
            self.part = None;
        }
        Ok(())
    }

    /// Show others all rows so far. Without a row there is no file yet.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn sync(&mut self) -> io::Result<()> {
        if !self.has_rows || self.file.is_none() {
            return Ok(());
        }
        if !self.pending.is_empty() || self.begins_anew {
            self.write_pending()?;
        }
        self.publish()
    }

    /// No rows will follow: the file is there, without a row too.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn finish(&mut self) -> io::Result<()> {
        if self.file.is_none() {
            return Ok(());
        }
        let done = self.write_pending().and_then(|()| self.publish());
        self.file = None;
        done
    }
}

impl Drop for ResultFile {
    fn drop(&mut self) {
        // Errors have come up with the rows before.
        let _ = self.finish();
    }
}

#[cfg(test)]
mod tests {
    use super::{MAX_PENDING, ResultFile};
    use crate::{Scratch, list, read, write};
    use std::io::ErrorKind;

    fn push(file: &mut ResultFile, text: &str) {
        file.append(|bytes| bytes.extend_from_slice(text.as_bytes())).expect("it is written");
    }

    #[test]
    fn a_file_of_rows_is_absent_or_has_whole_rows_of_its_own() {
        let scratch = Scratch::new("test").expect("a folder");
        let path = scratch.path().join("d.out");
        write(&path, "of an earlier run\n").expect("it is written");
        let mut file = ResultFile::create(&path, false).expect("it is made");
        assert!(!path.exists(), "a file of an earlier run is gone");
        file.sync().expect("it is synced");
        assert!(!path.exists(), "without a row there is no file");
        let row = "0123456789\n";
        for _ in 0..=MAX_PENDING / row.len() + 1 {
            push(&mut file, row);
        }
        assert!(!path.exists());
        file.sync().expect("it is synced");
        let whole = |n: usize| read(&path).expect("it is read").len() == n * row.len();
        assert!(whole(MAX_PENDING / row.len() + 2));
        file.begin_anew();
        push(&mut file, row);
        file.sync().expect("it is synced");
        assert!(whole(1));
        push(&mut file, row);
        assert!(whole(1), "rows are held back");
        file.finish().expect("it is finished");
        assert!(whole(2));
        assert_eq!(list(scratch.path()).expect("names"), ["d.out"]);
    }

    #[test]
    fn a_file_has_one_writer() {
        let scratch = Scratch::new("test").expect("a folder");
        let path = scratch.path().join("d.out");
        let mut first = ResultFile::create(&path, false).expect("it is made");
        let busy = |path| ResultFile::create(path, false).err().map(|e| e.kind());
        assert_eq!(busy(&path), Some(ErrorKind::ResourceBusy));
        push(&mut first, "1\n");
        first.sync().expect("it is synced");
        assert_eq!(busy(&path), Some(ErrorKind::ResourceBusy));
        first.finish().expect("it is finished");
        drop(ResultFile::create(&path, true).expect("it is free again"));
        assert_eq!(read(&path).expect("an empty file"), b"");
    }

    #[cfg(unix)]
    #[test]
    fn links_are_replaced() {
        let scratch = Scratch::new("test").expect("a folder");
        let kept = scratch.path().join("kept");
        write(&kept, "kept").expect("it is written");
        for name in ["d.out", ".d.out.part"] {
            std::os::unix::fs::symlink(&kept, scratch.path().join(name)).expect("a link");
        }
        let mut file = ResultFile::create(&scratch.path().join("d.out"), false).expect("it is made");
        push(&mut file, "1\n");
        drop(file);
        assert_eq!(read(&kept).expect("it is read"), b"kept");
        assert_eq!(read(scratch.path().join("d.out")).expect("it is read"), b"1\n");
    }
}

//! Read-only files for the script of a study. Each is looked for and read from the disk once.

use hysteron_tcl::{FileInfo, FileKind, Files, OpenMode, OsFiles, Stream};
use std::collections::HashMap;
use std::io::{self, Cursor, Read, Seek, SeekFrom, Write};
use std::sync::{Arc, Mutex};
use std::time::Duration;

/// Contents of files by path. Clones share them.
#[derive(Clone, Debug, Default)]
pub(super) struct FileContents {
    known: Arc<Mutex<HashMap<String, KnownFile>>>,
    /// Files and folders that have not been read: `None` where there is none.
    seen: Arc<Mutex<HashMap<String, Option<FileInfo>>>>,
}

/// A file that has been read.
#[derive(Clone, Debug)]
struct KnownFile {
    content: Arc<[u8]>,
    info: FileInfo,
}

impl KnownFile {
    /// A text that takes the place of a file, which may not be on the disk.
    fn text(text: &str) -> Self {
        let (size, epoch) = (text.len() as u64, Duration::ZERO);
        let info = FileInfo { kind: FileKind::File, size, modified: epoch, accessed: epoch, mode: 0o444 };
        Self { content: text.as_bytes().into(), info }
    }
}

impl FileContents {
    /// A copy with another text for one file.
    pub(super) fn with_text(&self, path: &str, text: &str) -> Self {
        let mut texts = self.known.lock().map_or_else(|e| e.into_inner().clone(), |k| k.clone());
        texts.insert(path.to_owned(), KnownFile::text(text));
        Self { known: Arc::new(Mutex::new(texts)), seen: self.seen.clone() }
    }

    /// Paths and texts, in the order of the paths.
    pub(super) fn texts(&self) -> Vec<(String, String)> {
        let texts = self.known.lock().map_or_else(|e| e.into_inner().clone(), |k| k.clone());
        let texts = texts.iter().map(|(path, f)| (path.clone(), String::from_utf8_lossy(&f.content).into_owned()));
        let mut texts: Vec<_> = texts.collect();
        texts.sort();
        texts
    }

    /// Metadata of a file that has not been read. Every run asks for the folder of its recorders.
    fn seen(&self, path: &str) -> io::Result<FileInfo> {
        let mut seen = self.seen.lock().map_err(|_| io::Error::from(io::ErrorKind::Other))?;
        if let Some(info) = seen.get(path) {
            return info.clone().ok_or_else(|| io::ErrorKind::NotFound.into());
        }
        let info = OsFiles.info(path, true);
        match &info {
            Ok(info) => drop(seen.insert(path.to_owned(), Some(info.clone()))),
            Err(e) if e.kind() == io::ErrorKind::NotFound => drop(seen.insert(path.to_owned(), None)),
            Err(_) => {}
        }
        info
    }
}

/// Files of the system, kept in memory once they are read. Writing is refused: an overlay takes what a script writes.
pub(super) struct CachedFiles {
    folder: String,
    contents: FileContents,
}

impl CachedFiles {
    /// Files with `folder` as the current folder.
    pub(super) fn new(folder: &str, contents: &FileContents) -> Self {
        Self { folder: folder.to_owned(), contents: contents.clone() }
    }

    fn content(&self, path: &str) -> io::Result<Arc<[u8]>> {
        let mut texts = self.contents.known.lock().map_err(|_| io::Error::from(io::ErrorKind::Other))?;
        if let Some(known) = texts.get(path) {
            return Ok(known.content.clone());
        }
        let content: Arc<[u8]> = OsFiles.read(path)?.into();
        let info = OsFiles.info(path, true)?;
        texts.insert(path.to_owned(), KnownFile { content: content.clone(), info });
        Ok(content)
    }
}

fn read_only<T>() -> io::Result<T> {
    Err(io::ErrorKind::PermissionDenied.into())
}

impl Files for CachedFiles {
    fn current_dir(&self) -> String {
        self.folder.clone()
    }

    fn open(&mut self, path: &str, mode: OpenMode) -> io::Result<Box<dyn Stream>> {
        if mode.write {
            return read_only();
        }
        Ok(Box::new(ReadStream(Cursor::new(self.content(path)?))))
    }

    fn info(&self, path: &str, follow: bool) -> io::Result<FileInfo> {
        let texts = self.contents.known.lock().map_err(|_| io::Error::from(io::ErrorKind::Other))?;
        match (texts.get(path), follow) {
            (Some(known), true) => Ok(known.info.clone()),
            (None, true) => self.contents.seen(path),
            // A replaced text may have no file on the disk.
            (known, _) => OsFiles.info(path, follow).or_else(|e| known.map(|k| k.info.clone()).ok_or(e)),
        }
    }

    fn list(&self, path: &str) -> io::Result<Vec<String>> {
        OsFiles.list(path)
    }

    fn make_dir(&mut self, _: &str) -> io::Result<()> {
        read_only()
    }

    fn remove(&mut self, _: &str) -> io::Result<()> {
        read_only()
    }

    fn rename(&mut self, _: &str, _: &str) -> io::Result<()> {
        read_only()
    }

    fn set_modified(&mut self, _: &str, _: Duration) -> io::Result<()> {
        read_only()
    }

    fn read(&mut self, path: &str) -> io::Result<Vec<u8>> {
        Ok(self.content(path)?.to_vec())
    }
}

/// A stream that reads a cached file.
struct ReadStream(Cursor<Arc<[u8]>>);

impl Read for ReadStream {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        self.0.read(buffer)
    }

    fn read_to_end(&mut self, out: &mut Vec<u8>) -> io::Result<usize> {
        self.0.read_to_end(out)
    }
}

impl Write for ReadStream {
    fn write(&mut self, _: &[u8]) -> io::Result<usize> {
        read_only()
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Seek for ReadStream {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.0.seek(to)
    }
}

impl Stream for ReadStream {
    fn set_len(&mut self, _: u64) -> io::Result<()> {
        read_only()
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::{CachedFiles, FileContents};
    use hysteron_tcl::{Files as _, OpenMode, OverlayFiles};

    #[test]
    fn a_run_reads_what_it_has_written_and_no_other_does() {
        let contents = FileContents::default().with_text("/study/motion.dat", "1 2");
        let files = || OverlayFiles::new(Box::new(CachedFiles::new("/study", &contents)));
        let mut own = files();
        assert_eq!(own.read("/study/motion.dat").unwrap(), b"1 2");
        let anew = OpenMode { write: true, create: true, truncate: true, ..OpenMode::default() };
        own.open("/study/motion.dat", anew).unwrap().write_all(b"3").unwrap();
        assert_eq!(own.read("/study/motion.dat").unwrap(), b"3");
        assert_eq!(files().read("/study/motion.dat").unwrap(), b"1 2");
        own.remove("/study/motion.dat").unwrap();
        assert!(own.read("/study/motion.dat").is_err());
    }
}

//! The files that the script of a study sees: those of its folder, each read from the disk once.

use hysteron_tcl::{FileInfo, FileKind, Files, OpenMode, OsFiles, Stream};
use std::collections::HashMap;
use std::io::{self, Cursor, Read, Seek, SeekFrom, Write};
use std::sync::{Arc, Mutex};
use std::time::Duration;

/// Contents of files by their path; clones share them.
#[derive(Clone, Debug, Default)]
pub(super) struct Contents(Arc<Mutex<HashMap<String, Arc<[u8]>>>>);

impl Contents {
    /// The same, with another text for one file.
    pub(super) fn with(&self, path: &str, text: &str) -> Self {
        let mut known = self.0.lock().map_or_else(|e| e.into_inner().clone(), |k| k.clone());
        known.insert(path.to_owned(), text.as_bytes().into());
        Self(Arc::new(Mutex::new(known)))
    }
}

/// Files of the system, remembered once they are read. What a script writes goes to an overlay, never here.
pub(super) struct StudyFiles {
    folder: String,
    contents: Contents,
}

impl StudyFiles {
    /// With `folder` as the current one.
    pub(super) fn new(folder: &str, contents: &Contents) -> Self {
        Self { folder: folder.to_owned(), contents: contents.clone() }
    }

    fn content(&self, path: &str) -> io::Result<Arc<[u8]>> {
        let mut known = self.contents.0.lock().map_err(|_| io::Error::from(io::ErrorKind::Other))?;
        if let Some(content) = known.get(path) {
            return Ok(content.clone());
        }
        let content: Arc<[u8]> = OsFiles.read(path)?.into();
        known.insert(path.to_owned(), content.clone());
        Ok(content)
    }
}

fn read_only<T>() -> io::Result<T> {
    Err(io::ErrorKind::PermissionDenied.into())
}

impl Files for StudyFiles {
    fn current_dir(&self) -> String {
        self.folder.clone()
    }

    fn open(&mut self, path: &str, mode: OpenMode) -> io::Result<Box<dyn Stream>> {
        if mode.write {
            return read_only();
        }
        Ok(Box::new(Content(Cursor::new(self.content(path)?))))
    }

    fn info(&self, path: &str, follow: bool) -> io::Result<FileInfo> {
        OsFiles.info(path, follow).or_else(|e| {
            // A text that was put in place of a file that is not there.
            let known = self.contents.0.lock().map_err(|_| io::Error::from(io::ErrorKind::Other))?;
            let size = known.get(path).ok_or(e)?.len() as u64;
            let long_ago = Duration::ZERO;
            Ok(FileInfo { kind: FileKind::File, size, modified: long_ago, accessed: long_ago, mode: 0o444 })
        })
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
}

/// A content that is read.
struct Content(Cursor<Arc<[u8]>>);

impl Read for Content {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        self.0.read(buffer)
    }

    fn read_to_end(&mut self, out: &mut Vec<u8>) -> io::Result<usize> {
        self.0.read_to_end(out)
    }
}

impl Write for Content {
    fn write(&mut self, _: &[u8]) -> io::Result<usize> {
        read_only()
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Seek for Content {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.0.seek(to)
    }
}

impl Stream for Content {
    fn set_len(&mut self, _: u64) -> io::Result<()> {
        read_only()
    }
}

//! The files that a script sees: those of the system, or some in memory.

use std::io::{self, Read, Seek, Write};
use std::time::{Duration, SystemTime};

use super::error::Exception;
use hysteron_files::{self as system, Access, File};

pub use hysteron_files::{MAX_FILE_SIZE, read_whole};

/// An open file.
pub trait Stream: Read + Write + Seek {
    /// Cut or extend the file to a length in bytes.
    fn set_len(&mut self, length: u64) -> io::Result<()>;
}

impl Stream for File {
    fn set_len(&mut self, length: u64) -> io::Result<()> {
        File::set_len(self, length)
    }
}

/// Mode in which a file is opened.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct OpenMode {
    /// For reading.
    pub read: bool,
    /// For writing.
    pub write: bool,
    /// All writing goes to the end.
    pub append: bool,
    /// Made if it does not exist.
    pub create: bool,
    /// An error if it exists.
    pub exclusive: bool,
    /// Emptied.
    pub truncate: bool,
}

/// Of what kind a file is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileKind {
    /// A file with content.
    File,
    /// A folder.
    Directory,
    /// A symbolic link, where links are not followed.
    Link,
    /// A device, a pipe and the like.
    Other,
}

/// Metadata of a file.
#[derive(Clone, Debug)]
pub struct FileInfo {
    /// Of what kind it is.
    pub kind: FileKind,
    /// Length in bytes.
    pub size: u64,
    /// Time of the last change, since 1970.
    pub modified: Duration,
    /// Time of the last reading, since 1970.
    pub accessed: Duration,
    /// Permissions as in Unix.
    pub mode: u32,
}

/// Access of a script to files.
///
/// Paths are absolute, with `/` between their parts and no `.` or `..` in them. Errors are those of the system: their
/// kinds decide the text and the error code that the script sees.
pub trait Files {
    /// The folder in which a new interpreter starts.
    fn current_dir(&self) -> String;
    /// Open a file.
    fn open(&mut self, path: &str, mode: OpenMode) -> io::Result<Box<dyn Stream>>;
    /// Metadata of a file; with `follow`, of the one that a link points to.
    fn info(&self, path: &str, follow: bool) -> io::Result<FileInfo>;
    /// Names of the files in a folder, in any order.
    fn list(&self, path: &str) -> io::Result<Vec<String>>;
    /// Make a folder, its parents being there.
    fn make_dir(&mut self, path: &str) -> io::Result<()>;
    /// Remove a file or an empty folder.
    fn remove(&mut self, path: &str) -> io::Result<()>;
    /// Move a file or a folder.
    fn rename(&mut self, from: &str, to: &str) -> io::Result<()>;
    /// Set the time of the last change.
    fn set_modified(&mut self, path: &str, time: Duration) -> io::Result<()>;

    /// The whole content of a file.
    fn read(&mut self, path: &str) -> io::Result<Vec<u8>> {
        read_whole(self.open(path, OpenMode { read: true, ..OpenMode::default() })?)
    }
}

/// The files of the system.
#[derive(Clone, Copy, Debug, Default)]
pub struct OsFiles;

impl Files for OsFiles {
    fn current_dir(&self) -> String {
        std::env::current_dir().map_or_else(|_| "/".to_owned(), system::portable)
    }

    fn open(&mut self, path: &str, mode: OpenMode) -> io::Result<Box<dyn Stream>> {
        let OpenMode { read, write, append, create, exclusive, truncate } = mode;
        Ok(Box::new(system::open(path, Access { read, write, append, create, exclusive, truncate })?))
    }

    fn info(&self, path: &str, follow: bool) -> io::Result<FileInfo> {
        let meta = if follow { system::info(path)? } else { system::link_info(path)? };
        let since = |t: io::Result<SystemTime>| {
            t.ok().and_then(|t| t.duration_since(SystemTime::UNIX_EPOCH).ok()).unwrap_or_default()
        };
        let kind = match meta.file_type() {
            t if t.is_dir() => FileKind::Directory,
            t if t.is_file() => FileKind::File,
            t if t.is_symlink() => FileKind::Link,
            _ => FileKind::Other,
        };
        Ok(FileInfo {
            kind,
            size: meta.len(),
            modified: since(meta.modified()),
            accessed: since(meta.accessed()),
            mode: system::permissions(&meta),
        })
    }

    fn list(&self, path: &str) -> io::Result<Vec<String>> {
        system::list(path)
    }

    fn make_dir(&mut self, path: &str) -> io::Result<()> {
        system::make_folder(path)
    }

    fn remove(&mut self, path: &str) -> io::Result<()> {
        system::remove(path)
    }

    fn rename(&mut self, from: &str, to: &str) -> io::Result<()> {
        system::rename(from, to)
    }

    fn set_modified(&mut self, path: &str, time: Duration) -> io::Result<()> {
        system::set_modified(path, time)
    }

    fn read(&mut self, path: &str) -> io::Result<Vec<u8>> {
        system::read(path)
    }
}

/// The error for a file, its message made from the reason.
pub(crate) fn posix(error: &io::Error, message: impl FnOnce(&str) -> String) -> Exception {
    let (code, why) = reason(error);
    let failed = Exception::coded(message(why), &["POSIX", code, why]);
    // The host may say more than the system would.
    match error.get_ref() {
        Some(said) => failed.help(said.to_string()),
        None => failed,
    }
}

/// Error of a file, in the words of the C library that Tcl uses.
fn reason(error: &io::Error) -> (&'static str, &'static str) {
    use io::ErrorKind as K;
    match error.kind() {
        K::NotFound => ("ENOENT", "no such file or directory"),
        K::PermissionDenied => ("EACCES", "permission denied"),
        K::AlreadyExists => ("EEXIST", "file already exists"),
        K::IsADirectory => ("EISDIR", "illegal operation on a directory"),
        K::NotADirectory => ("ENOTDIR", "not a directory"),
        K::DirectoryNotEmpty => ("EEXIST", "file already exists"),
        K::StorageFull => ("ENOSPC", "no space left on device"),
        K::ReadOnlyFilesystem => ("EROFS", "read-only file system"),
        K::InvalidInput | K::InvalidFilename => ("EINVAL", "invalid argument"),
        K::FileTooLarge => ("EFBIG", "file too large"),
        _ => ("EIO", "i/o error"),
    }
}

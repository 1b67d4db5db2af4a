//! The files that a script sees: those of the system, or some in memory.

use std::fs;
use std::io::{self, Read, Seek, Write};
use std::path::Path;
use std::time::{Duration, SystemTime};

use super::error::Exception;

/// An open file.
pub trait Stream: Read + Write + Seek {
    /// Cut or extend the file to a length in bytes.
    fn set_len(&mut self, length: u64) -> io::Result<()>;
}

impl Stream for fs::File {
    fn set_len(&mut self, length: u64) -> io::Result<()> {
        fs::File::set_len(self, length)
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

/// Largest file that is read as a whole, in bytes. A device such as `/dev/zero` has no end.
pub const MAX_FILE_SIZE: u64 = 1 << 30;

/// The whole content of a file.
///
/// # Errors
/// It cannot be read, or has more than [`MAX_FILE_SIZE`] bytes.
pub fn read_whole(file: impl Read) -> io::Result<Vec<u8>> {
    let mut content = vec![];
    if file.take(MAX_FILE_SIZE + 1).read_to_end(&mut content)? as u64 > MAX_FILE_SIZE {
        return Err(io::ErrorKind::FileTooLarge.into());
    }
    Ok(content)
}

/// The files of the system.
#[derive(Clone, Copy, Debug, Default)]
pub struct OsFiles;

impl Files for OsFiles {
    fn current_dir(&self) -> String {
        std::env::current_dir().map_or_else(|_| "/".to_owned(), |d| d.to_string_lossy().replace('\\', "/"))
    }

    fn open(&mut self, path: &str, mode: OpenMode) -> io::Result<Box<dyn Stream>> {
        // Opening a folder for reading succeeds on some systems; Tcl refuses it.
        if Path::new(path).is_dir() {
            return Err(io::ErrorKind::IsADirectory.into());
        }
        let file = fs::OpenOptions::new()
            .read(mode.read)
            .write(mode.write && !mode.append)
            .append(mode.append)
            .truncate(mode.truncate)
            .create(mode.create && !mode.exclusive)
            .create_new(mode.exclusive)
            .open(path)?;
        Ok(Box::new(file))
    }

    fn info(&self, path: &str, follow: bool) -> io::Result<FileInfo> {
        let meta = if follow { fs::metadata(path)? } else { fs::symlink_metadata(path)? };
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
            mode: mode_of(&meta),
        })
    }

    fn list(&self, path: &str) -> io::Result<Vec<String>> {
        fs::read_dir(path)?.map(|e| Ok(e?.file_name().to_string_lossy().into_owned())).collect()
    }

    fn make_dir(&mut self, path: &str) -> io::Result<()> {
        fs::create_dir(path)
    }

    fn remove(&mut self, path: &str) -> io::Result<()> {
        if fs::symlink_metadata(path)?.is_dir() { fs::remove_dir(path) } else { fs::remove_file(path) }
    }

    fn rename(&mut self, from: &str, to: &str) -> io::Result<()> {
        fs::rename(from, to)
    }

    fn set_modified(&mut self, path: &str, time: Duration) -> io::Result<()> {
        fs::OpenOptions::new().append(true).open(path)?.set_modified(SystemTime::UNIX_EPOCH + time)
    }
}

#[cfg(unix)]
fn mode_of(meta: &fs::Metadata) -> u32 {
    use std::os::unix::fs::PermissionsExt as _;
    meta.permissions().mode() & 0o7777
}

#[cfg(not(unix))]
fn mode_of(meta: &fs::Metadata) -> u32 {
    let write = if meta.permissions().readonly() { 0 } else { 0o222 };
    0o444 | write | if meta.is_dir() { 0o111 } else { 0 }
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

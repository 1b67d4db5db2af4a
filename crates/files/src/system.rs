//! Single operations of the system.

use std::fs::{self, File, Metadata, OpenOptions};
use std::io;
use std::path::{Component, Path, PathBuf};
use std::time::{Duration, SystemTime};

/// Use of a file that is opened.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Access {
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

/// Path of a file from a folder, with `/` between the names. It is the whole path where both share no folder but the root.
///
/// # Errors
/// One of both does not exist.
pub fn path_from(folder: &Path, file: &Path) -> io::Result<String> {
    let (folder, file) = (folder.canonicalize()?, file.canonicalize()?);
    let shared: Vec<Component<'_>> =
        folder.components().zip(file.components()).take_while(|(a, b)| a == b).map(|(a, _)| a).collect();
    let path: PathBuf = if shared.iter().any(|c| matches!(c, Component::Normal(_))) {
        let up = folder.components().skip(shared.len()).map(|_| Component::ParentDir);
        up.chain(file.components().skip(shared.len())).collect()
    } else {
        file.clone()
    };
    Ok(portable(path))
}

/// Open a file. A link is followed: who may not trust its folder uses [`crate::write`].
///
/// # Errors
/// It cannot be opened so, or is a folder.
pub fn open(path: impl AsRef<Path>, access: Access) -> io::Result<File> {
    // Opening a folder for reading succeeds on some systems.
    if path.as_ref().is_dir() {
        return Err(io::ErrorKind::IsADirectory.into());
    }
    OpenOptions::new()
        .read(access.read)
        .write(access.write && !access.append)
        .append(access.append)
        .truncate(access.truncate)
        .create(access.create && !access.exclusive)
        .create_new(access.exclusive)
        .open(path)
}

/// Metadata of a file, of the one that a link points to.
///
/// # Errors
/// It is not there.
pub fn info(path: impl AsRef<Path>) -> io::Result<Metadata> {
    fs::metadata(path)
}

/// Metadata of a file, of a link itself.
///
/// # Errors
/// It is not there.
pub fn link_info(path: impl AsRef<Path>) -> io::Result<Metadata> {
    fs::symlink_metadata(path)
}

/// Returns true if the path is that of a symbolic link.
pub fn is_link(path: impl AsRef<Path>) -> bool {
    link_info(path).is_ok_and(|m| m.file_type().is_symlink())
}

/// Permissions as in Unix.
#[cfg(unix)]
pub fn permissions(info: &Metadata) -> u32 {
    use std::os::unix::fs::PermissionsExt as _;
    info.permissions().mode() & 0o7777
}

/// Permissions as in Unix.
#[cfg(not(unix))]
pub fn permissions(info: &Metadata) -> u32 {
    let write = if info.permissions().readonly() { 0 } else { 0o222 };
    0o444 | write | if info.is_dir() { 0o111 } else { 0 }
}

/// Remove a file, a link or an empty folder.
///
/// # Errors
/// It cannot be removed, or is not there.
pub fn remove(path: impl AsRef<Path>) -> io::Result<()> {
    let path = path.as_ref();
    if link_info(path)?.is_dir() { fs::remove_dir(path) } else { fs::remove_file(path) }
}

/// Move a file or a folder.
///
/// # Errors
/// It cannot be moved.
pub fn rename(from: impl AsRef<Path>, to: impl AsRef<Path>) -> io::Result<()> {
    fs::rename(from, to)
}

/// Set the time of the last change, since 1970.
///
/// # Errors
/// The file cannot be written.
pub fn set_modified(path: impl AsRef<Path>, time: Duration) -> io::Result<()> {
    OpenOptions::new().append(true).open(path)?.set_modified(SystemTime::UNIX_EPOCH + time)
}

/// A path as text with `/` between its parts. A backslash is a letter of a name where the system takes it as one.
pub fn portable(path: impl AsRef<Path>) -> String {
    let text = path.as_ref().to_string_lossy();
    if cfg!(windows) { text.replace('\\', "/") } else { text.into_owned() }
}

//! Folders.

use std::fs::{self, DirBuilder};
use std::io::{self, ErrorKind};
use std::path::Path;

/// Make a folder whose parent is there.
///
/// # Errors
/// It cannot be made, or is there.
pub fn make_folder(path: impl AsRef<Path>) -> io::Result<()> {
    fs::create_dir(path)
}

/// Make a folder that this user alone may use.
///
/// # Errors
/// As [`make_folder`].
pub fn make_own_folder(path: impl AsRef<Path>) -> io::Result<()> {
    #[cfg_attr(not(unix), expect(unused_mut))]
    let mut builder = DirBuilder::new();
    #[cfg(unix)]
    std::os::unix::fs::DirBuilderExt::mode(&mut builder, 0o700);
    builder.create(path)
}

/// Make a folder with its parents, where they are not there.
///
/// # Errors
/// It cannot be made; the message names it.
pub fn make_folders(path: impl AsRef<Path>) -> io::Result<()> {
    let path = path.as_ref();
    let named = |e: io::Error| io::Error::new(e.kind(), format!("cannot make {}: {e}", path.display()));
    fs::create_dir_all(path).map_err(named)
}

/// Make a folder within a folder of results, where it is not there.
///
/// # Errors
/// It cannot be made, or is a link to another folder; the message names it.
pub fn make_inner_folder(path: impl AsRef<Path>) -> io::Result<()> {
    let path = path.as_ref();
    if crate::is_link(path) {
        let why = format!("{} is a link to another folder, which is not followed", path.display());
        return Err(io::Error::new(ErrorKind::PermissionDenied, why));
    }
    make_folders(path)
}

/// Names of the files in a folder, in the order of their letters.
///
/// # Errors
/// It cannot be read.
pub fn list(path: impl AsRef<Path>) -> io::Result<Vec<String>> {
    let entries = fs::read_dir(path)?.map(|e| Ok(e?.file_name().to_string_lossy().into_owned()));
    let mut names = entries.collect::<io::Result<Vec<String>>>()?;
    names.sort();
    Ok(names)
}

/// Remove a folder with all that is in it, if it is there. A link in its place is removed and not followed.
///
/// # Errors
/// It cannot be removed.
pub fn remove_folder(path: impl AsRef<Path>) -> io::Result<()> {
    let path = path.as_ref();
    let removed = if crate::is_link(path) { fs::remove_file(path) } else { fs::remove_dir_all(path) };
    match removed {
        Err(e) if e.kind() != ErrorKind::NotFound => Err(e),
        _ => Ok(()),
    }
}

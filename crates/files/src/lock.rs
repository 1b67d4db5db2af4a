//! Locks, which end with the process that holds them.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// Lock a file for this process alone, as long as it is open. Returns false if another process holds it.
fn try_lock(file: &File) -> bool {
    // Some network file systems have no locks: two writers are the lesser evil there.
    !matches!(file.try_lock(), Err(TryLockError::WouldBlock))
}

/// The error of a file that another run writes.
fn busy() -> io::Error {
    io::Error::new(ErrorKind::ResourceBusy, "another run or recorder writes it")
}

/// Returns true if an open file has this path.
#[cfg(unix)]
fn is_at(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt as _;
    let (Ok(own), Ok(there)) = (file.metadata(), fs::symlink_metadata(path)) else { return false };
    (own.dev(), own.ino()) == (there.dev(), there.ino())
}

/// Elsewhere a file that is open keeps its name.
#[cfg(not(unix))]
fn is_at(_: &File, _: &Path) -> bool {
    true
}

/// Options of a file that has one writer.
fn options() -> OpenOptions {
    let mut options = OpenOptions::new();
    options.read(true).write(true);
    // A lock would keep readers off there. Others may read the file and give it another name.
    #[cfg(windows)]
    std::os::windows::fs::OpenOptionsExt::share_mode(&mut options, 5);
    options
}

/// How often a name is tried that others remove and make at the same time.
const TRIALS: usize = 100;

/// Open a file for reading and writing that is made if it is not there, for this writer alone. A link under its name is removed.
///
/// # Errors
/// It cannot be made, or another writer has it.
pub fn open_alone(path: &Path) -> io::Result<File> {
    for _ in 0..TRIALS {
        let made = options().create_new(true).open(path);
        let file = match made {
            Err(e) if e.kind() == ErrorKind::AlreadyExists && crate::is_link(path) => {
                fs::remove_file(path)?;
                continue;
            }
            Err(e) if e.kind() == ErrorKind::AlreadyExists => match options().open(path) {
                Err(e) if e.kind() == ErrorKind::NotFound => continue,
                found => found?,
            },
            made => made?,
        };
        if !cfg!(windows) && !try_lock(&file) {
            return Err(busy());
        }
        if is_at(&file, path) {
            return Ok(file);
        }
    }
    Err(busy())
}

/// Refuse a file that another writer has.
///
/// # Errors
/// It is there, and another writer has it.
pub(crate) fn check_free(path: &Path) -> io::Result<()> {
    match options().open(path) {
        Ok(file) if cfg!(windows) || try_lock(&file) => Ok(()),
        Ok(_) => Err(busy()),
        // What cannot be opened cannot be at work either: it is replaced or refused later on.
        Err(_) => Ok(()),
    }
}

/// A folder of results that one run alone writes into, until this is dropped or its process ends.
#[derive(Debug)]
pub struct FolderLock {
    path: PathBuf,
    file: Option<File>,
}

/// Name of the file in a folder whose lock is that of the folder.
const NAME: &str = ".hysteron.lock";

impl FolderLock {
    /// Make a folder with its parents, and lock it.
    ///
    /// # Errors
    /// It cannot be made, or another run writes into it. The message names it.
    pub fn take(folder: &Path) -> io::Result<Self> {
        crate::make_folders(folder)?;
        let path = folder.join(NAME);
        match open_alone(&path) {
            Ok(file) => Ok(Self { path, file: Some(file) }),
            Err(e) if e.kind() == ErrorKind::ResourceBusy => {
                let why = format!("another run writes into {}: wait for it, or take another folder", folder.display());
                Err(io::Error::new(e.kind(), why))
            }
            Err(e) => Err(io::Error::new(e.kind(), format!("cannot write into {}: {e}", folder.display()))),
        }
    }
}

impl FolderLock {
    /// Remove all that an earlier run has left in the folder.
    ///
    /// # Errors
    /// Something cannot be removed.
    pub fn clear(&self) -> io::Result<()> {
        let folder = self.path.parent().unwrap_or(Path::new("."));
        for name in crate::list(folder)?.iter().filter(|n| *n != NAME) {
            let path = folder.join(name);
            if path.is_dir() { crate::remove_folder(&path)? } else { crate::remove(&path)? }
        }
        Ok(())
    }
}

impl Drop for FolderLock {
    fn drop(&mut self) {
        // Removed while it is locked. Who waits for it looks whether it is still there.
        let _ = fs::remove_file(&self.path);
        self.file = None;
    }
}

#[cfg(test)]
mod tests {
    use super::{FolderLock, open_alone};
    use crate::{Scratch, list};
    use std::io::ErrorKind;

    #[test]
    fn one_run_writes_into_a_folder() {
        let scratch = Scratch::new("test").expect("a folder");
        let folder = scratch.path().join("a/b");
        let lock = FolderLock::take(&folder).expect("it is free");
        let second = FolderLock::take(&folder);
        assert_eq!(second.err().map(|e| e.kind()), Some(ErrorKind::ResourceBusy));
        drop(lock);
        assert!(list(&folder).expect("names").is_empty());
        assert!(FolderLock::take(&folder).is_ok());
    }

    #[cfg(unix)]
    #[test]
    fn a_link_under_the_name_of_a_file_is_removed() {
        let scratch = Scratch::new("test").expect("a folder");
        let (kept, link) = (scratch.path().join("kept"), scratch.path().join("link"));
        crate::write(&kept, "kept").expect("it is written");
        std::os::unix::fs::symlink(&kept, &link).expect("a link");
        drop(open_alone(&link).expect("a file"));
        assert!(!crate::is_link(&link) && crate::read(&link).expect("it is read").is_empty());
    }
}

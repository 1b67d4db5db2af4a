//! Folders for files that nobody keeps.

use std::fs;
use std::hash::{BuildHasher as _, RandomState};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// A number that others cannot guess: the standard library seeds its hash tables from the random numbers of the system.
pub(crate) fn random() -> u64 {
    RandomState::new().hash_one(std::process::id())
}

/// A new folder among the temporary files, for this user alone, with a name that nobody can guess. It is removed in the end.
#[derive(Debug)]
pub struct Scratch(PathBuf);

/// Names that are tried.
const TRIALS: usize = 16;

impl Scratch {
    /// A folder whose name begins with `hysteron-` and `purpose`.
    ///
    /// # Errors
    /// It cannot be made.
    pub fn new(purpose: &str) -> io::Result<Self> {
        let mut last = io::Error::from(ErrorKind::AlreadyExists);
        for _ in 0..TRIALS {
            let path = std::env::temp_dir().join(format!("hysteron-{purpose}-{:016x}", random()));
            match crate::make_own_folder(&path) {
                Ok(()) => return Ok(Self(path)),
                Err(e) if e.kind() == ErrorKind::AlreadyExists => last = e,
                Err(e) => return Err(e),
            }
        }
        Err(last)
    }

    /// Its path.
    pub fn path(&self) -> &Path {
        &self.0
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        // What is left behind lies among other temporary files.
        let _ = fs::remove_dir_all(&self.0);
    }
}

#[cfg(test)]
mod tests {
    use super::Scratch;

    #[test]
    fn scratch_folders_differ_and_go() {
        let (a, b) = (Scratch::new("test").expect("a folder"), Scratch::new("test").expect("a folder"));
        assert!(a.path() != b.path() && a.path().is_dir());
        let path = a.path().to_owned();
        crate::write(path.join("x"), "x").expect("a file");
        drop(a);
        assert!(!path.exists() && b.path().is_dir());
    }
}

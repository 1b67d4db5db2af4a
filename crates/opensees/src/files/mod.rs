//! Files of numbers: tables, ground motions.

pub mod guard;
pub mod motion;
pub(crate) mod number_files;
pub mod output_folder;
pub(crate) mod outputs;
pub(crate) mod series;
pub mod table;
pub mod vtu;

use std::fs::OpenOptions;
use std::io::{ErrorKind, Result, Write as _};
use std::path::Path;

/// Remove a file, if it is there.
///
/// # Errors
/// It cannot be removed.
pub(crate) fn remove(path: &Path) -> Result<()> {
    match std::fs::remove_file(path) {
        Err(e) if e.kind() != ErrorKind::NotFound => Err(e),
        _ => Ok(()),
    }
}

/// Write a file under another name and rename it, so that it is whole or as it was at any time, after a loss of power too.
///
/// # Errors
/// It cannot be written.
pub fn write_whole(path: &Path, bytes: &[u8]) -> Result<()> {
    let temporary = path.with_extension("part");
    // Made anew, so that no link under this name is followed.
    remove(&temporary)?;
    let mut file = OpenOptions::new().write(true).create_new(true).open(&temporary)?;
    file.write_all(bytes)?;
    file.sync_data()?;
    std::fs::rename(&temporary, path)
}

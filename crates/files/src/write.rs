//! Files that are written anew under another name and renamed.

use crate::scratch::random;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

/// A new file with a name that nobody can guess, in the folder of `path`.
fn beside(path: &Path) -> io::Result<(PathBuf, File)> {
    let temporary = path.with_file_name(format!(".{:016x}.part", random()));
    let file = OpenOptions::new().write(true).create_new(true).open(&temporary)?;
    Ok((temporary, file))
}

fn write_beside(path: &Path, bytes: &[u8], durable: bool) -> io::Result<()> {
    let (temporary, mut file) = beside(path)?;
    let written = file.write_all(bytes).and_then(|()| if durable { file.sync_data() } else { Ok(()) });
    drop(file);
    let done = written.and_then(|()| fs::rename(&temporary, path));
    if done.is_err() {
        // The first error is the one to tell.
        let _ = fs::remove_file(&temporary);
    }
    done
}

/// Write a file that is whole or as it was at any time. A link under its name is replaced.
///
/// # Errors
/// It cannot be written.
pub fn write(path: impl AsRef<Path>, bytes: impl AsRef<[u8]>) -> io::Result<()> {
    write_beside(path.as_ref(), bytes.as_ref(), false)
}

/// The same, after a loss of power too.
///
/// # Errors
/// It cannot be written.
pub fn write_durably(path: impl AsRef<Path>, bytes: impl AsRef<[u8]>) -> io::Result<()> {
    write_beside(path.as_ref(), bytes.as_ref(), true)
}

/// Copy a file with its permissions. A link under the new name is replaced.
///
/// # Errors
/// It cannot be read or written.
pub fn copy(from: impl AsRef<Path>, to: impl AsRef<Path>) -> io::Result<()> {
    let permissions = fs::metadata(&from)?.permissions();
    write(&to, crate::read(from)?)?;
    fs::set_permissions(to, permissions)
}

#[cfg(test)]
mod tests {
    use super::write;
    use crate::{Scratch, list, read};

    #[test]
    fn a_file_is_replaced_as_a_whole_and_leaves_nothing_else() {
        let scratch = Scratch::new("test").expect("a folder");
        let path = scratch.path().join("a.txt");
        for text in ["long text", "short"] {
            write(&path, text).expect("it is written");
            assert_eq!(read(&path).expect("it is read"), text.as_bytes());
        }
        assert!(write(scratch.path(), "x").is_err(), "a folder is no file");
        assert_eq!(list(scratch.path()).expect("names"), ["a.txt"]);
    }

    #[cfg(unix)]
    #[test]
    fn a_link_is_replaced_and_not_followed() {
        let scratch = Scratch::new("test").expect("a folder");
        let (kept, link) = (scratch.path().join("kept"), scratch.path().join("link"));
        write(&kept, "kept").expect("it is written");
        std::os::unix::fs::symlink(&kept, &link).expect("a link");
        write(&link, "new").expect("it is written");
        assert_eq!(
            (read(&kept).expect("it is read"), read(&link).expect("it is read")),
            (b"kept".into(), b"new".into())
        );
    }
}

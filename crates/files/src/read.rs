//! Reading, with a bound.

use std::fs::File;
use std::io::{self, ErrorKind, Read};
use std::path::Path;

/// Largest file that is read as a whole, in bytes.
pub const MAX_FILE_SIZE: u64 = 1 << 30;
/// Largest study, plan, table or recording, in bytes.
pub const MAX_INPUT_SIZE: u64 = 256 << 20;
/// Largest content of a device or a pipe that is read as a whole, in bytes. `/dev/zero` has no end.
const MAX_STREAM_SIZE: u64 = 64 << 20;

fn too_large(limit: u64) -> io::Error {
    io::Error::new(ErrorKind::FileTooLarge, format!("it has more than {} MB", limit >> 20))
}

/// All that a reader gives.
///
/// # Errors
/// It cannot be read, or gives more than [`MAX_FILE_SIZE`] bytes.
pub fn read_whole(file: impl Read) -> io::Result<Vec<u8>> {
    whole_up_to(file, MAX_FILE_SIZE)
}

fn whole_up_to(file: impl Read, limit: u64) -> io::Result<Vec<u8>> {
    let mut content = vec![];
    if file.take(limit + 1).read_to_end(&mut content)? as u64 > limit {
        return Err(too_large(limit));
    }
    Ok(content)
}

/// The content of a file of at most `limit` bytes.
///
/// # Errors
/// It cannot be read, is a folder, or has more bytes. A device or a pipe may give 64 MB at most.
pub fn read_up_to(path: impl AsRef<Path>, limit: u64) -> io::Result<Vec<u8>> {
    let file = File::open(path)?;
    let info = file.metadata()?;
    if info.is_dir() {
        return Err(ErrorKind::IsADirectory.into());
    }
    if info.is_file() && info.len() > limit {
        return Err(too_large(limit));
    }
    whole_up_to(file, if info.is_file() { limit } else { limit.min(MAX_STREAM_SIZE) })
}

/// The content of a file of at most [`MAX_FILE_SIZE`] bytes.
///
/// # Errors
/// As [`read_up_to`].
pub fn read(path: impl AsRef<Path>) -> io::Result<Vec<u8>> {
    read_up_to(path, MAX_FILE_SIZE)
}

/// The content of a study, a plan, a table or a recording, of at most [`MAX_INPUT_SIZE`] bytes.
///
/// # Errors
/// As [`read_up_to`].
pub fn read_input(path: impl AsRef<Path>) -> io::Result<Vec<u8>> {
    read_up_to(path, MAX_INPUT_SIZE)
}

/// Reads other inputs of the folder of a file by their names, such as the values that a header names. `None` for one that is
/// not there or that [`read_input`] refuses.
pub fn read_beside(path: impl AsRef<Path>) -> impl Fn(&str) -> Option<Vec<u8>> {
    let folder = path.as_ref().parent().unwrap_or(Path::new("")).to_owned();
    move |name| read_input(folder.join(name)).ok()
}

/// The same as text.
///
/// # Errors
/// As [`read_input`], or it is no UTF-8.
pub fn read_text(path: impl AsRef<Path>) -> io::Result<String> {
    let no_text = |_| io::Error::new(ErrorKind::InvalidData, "it is no text in UTF-8");
    String::from_utf8(read_input(path)?).map_err(no_text)
}

/// The same as text, with a mark in place of bytes that are no UTF-8.
///
/// # Errors
/// As [`read_input`].
pub fn read_lossy(path: impl AsRef<Path>) -> io::Result<String> {
    Ok(String::from_utf8_lossy(&read_input(path)?).into_owned())
}

#[cfg(test)]
mod tests {
    use super::{read, read_up_to, read_whole};
    use crate::Scratch;
    use std::io::ErrorKind;

    #[test]
    fn reading_is_bounded() {
        let scratch = Scratch::new("test").expect("a folder");
        let path = scratch.path().join("a");
        crate::write(&path, b"12345").expect("a file");
        assert_eq!(read_up_to(&path, 5).expect("it is read"), b"12345");
        assert_eq!(read_up_to(&path, 4).map_err(|e| e.kind()), Err(ErrorKind::FileTooLarge));
        assert_eq!(read(scratch.path()).map_err(|e| e.kind()), Err(ErrorKind::IsADirectory));
        assert!(read_whole(&b"12"[..]).is_ok());
        #[cfg(unix)]
        assert_eq!(read("/dev/zero").map_err(|e| e.kind()), Err(ErrorKind::FileTooLarge));
    }
}

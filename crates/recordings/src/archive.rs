//! Archives and compressed files, unpacked within bounds.

use crate::content::MAX_UNPACKED;
use miniz_oxide::inflate::decompress_to_vec_with_limit;

/// True if bytes are those of a gzip file.
pub(crate) fn is_gzip(bytes: &[u8]) -> bool {
    bytes.starts_with(&[0x1f, 0x8b, 8])
}

/// The content of a gzip file.
///
/// Source: RFC 1952.
///
/// # Errors
/// What is wrong with it.
pub(crate) fn gunzip(bytes: &[u8]) -> Result<Vec<u8>, String> {
    let short = || "the compressed file ends early".to_owned();
    let flags = *bytes.get(3).ok_or_else(short)?;
    let mut at = 10;
    if flags & 4 != 0 {
        let n = bytes.get(at..at + 2).ok_or_else(short)?;
        at += 2 + usize::from(u16::from_le_bytes([n[0], n[1]]));
    }
    // Name and comment end with a zero.
    for flag in [8, 16] {
        if flags & flag != 0 {
            at += bytes.get(at..).and_then(|b| b.iter().position(|x| *x == 0)).ok_or_else(short)? + 1;
        }
    }
    if flags & 2 != 0 {
        at += 2;
    }
    let end = bytes.len().checked_sub(8).filter(|end| *end >= at).ok_or_else(short)?;
    let content = inflated(&bytes[at..end])?;
    let word = |at: usize| u32::from_le_bytes([bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]]);
    if word(end + 4) != content.len() as u32 || word(end) != crc32(&content) {
        return Err("the compressed file is damaged, or there are several in one: its sum does not fit".into());
    }
    Ok(content)
}

fn inflated(bytes: &[u8]) -> Result<Vec<u8>, String> {
    use miniz_oxide::inflate::TINFLStatus;
    decompress_to_vec_with_limit(bytes, MAX_UNPACKED).map_err(|e| match e.status {
        TINFLStatus::HasMoreOutput => format!("it has more than {} MB when it is unpacked", MAX_UNPACKED >> 20),
        _ => format!("its compression is damaged ({e})"),
    })
}

/// Sum of RFC 1952, section 8.
pub(crate) fn crc32(bytes: &[u8]) -> u32 {
    const POLYNOMIAL: u32 = 0xedb8_8320;
    let mut table = [0u32; 256];
    for (i, entry) in table.iter_mut().enumerate() {
        let bit = |c: u32| if c & 1 != 0 { POLYNOMIAL ^ (c >> 1) } else { c >> 1 };
        *entry = (0..8).fold(i as u32, |c, _| bit(c));
    }
    !bytes.iter().fold(!0, |c, b| table[((c ^ u32::from(*b)) & 0xff) as usize] ^ (c >> 8))
}

/// A zip archive.
///
/// Source: PKWARE, .ZIP file format specification 6.3, without encryption, several disks and zip64.
pub(crate) struct Zip<'a> {
    bytes: &'a [u8],
    entries: Vec<Entry>,
}

struct Entry {
    name: String,
    method: u16,
    packed: usize,
    sum: u32,
    offset: usize,
}

impl<'a> Zip<'a> {
    /// True if bytes begin as an archive.
    pub(crate) fn is_zip(bytes: &[u8]) -> bool {
        bytes.starts_with(b"PK\x03\x04")
    }

    /// The archive in these bytes.
    ///
    /// # Errors
    /// What is wrong with it.
    pub(crate) fn new(bytes: &'a [u8]) -> Result<Self, String> {
        const END: &[u8] = b"PK\x05\x06";
        const LONGEST_COMMENT: usize = 65_536 + 22;
        let from = bytes.len().saturating_sub(LONGEST_COMMENT);
        let end = (from..bytes.len()).rev().find(|i| bytes[*i..].starts_with(END));
        let end = end.ok_or("it has no directory")?;
        let short = || "its directory is cut off".to_owned();
        let half = |at: usize| bytes.get(at..at + 2).map(|b| u16::from_le_bytes([b[0], b[1]])).ok_or_else(short);
        let word =
            |at: usize| bytes.get(at..at + 4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]])).ok_or_else(short);
        let mut at = word(end + 16)? as usize;
        let mut entries = vec![];
        for _ in 0..half(end + 10)? {
            if bytes.get(at..at + 4) != Some(b"PK\x01\x02") {
                return Err(short());
            }
            let (name, extra, comment) =
                (usize::from(half(at + 28)?), usize::from(half(at + 30)?), usize::from(half(at + 32)?));
            let text = bytes.get(at + 46..at + 46 + name).ok_or_else(short)?;
            entries.push(Entry {
                name: String::from_utf8_lossy(text).into_owned(),
                method: half(at + 10)?,
                sum: word(at + 16)?,
                packed: word(at + 20)? as usize,
                offset: word(at + 42)? as usize,
            });
            at += 46 + name + extra + comment;
        }
        Ok(Self { bytes, entries })
    }

    /// Names of the files.
    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        self.entries.iter().map(|e| e.name.as_str())
    }

    /// The content of a file.
    ///
    /// # Errors
    /// There is none of this name, or it is damaged.
    pub(crate) fn read(&self, name: &str) -> Result<Vec<u8>, String> {
        let entry = self.entries.iter().find(|e| e.name == name).ok_or_else(|| format!("there is no {name}"))?;
        let short = || format!("{name} is cut off");
        let head = self.bytes.get(entry.offset..).and_then(|b| b.get(..30)).ok_or_else(short)?;
        let half = |at: usize| usize::from(u16::from_le_bytes([head[at], head[at + 1]]));
        let start = entry.offset + 30 + half(26) + half(28);
        let end = start.checked_add(entry.packed).ok_or_else(short)?;
        let packed = self.bytes.get(start..end).ok_or_else(short)?;
        let content = match entry.method {
            0 => packed.to_vec(),
            8 => inflated(packed).map_err(|e| format!("{name}: {e}"))?,
            other => return Err(format!("{name} is packed by method {other}")),
        };
        if crc32(&content) != entry.sum {
            return Err(format!("{name} is damaged: its sum does not fit"));
        }
        Ok(content)
    }
}

#[cfg(test)]
mod tests {
    use super::{crc32, gunzip, is_gzip};

    #[test]
    fn sum_of_the_standard() {
        assert_eq!(crc32(b"123456789"), 0xcbf4_3926);
    }

    #[test]
    fn gzip_is_unpacked_and_checked() {
        let text = b"0 1\n1 2\n".repeat(100);
        let mut packed = vec![0x1f, 0x8b, 8, 8, 0, 0, 0, 0, 0, 3];
        packed.extend_from_slice(b"name.csv\0");
        packed.extend(miniz_oxide::deflate::compress_to_vec(&text, 6));
        packed.extend_from_slice(&crc32(&text).to_le_bytes());
        packed.extend_from_slice(&(text.len() as u32).to_le_bytes());
        assert!(is_gzip(&packed));
        assert_eq!(gunzip(&packed), Ok(text));
        packed[30] ^= 1;
        assert!(gunzip(&packed).is_err());
        assert!(gunzip(&packed[..12]).is_err());
    }
}

//! Text of measured files: encodings.

use crate::fault::Fault;
use std::borrow::Cow;

/// Windows-1252 from 0x80 to 0x9F; the other bytes are their own code points. Source: Unicode's CP1252.TXT.
const CP1252: [char; 32] = [
    '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8d}', 'Ž', '\u{8f}', '\u{90}', '‘', '’',
    '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9d}', 'ž', 'Ÿ',
];

/// Bytes that the kind of file is told from.
const SAMPLE: usize = 256;

/// Text of UTF-8, UTF-16 or Windows-1252 without its byte order mark.
///
/// # Errors
/// Kind of the file instead, and the format to save.
pub fn decode(bytes: &[u8]) -> Result<Cow<'_, str>, Fault> {
    const CSV: &str = "save it as CSV UTF-8, with the numbers in the first sheet";
    if bytes.starts_with(&[0xd0, 0xcf, 0x11, 0xe0]) {
        return Err(Fault::new("is an Excel workbook (xls), not a text").help(CSV));
    }
    let utf16 = |body: &[u8], unit: fn([u8; 2]) -> u16| {
        let units: Vec<u16> = body.chunks_exact(2).map(|pair| unit([pair[0], pair[1]])).collect();
        let text = String::from_utf16(&units).ok().filter(|_| body.len().is_multiple_of(2));
        text.map(Cow::Owned).ok_or_else(|| Fault::new("is no valid UTF-16").help(CSV))
    };
    match bytes {
        [0xff, 0xfe, body @ ..] => return utf16(body, u16::from_le_bytes),
        [0xfe, 0xff, body @ ..] => return utf16(body, u16::from_be_bytes),
        _ => {}
    }
    let body = bytes.strip_prefix(&[0xef, 0xbb, 0xbf]).unwrap_or(bytes);
    let sample = &body[..body.len().min(SAMPLE)];
    if sample.contains(&0) {
        // UTF-16 without a mark: of ASCII letters every second byte is zero.
        let zeros = |parity: usize| sample.iter().skip(parity).step_by(2).all(|b| *b == 0);
        return match (zeros(0), zeros(1)) {
            (false, true) => utf16(body, u16::from_le_bytes),
            (true, false) => utf16(body, u16::from_be_bytes),
            _ => Err(Fault::new("is a binary file, not a text").help("save it as comma-separated values")),
        };
    }
    Ok(match std::str::from_utf8(body) {
        Ok(text) => Cow::Borrowed(text),
        Err(_) => {
            let char_of = |b: &u8| CP1252.get(usize::from(*b).wrapping_sub(0x80)).map_or(char::from(*b), |c| *c);
            Cow::Owned(body.iter().map(char_of).collect())
        }
    })
}

#[cfg(test)]
mod tests {
    use super::decode;

    #[test]
    fn encodings_give_the_same_text() {
        let text = "time[s],acc[m/s²],θ\n0,1,2\n";
        let utf16 = |to: fn(u16) -> [u8; 2]| text.encode_utf16().flat_map(to).collect::<Vec<u8>>();
        let with = |mark: &[u8], body: Vec<u8>| [mark.to_vec(), body].concat();
        for bytes in [
            text.as_bytes().to_vec(),
            with(&[0xef, 0xbb, 0xbf], text.as_bytes().to_vec()),
            with(&[0xff, 0xfe], utf16(u16::to_le_bytes)),
            with(&[0xfe, 0xff], utf16(u16::to_be_bytes)),
        ] {
            assert_eq!(decode(&bytes).as_deref(), Ok(text));
        }
        let ascii: Vec<u8> = "time,a\n0,1\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
        assert_eq!(decode(&ascii).as_deref(), Ok("time,a\n0,1\n"));
        assert_eq!(decode(b"T[\xb0C],m/s\xb2,\x80").as_deref(), Ok("T[°C],m/s²,€"));
    }

    #[test]
    fn binary_files_are_refused() {
        for (bytes, said) in [(&b"\xd0\xcf\x11\xe0\xa1"[..], "(xls)"), (b"\x00\x00\x01\x02\x07", "binary")] {
            assert!(decode(bytes).expect_err("no text").message.contains(said));
        }
    }
}

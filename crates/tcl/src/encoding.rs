//! Text of a file by the encoding that its bytes show.

/// Marks of order at the start of a text, and the encoding that each belongs to.
const MARKS: [(&[u8], &str); 4] = [
    (&[0xff, 0xfe, 0, 0], "UTF-32"),
    (&[0, 0, 0xfe, 0xff], "UTF-32"),
    (&[0xff, 0xfe], "UTF-16"),
    (&[0xfe, 0xff], "UTF-16"),
];
/// The mark of UTF-8, which many editors write and no command begins with.
const UTF8_MARK: &[u8] = &[0xef, 0xbb, 0xbf];
/// Bytes that are looked at to recognise UTF-16 without a mark.
const LOOKED_AT: usize = 64;

/// The text of a file: UTF-8, with or without its mark, and Latin-1 where the bytes are no UTF-8.
///
/// ```
/// assert_eq!(hysteron_tcl::decode(b"\xef\xbb\xbfnode 1 0".to_vec()), Ok("node 1 0".into()));
/// assert_eq!(hysteron_tcl::decode(b"\xff\xfen\0o\0d\0e\0".to_vec()), Err("UTF-16"));
/// ```
///
/// # Errors
/// The name of an encoding of another width, which has to be converted.
pub fn decode(mut bytes: Vec<u8>) -> Result<String, &'static str> {
    if let Some((_, name)) = MARKS.iter().find(|(mark, _)| bytes.starts_with(mark)) {
        return Err(name);
    }
    if is_wide(&bytes) {
        return Err("UTF-16");
    }
    if bytes.starts_with(UTF8_MARK) {
        bytes.drain(..UTF8_MARK.len());
    }
    Ok(String::from_utf8(bytes).unwrap_or_else(|e| e.into_bytes().iter().map(|b| char::from(*b)).collect()))
}

/// Returns true if each second byte is zero and no other one, as in UTF-16 without a mark.
fn is_wide(bytes: &[u8]) -> bool {
    let pairs = bytes[..bytes.len().min(LOOKED_AT)].as_chunks::<2>().0;
    pairs.len() > 1 && (pairs.iter().all(|p| p[0] != 0 && p[1] == 0) || pairs.iter().all(|p| p[0] == 0 && p[1] != 0))
}

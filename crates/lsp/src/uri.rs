//! Addresses of files.

use lsp_types::Uri;
use std::str::FromStr as _;

/// The path of a file by its address, with `/` between its parts; none for another kind of address.
pub(crate) fn to_path(uri: &Uri) -> Option<String> {
    let rest = uri.as_str().strip_prefix("file://")?;
    // A host may stand before the path.
    let path = &rest[rest.find('/')?..];
    let mut bytes = vec![];
    let mut left = path.as_bytes().iter();
    while let Some(&b) = left.next() {
        let code = left.as_slice().get(..2).filter(|_| b == b'%');
        let code = code.and_then(|c| u8::from_str_radix(std::str::from_utf8(c).ok()?, 16).ok());
        if code.is_some() {
            left.nth(1);
        }
        bytes.push(code.unwrap_or(b));
    }
    let path = String::from_utf8(bytes).ok()?;
    // `/c:/folder` of Windows.
    let drive = path.as_bytes().get(1).is_some_and(u8::is_ascii_alphabetic) && path.as_bytes().get(2) == Some(&b':');
    Some(if drive { path[1..].to_owned() } else { path })
}

/// The address of a file.
pub(crate) fn from_path(path: &str) -> Option<Uri> {
    let mut text = String::from(if path.starts_with('/') { "file://" } else { "file:///" });
    for b in path.bytes() {
        if b.is_ascii_alphanumeric() || b"/-._~".contains(&b) {
            text.push(char::from(b));
        } else {
            text += &format!("%{b:02X}");
        }
    }
    Uri::from_str(&text).ok()
}

/// The folder of a file.
pub(crate) fn folder(path: &str) -> &str {
    match path.rfind('/') {
        Some(0) => "/",
        Some(at) => &path[..at],
        None => ".",
    }
}

/// The last part of a path.
pub(crate) fn file_name(path: &str) -> &str {
    path.rsplit('/').next().unwrap_or(path)
}

/// A path within a folder, or an absolute one, without `.` and `..`.
pub(crate) fn joined(folder: &str, path: &str) -> String {
    let path = path.replace('\\', "/");
    let is_absolute = path.starts_with('/') || path.as_bytes().get(1) == Some(&b':');
    let whole = if is_absolute { path } else { format!("{folder}/{path}") };
    let mut parts: Vec<&str> = vec![];
    for part in whole.split('/').filter(|p| !p.is_empty() && *p != ".") {
        match part {
            ".." => drop(parts.pop()),
            _ => parts.push(part),
        }
    }
    format!("{}{}", if whole.starts_with('/') { "/" } else { "" }, parts.join("/"))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::{from_path, joined, to_path};

    #[test]
    fn paths_and_addresses_are_the_same() {
        for path in ["/home/a b/brücke.tcl", "/x/100%.tcl", "C:/work/a#1.tcl"] {
            assert_eq!(to_path(&from_path(path).unwrap()).unwrap(), path);
        }
        assert_eq!(to_path(&"untitled:1".parse().unwrap()), None);
    }

    #[test]
    fn parts_of_paths_are_settled() {
        assert_eq!(joined("/a/b", "../c/./d.tcl"), "/a/c/d.tcl");
        assert_eq!(joined("/a/b", "/d.tcl"), "/d.tcl");
        assert_eq!(joined("C:/a", "d.tcl"), "C:/a/d.tcl");
    }
}

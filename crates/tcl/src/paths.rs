//! Names of files, with `/` between their parts.

use super::core::Core;
use std::borrow::Cow;

/// Root of an absolute path: `/`, or on Windows a drive.
fn root(path: &str) -> Option<&str> {
    if path.starts_with('/') {
        return path.get(..1);
    }
    let bytes = path.as_bytes();
    if cfg!(windows) && bytes.len() >= 2 && bytes[0].is_ascii_alphabetic() && bytes[1] == b':' {
        return path.get(..if bytes.get(2) == Some(&b'/') { 3 } else { 2 });
    }
    None
}

/// Returns true if a path does not depend on the current folder.
pub(crate) fn is_absolute(path: &str) -> bool {
    root(path).is_some() || path.starts_with('~')
}

/// The parts of a path, the root being one of them.
pub(crate) fn split(path: &str) -> Vec<String> {
    let first = root(path).unwrap_or_default();
    let rest = &path[first.len()..];
    let mut parts: Vec<String> = if first.is_empty() { vec![] } else { vec![first.to_owned()] };
    for part in rest.split('/').filter(|p| !p.is_empty()) {
        // A tilde that is not at the start stands for itself.
        let tilde = part.starts_with('~') && !parts.is_empty();
        parts.push(if tilde { format!("./{part}") } else { part.to_owned() });
    }
    parts
}

/// Parts joined to a path; one that is absolute starts anew.
pub(crate) fn join<'p>(parts: impl IntoIterator<Item = &'p str>) -> String {
    let mut path = String::new();
    for part in parts {
        if is_absolute(part) {
            path.clear();
        }
        for piece in split(part) {
            let piece = match piece.strip_prefix("./~") {
                Some(_) if path.is_empty() => piece.as_str(),
                Some(_) => &piece[2..],
                None => piece.as_str(),
            };
            if !path.is_empty() && !path.ends_with('/') {
                path.push('/');
            }
            path.push_str(piece);
        }
    }
    path
}

/// All but the last part.
pub(crate) fn dirname(path: &str) -> String {
    let parts = split(path);
    match parts.split_last() {
        None => ".".to_owned(),
        Some((only, [])) if is_absolute(only) => only.clone(),
        Some((_, [])) => ".".to_owned(),
        Some((_, before)) => join(before.iter().map(String::as_str)),
    }
}

/// The last part.
pub(crate) fn tail(path: &str) -> String {
    match split(path).pop() {
        Some(last) if root(&last) != Some(last.as_str()) => last.strip_prefix("./").map_or(last.clone(), str::to_owned),
        _ => String::new(),
    }
}

/// From the last dot of the last part on.
pub(crate) fn extension(path: &str) -> &str {
    let from = path.rfind('/').map_or(0, |at| at + 1);
    match path[from..].rfind('.') {
        Some(at) => &path[from + at..],
        None => "",
    }
}

/// Without `.`, `..` and double slashes.
pub(crate) fn normalize(path: &str) -> String {
    let mut parts: Vec<String> = vec![];
    for part in split(path) {
        match part.as_str() {
            "." => {}
            ".." if parts.len() > 1 => {
                parts.pop();
            }
            ".." if parts.len() == 1 && root(&parts[0]).is_some() => {}
            _ => parts.push(part.strip_prefix("./~").map_or(part.clone(), |name| format!("~{name}"))),
        }
    }
    let mut path = String::new();
    for part in &parts {
        if !path.is_empty() && !path.ends_with('/') {
            path.push('/');
        }
        path.push_str(part);
    }
    path
}

impl Core {
    /// The full path of a name: from the current folder, `~` being that of the user.
    pub fn absolute(&self, name: &str) -> String {
        let name = if cfg!(windows) { name.replace('\\', "/") } else { name.to_owned() };
        if let Some(rest) = name.strip_prefix('~')
            && (rest.is_empty() || rest.starts_with('/'))
            && let Ok(home) = self.get_var("::env(HOME)")
        {
            return normalize(&format!("{home}{rest}"));
        }
        if root(&name).is_some() { normalize(&name) } else { normalize(&format!("{}/{name}", self.current_dir())) }
    }

    /// The folder in which relative names are looked up.
    pub fn current_dir(&self) -> Cow<'_, str> {
        self.cwd.as_deref().map_or_else(|| self.files.current_dir().into(), Cow::from)
    }

    /// Look up relative names in this folder from now on.
    pub fn set_current_dir(&mut self, path: &str) {
        self.cwd = Some(self.absolute(path));
    }
}

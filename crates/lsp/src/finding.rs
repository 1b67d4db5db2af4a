//! Findings of a check, with their places.

use crate::script::{Paths, Place};
use hysteron_tcl::diagnostic::{Diagnostic, Severity, SourceMap};

/// A finding of a check.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Finding {
    pub(crate) place: Place,
    pub(crate) severity: Severity,
    /// Code of the check that found it; empty where it has none.
    pub(crate) code: &'static str,
    /// What is wrong, in its first line; what was expected, and help.
    pub(crate) message: String,
    /// Calls that led there: place, and what was called.
    pub(crate) related: Vec<(Place, String)>,
    /// Place of a word, and the name that may have been meant there.
    pub(crate) replacement: Option<(Place, String)>,
}

impl Finding {
    /// Of a message of a run in a folder. One without a place is at the beginning of `root`.
    pub(crate) fn new(d: &Diagnostic, sources: &SourceMap, paths: &mut Paths, folder: &str, root: &str) -> Self {
        let place = match d.span {
            Some(span) => paths.place(sources, folder, span),
            None => Place { path: root.to_owned(), start: 0, end: 0 },
        };
        let mut message = d.message.clone();
        if d.count > 1 {
            message += &format!(" ({} times)", d.count);
        }
        if !d.label.is_empty() && !d.message.ends_with(&d.label) {
            message += &format!("\n{}", d.label);
        }
        d.help.iter().for_each(|h| message += &format!("\nhelp: {h}"));
        let mut related: Vec<(Place, String)> = vec![];
        for caller in &d.callers {
            related.push((paths.place(sources, folder, caller.span), format!("{} is called here", caller.what)));
        }
        let replacement = d.suggestion.as_ref().and_then(|s| {
            let at = sources.snippet(d.span?).find(&s.wrong)?;
            let start = place.start + at;
            Some((Place { path: place.path.clone(), start, end: start + s.wrong.len() }, s.near.clone()))
        });
        Self { place, severity: d.severity, code: d.code(), message, related, replacement }
    }

    /// Information at the beginning of a file.
    pub(crate) fn note(path: &str, message: impl Into<String>) -> Self {
        let place = Place { path: path.to_owned(), start: 0, end: 0 };
        let message = message.into();
        Self { place, severity: Severity::Note, code: "", message, related: vec![], replacement: None }
    }

    /// An error at the beginning of a file.
    pub(crate) fn error(path: &str, message: impl Into<String>) -> Self {
        Self { severity: Severity::Error, ..Self::note(path, message) }
    }
}

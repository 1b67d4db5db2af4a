//! Keys that a file of TOML does not have.

use hysteron_tcl::diagnostic::{Diagnostic, Span, nearest};

/// A key that no table of its place has, and the keys that it has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownKey<'a> {
    /// The key as it is written.
    pub word: &'a str,
    /// The keys of the table.
    pub known: Vec<&'a str>,
}

impl<'a> UnknownKey<'a> {
    /// The key that an error of the TOML parser is about. The parser gives it in its text alone.
    pub fn of(e: &'a toml::de::Error) -> Option<Self> {
        let mut quoted = e.message().trim().strip_prefix("unknown field")?.split('`').skip(1).step_by(2);
        Some(Self { word: quoted.next()?, known: quoted.collect() })
    }

    /// The error at its place, with the nearest known key.
    pub fn diagnostic(&self, span: Option<Span>) -> Diagnostic {
        let mut d = Diagnostic::error(format!("unknown key \"{}\"", self.word)).place(span);
        d.add_suggestion(self.word, nearest(self.word, self.known.iter().copied()));
        d
    }
}

//! Faults of measured files, with their place.

use hysteron_tcl::diagnostic::{Diagnostic, SourceMap, Span};
use std::fmt;

/// A fault of a file: what is wrong, where, and what was expected.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Fault {
    /// What is wrong.
    pub message: String,
    /// What was expected; empty where there is nothing to add.
    pub expected: String,
    /// What the user can do.
    pub help: Vec<String>,
    /// Line, counted from 1.
    pub line: Option<usize>,
    /// Byte range in the text of the file.
    pub range: Option<(usize, usize)>,
}

impl Fault {
    /// A fault of the whole file.
    pub fn new(message: impl Into<String>) -> Self {
        Self { message: message.into(), ..Self::default() }
    }

    /// A fault in a line, counted from 1.
    pub fn in_line(line: usize, message: impl Into<String>) -> Self {
        Self { line: Some(line), ..Self::new(message) }
    }

    /// With what was expected.
    #[must_use]
    pub fn expected(mut self, expected: impl Into<String>) -> Self {
        self.expected = expected.into();
        self
    }

    /// With an advice. An empty one is left out.
    #[must_use]
    pub fn help(mut self, help: impl Into<String>) -> Self {
        let help = help.into();
        self.help.extend((!help.is_empty()).then_some(help));
        self
    }

    /// At a byte range of the text.
    #[must_use]
    pub fn at(mut self, range: (usize, usize)) -> Self {
        self.range = Some(range);
        self
    }

    /// The fault as a message that points into the text.
    pub fn diagnostic(&self, name: &str, text: &str, sources: &mut SourceMap) -> Box<Diagnostic> {
        let range = self.range.or_else(|| self.line.map(|n| line_range(text, n)));
        let mut d = Diagnostic::error(self.message.clone());
        if let Some((start, end)) = range {
            let source = sources.add(name, text);
            let (start, end) = (start.min(text.len()), end.min(text.len()));
            d = d.at(Some(Span { source, start: start as u32, end: end as u32 }), self.expected.clone());
        } else if !self.expected.is_empty() {
            d = d.help(self.expected.clone());
        }
        d.help.extend(self.help.iter().cloned());
        Box::new(d)
    }
}

/// The byte range of a line, counted from 1, without its end.
fn line_range(text: &str, number: usize) -> (usize, usize) {
    let mut start = 0;
    for (i, line) in text.split_inclusive('\n').enumerate() {
        if i + 1 == number {
            return (start, start + line.trim_end_matches(['\n', '\r']).len());
        }
        start += line.len();
    }
    (text.len(), text.len())
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(line) = self.line {
            write!(f, "line {line}: ")?;
        }
        f.write_str(&self.message)?;
        if !self.expected.is_empty() {
            write!(f, ": {}", self.expected)?;
        }
        self.help.iter().try_for_each(|h| write!(f, "; {h}"))
    }
}

impl From<Fault> for String {
    fn from(fault: Fault) -> Self {
        fault.to_string()
    }
}

//! Messages that point into a text: which file, line, column and word, what was expected, the nearest known name.
//!
//! Nothing here prints. `main` renders a [`Diagnostic`] for a terminal; a test looks at its fields.

use std::fmt;
use std::sync::Arc;

pub use crate::check::Check;

/// A text that messages can point into: a script, a study, a table of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct SourceId(u32);

/// A stretch of bytes of one source, end excluded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Span {
    /// The text.
    pub source: SourceId,
    /// First byte.
    pub start: u32,
    /// One past the last byte.
    pub end: u32,
}

impl Span {
    /// The stretch from the start of `self` to the end of `other`, which is in the same source.
    pub fn to(self, other: Span) -> Span {
        Span { source: self.source, start: self.start.min(other.start), end: self.end.max(other.end) }
    }
}

/// Start of a span: line and column, in characters, both counted from 1.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Location {
    /// Name of the source, as it was given.
    pub name: Arc<str>,
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
}

impl fmt::Display for Location {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}:{}", self.name, self.line, self.column)
    }
}

#[derive(Debug)]
struct Source {
    name: Arc<str>,
    text: Arc<str>,
    /// Byte at which each line starts.
    lines: Vec<u32>,
}

/// All texts read so far.
#[derive(Debug, Default)]
pub struct SourceMap {
    sources: Vec<Source>,
}

impl SourceMap {
    /// Take in a text under a name (usually its path as the user wrote it).
    pub fn add(&mut self, name: &str, text: &str) -> SourceId {
        let mut lines = vec![0];
        lines.extend(text.bytes().enumerate().filter(|&(_, b)| b == b'\n').map(|(i, _)| i as u32 + 1));
        self.sources.push(Source { name: name.into(), text: text.into(), lines });
        SourceId(self.sources.len() as u32 - 1)
    }

    /// Number of the source that is added next.
    pub fn next(&self) -> SourceId {
        SourceId(self.sources.len() as u32)
    }

    /// All texts, in the order in which they were added.
    pub fn texts(&self) -> impl Iterator<Item = &str> {
        self.sources.iter().map(|s| &*s.text)
    }

    /// All texts with their names, in the order in which they were added.
    pub fn named_texts(&self) -> impl Iterator<Item = (&str, &Arc<str>)> {
        self.sources.iter().map(|s| (&*s.name, &s.text))
    }

    /// A text that is there under a name.
    pub fn find(&self, name: &str, text: &str) -> Option<SourceId> {
        let same = |s: &Source| &*s.name == name && &*s.text == text;
        self.sources.iter().position(same).map(|i| SourceId(i as u32))
    }

    /// The name under which the text was added.
    pub fn name(&self, id: SourceId) -> Arc<str> {
        self.sources[id.0 as usize].name.clone()
    }

    /// The whole text.
    pub fn text(&self, id: SourceId) -> Arc<str> {
        self.sources[id.0 as usize].text.clone()
    }

    /// File, line and column of the start of a span.
    pub fn location(&self, span: Span) -> Location {
        let s = &self.sources[span.source.0 as usize];
        let line = s.lines.partition_point(|&l| l <= span.start);
        let from = s.lines[line - 1] as usize;
        let column = s.text.get(from..span.start as usize).map_or(0, |t| t.chars().count()) + 1;
        Location { name: s.name.clone(), line, column }
    }

    /// The text of a span; empty where the span does not fit the text.
    pub fn snippet(&self, span: Span) -> &str {
        self.sources[span.source.0 as usize].text.get(span.start as usize..span.end as usize).unwrap_or("")
    }
}

/// Severity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// Information; nothing is wrong.
    Note,
    /// Goes on, but the result may not be what was meant. An error under `--strict`.
    Warning,
    /// The input is refused or the analysis has failed.
    Error,
}

/// One level of the chain of calls that led to a message: `in proc "storey", called here`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Caller {
    /// Callee, for instance `proc "storey"`.
    pub what: String,
    /// The call.
    pub span: Span,
}

/// A thing that a message says is missing: a variable, a command, a thing that a command defines by a tag.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Absent {
    /// Kind of thing, for instance "variable" or "node".
    pub kind: &'static str,
    /// Its name or tag; empty for a thing that has none.
    pub name: String,
}

/// Kind of a variable.
pub const VARIABLE: &str = "variable";
/// Kind of a command.
pub const COMMAND: &str = "command";

impl Absent {
    /// A thing of a kind by its name or tag.
    pub fn new(kind: &'static str, name: impl fmt::Display) -> Self {
        Self { kind, name: name.to_string() }
    }
}

impl fmt::Display for Absent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}{}", self.kind, if self.name.is_empty() { "" } else { " " }, self.name)
    }
}

/// A known name for a word that is not known.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Suggestion {
    /// The word as it was read, which stands within the place of the message.
    pub wrong: String,
    /// The name that may have been meant.
    pub near: String,
}

/// A message with its place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// Severity.
    pub severity: Severity,
    /// Description in one sentence without a full stop.
    pub message: String,
    /// The offending word.
    pub span: Option<Span>,
    /// A few words to stand under the offending word: what was expected there.
    pub label: String,
    /// Hints: the nearest known name, the usage of the command.
    pub help: Vec<String>,
    /// Calls from the innermost outwards.
    pub callers: Vec<Caller>,
    /// The check that found it. Each warning has one, and so has an error that many places share.
    pub check: Option<&'static Check>,
    /// The thing that it says is missing.
    pub absent: Option<Absent>,
    /// The nearest known name to the word that is wrong. The help says it too.
    pub suggestion: Option<Suggestion>,
    /// Number of times that it came up at this place, in the words of the first.
    pub count: usize,
}

/// Key by which two warnings are the same: the place and the check, and the message but for its numbers unless the check has one
/// message at a place.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) struct WarningKind {
    span: Option<Span>,
    code: &'static str,
    words: String,
}

impl Diagnostic {
    fn new(severity: Severity, message: impl Into<String>) -> Self {
        let (message, label) = (message.into(), String::new());
        let (check, absent, suggestion) = (None, None, None);
        Self {
            severity,
            message,
            span: None,
            label,
            help: vec![],
            callers: vec![],
            check,
            absent,
            suggestion,
            count: 1,
        }
    }

    /// Code of the check that found it; empty where it has none.
    pub fn code(&self) -> &'static str {
        self.check.map_or("", |c| c.code)
    }

    /// Its kind and place.
    pub(crate) fn kind(&self) -> WarningKind {
        let words = match self.check {
            Some(check) if check.once => String::new(),
            _ => self.message.chars().filter(|c| !c.is_ascii_digit()).collect(),
        };
        WarningKind { span: self.span, code: self.code(), words }
    }

    /// Name the check that found it.
    pub fn by(mut self, check: &'static Check) -> Self {
        self.check = Some(check);
        self
    }

    /// Name the thing that it says is missing.
    pub fn absent(mut self, absent: Absent) -> Self {
        self.absent = Some(absent);
        self
    }

    /// An error.
    pub fn error(message: impl Into<String>) -> Self {
        Self::new(Severity::Error, message)
    }

    /// A warning of a check.
    pub fn warning(check: &'static Check, message: impl Into<String>) -> Self {
        Self::new(Severity::Warning, message).by(check)
    }

    /// Point at a word and say what was expected there (may be empty).
    pub fn at(mut self, span: Option<Span>, label: impl Into<String>) -> Self {
        self.span = span;
        self.label = label.into();
        self
    }

    /// Say what was expected at its place.
    pub fn label(mut self, label: impl Into<String>) -> Self {
        self.label = label.into();
        self
    }

    /// Point at a word.
    pub fn place(mut self, span: Option<Span>) -> Self {
        self.span = span;
        self
    }

    /// Offer a known name for the word that is wrong, where one is near enough.
    pub fn suggest(mut self, wrong: &str, near: Option<&str>) -> Self {
        self.add_suggestion(wrong, near);
        self
    }

    /// As [`Diagnostic::suggest`], in place.
    pub fn add_suggestion(&mut self, wrong: &str, near: Option<&str>) {
        if let Some(near) = near {
            self.help.push(format!("did you mean \"{near}\"?"));
            self.suggestion = Some(Suggestion { wrong: wrong.to_owned(), near: near.to_owned() });
        }
    }

    /// Add a line of help.
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help.push(help.into());
        self
    }
}

/// The known name nearest to a misspelled one, if any is near enough to be meant.
pub fn nearest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let lower = word.to_lowercase();
    known
        .into_iter()
        .map(|k| (strsim::damerau_levenshtein(&lower, &k.to_lowercase()), k))
        .filter(|&(d, k)| d <= 1 + k.len().max(word.len()) / 4)
        .min_by_key(|&(d, _)| d)
        .map(|(_, k)| k)
}

//! Mistakes of studies: what is wrong, and the key of the file that it is about.

use hysteron_tcl::diagnostic::{Diagnostic, SourceId, Span};
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A step from a table of a file to a part of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Step {
    /// A key of a table.
    Key(String),
    /// A number of a list, from 0.
    Item(usize),
}

impl From<&str> for Step {
    fn from(key: &str) -> Self {
        Self::Key(key.to_owned())
    }
}

impl From<usize> for Step {
    fn from(item: usize) -> Self {
        Self::Item(item)
    }
}

/// The steps from a file to a value: `key!["bearing", 0, "q_d"]`.
macro_rules! key {
    ($($step:expr),* $(,)?) => { vec![$($crate::mistake::Step::from($step)),*] };
}
pub(crate) use key;

/// A mistake of a study.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mistake {
    /// Description in one sentence.
    pub message: String,
    /// Steps to the value that it is about; none where it is about the whole.
    pub key: Vec<Step>,
}

impl Mistake {
    /// A mistake of a value.
    pub fn new(key: Vec<Step>, message: impl Into<String>) -> Self {
        Self { message: message.into(), key }
    }

    /// As a message about the text of its file. Without a key it stands at `whole`.
    pub fn diagnostic(&self, text: &str, source: SourceId, whole: &[Step]) -> Diagnostic {
        let key = if self.key.is_empty() { whole } else { &self.key };
        let at = locate(text, key).map(|r| Span { source, start: r.start as u32, end: r.end as u32 });
        Diagnostic::error(self.message.clone()).place(at)
    }
}

impl From<String> for Mistake {
    fn from(message: String) -> Self {
        Self { message, key: vec![] }
    }
}

impl From<&str> for Mistake {
    fn from(message: &str) -> Self {
        message.to_owned().into()
    }
}

/// Results whose error gets a key.
pub(crate) trait About<T> {
    /// The error is one of a value.
    fn about(self, key: impl FnOnce() -> Vec<Step>) -> Result<T, Mistake>;
}

impl<T> About<T> for Result<T, String> {
    fn about(self, key: impl FnOnce() -> Vec<Step>) -> Result<T, Mistake> {
        self.map_err(|message| Mistake::new(key(), message))
    }
}

/// Place of a value in the text of its file. Where the last steps lead to nothing, the place of the table that lacks it: its first
/// line.
pub fn locate(text: &str, key: &[Step]) -> Option<Range<usize>> {
    let whole = DeTable::parse(text).ok()?;
    let mut table = Some(whole.get_ref());
    let mut value: Option<&Spanned<DeValue<'_>>> = None;
    for step in key {
        let next = match (step, value.map(Spanned::get_ref)) {
            (Step::Key(k), _) => table.and_then(|t| t.get(k.as_str())),
            (Step::Item(i), Some(DeValue::Array(list))) => list.get(*i),
            (Step::Item(_), _) => None,
        };
        let Some(next) = next else { break };
        value = Some(next);
        table = next.get_ref().as_table();
    }
    let range = value?.span();
    let end = range.start + text.get(range.clone())?.lines().next().unwrap_or_default().len();
    Some(range.start..end)
}

#[cfg(test)]
mod tests {
    use super::locate;

    #[test]
    fn a_key_has_the_place_of_its_value() {
        let text = "plan = [\n  1.0,\n]\nlive = { over_dead = 2 }\n[[bearing]]\nname = \"A\"\n\n[[bearing]]\nname = \"B\"\n\
                    tags = [1, 22]\n[bearing.upper]\naging = [1, 3]\n[live_load]\n";
        let place = |key: Vec<super::Step>| locate(text, &key);
        let at = |key| place(key).and_then(|r| text.get(r));
        assert_eq!(at(key!["bearing", 1, "name"]), Some("\"B\""));
        assert_eq!(at(key!["bearing", 1, "tags", 1]), Some("22"));
        assert_eq!(at(key!["bearing", 1, "upper", "aging"]), Some("[1, 3]"));
        assert_eq!(at(key!["live", "over_dead"]), Some("2"));
        assert_eq!(at(key!["plan"]), Some("["));
        // What is missing is told at its table.
        assert_eq!(at(key!["bearing", 1, "k_d"]), Some("[[bearing]]"));
        assert_eq!(place(key!["bearing", 1, "k_d"]).map(|r| r.start), text.rfind("[[bearing]]"));
        assert_eq!(at(key!["nothing"]), None);
        assert_eq!(locate("x = ", &["x".into()]), None);
    }
}

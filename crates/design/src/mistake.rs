//! Mistakes of studies: what is wrong, and the key of the file that it is about.

use hysteron_identify::study::UnknownKey;
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

/// Page of the keys of an isolation study.
const PAGE_OF_KEYS: &str = "docs/reference/isolation-keys.md";

/// The message for an error of the TOML parser. An unknown key comes with the nearest known one and the section of its page.
pub(crate) fn form_error(e: &toml::de::Error, text: &str, at: Option<Span>) -> Diagnostic {
    let Some(unknown) = UnknownKey::of(e) else { return Diagnostic::error(e.message()).place(at) };
    let before = at.and_then(|s| text.get(..s.start as usize)).unwrap_or_default();
    let is_head = |l: &&str| l.starts_with('[') && l.trim_start_matches('[').starts_with(char::is_alphabetic);
    let table = before.lines().map(str::trim).rfind(is_head).unwrap_or("the top of the file");
    unknown.diagnostic(at).help(format!("the keys of {table} stand in {PAGE_OF_KEYS}"))
}

#[cfg(test)]
mod tests {
    use super::{form_error, locate};

    #[test]
    fn an_unknown_key_has_the_nearest_and_the_section_of_its_page() {
        #[derive(Debug, serde::Deserialize)]
        #[serde(deny_unknown_fields)]
        struct Entry {
            #[serde(rename = "tags")]
            _tags: Option<Vec<i64>>,
        }
        let told = |text: &str| {
            let error = toml::from_str::<std::collections::BTreeMap<String, Vec<Entry>>>(text).expect_err("a mistake");
            let source = hysteron_tcl::diagnostic::SourceMap::default().add("study.toml", text);
            let at = error.span().map(|r| super::Span { source, start: r.start as u32, end: r.end as u32 });
            form_error(&error, text, at)
        };
        let d = told("[[bearing]]\ntags = [\n[1],\n]\n");
        assert!(d.help.is_empty() && !d.message.contains("unknown key"), "{d:?}");
        let d = told("[[bearing]]\ntgas = [1]\n");
        assert_eq!(d.message, "unknown key \"tgas\"");
        assert_eq!(
            d.help,
            ["did you mean \"tags\"?", "the keys of [[bearing]] stand in docs/reference/isolation-keys.md"]
        );
        let d = told("[[bearing]]\nsomething = [1]\n");
        assert_eq!(d.help, ["the keys of [[bearing]] stand in docs/reference/isolation-keys.md"]);
    }

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

//! Locations of the values of a study in its file.

use super::load::StudyError;
use hysteron_tcl::diagnostic::{Diagnostic, SourceId, Span, nearest};
use toml::Spanned;

/// Locations in the file of the study, for messages.
pub(super) struct SourceSpans {
    source: SourceId,
}

impl SourceSpans {
    /// Locations in a text.
    pub(super) fn new(source: SourceId) -> Self {
        Self { source }
    }

    /// The location of a value.
    pub(super) fn span<T>(&self, s: &Spanned<T>) -> Span {
        let range = s.span();
        Span { source: self.source, start: range.start as u32, end: range.end as u32 }
    }

    /// An error at a value.
    pub(super) fn error<T>(&self, s: &Spanned<T>, message: impl Into<String>, label: impl Into<String>) -> StudyError {
        Box::new(Diagnostic::error(message).at(Some(self.span(s)), label))
    }

    /// A finite number that passes the check `good`. The message says what was `expected`.
    pub(super) fn number(
        &self,
        what: &str,
        s: &Spanned<f64>,
        good: impl Fn(f64) -> bool,
        expected: &str,
    ) -> Result<f64, StudyError> {
        let x = *s.get_ref();
        if x.is_finite() && good(x) { Ok(x) } else { Err(self.error(s, format!("{what} is {x}"), expected)) }
    }

    /// A whole number that is at least `least`.
    pub(super) fn count(&self, what: &str, s: &Option<Spanned<i64>>, least: i64) -> Result<Option<usize>, StudyError> {
        let Some(s) = s else { return Ok(None) };
        match usize::try_from(*s.get_ref()) {
            Ok(n) if n as i64 >= least => Ok(Some(n)),
            _ => {
                let message = format!("{what} is {}", s.get_ref());
                Err(self.error(s, message, format!("expected a whole number not less than {least}")))
            }
        }
    }

    /// One of several known words.
    pub(super) fn choice<'a>(&self, what: &str, s: &Spanned<String>, known: &[&'a str]) -> Result<&'a str, StudyError> {
        let word = s.get_ref();
        if let Some(k) = known.iter().find(|k| *k == word) {
            return Ok(k);
        }
        let mut d = self.error(s, format!("unknown {what} \"{word}\""), format!("expected {}", known.join(" or ")));
        if let Some(near) = nearest(word, known.iter().copied()) {
            d.help.push(format!("did you mean \"{near}\"?"));
        }
        Err(d)
    }
}

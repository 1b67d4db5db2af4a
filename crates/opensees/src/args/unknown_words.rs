//! Words that a command does not know, and words that are left over.

use super::number_words::no_list_of_numbers;
use super::{Args, COMMENT, MAX_LISTED, MAX_UNKNOWN};
use crate::checks::words;
use crate::opensees_names;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::{self, Diagnostic};

impl Args<'_> {
    /// The options of the usage, in its order.
    pub(crate) fn options(&self) -> Vec<&'static str> {
        let words = self.usage.split([' ', '<', '>', '|']).filter(|word| {
            let mut letters = word.chars();
            letters.next() == Some('-') && letters.next().is_some_and(char::is_alphabetic)
        });
        let mut known = vec![];
        words.for_each(|word| {
            if !known.contains(&word) {
                known.push(word)
            }
        });
        known
    }

    /// A warning about the last word taken, which is no option of the command. Numbers after it are left out with it.
    /// After a word that begins with "#" there is no further warning: OpenSees still takes options from there.
    ///
    /// # Errors
    /// There have been too many.
    pub(crate) fn unknown_option(&mut self, known: &[&str]) -> Result<Option<Diagnostic>, Exception> {
        let (word, span) = (self.last_word(), self.last_span());
        if self.commented {
            return Ok(None);
        }
        if word.starts_with('#') {
            self.commented = true;
            let message = format!("{}: \"{word}\" and what follows it are no options", self.call.name());
            let d = Diagnostic::warning(&words::COMMENT_IN_COMMAND, message).at(span, "expected an option");
            return Ok(Some(d.help(COMMENT)));
        }
        self.unknown += 1;
        if self.unknown > MAX_UNKNOWN {
            return Err(self.refuse(format!("more than {MAX_UNKNOWN} words are no options"), "expected an option"));
        }
        let mut values = 0;
        while word.starts_with('-') && self.at_number() {
            self.at += 1;
            values += 1;
        }
        let with = if values > 0 { ", and so is what follows it" } else { "" };
        let message = format!("{}: \"{word}\" is not an option and is ignored{with}", self.call.name());
        let expected = if known.is_empty() { String::new() } else { format!("expected one of {}", known.join(" ")) };
        let mut d = Diagnostic::warning(&words::UNKNOWN_OPTION, message).at(span, expected);
        d.help.extend(no_list_of_numbers(self.call.arg(self.at - 1 - values)));
        Ok(Some(d.suggest(&word, diagnostic::nearest(&word, known.iter().copied()))))
    }

    /// An error about the last word taken, which is none of the `known` names.
    pub(crate) fn unknown_name(&self, what: &str, known: impl IntoIterator<Item = &'static str>) -> Exception {
        self.unknown(what, &known.into_iter().collect::<Vec<_>>(), |known| format!("known: {}", known.join(" ")))
    }

    /// An error about the last word taken, which is no kind of the command's family.
    pub(crate) fn unknown_kind(&self, family: &str, known: impl IntoIterator<Item = &'static str>) -> Exception {
        self.unknown(family, &known.into_iter().collect::<Vec<_>>(), |known| match known.len() {
            0..=MAX_LISTED => format!("known: {}", known.join(" ")),
            _ => format!("\"hysteron commands {}\" lists all that are known", self.call.name()),
        })
    }

    fn unknown(&self, what: &str, known: &[&'static str], list: impl Fn(&[&str]) -> String) -> Exception {
        let word = self.last_word();
        let label = opensees_names::kind_label(&self.call.name(), &word).unwrap_or("not known");
        let d = Diagnostic::error(format!("unknown {what} \"{word}\"")).by(&words::UNKNOWN_KIND);
        let near = diagnostic::nearest(&word, known.iter().copied());
        Exception::diagnosed(d.at(self.last_span(), label).suggest(&word, near).help(list(known)))
    }

    /// A warning about the words that are left over, if any.
    pub(crate) fn rest(&self) -> Option<Diagnostic> {
        let word = self.peek()?;
        let message = format!("{}: \"{word}\" and what follows it is ignored", self.call.name());
        let d = Diagnostic::warning(&words::WORDS_LEFT_OVER, message).at(self.next_span(), "nothing more was expected");
        let comment = word.starts_with('#');
        Some(d.help(if comment { COMMENT.into() } else { self.usage_line() }))
    }
}

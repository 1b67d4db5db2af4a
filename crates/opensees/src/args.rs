//! The words of an OpenSees command, taken one after the other with a message for each that is not what it should be.

mod declared;
mod number_names;
mod number_words;
mod switches;
mod unknown_words;

use crate::checks::words;
use crate::text::{Arg, Domain};
use crate::{Tcl, mistakes, slips, warn};
use hysteron_engine::model::{Registry, Tag};
use hysteron_tcl::diagnostic::{Absent, Diagnostic, Span};
use hysteron_tcl::{Call, Exception, Value, lookalike};
pub(crate) use number_names::number_names;
use number_words::{as_int, no_list_of_numbers, numbers};
use std::borrow::Cow;
use std::fmt::Display;

/// Number of names that a message lists. Of longer lists it says how to print them.
const MAX_LISTED: usize = 6;

/// Characters of a list that a message shows.
const MAX_SHOWN: usize = 60;

/// Largest number of fibers, bars, sections or elements that one command makes.
const MAX_PARTS: usize = 1_000_000;

/// The words of a command that have not been taken yet.
pub(crate) struct Args<'a> {
    call: &'a Call<'a>,
    at: usize,
    usage: &'static str,
    /// Words so far that are no options.
    unknown: usize,
    /// Returns true after a word that begins with "#": what follows is meant as a comment.
    commented: bool,
    /// Definitions that were taken so far: kind and tag.
    pub(crate) taken: Vec<(&'static str, Tag)>,
}

/// Words of a command that are ignored with a warning each. With more the command is not what was meant.
const MAX_UNKNOWN: usize = 20;

/// Help about a comment that is none.
const COMMENT: &str = "a comment after a command begins with \";#\"";

impl<'a> Args<'a> {
    /// All words after the name of the command.
    pub(crate) fn new(call: &'a Call<'a>, usage: &'static str) -> Self {
        Self { call, at: 1, usage, unknown: 0, commented: false, taken: vec![] }
    }

    /// The same words for what a sub-command wants.
    pub(crate) fn usage(&mut self, usage: &'static str) {
        self.usage = usage;
    }

    /// Leave out the words before one, which have been taken elsewhere.
    pub(crate) fn skip_to(&mut self, word: usize) {
        self.at = self.at.max(word);
    }

    /// Number of words left.
    pub(crate) fn left(&self) -> usize {
        self.call.len().saturating_sub(self.at)
    }

    /// Place of the last word taken.
    pub(crate) fn last_span(&self) -> Option<Span> {
        self.call.span(self.at - 1)
    }

    /// Place of the next word.
    pub(crate) fn next_span(&self) -> Option<Span> {
        self.call.span(self.at)
    }

    /// The next word, left where it is.
    pub(crate) fn peek(&self) -> Option<Cow<'a, str>> {
        self.call.get(self.at).map(Value::as_str)
    }

    /// The words that have not been taken.
    pub(crate) fn ahead(&self) -> impl Iterator<Item = &'a Value> + use<'a> {
        self.call.from(self.at).iter()
    }

    /// Returns true if the next word is a number.
    pub(crate) fn at_number(&self) -> bool {
        self.call.get(self.at).is_some_and(|v| v.as_f64().is_some())
    }

    /// Returns true if the next word looks like an option: a minus that begins no number.
    pub(crate) fn at_option(&self) -> bool {
        !self.at_number() && self.peek().is_some_and(|w| w.starts_with('-'))
    }

    /// An error about the last word taken.
    pub(crate) fn refuse(&self, message: impl Into<String>, label: impl Into<String>) -> Exception {
        self.refuse_at(self.last_span(), message, label)
    }

    /// An error about a place.
    pub(crate) fn refuse_at(
        &self,
        span: Option<Span>,
        message: impl Into<String>,
        label: impl Into<String>,
    ) -> Exception {
        Exception::diagnosed(Diagnostic::error(message).at(span, label).help(self.usage_line()))
    }

    /// The error for a tag of a kind that is not defined, the last word taken.
    pub(crate) fn absent(&self, kind: &'static str, tag: impl Display, label: impl Into<String>) -> Exception {
        self.absent_at(self.last_span(), kind, tag, label)
    }

    /// The same with the place of the tag.
    pub(crate) fn absent_at(
        &self,
        span: Option<Span>,
        kind: &'static str,
        tag: impl Display,
        label: impl Into<String>,
    ) -> Exception {
        let absent = Absent::new(kind, tag);
        self.refuse_at(span, format!("there is no {absent}"), label).by(&words::NOT_DEFINED).absent(absent)
    }

    /// The error for a tag that a thing of the kind has already, the last word taken.
    pub(crate) fn exists(&self, kind: &'static str, tag: impl Display) -> Exception {
        self.exists_at(self.last_span(), kind, tag)
    }

    /// The same with the place of the tag.
    pub(crate) fn exists_at(&self, span: Option<Span>, kind: &'static str, tag: impl Display) -> Exception {
        let article = if kind.starts_with(['a', 'e', 'i', 'o']) { "an" } else { "a" };
        self.refuse_at(span, format!("there is {article} {kind} {tag} already"), "expected a new tag")
            .by(&words::TAG_IN_USE)
    }

    /// The error for a file that cannot be read.
    pub(crate) fn unreadable(&self, span: Option<Span>, name: impl Display, error: &dyn Display) -> Exception {
        self.refuse_at(span, format!("cannot read \"{name}\": {error}"), "expected a file").by(&words::UNREADABLE_FILE)
    }

    /// Refuse the body of a command that a host calls: its text would be run as Tcl, with all that Tcl may do.
    ///
    /// # Errors
    /// A host calls the command.
    pub(crate) fn refuse_body(&self, interp: &Tcl, command: &str) -> Result<(), Exception> {
        if !interp.host.called_by_host {
            return Ok(());
        }
        let message = format!("a text is not run as a script here: \"{command}\" comes as a command of its own");
        Err(self.refuse(message, "not read"))
    }

    /// An error about the last word taken, a number outside of its range.
    fn out_of_range(&self, message: String, label: String) -> Exception {
        self.refuse(message, label).by(&words::OUT_OF_RANGE)
    }

    fn usage_line(&self) -> String {
        format!("usage: {}", crate::usage_as(&self.call.name(), self.usage))
    }

    /// The error for a word that is not there.
    fn missing(&self, what: &dyn Display) -> Exception {
        let span = self.call.whole_span().or_else(|| self.call.span(0));
        self.refuse_at(span, format!("{}: the {what} is missing", self.call.name()), format!("expected the {what}"))
            .by(&words::MISSING_WORD)
    }

    fn take(&mut self, what: &dyn Display) -> Result<&'a Value, Exception> {
        if self.left() == 0 {
            return Err(self.missing(what));
        }
        self.call.note_meaning(self.at, || what.to_string());
        self.at += 1;
        Ok(self.call.arg(self.at - 1))
    }

    /// The tag of a thing of a kind: the word names the thing, whether or not it is there.
    pub(crate) fn tag(&mut self, kind: &'static str, what: &str) -> Result<Tag, Exception> {
        let tag = self.int(what)?;
        self.call.note_name(self.last_span(), kind, tag);
        Ok(tag)
    }

    /// Tags of things of a kind, up to the next word that is none.
    pub(crate) fn tags(&mut self, kind: &'static str) -> Vec<(Tag, Option<Span>)> {
        let from = self.at;
        let tags = self.placed_ints();
        tags.iter().for_each(|(tag, span)| self.call.note_name(*span, kind, tag));
        (from..self.at).for_each(|i| self.call.note_meaning(i, || format!("tag of a {kind}")));
        tags
    }

    /// The next word.
    pub(crate) fn word(&mut self, what: &str) -> Result<Cow<'a, str>, Exception> {
        self.take(&what).map(Value::as_str)
    }

    /// The next word as it is, for instance a body.
    pub(crate) fn value(&mut self, what: &str) -> Result<Value, Exception> {
        self.take(&what).cloned()
    }

    fn within(&mut self, what: &dyn Display, domain: Domain) -> Result<f64, Exception> {
        let value = self.take(what)?;
        let expected = domain.expected();
        self.call.note_meaning(self.at - 1, || format!("{what}, {expected}"));
        self.call.note_number(self.at - 1, || what.to_string(), false);
        let label = || format!("expected the {what}, {expected}");
        let Some(x) = value.as_f64() else {
            let text = value.as_str();
            let e = self.refuse(format!("{what} is not a number: \"{text}\""), label()).by(&words::NOT_A_NUMBER);
            return Err(lookalike(&text).into_iter().fold(e, Exception::help));
        };
        if !x.is_finite() {
            return Err(self.refuse(format!("{what} is not finite"), label()).by(&words::NOT_A_NUMBER));
        }
        if domain.holds(x) { Ok(x) } else { Err(self.out_of_range(format!("{what} is {x}"), label())) }
    }

    /// Number of numbers that come next.
    pub(crate) fn numbers_ahead(&self) -> usize {
        self.ahead().take_while(|v| v.as_f64().is_some()).count()
    }

    /// A finite number.
    pub(crate) fn float(&mut self, what: &str) -> Result<f64, Exception> {
        self.within(&what, Domain::Number)
    }

    /// The last word taken has no meaning, though OpenSees computes with it: an error, and a warning under `--compat opensees`.
    /// A check reports the error and goes on with the command.
    pub(crate) fn doubt(
        &self,
        interp: &mut Tcl,
        message: impl Into<String>,
        label: impl Into<String>,
    ) -> Result<(), Exception> {
        self.doubt_at(interp, self.last_span(), message, label)
    }

    /// The same of another place.
    pub(crate) fn doubt_at(
        &self,
        interp: &mut Tcl,
        span: Option<Span>,
        message: impl Into<String>,
        label: impl Into<String>,
    ) -> Result<(), Exception> {
        if !interp.host.follows(&[slips::DOMAINS]) {
            let e = self.refuse_at(span, message, label).by(&words::OUT_OF_RANGE);
            return mistakes::go_on(interp, Err(e));
        }
        warn(
            interp,
            Diagnostic::warning(&words::OUT_OF_RANGE, message).at(span, label).help("OpenSees computes with it"),
        )
    }

    /// A number, where the next word is one.
    pub(crate) fn optional_float(&mut self, what: &str) -> Result<Option<f64>, Exception> {
        if self.at_number() { self.float(what).map(Some) } else { Ok(None) }
    }

    /// All numbers up to the next word that is none. A word that is a list of numbers counts as its elements.
    pub(crate) fn floats(&mut self, what: &str) -> Result<Vec<f64>, Exception> {
        let mut out = vec![];
        while let Some(value) = self.call.get(self.at) {
            self.call.note_meaning(self.at, || what.to_owned());
            if let Some(x) = value.as_f64() {
                self.call.note_number(self.at, || what.to_owned(), false);
                if !x.is_finite() {
                    self.at += 1;
                    return Err(self.refuse(format!("a {what} is not finite"), "expected a number"));
                }
                out.push(x);
            } else if let Some(list) = numbers(value) {
                out.extend(list);
            } else {
                break;
            }
            self.at += 1;
        }
        Ok(out)
    }

    /// The error for the next word, where it was meant as a list of numbers.
    pub(crate) fn next_is_no_list(&self, what: &str) -> Option<Exception> {
        let value = self.call.get(self.at).filter(|_| !self.at_option())?;
        let text: String = value.as_str().chars().take(MAX_SHOWN).collect();
        let e =
            self.refuse_at(self.next_span(), format!("not a list of numbers: \"{text}\""), format!("expected {what}"));
        Some(no_list_of_numbers(value).into_iter().fold(e, Exception::help))
    }

    /// A whole number. OpenSees takes `2.0` for 2; so do we.
    pub(crate) fn int(&mut self, what: &str) -> Result<i32, Exception> {
        self.int_as(&what)
    }

    fn int_as(&mut self, what: &dyn Display) -> Result<i32, Exception> {
        let value = self.take(what)?;
        self.call.note_number(self.at - 1, || what.to_string(), true);
        match as_int(value) {
            Some(i) => Ok(i),
            None => {
                let text = value.as_str();
                let message = format!("{what} is not a whole number: \"{text}\"");
                let label = format!("expected the {what}, a whole number");
                let e = self.refuse(message, label).by(&words::NOT_A_NUMBER);
                Err(lookalike(&text).into_iter().fold(e, Exception::help))
            }
        }
    }

    /// A whole number, where the next word is one.
    pub(crate) fn optional_int(&mut self, what: &str) -> Result<Option<i32>, Exception> {
        if self.call.get(self.at).is_some_and(|v| as_int(v).is_some()) { self.int(what).map(Some) } else { Ok(None) }
    }

    /// All whole numbers up to the next word that is none; a word that is a list of them counts as its elements.
    pub(crate) fn ints(&mut self) -> Vec<i32> {
        self.placed_ints().into_iter().map(|(i, _)| i).collect()
    }

    /// The same with the place of each.
    pub(crate) fn placed_ints(&mut self) -> Vec<(i32, Option<Span>)> {
        let mut out = vec![];
        while let Some(value) = self.call.get(self.at) {
            let span = self.call.span(self.at);
            if let Some(i) = as_int(value) {
                out.push((i, span));
            } else if let Some(list) = value.to_list().ok().filter(|l| l.len() > 1) {
                let all: Option<Vec<_>> = list.iter().map(|v| Some((as_int(v)?, span))).collect();
                match all {
                    Some(all) => out.extend(all),
                    None => break,
                }
            } else {
                break;
            }
            self.at += 1;
        }
        out
    }

    /// A count, at least one.
    pub(crate) fn count(&mut self, arg: &Arg) -> Result<usize, Exception> {
        let what = arg.meaning;
        match self.int(what)? {
            i if i >= 1 => Ok(i as usize),
            i => Err(self.out_of_range(format!("{what} is {i}"), format!("expected the {what}, at least 1"))),
        }
    }

    /// Counts whose product is the number of parts that a command makes: at least 1 each, and at most [`MAX_PARTS`] together,
    /// since a slip of some zeros would take all memory.
    pub(crate) fn parts<const N: usize>(&mut self, args: [&Arg; N]) -> Result<[usize; N], Exception> {
        let (mut counts, mut parts) = ([1; N], 1_usize);
        for (count, arg) in counts.iter_mut().zip(args) {
            *count = self.parts_of(parts, arg)?;
            parts = parts.saturating_mul(*count);
        }
        Ok(counts)
    }

    /// A count that multiplies the number of parts that a command makes so far; see [`Self::parts`].
    pub(crate) fn parts_of(&mut self, parts: usize, arg: &Arg) -> Result<usize, Exception> {
        let count = self.count(arg)?;
        let parts = parts.saturating_mul(count);
        if parts > MAX_PARTS {
            let message = format!("{parts} parts are more than one command can make");
            return Err(self.refuse(message, format!("expected at most {MAX_PARTS} in all")));
        }
        Ok(count)
    }

    /// A degree of freedom or direction, 1 to `limit`; counted from 0 in the result.
    pub(crate) fn dof(&mut self, what: &str, limit: usize) -> Result<usize, Exception> {
        match self.int(what)? {
            i if i >= 1 && i as usize <= limit => Ok(i as usize - 1),
            i => Err(self.out_of_range(format!("{what} is {i}"), format!("expected the {what}, 1 to {limit}"))),
        }
    }

    /// The same with a sign: the degree of freedom from 0, and true for a negative number.
    pub(crate) fn signed_dof(&mut self, what: &str, limit: usize) -> Result<(usize, bool), Exception> {
        match self.int(what)? {
            i if i != 0 && i.unsigned_abs() as usize <= limit => Ok((i.unsigned_abs() as usize - 1, i < 0)),
            i => {
                let label = format!("expected the {what}, 1 to {limit} or -1 to -{limit}");
                Err(self.out_of_range(format!("{what} is {i}"), label))
            }
        }
    }

    /// A thing by its tag.
    pub(crate) fn of<T: Clone>(&mut self, registry: &Registry<T>) -> Result<(T, Tag), Exception> {
        let kind = registry.kind;
        let tag = self.int_as(&format_args!("tag of a {kind}"))?;
        self.call.note_name(self.last_span(), kind, tag);
        match registry.get(tag) {
            Some(thing) => {
                self.taken.push((kind, tag));
                Ok((thing.clone(), tag))
            }
            None => {
                let known: Vec<String> = registry.tags().map(|t| t.to_string()).collect();
                let known = match known.len() {
                    0 => format!("no {kind} has been defined"),
                    n if n > 20 => format!("{n} have been defined, {} to {}", known[0], known[n - 1]),
                    _ => format!("defined: {}", known.join(" ")),
                };
                Err(self.absent(kind, tag, known))
            }
        }
    }

    /// Take the next word if it is this one.
    pub(crate) fn flag(&mut self, name: &str) -> bool {
        let there = self.peek().is_some_and(|w| w == name);
        self.at += usize::from(there);
        there
    }

    /// The next word, if there is one, as an option.
    pub(crate) fn option(&mut self) -> Option<Cow<'a, str>> {
        let word = self.peek()?;
        self.at += 1;
        Some(word)
    }

    /// The last word taken.
    pub(crate) fn last_word(&self) -> Cow<'a, str> {
        self.call.arg(self.at - 1).as_str()
    }
}

//! Commands and calls of them.

use std::cell::RefCell;
use std::rc::Rc;

use super::ast::{Command, Script};
use super::core::{Core, NsId};
use super::ensemble::Ensemble;
use super::error::Exception;
use super::interp::Interp;
use super::text::Text;
use super::value::Value;
use super::vars::VarName;
use crate::check::WRONG_ARGUMENTS;
use crate::diagnostic::{self, Diagnostic, SourceId, Span};

/// A command of the host or of the language.
pub type CommandFn<H> = fn(&mut Interp<H>, &Call<'_>) -> Result<Value, Exception>;

/// A command that needs neither the host nor to evaluate scripts.
pub(crate) type CoreFn = fn(&mut Core, &Call<'_>) -> Result<Value, Exception>;

/// Number of a command; stays with it when it is renamed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct CmdId(pub(crate) u32);

/// A command under its name.
#[derive(Clone)]
pub(crate) struct Definition {
    pub(crate) name: Text,
    pub(crate) ns: NsId,
    pub(crate) imp: Imp,
}

/// Implementation of a command.
#[derive(Clone)]
pub(crate) enum Imp {
    Core(CoreFn),
    /// Number among the functions of the interpreter.
    Full(u32),
    Proc(Rc<Proc>),
    Import(CmdId),
    Ensemble(Rc<Ensemble>),
    /// Other words in place of the name.
    Alias(Rc<[Value]>),
    Deleted,
}

/// A procedure.
#[derive(Clone, Debug)]
pub(crate) struct Proc {
    pub(crate) ns: NsId,
    pub(crate) params: Vec<Param>,
    /// True if the last parameter is `args`.
    pub(crate) variadic: bool,
    /// True if no two parameters have the same name.
    pub(crate) distinct: bool,
    pub(crate) body: Value,
    pub(crate) script: Rc<Script>,
}

/// A parameter of a procedure.
#[derive(Clone, Debug)]
pub(crate) struct Param {
    pub(crate) name: Rc<VarName>,
    pub(crate) default: Option<Value>,
}

/// Places of a call's words in a script.
#[derive(Clone, Copy)]
pub(crate) struct Place<'a> {
    pub(crate) script: &'a Script,
    pub(crate) command: &'a Command,
    /// For each word of the call the word of the command that it comes from, where `{*}` has made more or fewer of them.
    pub(crate) map: Option<&'a [u32]>,
}

impl Place<'_> {
    /// Place of a word of the call.
    pub(crate) fn word(&self, i: usize) -> Option<Span> {
        let i = match self.map {
            None => i,
            Some(map) => *map.get(i)? as usize,
        };
        let word = self.command.words.get(i)?;
        self.script.unit.span(word.start, word.end)
    }

    #[inline]
    pub(crate) fn whole(&self) -> Option<Span> {
        self.command.span
    }
}

/// A word of a call that is taken for a number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NumberNote {
    /// Number of the word.
    pub word: usize,
    /// Meaning of the number.
    pub what: String,
    /// A count, a switch or a tag.
    pub whole: bool,
}

/// What a command took the words of a call for, told to those who show scripts.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CallNotes {
    /// Number of a word and its meaning.
    pub meanings: Vec<(usize, String)>,
    /// Words that are taken for numbers.
    pub numbers: Vec<NumberNote>,
    /// Numbers that are left out: the word that they would stand before, and their values.
    pub omitted: Vec<(usize, f64)>,
    /// Place of a word, and the thing that it names: kind and tag.
    pub names: Vec<(Span, &'static str, String)>,
}

/// The words of a call, the name of the command being the first.
pub struct Call<'a> {
    words: &'a [Value],
    place: Option<Place<'a>>,
    /// Notes about the words, where they are wanted.
    notes: Option<Box<RefCell<CallNotes>>>,
    /// Of a call by the host: the source that stands for it, and the number of the call.
    number: Option<(SourceId, u32)>,
    /// Of a call by the host whose words stand in a text of another language: the place of each word, and that of the call.
    spans: Option<(&'a [Span], Span)>,
    blank: Value,
}

impl<'a> Call<'a> {
    /// A call that stands nowhere in a script; the first word is the name of the command.
    pub fn of(words: &'a [Value]) -> Self {
        Self::new(words, None)
    }

    pub(crate) fn new(words: &'a [Value], place: Option<Place<'a>>) -> Self {
        Call { words, place, notes: None, number: None, spans: None, blank: Value::EMPTY }
    }

    /// The same call, whose command takes notes.
    pub fn noting(&self) -> Self {
        let notes = Some(Box::default());
        Call {
            words: self.words,
            place: self.place,
            notes,
            number: self.number,
            spans: self.spans,
            blank: Value::EMPTY,
        }
    }

    /// Note what a word means.
    pub fn note_meaning(&self, i: usize, meaning: impl FnOnce() -> String) {
        if let Some(notes) = &self.notes {
            notes.borrow_mut().meanings.push((i, meaning()));
        }
    }

    /// Note that a word is taken for a number, what the number is, and whether it is a count, a switch or a tag.
    pub fn note_number(&self, word: usize, what: impl FnOnce() -> String, whole: bool) {
        if let Some(notes) = &self.notes {
            notes.borrow_mut().numbers.push(NumberNote { word, what: what(), whole });
        }
    }

    /// Note a number that is left out: the word that it would stand before, and its value.
    pub fn note_omitted(&self, word: usize, value: f64) {
        if let Some(notes) = &self.notes {
            notes.borrow_mut().omitted.push((word, value));
        }
    }

    /// Note that the word at a place names a thing.
    pub fn note_name(&self, place: Option<Span>, kind: &'static str, tag: impl std::fmt::Display) {
        if let (Some(notes), Some(place)) = (&self.notes, place) {
            notes.borrow_mut().names.push((place, kind, tag.to_string()));
        }
    }

    /// The notes so far.
    pub fn notes(&self) -> CallNotes {
        self.notes.as_ref().map(|n| n.borrow().clone()).unwrap_or_default()
    }

    /// A call by the host, whose words have no text; the first word is the name of the command.
    ///
    /// The span of word `i` starts at `number` and ends at `i`; that of the whole call ends at `u32::MAX`. The host
    /// finds the word by them.
    pub fn numbered(words: &'a [Value], source: SourceId, number: u32) -> Self {
        Call { number: Some((source, number)), ..Self::of(words) }
    }

    /// A call by the host whose words stand in a text of another language; the first word is the name of the command.
    pub fn placed(words: &'a [Value], spans: &'a [Span], whole: Span) -> Self {
        Call { spans: Some((spans, whole)), ..Self::of(words) }
    }

    fn numbered_span(&self, end: u32) -> Option<Span> {
        self.number.map(|(source, start)| Span { source, start, end })
    }

    /// The name under which the command was called.
    pub fn name(&self) -> std::borrow::Cow<'_, str> {
        self.arg(0).as_str()
    }

    /// Number of words, the name included.
    #[allow(clippy::len_without_is_empty)]
    pub fn len(&self) -> usize {
        self.words.len()
    }

    /// A word; number 0 is the name. Empty where there is no such word.
    pub fn arg(&self, i: usize) -> &Value {
        self.words.get(i).unwrap_or(&self.blank)
    }

    /// A word, if it was given.
    pub fn get(&self, i: usize) -> Option<&Value> {
        self.words.get(i)
    }

    /// The words after the name.
    pub fn args(&self) -> &'a [Value] {
        self.from(1)
    }

    /// All words from the one with this number.
    pub fn from(&self, i: usize) -> &'a [Value] {
        self.words.get(i..).unwrap_or_default()
    }

    /// Place of a word in the script; none for a text that was built at run time.
    pub fn span(&self, i: usize) -> Option<Span> {
        match (&self.place, self.spans) {
            (Some(place), _) => place.word(i),
            (None, Some((spans, _))) => spans.get(i).copied(),
            (None, None) if i < self.words.len() => self.numbered_span(i as u32),
            (None, None) => None,
        }
    }

    /// Place of the whole command.
    pub fn whole_span(&self) -> Option<Span> {
        match (&self.place, self.spans) {
            (Some(place), _) => place.whole(),
            (None, Some((_, whole))) => Some(whole),
            (None, None) => self.numbered_span(u32::MAX),
        }
    }

    /// The text of the whole command as it stands in the script.
    pub(crate) fn source_text(&self) -> Option<&str> {
        let place = self.place.as_ref()?;
        Some(place.script.unit.slice(place.command.start, place.command.end))
    }

    /// An error that points at a word.
    pub fn error_at(&self, i: usize, message: impl Into<String>, label: &str) -> Exception {
        Exception::error(message).at(self.span(i), label)
    }

    /// An error with a diagnostic of its own, which points at a word unless it points somewhere already.
    pub fn refuse(&self, i: usize, mut diagnostic: Diagnostic) -> Exception {
        if diagnostic.span.is_none() {
            diagnostic.span = self.span(i);
        }
        Exception::diagnosed(diagnostic)
    }

    /// The error for a wrong number of words. `usage`: the words that belong after the first `given` ones.
    pub fn usage(&self, given: usize, usage: &str) -> Exception {
        let mut text = String::new();
        super::list::join(&self.words[..given.min(self.words.len())]).clone_into(&mut text);
        if !usage.is_empty() {
            text.push(' ');
            text.push_str(usage);
        }
        self.wrong_args(&text)
    }

    /// The error for a wrong number of words, for a command that is to be written like this.
    pub(crate) fn wrong_args(&self, right: &str) -> Exception {
        let span = match (self.place.as_ref().and_then(Place::whole), self.span(0)) {
            (Some(whole), Some(name)) if self.words.len() == 1 => Some(name.to(whole)),
            (whole, _) => whole,
        };
        Exception::coded(format!("wrong # args: should be \"{right}\""), &["TCL", "WRONGARGS"])
            .by(&WRONG_ARGUMENTS)
            .at(span, "")
    }

    /// Check the number of words, the name included; `right` is how the command is to be written.
    pub(crate) fn expect(&self, words: impl std::ops::RangeBounds<usize>, right: &str) -> Result<(), Exception> {
        if words.contains(&self.words.len()) { Ok(()) } else { Err(self.wrong_args(right)) }
    }

    /// The one of some names that a word is or, unless `exact`, abbreviates; Tcl's error if it is none.
    pub(crate) fn choose(&self, i: usize, what: &str, names: &[&str], exact: bool) -> Result<usize, Exception> {
        choose(&self.arg(i).as_str(), what, names, exact).map_err(|e| e.at(self.span(i), ""))
    }
}

impl Core {
    /// Returns true if nothing looks at the result of a command: it stands for itself, neither in brackets or `catch` nor at
    /// the end of a body in a procedure, whose result it may be.
    pub fn is_discarded(&self, call: &Call<'_>) -> bool {
        let Some(Place { script, command, .. }) = &call.place else { return false };
        let is_last = script.commands.last().is_some_and(|last| std::ptr::eq(last, *command));
        let before = script.unit.slice(0, command.start).trim_end();
        let is_kept = is_last && self.frame().is_proc || before.ends_with('[') || self.calls.catching > 0;
        !is_kept && script.unit.origin.is_some()
    }
}

/// The one of some names that a word is or, unless `exact`, abbreviates.
pub(crate) fn choose(word: &str, what: &str, names: &[&str], exact: bool) -> Result<usize, Exception> {
    if let Some(at) = names.iter().position(|n| *n == word) {
        return Ok(at);
    }
    let mut ambiguous = false;
    if !exact && !word.is_empty() {
        let mut matches = names.iter().enumerate().filter(|(_, n)| n.starts_with(word));
        match (matches.next(), matches.next()) {
            (Some((at, _)), None) => return Ok(at),
            (Some(_), Some(_)) => ambiguous = true,
            _ => {}
        }
    }
    let kind = if ambiguous { "ambiguous" } else { "bad" };
    let message = format!("{kind} {what} \"{word}\": must be {}", alternatives(names));
    let near = diagnostic::nearest(word, names.iter().copied()).map(str::to_owned);
    Err(Exception::coded(message, &["TCL", "LOOKUP", "INDEX", what, word]).suggest(word, near))
}

/// `a`, `a or b`, `a, b, or c`.
pub(crate) fn alternatives(names: &[&str]) -> String {
    match names {
        [] => String::new(),
        [one] => (*one).to_owned(),
        [a, b] => format!("{a} or {b}"),
        [most @ .., last] => format!("{}, or {last}", most.join(", ")),
    }
}

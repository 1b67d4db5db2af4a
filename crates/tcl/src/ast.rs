//! A parsed script. Bytes are counted in the text of the [`Unit`], which knows where that text comes from.

use std::cell::Cell;
use std::rc::Rc;

use super::inline::Inline;
use super::origin::Origin;
use super::stack;
use super::stretch::Stretch;
use super::text::Text;
use super::value::Value;
use super::vars::VarName;
use crate::diagnostic::Span;

/// A text that was parsed as a whole.
#[derive(Debug)]
pub(crate) struct Unit {
    pub(crate) text: Stretch,
    pub(crate) origin: Option<Origin>,
}

impl Unit {
    pub(crate) fn span(&self, start: u32, end: u32) -> Option<Span> {
        self.origin.as_ref().map(|o| o.span(start, end))
    }

    pub(crate) fn slice(&self, start: u32, end: u32) -> &str {
        self.text.get(start as usize..end as usize).unwrap_or_default()
    }

    /// Line of a byte, from 1.
    pub(crate) fn line(&self, at: u32) -> usize {
        self.slice(0, at).bytes().filter(|b| *b == b'\n').count() + 1
    }
}

/// The commands of a script, or of one pair of brackets.
#[derive(Debug)]
pub(crate) struct Script {
    pub(crate) unit: Rc<Unit>,
    pub(crate) commands: Vec<Command>,
    /// Error after the last of the commands, which run before it is raised.
    pub(crate) error: Option<ParseError>,
}

impl Drop for Script {
    /// Bodies hold their own parsed form, so that scripts nest as deep as the text does.
    fn drop(&mut self) {
        stack::grow(|| self.commands.clear());
    }
}

/// Syntax error of a text.
#[derive(Clone, Debug)]
pub(crate) struct ParseError {
    pub(crate) message: String,
    /// Place of the error, for instance the brace that is not closed.
    pub(crate) start: u32,
    pub(crate) end: u32,
    pub(crate) label: &'static str,
    pub(crate) help: Option<&'static str>,
    /// The text ends before what was opened is closed.
    pub(crate) never_closed: bool,
}

/// Cached place of the command of a name.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Found {
    /// State of the command tables then; 0: never looked.
    pub(crate) epoch: u32,
    pub(crate) namespace: u32,
    pub(crate) command: u32,
}

/// One command.
#[derive(Debug)]
pub(crate) struct Command {
    pub(crate) words: Box<[Word]>,
    pub(crate) start: u32,
    pub(crate) end: u32,
    /// Its place in the sources.
    pub(crate) span: Option<Span>,
    pub(crate) found: Cell<Found>,
    /// The form in which it runs without a call.
    pub(crate) inline: Inline,
    /// Number of that form among the commands of the language.
    pub(crate) form: u8,
    /// True if it is such a form without brackets in it.
    pub(crate) is_flat: bool,
}

/// One word.
#[derive(Debug)]
pub(crate) struct Word {
    pub(crate) kind: WordKind,
    pub(crate) start: u32,
    pub(crate) end: u32,
    /// Marked with `{*}`: its elements are words of their own.
    pub(crate) expand: bool,
}

/// Parts of a word.
#[derive(Debug)]
pub(crate) enum WordKind {
    Literal(Value),
    Var(VarRef),
    Script(Rc<Script>),
    Parts(Box<[Part]>),
}

/// One part of a word.
#[derive(Debug)]
pub(crate) enum Part {
    Text(Box<str>),
    Var(VarRef),
    Script(Rc<Script>),
}

/// `$name`, `$name(index)`.
#[derive(Clone, Debug)]
pub(crate) struct VarRef {
    pub(crate) name: Rc<VarName>,
    pub(crate) index: Option<Index>,
    pub(crate) start: u32,
    pub(crate) end: u32,
}

/// The index of an array element.
#[derive(Clone, Debug)]
pub(crate) enum Index {
    Text(Text),
    Parts(Rc<[Part]>),
}

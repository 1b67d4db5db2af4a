//! Frequent commands that are carried out without a call, as long as their names mean those of the language.
//!
//! Each is read once, when the script is parsed. Where a command turns out to be unusual, and where it fails for a reason
//! that its own function tells better, it is called like any other.

mod control;
mod variables;

use std::cell::OnceCell;
use std::rc::Rc;

use super::ast::{Command, Index, Part, Script, VarRef, Word, WordKind};
use super::command::{CmdId, Place};
use super::core::Core;
use super::error::Exception;
use super::expr::{Expr, Template};
use super::interp::Interp;
use super::value::{Rep, Value};
use super::vars::VarName;

/// The names of these commands, in the order of `Inline::number`.
const NAMES: [&str; 13] = [
    "expr", "set", "incr", "if", "while", "for", "foreach", "return", "lappend", "lindex", "llength", "string",
    "append",
];

/// The commands of the language behind the names; none where a script has put another in the place.
#[derive(Clone, Copy, Default)]
pub(crate) struct InlinedCommands([Option<CmdId>; NAMES.len()]);

impl InlinedCommands {
    /// The commands as an interpreter begins with them.
    pub(crate) fn new(find: impl Fn(&str) -> Option<CmdId>) -> Self {
        InlinedCommands(NAMES.map(find))
    }

    /// Another function stands behind a command: it is no longer that of the language.
    pub(crate) fn forget(&mut self, id: CmdId) {
        for known in &mut self.0 {
            known.take_if(|known| *known == id);
        }
    }
}

/// A command that needs no call.
#[derive(Debug)]
pub(crate) enum Inline {
    No,
    /// `expr`
    Expr(Box<Expression>),
    /// `set name value`
    Set(Rc<VarName>),
    /// `incr name ?increment?`
    Incr(Rc<VarName>),
    /// `if test body ...`
    If(Box<[Clause]>),
    /// `while test body`
    While(Box<Loop>),
    /// `for start test next body`
    For(Box<Loop>),
    /// `foreach names list body`
    Foreach(Box<[Rc<VarName>]>, Body),
    /// `return ?value?`
    Return,
    /// `lappend name value`
    Lappend(Rc<VarName>),
    /// `append name value`
    Append(Rc<VarName>),
    /// `lindex list place`
    Item,
    /// `llength list`
    Length,
    /// `string length text`
    Characters,
}

/// The words of an `expr`, compiled.
#[derive(Debug, Default)]
pub(crate) struct Expression {
    /// One braced word.
    pub(crate) braced: OnceCell<Rc<Expr>>,
    /// Other words, as an expression with places for operands.
    pub(crate) template: OnceCell<Option<Template>>,
}

/// A word that is a condition.
#[derive(Debug)]
pub(crate) struct Test {
    word: usize,
    expr: OnceCell<Rc<Expr>>,
}

/// A word that is a script.
#[derive(Debug)]
pub(crate) struct Body {
    word: usize,
    script: OnceCell<Rc<Script>>,
}

impl Test {
    fn new(word: usize) -> Self {
        Test { word, expr: OnceCell::new() }
    }
}

impl Body {
    fn new(word: usize) -> Self {
        Body { word, script: OnceCell::new() }
    }
}

/// A condition of an `if`, none for `else`, and what runs.
#[derive(Debug)]
pub(crate) struct Clause {
    test: Option<Test>,
    body: Body,
}

/// The words of `while` and `for`.
#[derive(Debug)]
pub(crate) struct Loop {
    start: Option<Body>,
    test: Test,
    next: Option<Body>,
    body: Body,
}

impl Inline {
    /// The form of a command without a call.
    pub(crate) fn of(words: &[Word]) -> Inline {
        let [Word { kind: WordKind::Literal(name), .. }, rest @ ..] = words else { return Inline::No };
        if words.iter().any(|w| w.expand) {
            return Inline::No;
        }
        let variable = |i: usize| match words.get(i).map(|w| &w.kind) {
            Some(WordKind::Literal(name)) => Some(VarName::of(name)),
            _ => None,
        };
        let form = match (&*name.as_str(), rest.len()) {
            ("expr", _) => Some(Inline::Expr(Box::default())),
            ("set", 2) => variable(1).map(Inline::Set),
            ("incr", 1..=2) => variable(1).map(Inline::Incr),
            ("if", _) => clauses(words).map(|c| Inline::If(c.into())),
            ("while", 2) if are_scripts(words, &[2]) && is_literal(words, 1) => {
                Some(Inline::While(Box::new(Loop { start: None, test: Test::new(1), next: None, body: Body::new(2) })))
            }
            ("for", 4) if are_scripts(words, &[1, 3, 4]) && is_literal(words, 2) => {
                let [start, next, body] = [1, 3, 4].map(Body::new);
                let test = Test::new(2);
                Some(Inline::For(Box::new(Loop { start: Some(start), test, next: Some(next), body })))
            }
            ("foreach", 3) if are_scripts(words, &[3]) => {
                names(words).map(|names| Inline::Foreach(names, Body::new(3)))
            }
            ("return", 0..=1) => Some(Inline::Return),
            ("lappend", 2) => variable(1).map(Inline::Lappend),
            ("append", 2) => variable(1).map(Inline::Append),
            ("lindex", 2) => Some(Inline::Item),
            ("llength", 1) => Some(Inline::Length),
            ("string", 2) if is_word(words, 1, "length") => Some(Inline::Characters),
            _ => None,
        };
        form.unwrap_or(Inline::No)
    }

    /// Number of the command's name; that of no name where it must be called.
    pub(crate) fn number(&self) -> u8 {
        match self {
            Inline::No => u8::MAX,
            Inline::Expr(_) => 0,
            Inline::Set(_) => 1,
            Inline::Incr(_) => 2,
            Inline::If(_) => 3,
            Inline::While(_) => 4,
            Inline::For(_) => 5,
            Inline::Foreach(..) => 6,
            Inline::Return => 7,
            Inline::Lappend(_) => 8,
            Inline::Item => 9,
            Inline::Length => 10,
            Inline::Characters => 11,
            Inline::Append(_) => 12,
        }
    }

    /// Returns true if a command in brackets needs no script around it: it has no brackets of its own.
    pub(crate) fn is_flat(&self, words: &[Word]) -> bool {
        let queries = matches!(self, Inline::Expr(_) | Inline::Item | Inline::Length | Inline::Characters);
        queries && words.iter().all(|w| is_flat_word(&w.kind))
    }
}

fn is_flat_word(kind: &WordKind) -> bool {
    match kind {
        WordKind::Literal(_) => true,
        WordKind::Var(var) => is_flat_variable(var),
        WordKind::Script(_) => false,
        WordKind::Parts(parts) => are_flat(parts),
    }
}

fn are_flat(parts: &[Part]) -> bool {
    parts.iter().all(|part| match part {
        Part::Text(_) => true,
        Part::Var(var) => is_flat_variable(var),
        Part::Script(_) => false,
    })
}

fn is_flat_variable(var: &VarRef) -> bool {
    match &var.index {
        None | Some(Index::Text(_)) => true,
        Some(Index::Parts(parts)) => are_flat(parts),
    }
}

fn is_literal(words: &[Word], i: usize) -> bool {
    matches!(words.get(i), Some(Word { kind: WordKind::Literal(_), .. }))
}

/// Returns true if words are texts, as scripts are.
fn are_scripts(words: &[Word], which: &[usize]) -> bool {
    let is_script = |word: &Word| matches!(&word.kind, WordKind::Literal(Value(Rep::Str(_) | Rep::Empty)));
    which.iter().all(|i| words.get(*i).is_some_and(is_script))
}

fn is_word(words: &[Word], i: usize, wanted: &str) -> bool {
    matches!(words.get(i), Some(Word { kind: WordKind::Literal(text), .. }) if *text.as_str() == *wanted)
}

/// The clauses of an `if` whose words are all literal and in their places.
fn clauses(words: &[Word]) -> Option<Vec<Clause>> {
    let mut clauses = vec![];
    let mut i = 1;
    loop {
        if !is_literal(words, i) {
            return None;
        }
        let test = Test::new(i);
        i += 1;
        i += usize::from(is_word(words, i, "then"));
        if !are_scripts(words, &[i]) {
            return None;
        }
        clauses.push(Clause { test: Some(test), body: Body::new(i) });
        i += 1;
        if i == words.len() {
            return Some(clauses);
        }
        if is_word(words, i, "elseif") {
            i += 1;
            continue;
        }
        i += usize::from(is_word(words, i, "else"));
        if i + 1 != words.len() || !are_scripts(words, &[i]) {
            return None;
        }
        clauses.push(Clause { test: None, body: Body::new(i) });
        return Some(clauses);
    }
}

/// The variables of a `foreach`.
fn names(words: &[Word]) -> Option<Box<[Rc<VarName>]>> {
    let Some(Word { kind: WordKind::Literal(names), .. }) = words.get(1) else { return None };
    let names = names.to_list().ok()?;
    (!names.is_empty()).then(|| names.iter().map(VarName::of).collect())
}

fn literal(command: &Command, word: usize) -> &Value {
    const EMPTY: &Value = &Value::EMPTY;
    match command.words.get(word).map(|w| &w.kind) {
        Some(WordKind::Literal(value)) => value,
        _ => EMPTY,
    }
}

impl<H> Interp<H> {
    /// Carry a command out without a call, if it is one of these.
    #[inline]
    pub(crate) fn inlined(&mut self, script: &Script, command: &Command) -> Result<Value, Exception> {
        match &command.inline {
            Inline::No => self.call_command(script, command),
            Inline::Expr(expression) => self.inline_expr(script, command, expression),
            Inline::Set(name) => self.inline_set(script, command, name),
            Inline::Incr(name) => self.inline_incr(script, command, name),
            Inline::If(clauses) => self.inline_if(script, command, clauses),
            Inline::While(words) | Inline::For(words) => self.inline_loop(script, command, words),
            Inline::Foreach(names, body) => self.inline_foreach(script, command, names, body),
            Inline::Return => self.inline_return(script, command),
            Inline::Lappend(name) => self.inline_lappend(script, command, name),
            Inline::Append(name) => self.inline_append(script, command, name),
            Inline::Item => self.inline_item(script, command),
            Inline::Length => self.inline_length(script, command),
            Inline::Characters => self.inline_characters(script, command),
        }
    }

    /// The value of a word of a command that is carried out without a call.
    #[inline]
    fn inline_word(&mut self, script: &Script, command: &Command, i: usize) -> Result<Value, Exception> {
        let Some(word) = command.words.get(i) else { return Ok(Value::EMPTY) };
        match &word.kind {
            WordKind::Literal(value) => Ok(value.clone()),
            kind => self.word(script, kind).map_err(|e| self.control_failed(e, script, command)),
        }
    }

    /// Call the command after all, with words that have their values.
    #[cold]
    fn call_inlined(
        &mut self,
        script: &Script,
        command: &Command,
        words: impl IntoIterator<Item = Value>,
    ) -> Result<Value, Exception> {
        let mut argv = self.core.take_words();
        argv.extend(words);
        self.invoke(argv, Some(Place { script, command, map: None }))
    }

    /// Complete an error that a part of a command has located, as far as it can be.
    #[cold]
    pub(crate) fn control_failed(&mut self, e: Exception, script: &Script, command: &Command) -> Exception {
        let place = Place { script, command, map: None };
        match e {
            Exception::Error(_) => {
                let e = self.core.settle_place(e, Some(place));
                self.core.trace_command(e, Some(place), None)
            }
            Exception::Interrupted => {
                self.core.stopped_at = self.core.stopped_at.or(place.whole());
                e
            }
            other => other,
        }
    }
}

impl Core {
    /// Returns true if a command can be carried out without a call: its name means that of the language.
    #[inline]
    pub(crate) fn is_inlined(&self, script: &Script, command: &Command) -> bool {
        let Some(Some(wanted)) = self.table.inlined.0.get(usize::from(command.form)) else { return false };
        let known = command.found.get();
        if known.epoch == self.table.epoch && known.namespace == self.here().0 {
            return known.command == wanted.0;
        }
        self.is_first_inlined(script, command, *wanted)
    }

    #[cold]
    fn is_first_inlined(&self, script: &Script, command: &Command, wanted: CmdId) -> bool {
        let Some(Word { kind: WordKind::Literal(name), .. }) = command.words.first() else { return false };
        let place = Place { script, command, map: None };
        self.lookup(std::slice::from_ref(name), Some(place)) == Some(wanted)
    }
}

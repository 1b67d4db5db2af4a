//! From the text of an expression to operations, by operator precedence.
//!
//! Follows the way in which Tcl's own parser looks at an expression, since its messages come from that.

use std::cell::Cell;
use std::rc::Rc;

use super::super::ast::{Found, ParseError, Unit, WordKind};
use super::super::lexer::{Lexer, MAX_NESTING};
use super::super::number::{self, Number};
use super::super::value::Value;
use super::lexeme::{self, Lexeme};
use super::{Binary, Expr, ExprError, Function, Op, Range, Unary, func};

/// Characters shown on either side of an error.
const CONTEXT: usize = 25;
const MARK: &str = "_@_";

/// An operator that still lacks its right operand.
struct Pending {
    lexeme: Lexeme,
    /// Start of the text of the whole operation.
    start: u32,
    operator: (u32, u32),
    /// The jump to be completed, for operators that evaluate only one side.
    jump: usize,
    /// Commas within a parenthesis; for a function then its arguments.
    commas: usize,
}

/// The last complete operand.
#[derive(Clone, Copy)]
struct Operand {
    start: u32,
    end: u32,
    is_colon: bool,
    is_empty: bool,
}

pub(super) struct Parser<'a> {
    unit: &'a Rc<Unit>,
    text: &'a str,
    lexer: Lexer<'a>,
    ops: Vec<Op>,
    places: Vec<Range>,
    pending: Vec<Pending>,
    names: Vec<&'a str>,
    complete: Option<Operand>,
    open: usize,
    /// Number of operands handed in so far; none outside of templates.
    slots: Option<usize>,
}

type Failed = Box<ExprError>;

impl<'a> Parser<'a> {
    pub(super) fn new(unit: &'a Rc<Unit>) -> Self {
        let start = Pending { lexeme: Lexeme::Start, start: 0, operator: (0, 0), jump: 0, commas: 0 };
        Parser {
            unit,
            text: &unit.text,
            lexer: Lexer::new(unit),
            ops: vec![],
            places: vec![],
            pending: vec![start],
            names: vec![],
            complete: None,
            open: 0,
            slots: None,
        }
    }

    /// For a text with marks where operands are handed in.
    pub(super) fn template(unit: &'a Rc<Unit>) -> Self {
        Parser { slots: Some(0), ..Self::new(unit) }
    }

    pub(super) fn parse(mut self) -> Result<Expr, Failed> {
        let mut at = 0;
        loop {
            at = lexeme::skip_blanks(self.text, at);
            let (lexeme, length) = lexeme::lexeme(self.text, at);
            let after_operator = self.complete.is_none();
            let lexeme = match lexeme {
                Lexeme::Slot if self.slots.is_none() => Lexeme::Invalid,
                Lexeme::Bareword => self.bareword(at, length)?,
                Lexeme::Binary(Binary::Add) if after_operator => Lexeme::Unary(Unary::Plus),
                Lexeme::Binary(Binary::Sub) if after_operator => Lexeme::Unary(Unary::Minus),
                other => other,
            };
            let shown = &self.text[at..at + length];
            match lexeme {
                Lexeme::Invalid => {
                    return Err(self.error(format!("invalid character \"{shown}\""), at, length, "", &["BADCHAR"]));
                }
                Lexeme::Incomplete => {
                    return Err(self.error(format!("incomplete operator \"{shown}\""), at, length, "", &["PARTOP"]));
                }
                Lexeme::Number
                | Lexeme::Bareword
                | Lexeme::Quoted
                | Lexeme::Braced
                | Lexeme::Variable
                | Lexeme::Slot
                | Lexeme::Script => {
                    self.no_operand_before(at)?;
                    let end = self.leaf(lexeme, at, length)?;
                    self.complete =
                        Some(Operand { start: at as u32, end: end as u32, is_colon: false, is_empty: false });
                    at = end;
                }
                Lexeme::Unary(_) | Lexeme::Function | Lexeme::Open => {
                    self.no_operand_before(at)?;
                    self.prefix(lexeme, at, length)?;
                    at += length;
                }
                _ => match self.binary(lexeme, at, length)? {
                    None => {
                        return Ok(Expr::new(self.unit.clone(), self.ops, self.places));
                    }
                    Some(next) => at = next,
                },
            }
        }
    }

    /// A word is a function before a parenthesis, or a boolean; anything else is a mistake.
    fn bareword(&self, at: usize, length: usize) -> Result<Lexeme, Failed> {
        let word = &self.text[at..at + length];
        if lexeme::byte(self.text, lexeme::skip_blanks(self.text, at + length)) == Some(b'(') {
            return Ok(Lexeme::Function);
        }
        if number::boolean_word(word).is_some() {
            return Ok(Lexeme::Bareword);
        }
        let (cut, dots) = if length < CONTEXT { (word, "") } else { (&word[..CONTEXT - 3], "...") };
        let mut post = format!(";\nshould be \"${cut}{dots}\" or \"{{{cut}{dots}}}\" or \"{cut}{dots}(...)\" or ...");
        let mut code: &[&str] = &["BAREWORD"];
        let bytes = word.as_bytes();
        if bytes.first() == Some(&b'0') {
            let accepted = number::prefix(word).map_or(0, |(l, _)| l);
            if accepted == 1 || bytes.get(accepted).is_some_and(u8::is_ascii_digit) {
                let kind = match bytes.get(1) {
                    Some(b'b') => Some(("binary", &["BADNUMBER", "BINARY"])),
                    Some(b'o') => Some(("octal", &["BADNUMBER", "OCTAL"])),
                    Some(b) if b.is_ascii_digit() => Some(("octal", &["BADNUMBER", "OCTAL"])),
                    _ => None,
                };
                if let Some((kind, bad)) = kind {
                    post.push_str(&format!(" (invalid {kind} number?)"));
                    code = bad;
                }
            }
        }
        Err(self.error(format!("invalid bareword \"{cut}{dots}\""), at, length, &post, code))
    }

    /// Build Tcl's message: what, the expression around it with a mark if wanted, what it should be.
    fn error(&self, what: String, at: usize, length: usize, post: &str, code: &'static [&'static str]) -> Failed {
        let marked = what.ends_with(MARK);
        let length = if marked { 0 } else { length };
        let text = self.text;
        let cut = |from: usize, to: usize| String::from_utf8_lossy(&text.as_bytes()[from.min(to)..to]).into_owned();
        let before = if at < CONTEXT { cut(0, at) } else { format!("...{}", cut(at + 3 - CONTEXT, at)) };
        let scanned = if length < CONTEXT { cut(at, at + length) } else { format!("{}...", cut(at, at + CONTEXT - 3)) };
        let rest = at + length;
        let after = if rest + CONTEXT > text.len() {
            cut(rest, text.len())
        } else {
            format!("{}...", cut(rest, rest + CONTEXT - 3))
        };
        let mark = if marked { MARK } else { "" };
        let message = format!("{what}\nin expression \"{before}{scanned}{mark}{after}\"{post}");
        let end = at + length.max(1);
        let (start, end) = (at as u32, end.min(text.len()) as u32);
        let error = ParseError { message, start, end, label: "", help: None, never_closed: false };
        Box::new(ExprError { error, code: code.to_vec() })
    }

    fn missing(&self, what: &str, at: usize) -> Failed {
        self.error(format!("missing {what} at {MARK}"), at, 0, "", &["MISSING"])
    }

    fn no_operand_before(&self, at: usize) -> Result<(), Failed> {
        match self.complete {
            None => Ok(()),
            Some(_) => Err(self.missing("operator", at)),
        }
    }

    fn emit(&mut self, op: Op, start: u32, end: u32, operator: (u32, u32)) {
        self.ops.push(op);
        self.places.push(Range { start, end, operator });
    }

    /// An operand that needs no others; its end.
    fn leaf(&mut self, lexeme: Lexeme, at: usize, length: usize) -> Result<usize, Failed> {
        let text = &self.text[at..at + length];
        let mut end = at + length;
        let op = match lexeme {
            Lexeme::Number => Op::Push(number_value(text)),
            Lexeme::Bareword => Op::Push(Value::from(text)),
            Lexeme::Slot => {
                let number = self.slots.unwrap_or(0);
                self.slots = Some(number + 1);
                Op::Slot(number)
            }
            _ => {
                self.lexer.pos = at;
                let parsed = match lexeme {
                    Lexeme::Quoted => self.lexer.quoted().map(|kind| match kind {
                        WordKind::Literal(v) => Op::Push(v),
                        WordKind::Var(v) => Op::Var(v),
                        WordKind::Script(s) => Op::Script(s),
                        WordKind::Parts(p) => Op::Parts(p),
                    }),
                    Lexeme::Braced => self.lexer.braced().map(Op::Push),
                    Lexeme::Script => self.lexer.bracketed().map(Op::Script),
                    _ => match self.lexer.variable() {
                        Ok(Some(var)) => Ok(Op::Var(var)),
                        Ok(None) => {
                            let what = "invalid character \"$\"".to_owned();
                            return Err(self.error(what, at, 1, "", &["BADCHAR"]));
                        }
                        Err(e) => Err(e),
                    },
                };
                end = self.lexer.pos;
                match parsed {
                    Ok(op) => op,
                    Err(e) => {
                        let start = e.start as usize;
                        let code: &[&str] = if e.never_closed { &["UNBALANCED"] } else { &[] };
                        let mut failed = self.error(e.message, start, 0, "", code);
                        failed.error.end = e.end;
                        failed.error.label = e.label;
                        failed.error.never_closed = e.never_closed;
                        return Err(failed);
                    }
                }
            }
        };
        self.emit(op, at as u32, end as u32, (0, 0));
        Ok(end)
    }

    fn prefix(&mut self, lexeme: Lexeme, at: usize, length: usize) -> Result<(), Failed> {
        if lexeme == Lexeme::Function {
            let name = &self.text[at..at + length];
            self.names.push(name);
        }
        if lexeme == Lexeme::Open {
            self.open += 1;
            if self.open > MAX_NESTING {
                let what = "too many nested parentheses".to_owned();
                return Err(self.error(what, at, 1, "", &["UNBALANCED"]));
            }
        }
        self.pending.push(Pending {
            lexeme,
            start: at as u32,
            operator: (at as u32, (at + length) as u32),
            jump: 0,
            commas: 0,
        });
        Ok(())
    }

    fn last(&self) -> Lexeme {
        self.pending.last().map_or(Lexeme::Start, |p| p.lexeme)
    }

    fn before_last(&self) -> Lexeme {
        self.pending.len().checked_sub(2).and_then(|i| self.pending.get(i)).map_or(Lexeme::Start, |p| p.lexeme)
    }

    /// An operator after an operand, a closing parenthesis, a comma or the end. Gives where to go on; none at the end.
    fn binary(&mut self, lexeme: Lexeme, at: usize, length: usize) -> Result<Option<usize>, Failed> {
        let Some(mut complete) = self.complete else {
            return self.operand_lacking(lexeme, at, length).map(|()| Some(at));
        };
        let precedence = lexeme.precedence();
        loop {
            let top = self.last();
            let top_precedence = top.precedence();
            if top_precedence < precedence {
                break;
            }
            if top_precedence == precedence {
                let paired = complete.is_colon;
                if lexeme == Lexeme::Binary(Binary::Pow)
                    || (top == Lexeme::Question && !paired)
                    || (top == Lexeme::Colon && lexeme == Lexeme::Question)
                {
                    break;
                }
            }
            if top == Lexeme::Open && lexeme != Lexeme::Close {
                return Err(self.error("unbalanced open paren".into(), at, length, "", &["UNBALANCED"]));
            }
            if top == Lexeme::Question && !complete.is_colon {
                return Err(self.missing("operator \":\"", at));
            }
            if complete.is_colon && top != Lexeme::Question {
                return Err(self.surprise(at, length));
            }
            if top == Lexeme::Start {
                return Ok(None);
            }
            complete = self.reduce(complete, at, length);
            if top == Lexeme::Open {
                self.complete = Some(complete);
                return Ok(Some(at + length));
            }
        }
        if lexeme == Lexeme::Close {
            return Err(self.error("unbalanced close paren".into(), at, length, "", &["UNBALANCED"]));
        }
        if lexeme == Lexeme::Comma {
            if self.last() != Lexeme::Open || self.before_last() != Lexeme::Function {
                let what = "unexpected \",\" outside function argument list".to_owned();
                return Err(self.error(what, at, length, "", &["SURPRISE"]));
            }
            if let Some(open) = self.pending.last_mut() {
                open.commas += 1;
            }
        }
        if complete.is_colon {
            return Err(self.surprise(at, length));
        }
        self.shift(lexeme, complete, at, length);
        Ok(Some(at + length))
    }

    fn surprise(&self, at: usize, length: usize) -> Failed {
        let what = "unexpected operator \":\" without preceding \"?\"".to_owned();
        self.error(what, at, length, "", &["SURPRISE"])
    }

    /// An operator where an operand belongs: fine only for the parentheses of a function without arguments.
    fn operand_lacking(&mut self, lexeme: Lexeme, at: usize, length: usize) -> Result<(), Failed> {
        let top = self.last();
        if lexeme == Lexeme::Close && top == Lexeme::Open {
            if self.before_last() == Lexeme::Function {
                let at = at as u32;
                self.complete = Some(Operand { start: at, end: at, is_colon: false, is_empty: true });
                return Ok(());
            }
            return Err(self.error(format!("empty subexpression at {MARK}"), at, 0, "", &["EMPTY"]));
        }
        if top.precedence() > lexeme.precedence() {
            match top {
                Lexeme::Open => {
                    return Err(self.error("unbalanced open paren".into(), at, length, "", &["UNBALANCED"]));
                }
                Lexeme::Comma => return Err(self.missing("function argument", at)),
                _ => {}
            }
        } else if lexeme == Lexeme::End && top == Lexeme::Start {
            return Err(self.error("empty expression".into(), at, length, "", &["EMPTY"]));
        } else if lexeme == Lexeme::Close {
            return Err(self.error("unbalanced close paren".into(), at, length, "", &["UNBALANCED"]));
        } else if lexeme == Lexeme::Comma && top == Lexeme::Open && self.before_last() == Lexeme::Function {
            return Err(self.error(format!("missing function argument at {MARK}"), at, 0, "", &["UNBALANCED"]));
        }
        Err(self.missing("operand", at))
    }

    /// Put an operator on hold until its right operand is there.
    fn shift(&mut self, lexeme: Lexeme, left: Operand, at: usize, length: usize) {
        let operator = (at as u32, (at + length) as u32);
        let jump = self.ops.len();
        match lexeme {
            Lexeme::And => self.emit(Op::And(0), left.start, left.end, operator),
            Lexeme::Or => self.emit(Op::Or(0), left.start, left.end, operator),
            Lexeme::Question => self.emit(Op::Else(0), left.start, left.end, operator),
            Lexeme::Colon => {
                self.emit(Op::Jump(0), left.start, left.end, operator);
                let next = self.ops.len() as u32;
                if let Some(question) = self.pending.last()
                    && question.lexeme == Lexeme::Question
                    && let Some(op) = self.ops.get_mut(question.jump)
                {
                    *op = Op::Else(next);
                }
            }
            _ => {}
        }
        self.pending.push(Pending { lexeme, start: left.start, operator, jump, commas: 0 });
        self.complete = None;
    }

    /// Give the last pending operator its right operand. `at`, `length`: what is being looked at.
    fn reduce(&mut self, right: Operand, at: usize, length: usize) -> Operand {
        let Some(pending) = self.pending.pop() else { return right };
        let Pending { lexeme, start, operator, jump, .. } = pending;
        let mut done = Operand { start, end: right.end, is_colon: false, is_empty: false };
        let next = self.ops.len() as u32;
        match lexeme {
            Lexeme::Unary(op) => self.emit(Op::Unary(op), start, right.end, operator),
            Lexeme::Binary(op) => self.emit(Op::Binary(op), start, right.end, operator),
            Lexeme::And | Lexeme::Or => {
                self.emit(Op::Truth, right.start, right.end, operator);
                if let Some(op) = self.ops.get_mut(jump) {
                    *op = if lexeme == Lexeme::And { Op::And(next + 1) } else { Op::Or(next + 1) };
                }
            }
            Lexeme::Colon => {
                if let Some(op) = self.ops.get_mut(jump) {
                    *op = Op::Jump(next);
                }
                done.is_colon = true;
            }
            Lexeme::Open => {
                self.open -= 1;
                done.end = (at + length) as u32;
                let args = if right.is_empty { 0 } else { pending.commas + 1 };
                if let Some(function) = self.pending.last_mut()
                    && function.lexeme == Lexeme::Function
                {
                    function.commas = args;
                }
            }
            Lexeme::Function => {
                let name = self.names.pop().unwrap_or_default();
                let known = func::known(name);
                let function =
                    Function { name: name.into(), args: pending.commas, known, found: Cell::new(Found::default()) };
                self.emit(Op::Function(Rc::new(function)), start, right.end, operator);
            }
            // A comma only separates; a question mark has made its jump already.
            _ => {}
        }
        done
    }
}

/// A number as it is written: `0x10` stays `0x10` when compared as a string.
fn number_value(text: &str) -> Value {
    let value = Value::literal(text.to_owned(), None);
    match number::prefix(text) {
        Some((_, number @ (Number::Int(_) | Number::Double(_) | Number::Big(_)))) if value.as_str() != text => {
            Value::with_number(text.to_owned(), number)
        }
        _ => value,
    }
}

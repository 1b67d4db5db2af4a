//! `expr $a*$b`, not braced: the values become part of the text of the expression, which Tcl parses anew each time.
//!
//! If every value is a number between operators, the expression is compiled once, with operands in these places. In
//! all other cases the text is put together and parsed.

use std::rc::Rc;

use super::super::ast::{Command, Part, Script, Unit, Word, WordKind};
use super::super::command::Place;
use super::super::error::Exception;
use super::super::inline::Expression;
use super::super::interp::Interp;
use super::super::number::is_space;
use super::super::value::{Rep, Value};
use super::{Expr, compile as compile_value, parse};

/// Marks a place where an operand is handed in.
pub(super) const SLOT: u8 = 1;

/// The words of an `expr` as an expression with places for operands.
#[derive(Debug)]
pub(crate) struct Template {
    expr: Option<Expr>,
}

/// The parts of a word.
enum Piece<'a> {
    Text(&'a str),
    Operand,
    Word(&'a WordKind),
}

fn pieces(words: &[Word]) -> impl Iterator<Item = Piece<'_>> {
    words.iter().enumerate().flat_map(|(i, word)| {
        let blank = (i > 0).then_some(Piece::Text(" "));
        let parts: Vec<Piece<'_>> = match &word.kind {
            WordKind::Parts(parts) => {
                parts.iter().map(|p| if let Part::Text(t) = p { Piece::Text(t) } else { Piece::Operand }).collect()
            }
            kind => vec![Piece::Word(kind)],
        };
        blank.into_iter().chain(parts)
    })
}

impl Template {
    /// The template of the words after `expr`; none where they are to be handled in the general way.
    fn new(words: &[Word]) -> Option<Template> {
        if words.is_empty() || words.iter().any(|w| w.expand) {
            return None;
        }
        if let [Word { kind: WordKind::Literal(_) | WordKind::Var(_) | WordKind::Script(_), .. }] = words {
            return None;
        }
        let mut text = String::new();
        for piece in pieces(words) {
            match piece {
                Piece::Text(t) => text.push_str(t),
                Piece::Word(WordKind::Literal(v)) => v.write_to(&mut text),
                Piece::Word(_) | Piece::Operand => text.push(SLOT as char),
            }
        }
        Some(Template { expr: compile(&text) })
    }
}

fn compile(text: &str) -> Option<Expr> {
    if text.contains(['"', '{', '[', '$', '\\']) {
        return None;
    }
    let bytes = text.as_bytes();
    let apart = |b: Option<&u8>, allowed: &[u8]| b.is_none_or(|b| allowed.contains(b));
    for (at, _) in bytes.iter().enumerate().filter(|(_, b)| **b == SLOT) {
        let before = at.checked_sub(1).and_then(|i| bytes.get(i));
        if !apart(before, b" \t\n(+-*/%<>=!&|^~?:,") || !apart(bytes.get(at + 1), b" \t\n)+-*/%<>=!&|^?:,") {
            return None;
        }
    }
    let unit = Rc::new(Unit { text: text.into(), origin: None });
    parse::Parser::template(&unit).parse().ok()
}

/// Returns true if a value is a number and nothing else, blanks included.
fn is_number(value: &Value) -> bool {
    match &value.0 {
        Rep::Int(_) => true,
        Rep::Double(d) => d.get().is_finite(),
        Rep::Str(_) => {
            let text = value.as_str();
            let bytes = text.as_bytes();
            matches!(bytes.first(), Some(b'0'..=b'9' | b'.' | b'-'))
                && !bytes.last().is_some_and(|b| is_space(*b))
                && value.number().is_some_and(|n| n.to_f64().is_finite())
        }
        _ => false,
    }
}

/// A sign in the text would be an operator, after which the number has Tcl's own spelling.
fn negate(value: &mut Value) {
    if let Rep::Str(_) = value.0
        && value.as_str().starts_with('-')
        && let Some(number) = value.number()
    {
        *value = Value::from(number);
    }
}

impl<H> Interp<H> {
    /// An `expr` whose words are not put together, as far as they can be compiled.
    #[inline(never)]
    pub(crate) fn inline_expr(
        &mut self,
        script: &Script,
        command: &Command,
        expression: &Expression,
    ) -> Result<Value, Exception> {
        let words = command.words.get(1..).unwrap_or_default();
        if let [Word { kind: WordKind::Literal(text), .. }] = words {
            let result = match expression.braced.get() {
                Some(expr) => self.result_of(expr, &[]),
                None => self.first_braced(text, expression),
            };
            return result.map_err(|e| self.inline_failed(e, script, command));
        }
        let Some(template) = expression.template.get_or_init(|| Template::new(words)) else {
            return self.call_command(script, command);
        };
        let mut operands = self.core.take_words();
        let result = self.expr_template(template, script, words, &mut operands);
        self.core.give_words(operands);
        result.map_err(|e| self.inline_failed(e, script, command))
    }

    #[cold]
    fn first_braced(&mut self, text: &Value, expression: &Expression) -> Result<Value, Exception> {
        if let Rep::Str(_) = text.0 {
            // The text may be a number that is asked for again: its form is kept here as well.
            let expr = compile_value(text)?;
            return self.result_of(expression.braced.get_or_init(|| expr), &[]);
        }
        self.expr(text)
    }

    fn expr_template(
        &mut self,
        template: &Template,
        script: &Script,
        words: &[Word],
        operands: &mut Vec<Value>,
    ) -> Result<Value, Exception> {
        for word in words {
            match &word.kind {
                WordKind::Literal(_) => {}
                WordKind::Parts(parts) => {
                    for part in parts {
                        match part {
                            Part::Text(_) => {}
                            Part::Var(var) => operands.push(self.variable(&script.unit, var)?),
                            Part::Script(inner) => operands.push(self.run(inner)?),
                        }
                    }
                }
                kind => operands.push(self.word(script, kind)?),
            }
        }
        if let Some(expr) = &template.expr
            && self.core.precision == 0
            && operands.iter().all(is_number)
        {
            operands.iter_mut().for_each(negate);
            return self.result_of(expr, operands);
        }
        let mut text = String::new();
        let mut next = operands.iter();
        for piece in pieces(words) {
            match piece {
                Piece::Text(t) => text.push_str(t),
                Piece::Word(WordKind::Literal(v)) => v.write_to(&mut text),
                Piece::Word(_) | Piece::Operand => {
                    if let Some(value) = next.next() {
                        value.write_to(&mut text);
                    }
                }
            }
        }
        self.expr_text(&text)
    }

    /// Complete an error of a command without a call: it points at the first word after the name, if at nothing else.
    pub(crate) fn inline_failed(&mut self, e: Exception, script: &Script, command: &Command) -> Exception {
        let place = Place { script, command, map: None };
        let word = command.words.len() - 1;
        self.control_failed(e.at(place.word(word.min(1)), ""), script, command)
    }
}

//! Expressions: compiled to a row of operations on a stack, so that neither long nor deep ones recurse.

pub(crate) mod arith;
mod eval;
pub(crate) mod func;
mod lexeme;
mod num;
mod numeric;
mod parse;
mod template;

use std::cell::{Cell, OnceCell};
use std::rc::Rc;

use super::ast::{Found, ParseError, Part, Script, Unit, VarRef};
use super::error::Exception;
use super::text::Cache;
use super::value::Value;
use crate::diagnostic::Span;
pub(crate) use num::Num;
pub(crate) use template::Template;

/// A compiled expression.
#[derive(Debug)]
pub(crate) struct Expr {
    unit: Rc<Unit>,
    ops: Vec<Op>,
    /// For each operation where its text is.
    places: Vec<Range>,
    /// True until it is evaluated.
    is_new: Cell<bool>,
    /// Its form without values in between, if it is one of numbers.
    tree: OnceCell<Option<numeric::Node>>,
}

impl Expr {
    fn new(unit: Rc<Unit>, ops: Vec<Op>, places: Vec<Range>) -> Self {
        Expr { unit, ops, places, is_new: Cell::new(true), tree: OnceCell::new() }
    }
}

/// Bytes of the text.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Range {
    start: u32,
    end: u32,
    /// For a binary operation: its operator, which tells the operands apart.
    operator: (u32, u32),
}

/// One operation.
#[derive(Debug)]
enum Op {
    Push(Value),
    /// The operand with this number, handed in.
    Slot(usize),
    Var(VarRef),
    Script(Rc<Script>),
    Parts(Box<[Part]>),
    Unary(Unary),
    Binary(Binary),
    Function(Rc<Function>),
    /// If the top is false, replace it by 0 and go on there.
    And(u32),
    /// If the top is true, replace it by 1 and go on there.
    Or(u32),
    /// The top as 0 or 1.
    Truth,
    /// Take the top off; go on there if it is false.
    Else(u32),
    /// Go on there.
    Jump(u32),
}

/// A call of a math function.
#[derive(Debug)]
struct Function {
    name: Box<str>,
    args: usize,
    /// Tcl's own function, where it is one of numbers.
    known: Option<func::Known>,
    found: Cell<Found>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Unary {
    Plus,
    Minus,
    BitNot,
    Not,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Binary {
    Add,
    Sub,
    Mul,
    Div,
    Mod,
    Pow,
    Shl,
    Shr,
    BitAnd,
    BitXor,
    BitOr,
    Lt,
    Gt,
    Le,
    Ge,
    Eq,
    Ne,
    StrEq,
    StrNe,
    In,
    NotIn,
}

impl Binary {
    pub(crate) fn symbol(self) -> &'static str {
        match self {
            Binary::Add => "+",
            Binary::Sub => "-",
            Binary::Mul => "*",
            Binary::Div => "/",
            Binary::Mod => "%",
            Binary::Pow => "**",
            Binary::Shl => "<<",
            Binary::Shr => ">>",
            Binary::BitAnd => "&",
            Binary::BitXor => "^",
            Binary::BitOr => "|",
            Binary::Lt => "<",
            Binary::Gt => ">",
            Binary::Le => "<=",
            Binary::Ge => ">=",
            Binary::Eq => "==",
            Binary::Ne => "!=",
            Binary::StrEq => "eq",
            Binary::StrNe => "ne",
            Binary::In => "in",
            Binary::NotIn => "ni",
        }
    }
}

/// Error in an expression.
#[derive(Debug)]
pub(crate) struct ExprError {
    /// Tcl's message with all its lines, and where it points.
    error: ParseError,
    /// The rest of `$errorCode` after `TCL PARSE EXPR`.
    code: Vec<&'static str>,
}

/// Compile a value, or take its compiled form from last time.
pub(crate) fn compile(value: &Value) -> Result<Rc<Expr>, Exception> {
    let obj = value.str_obj();
    if let Some(expr) = obj.cached(|c| if let Cache::Expr(e) = c { Some(e.clone()) } else { None }) {
        return Ok(expr);
    }
    let unit = Rc::new(Unit { text: obj.stretch(), origin: value.origin().cloned() });
    let expr = Rc::new(compile_unit(unit)?);
    obj.set_cache(Cache::Expr(expr.clone()));
    Ok(expr)
}

/// Compile a text that is used once.
pub(crate) fn compile_text(text: &str) -> Result<Expr, Exception> {
    compile_unit(Rc::new(Unit { text: text.into(), origin: None }))
}

fn compile_unit(unit: Rc<Unit>) -> Result<Expr, Exception> {
    parse::Parser::new(&unit).parse().map_err(|e| {
        let ExprError { error, code } = *e;
        let span: Option<Span> = unit.span(error.start, error.end);
        let words = if code.is_empty() { vec!["NONE"] } else { [vec!["TCL", "PARSE", "EXPR"], code].concat() };
        let shown: String = unit.text.chars().take(50).collect();
        let dots = if unit.text.chars().count() > 50 { "..." } else { "" };
        Exception::coded(error.message, &words)
            .at(span, error.label)
            .trace(|_| format!("parsing expression \"{shown}{dots}\""))
    })
}

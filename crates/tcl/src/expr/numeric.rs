//! Expressions of numbers alone, evaluated without values in between.
//!
//! Such an expression reads variables and list elements and changes nothing. Where anything comes up that is no small
//! number, and where there is an error, there is no result, and the expression is evaluated again in the general way.

use std::rc::Rc;

use super::super::ast::{Command, Index, Part, Script, VarRef, WordKind};
use super::super::core::Core;
use super::super::inline::Inline;
use super::super::value::{Rep, Value};
use super::super::vars::VarName;
use super::func::Known;
use super::num::{EXACT, Num, binary, unary};
use super::{Binary, Expr, Function, Op, Unary};

/// Operations within operations up to here; deeper expressions are evaluated in the general way.
const MAX_DEPTH: usize = 32;
/// An expression of numbers.
#[derive(Debug)]
pub(super) enum Node {
    Constant(Num),
    /// The operand with this number, handed in.
    Operand(usize),
    Variable(Rc<VarName>),
    /// An element of an array.
    Element(VarRef),
    Unary(Unary, Box<Node>),
    Binary(Binary, Box<(Node, Node)>),
    Function(Rc<Function>, Known, Box<[Node]>),
    And(Box<(Node, Node)>),
    Or(Box<(Node, Node)>),
    Choose(Box<(Node, Node, Node)>),
    /// `[lindex $list place]`
    Item {
        script: Rc<Script>,
        list: Rc<VarName>,
        place: Box<Node>,
    },
    /// `[llength $list]`
    Length {
        script: Rc<Script>,
        list: Rc<VarName>,
    },
    /// `[string length $text]`
    Characters {
        script: Rc<Script>,
        text: Rc<VarName>,
    },
}

/// The tree of some operations; none where they are more than numbers.
pub(super) fn tree(ops: &[Op]) -> Option<Node> {
    let mut builder = Builder { ops, at: 0 };
    builder.build(ops.len(), 0)
}

struct Builder<'a> {
    ops: &'a [Op],
    at: usize,
}

impl Builder<'_> {
    /// The tree of the operations up to `end`.
    fn build(&mut self, end: usize, depth: usize) -> Option<Node> {
        if depth > MAX_DEPTH {
            return None;
        }
        let ops = self.ops;
        let mut stack: Vec<(Node, usize)> = vec![];
        while self.at < end {
            let op = &ops[self.at];
            self.at += 1;
            let (node, below) = match op {
                Op::Push(value) => (Node::Constant(Num::of(value)?), 0),
                Op::Slot(number) => (Node::Operand(*number), 0),
                Op::Var(var) => (variable(var)?, 0),
                Op::Script(script) => query(script)?,
                Op::Unary(Unary::BitNot) | Op::Parts(_) | Op::Truth | Op::Jump(_) => return None,
                Op::Unary(op) => {
                    let (operand, below) = stack.pop()?;
                    (Node::Unary(*op, Box::new(operand)), below + 1)
                }
                Op::Binary(op) => {
                    let (right, below_right) = stack.pop()?;
                    let (left, below_left) = stack.pop()?;
                    (Node::Binary(*op, Box::new((left, right))), below_left.max(below_right) + 1)
                }
                Op::Function(function) => {
                    let known = function.known?;
                    let from = stack.len().checked_sub(function.args)?;
                    let (args, depths): (Vec<_>, Vec<_>) = stack.split_off(from).into_iter().unzip();
                    let below = depths.into_iter().max().unwrap_or(0);
                    (Node::Function(function.clone(), known, args.into()), below + 1)
                }
                Op::And(to) | Op::Or(to) => {
                    let (left, below) = stack.pop()?;
                    let to = *to as usize;
                    let right = self.build(to.checked_sub(1)?, depth + below + 1)?;
                    self.at = to;
                    let pair = Box::new((left, right));
                    (if matches!(op, Op::And(_)) { Node::And(pair) } else { Node::Or(pair) }, below + 1)
                }
                Op::Else(other) => {
                    let (test, below) = stack.pop()?;
                    let other = *other as usize;
                    let yes = self.build(other.checked_sub(1)?, depth + below + 1)?;
                    let Op::Jump(to) = ops.get(other.checked_sub(1)?)? else { return None };
                    self.at = other;
                    let no = self.build(*to as usize, depth + below + 1)?;
                    (Node::Choose(Box::new((test, yes, no))), below + 1)
                }
            };
            if below + depth > MAX_DEPTH {
                return None;
            }
            stack.push((node, below));
        }
        match stack.pop() {
            Some((node, _)) if stack.is_empty() => Some(node),
            _ => None,
        }
    }
}

fn variable(var: &VarRef) -> Option<Node> {
    match &var.index {
        None => Some(Node::Variable(var.name.clone())),
        Some(Index::Text(_)) => Some(Node::Element(var.clone())),
        Some(Index::Parts(parts)) => match &**parts {
            [Part::Var(VarRef { index: None, .. })] => Some(Node::Element(var.clone())),
            _ => None,
        },
    }
}

/// A command in brackets that looks at a list or text.
fn query(script: &Rc<Script>) -> Option<(Node, usize)> {
    let [Command { words, inline, .. }] = &script.commands[..] else { return None };
    let plain = |i: usize| match &words.get(i)?.kind {
        WordKind::Var(VarRef { name, index: None, .. }) => Some(name.clone()),
        _ => None,
    };
    let script = script.clone();
    match inline {
        Inline::Item => {
            let place = match &words.get(2)?.kind {
                WordKind::Literal(value) => Node::Constant(Num::of(value)?),
                WordKind::Var(var) => variable(var)?,
                _ => return None,
            };
            Some((Node::Item { list: plain(1)?, place: Box::new(place), script }, 1))
        }
        Inline::Length => Some((Node::Length { list: plain(1)?, script }, 0)),
        Inline::Characters => Some((Node::Characters { text: plain(2)?, script }, 0)),
        _ => None,
    }
}

impl Expr {
    /// The expression as one of numbers, if it is one. The first evaluation is always a general one: many are the only one.
    #[inline]
    fn numbers(&self) -> Option<&Node> {
        if self.is_new.get() {
            self.is_new.set(false);
            return None;
        }
        self.tree.get_or_init(|| tree(&self.ops)).as_ref()
    }
}

impl Core {
    /// The value of an expression of numbers; none where it must be evaluated in the general way.
    #[inline]
    pub(crate) fn number_of(&self, expr: &Expr, operands: &[Value]) -> Option<Num> {
        if self.precision > 0 {
            return None;
        }
        self.number(expr.numbers()?, operands)
    }

    #[inline]
    fn leaf(&self, node: &Node, operands: &[Value]) -> Option<Num> {
        match node {
            Node::Constant(n) => Some(*n),
            Node::Variable(name) => self.number_in(name),
            node => self.number(node, operands),
        }
    }

    /// The frequent nodes. This function is small so that it has few registers to save.
    fn number(&self, node: &Node, operands: &[Value]) -> Option<Num> {
        match node {
            Node::Constant(n) => Some(*n),
            Node::Variable(name) => self.number_in(name),
            Node::Binary(op, pair) => {
                let left = self.leaf(&pair.0, operands)?;
                let right = self.leaf(&pair.1, operands)?;
                binary(*op, left, right)
            }
            node => self.rare(node, operands),
        }
    }

    #[inline(never)]
    fn rare(&self, node: &Node, operands: &[Value]) -> Option<Num> {
        match node {
            Node::Constant(_) | Node::Variable(_) | Node::Binary(..) => self.number(node, operands),
            Node::Operand(i) => Num::of(operands.get(*i)?),
            Node::Element(var) => self.element(var),
            Node::Unary(op, operand) => unary(*op, self.leaf(operand, operands)?),
            Node::Function(function, known, args) => {
                if !self.is_of_the_language(function) {
                    return None;
                }
                self.function(*known, args, operands)
            }
            Node::And(pair) => {
                let both = self.number(&pair.0, operands)?.is_true() && self.number(&pair.1, operands)?.is_true();
                Some(Num::truth(both))
            }
            Node::Or(pair) => {
                let any = self.number(&pair.0, operands)?.is_true() || self.number(&pair.1, operands)?.is_true();
                Some(Num::truth(any))
            }
            Node::Choose(three) => {
                let (test, yes, no) = &**three;
                self.number(if self.number(test, operands)?.is_true() { yes } else { no }, operands)
            }
            Node::Item { script, list, place } => {
                self.if_inlined(script)?;
                let Num::Int(at) = self.number(place, operands)? else { return None };
                self.look_at_list(list, |items| Num::of(items.get(usize::try_from(at).ok()?)?))
            }
            Node::Length { script, list } => {
                self.if_inlined(script)?;
                self.look_at_list(list, |items| Some(Num::Int(items.len() as i64)))
            }
            Node::Characters { script, text } => {
                self.if_inlined(script)?;
                self.with_scalar(text, |text| Some(Num::Int(text.char_count() as i64)))
            }
        }
    }

    /// The number that an element of an array is.
    fn element(&self, var: &VarRef) -> Option<Num> {
        let value = match var.index.as_ref()? {
            Index::Text(index) => self.peek(&var.name, Some(index)),
            Index::Parts(parts) => match &**parts {
                [Part::Var(index)] => self.peek(&var.name, Some(&self.scalar(&index.name)?.as_str())),
                _ => return None,
            },
        };
        Num::of(&value.ok()?)
    }

    /// The number that a variable holds.
    #[inline]
    fn number_in(&self, name: &VarName) -> Option<Num> {
        self.with_scalar(name, Num::of)
    }

    fn look_at_list<R>(&self, name: &VarName, look: impl FnOnce(&[Value]) -> Option<R>) -> Option<R> {
        self.with_scalar(name, |value| match &value.0 {
            Rep::List(items) => look(items),
            Rep::Str(_) => look(&value.to_list().ok()?),
            _ => None,
        })
    }

    /// Something if the only command of a script means the one of the language.
    #[inline]
    fn if_inlined(&self, script: &Script) -> Option<()> {
        let command = script.commands.first()?;
        self.is_inlined(script, command).then_some(())
    }

    #[inline]
    fn function(&self, known: Known, args: &[Node], operands: &[Value]) -> Option<Num> {
        match (known, args) {
            (Known::Real(f), [x]) => Num::double(f(self.leaf(x, operands)?.to_f64())),
            (Known::Root, [x]) => Num::double(self.number(x, operands)?.to_f64().sqrt()),
            (Known::Real2(f), [x, y]) => {
                Num::double(f(self.number(x, operands)?.to_f64(), self.number(y, operands)?.to_f64()))
            }
            (Known::Double, [x]) => Num::double(self.number(x, operands)?.to_f64()),
            (Known::Abs, [x]) => match self.number(x, operands)? {
                Num::Int(i) => i.checked_abs().map(Num::Int),
                Num::Double(d) => Num::double(d.get().abs()),
            },
            (Known::Int, [x]) => match self.number(x, operands)? {
                n @ Num::Int(_) => Some(n),
                Num::Double(d) => (d.get().abs() < EXACT as f64).then_some(Num::Int(d.get() as i64)),
            },
            (Known::Round, [x]) => match self.number(x, operands)? {
                n @ Num::Int(_) => Some(n),
                Num::Double(d) => (d.get().abs() < EXACT as f64).then_some(Num::Int(d.get().round() as i64)),
            },
            (Known::Max | Known::Min, [first, more @ ..]) => {
                let other = if matches!(known, Known::Max) { Binary::Gt } else { Binary::Lt };
                let mut best = self.number(first, operands)?;
                for arg in more {
                    let n = self.number(arg, operands)?;
                    if binary(other, n, best)?.is_true() {
                        best = n;
                    }
                }
                Some(best)
            }
            _ => None,
        }
    }
}

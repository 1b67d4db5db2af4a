//! Numbers that fit a register, and operations on them.

use super::super::number::{Bits, Number};
use super::super::value::{Rep, Value};
use super::{Binary, Unary};

/// Integers up to here are doubles without a loss.
pub(super) const EXACT: u64 = 1 << 53;

/// A number that fits a register.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Num {
    Int(i64),
    Double(Bits),
}

impl Num {
    #[inline]
    pub(super) fn double(d: f64) -> Option<Num> {
        if d.is_nan() { None } else { Some(Num::Double(d.into())) }
    }

    pub(super) fn truth(truth: bool) -> Num {
        Num::Int(i64::from(truth))
    }

    #[inline]
    pub(crate) fn is_true(self) -> bool {
        match self {
            Num::Int(i) => i != 0,
            Num::Double(d) => d.get() != 0.0,
        }
    }

    #[inline]
    pub(super) fn to_f64(self) -> f64 {
        match self {
            Num::Int(i) => i as f64,
            Num::Double(d) => d.get(),
        }
    }

    /// The number that a value is; none for other values, integers of many digits and what is not a number.
    #[inline]
    pub(crate) fn of(value: &Value) -> Option<Num> {
        match &value.0 {
            Rep::Int(i) => Some(Num::Int(*i)),
            Rep::Double(d) => Num::double(d.get()),
            _ => Num::read(value),
        }
    }

    /// The number that a text is.
    #[inline(never)]
    fn read(value: &Value) -> Option<Num> {
        let Rep::Str(text) = &value.0 else { return None };
        match text.number()? {
            Number::Int(i) => Some(Num::Int(i)),
            Number::Double(d) => Num::double(d),
            Number::Big(_) => None,
        }
    }
}

impl From<Num> for Value {
    #[inline]
    fn from(n: Num) -> Value {
        match n {
            Num::Int(i) => Value(Rep::Int(i)),
            Num::Double(d) => Value(Rep::Double(d)),
        }
    }
}

/// The result of an operation; none where it takes more than small numbers, or is an error.
#[inline]
pub(super) fn unary(op: Unary, n: Num) -> Option<Num> {
    match (op, n) {
        (Unary::Plus, n) => Some(n),
        (Unary::Minus, Num::Int(i)) => i.checked_neg().map(Num::Int),
        (Unary::Minus, Num::Double(d)) => Num::double(-d.get()),
        (Unary::Not, n) => Some(Num::truth(!n.is_true())),
        (Unary::BitNot, _) => None,
    }
}

/// As [`unary`], for two operands.
#[inline]
pub(super) fn binary(op: Binary, left: Num, right: Num) -> Option<Num> {
    match (left, right) {
        (Num::Double(x), Num::Double(y)) => doubles(op, x.get(), y.get()),
        (Num::Int(x), Num::Int(y)) => ints(op, x, y),
        (Num::Double(x), Num::Int(y)) => (y.unsigned_abs() <= EXACT).then(|| doubles(op, x.get(), y as f64))?,
        (Num::Int(x), Num::Double(y)) => (x.unsigned_abs() <= EXACT).then(|| doubles(op, x as f64, y.get()))?,
    }
}

#[inline]
fn doubles(op: Binary, x: f64, y: f64) -> Option<Num> {
    match op {
        Binary::Add => Num::double(x + y),
        Binary::Sub => Num::double(x - y),
        Binary::Mul => Num::double(x * y),
        Binary::Div => Num::double(x / y),
        Binary::Pow if x != 0.0 || y >= 0.0 => Num::double(x.powf(y)),
        Binary::Lt => Some(Num::truth(x < y)),
        Binary::Gt => Some(Num::truth(x > y)),
        Binary::Le => Some(Num::truth(x <= y)),
        Binary::Ge => Some(Num::truth(x >= y)),
        Binary::Eq => Some(Num::truth(x == y)),
        Binary::Ne => Some(Num::truth(x != y)),
        _ => None,
    }
}

#[inline]
fn ints(op: Binary, x: i64, y: i64) -> Option<Num> {
    Some(match op {
        Binary::Add => Num::Int(x.checked_add(y)?),
        Binary::Sub => Num::Int(x.checked_sub(y)?),
        Binary::Mul => Num::Int(x.checked_mul(y)?),
        Binary::Div if y > 0 => Num::Int(x.div_euclid(y)),
        Binary::Mod if y > 0 => Num::Int(x.rem_euclid(y)),
        Binary::Pow => Num::Int(x.checked_pow(u32::try_from(y).ok()?)?),
        Binary::Lt => Num::truth(x < y),
        Binary::Gt => Num::truth(x > y),
        Binary::Le => Num::truth(x <= y),
        Binary::Ge => Num::truth(x >= y),
        Binary::Eq => Num::truth(x == y),
        Binary::Ne => Num::truth(x != y),
        Binary::BitAnd => Num::Int(x & y),
        Binary::BitOr => Num::Int(x | y),
        Binary::BitXor => Num::Int(x ^ y),
        _ => return None,
    })
}

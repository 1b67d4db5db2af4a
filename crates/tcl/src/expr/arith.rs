//! Operators on numbers of any kind and on strings.

use std::cmp::Ordering;

use num_bigint::{BigInt, Sign};
use num_integer::Integer as _;
use num_traits::{Signed as _, ToPrimitive as _, Zero as _};

use super::super::error::Exception;
use super::super::lookalike::lookalike;
use super::super::number::{Number, looks_like_bad_octal};
use super::super::value::{Rep, Value};
use super::num::{self, Num};
use super::{Binary, Unary};

/// Shifting further than this would make integers that take minutes to write.
const MAX_SHIFT: u64 = 1 << 27;

/// Operand at fault.
#[derive(Clone, Copy)]
pub(crate) enum Side {
    Left,
    Right,
}

/// Error of an operation.
pub(crate) struct Fault {
    pub(crate) side: Side,
    pub(crate) error: Exception,
}

fn right(error: Exception) -> Fault {
    Fault { side: Side::Right, error }
}

pub(crate) fn domain_error() -> Exception {
    let text = "domain error: argument not in valid range";
    Exception::coded(text, &["ARITH", "DOMAIN", text])
}

fn divide_by_zero() -> Fault {
    right(Exception::coded("divide by zero", &["ARITH", "DIVZERO", "divide by zero"]))
}

/// Tcl's error for an operand that an operator cannot take.
fn unfit(value: &Value, symbol: &str) -> Exception {
    let what = match value.number() {
        Some(Number::Double(d)) if d.is_nan() => "non-numeric floating-point value",
        Some(Number::Double(_)) => "floating-point value",
        Some(_) => "(big) integer",
        None if value.is_empty() => "empty string",
        None if looks_like_bad_octal(&value.as_str()) => "invalid octal number",
        None => "non-numeric string",
    };
    let e = Exception::coded(format!("can't use {what} as operand of \"{symbol}\""), &["ARITH", "DOMAIN", what]);
    lookalike(&value.as_str()).into_iter().fold(e, Exception::help)
}

fn numeric(value: &Value, symbol: &str) -> Result<Number, Exception> {
    match value.number() {
        Some(Number::Double(d)) if d.is_nan() => Err(unfit(value, symbol)),
        Some(n) => Ok(n),
        None => Err(unfit(value, symbol)),
    }
}

fn integral(value: &Value, symbol: &str) -> Result<Number, Exception> {
    match value.number() {
        Some(n @ (Number::Int(_) | Number::Big(_))) => Ok(n),
        _ => Err(unfit(value, symbol)),
    }
}

/// An integer, to compute with in any size.
pub(crate) fn big(n: &Number) -> BigInt {
    match n {
        Number::Int(i) => BigInt::from(*i),
        Number::Big(b) => (**b).clone(),
        Number::Double(_) => BigInt::zero(),
    }
}

pub(crate) fn unary(op: Unary, value: &Value) -> Result<Value, Exception> {
    match (op, &value.0) {
        (Unary::Minus, Rep::Double(d)) if !d.get().is_nan() => return Ok(Value::from(-d.get())),
        (Unary::Not, Rep::Int(i)) => return Ok(Value::from(*i == 0)),
        _ => {}
    }
    match op {
        Unary::Not => match value.truth() {
            Some(b) => Ok(Value::from(!b)),
            None => Err(unfit(value, "!")),
        },
        Unary::BitNot => Ok(match integral(value, "~")? {
            Number::Int(i) => Value::from(!i),
            n => Value::from(-big(&n) - 1),
        }),
        Unary::Plus => Ok(numeric(value, "+")?.into()),
        Unary::Minus => Ok(match numeric(value, "-")? {
            Number::Double(d) => Value::from(-d),
            Number::Int(i) => match i.checked_neg() {
                Some(i) => Value::from(i),
                None => Value::from(-BigInt::from(i)),
            },
            n => Value::from(-big(&n)),
        }),
    }
}

#[inline]
pub(crate) fn binary(op: Binary, a: &Value, b: &Value) -> Result<Value, Fault> {
    if let (Rep::Int(_) | Rep::Double(_), Rep::Int(_) | Rep::Double(_)) = (&a.0, &b.0)
        && let (Some(x), Some(y)) = (Num::of(a), Num::of(b))
        && let Some(n) = num::binary(op, x, y)
    {
        return Ok(n.into());
    }
    general(op, a, b)
}

fn general(op: Binary, a: &Value, b: &Value) -> Result<Value, Fault> {
    let symbol = op.symbol();
    let left = |error| Fault { side: Side::Left, error };
    match op {
        Binary::StrEq => Ok(Value::from(a == b)),
        Binary::StrNe => Ok(Value::from(a != b)),
        Binary::In | Binary::NotIn => {
            let list = b.to_list().map_err(right)?;
            Ok(Value::from(list.contains(a) == (op == Binary::In)))
        }
        Binary::Lt | Binary::Gt | Binary::Le | Binary::Ge | Binary::Eq | Binary::Ne => {
            Ok(Value::from(holds(op, compare(a, b))))
        }
        Binary::Mod | Binary::Shl | Binary::Shr | Binary::BitAnd | Binary::BitOr | Binary::BitXor => {
            let x = integral(a, symbol).map_err(left)?;
            let y = integral(b, symbol).map_err(right)?;
            integers(op, &x, &y)
        }
        Binary::Add | Binary::Sub | Binary::Mul | Binary::Div | Binary::Pow => {
            let x = numeric(a, symbol).map_err(left)?;
            let y = numeric(b, symbol).map_err(right)?;
            if let (Number::Int(_) | Number::Big(_), Number::Int(_) | Number::Big(_)) = (&x, &y) {
                return integers(op, &x, &y);
            }
            let (x, y) = (x.to_f64(), y.to_f64());
            let result = match op {
                Binary::Add => x + y,
                Binary::Sub => x - y,
                Binary::Mul => x * y,
                Binary::Div => x / y,
                _ if x == 0.0 && y < 0.0 => return Err(zero_to_negative()),
                _ => x.powf(y),
            };
            if result.is_nan() { Err(right(domain_error())) } else { Ok(Value::from(result)) }
        }
    }
}

/// The order of two values: as numbers if both are, else as strings. `None` if one is not a number at all.
pub(crate) fn compare(a: &Value, b: &Value) -> Option<Ordering> {
    match (a.number(), b.number()) {
        (Some(x), Some(y)) => compare_numbers(&x, &y),
        _ => Some(a.as_str().cmp(&b.as_str())),
    }
}

/// The order of two numbers, exact between integers and doubles too.
pub(crate) fn compare_numbers(x: &Number, y: &Number) -> Option<Ordering> {
    match (x, y) {
        (Number::Int(x), Number::Int(y)) => Some(x.cmp(y)),
        (Number::Double(x), Number::Double(y)) => x.partial_cmp(y),
        (Number::Double(_), _) => compare_numbers(y, x).map(Ordering::reverse),
        (_, Number::Double(d)) if d.is_nan() => None,
        (_, Number::Double(d)) if d.is_infinite() => Some(if *d > 0.0 { Ordering::Less } else { Ordering::Greater }),
        (_, Number::Double(d)) => {
            let whole = num_traits::FromPrimitive::from_f64(d.trunc()).unwrap_or_else(BigInt::zero);
            Some(big(x).cmp(&whole).then_with(|| 0.0.partial_cmp(&d.fract()).unwrap_or(Ordering::Equal)))
        }
        _ => Some(big(x).cmp(&big(y))),
    }
}

fn holds(op: Binary, order: Option<Ordering>) -> bool {
    match (op, order) {
        (Binary::Ne, order) => order != Some(Ordering::Equal),
        (_, None) => false,
        (Binary::Lt, Some(o)) => o.is_lt(),
        (Binary::Gt, Some(o)) => o.is_gt(),
        (Binary::Le, Some(o)) => o.is_le(),
        (Binary::Ge, Some(o)) => o.is_ge(),
        (_, Some(o)) => o.is_eq(),
    }
}

fn zero_to_negative() -> Fault {
    let text = "exponentiation of zero by negative power";
    right(Exception::coded(text, &["ARITH", "DOMAIN", text]))
}

/// Operations on integers of any size.
fn integers(op: Binary, x: &Number, y: &Number) -> Result<Value, Fault> {
    let (a, b) = (big(x), big(y));
    Ok(Value::from(match op {
        Binary::Add => a + b,
        Binary::Sub => a - b,
        Binary::Mul => a * b,
        Binary::Div | Binary::Mod if b.is_zero() => return Err(divide_by_zero()),
        Binary::Div => a.div_floor(&b),
        Binary::Mod => a.mod_floor(&b),
        Binary::BitAnd => a & b,
        Binary::BitOr => a | b,
        Binary::BitXor => a ^ b,
        Binary::Shl | Binary::Shr if b.is_negative() => return Err(right(Exception::error("negative shift argument"))),
        Binary::Shl if a.is_zero() => a,
        Binary::Shl => match b.to_u64() {
            Some(by) if by < MAX_SHIFT => a << by,
            _ => return Err(right(Exception::error("integer value too large to represent"))),
        },
        Binary::Shr => match b.to_u64() {
            Some(by) if by <= a.bits() => a >> by,
            _ if a.is_negative() => BigInt::from(-1),
            _ => BigInt::zero(),
        },
        _ => return power(a, b).map(Value::from),
    }))
}

fn power(base: BigInt, exponent: BigInt) -> Result<BigInt, Fault> {
    let unit = base.to_i64().filter(|b| b.abs() <= 1);
    let even = exponent.is_even();
    match (unit, exponent.sign()) {
        (_, Sign::NoSign) => Ok(BigInt::from(1)),
        (Some(0), Sign::Minus) => Err(zero_to_negative()),
        (Some(0), _) => Ok(BigInt::zero()),
        (Some(1), _) => Ok(BigInt::from(1)),
        (Some(_), _) => Ok(BigInt::from(if even { 1 } else { -1 })),
        (None, Sign::Minus) => Ok(BigInt::zero()),
        (None, _) => match exponent.to_u32() {
            Some(e) if u64::from(e) < 1 << 28 && base.bits().saturating_mul(u64::from(e)) < MAX_SHIFT => {
                Ok(base.pow(e))
            }
            _ => Err(right(Exception::error("exponent too large"))),
        },
    }
}

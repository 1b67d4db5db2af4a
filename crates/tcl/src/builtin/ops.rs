//! The operators of `expr` as commands, `tcl::mathop::+` and so on.

use crate::command::{Call, CoreFn};
use crate::core::Core;
use crate::error::Exception;
use crate::expr::arith;
use crate::expr::{Binary, Unary};
use crate::value::Value;

pub(crate) const COMMANDS: &[(&str, CoreFn)] = &[
    ("::tcl::mathop::+", |core, call| fold(core, call, Binary::Add, 0)),
    ("::tcl::mathop::-", |core, call| less(core, call, Binary::Sub)),
    ("::tcl::mathop::*", |core, call| fold(core, call, Binary::Mul, 1)),
    ("::tcl::mathop::/", |core, call| less(core, call, Binary::Div)),
    ("::tcl::mathop::%", |core, call| two(core, call, Binary::Mod, "integer integer")),
    ("::tcl::mathop::**", power),
    ("::tcl::mathop::<<", |core, call| two(core, call, Binary::Shl, "integer shift")),
    ("::tcl::mathop::>>", |core, call| two(core, call, Binary::Shr, "integer shift")),
    ("::tcl::mathop::&", |core, call| fold(core, call, Binary::BitAnd, -1)),
    ("::tcl::mathop::|", |core, call| fold(core, call, Binary::BitOr, 0)),
    ("::tcl::mathop::^", |core, call| fold(core, call, Binary::BitXor, 0)),
    ("::tcl::mathop::~", |core, call| one(core, call, Unary::BitNot, "integer")),
    ("::tcl::mathop::!", |core, call| one(core, call, Unary::Not, "boolean")),
    ("::tcl::mathop::==", |core, call| chain(core, call, Binary::Eq)),
    ("::tcl::mathop::!=", |core, call| two(core, call, Binary::Ne, "value value")),
    ("::tcl::mathop::<", |core, call| chain(core, call, Binary::Lt)),
    ("::tcl::mathop::<=", |core, call| chain(core, call, Binary::Le)),
    ("::tcl::mathop::>", |core, call| chain(core, call, Binary::Gt)),
    ("::tcl::mathop::>=", |core, call| chain(core, call, Binary::Ge)),
    ("::tcl::mathop::eq", |core, call| chain(core, call, Binary::StrEq)),
    ("::tcl::mathop::ne", |core, call| two(core, call, Binary::StrNe, "value value")),
    ("::tcl::mathop::in", |core, call| two(core, call, Binary::In, "value list")),
    ("::tcl::mathop::ni", |core, call| two(core, call, Binary::NotIn, "value list")),
];

/// Apply an operator; a double comes out with the digits of `tcl_precision`.
fn apply(core: &Core, op: Binary, a: &Value, b: &Value) -> Result<Value, Exception> {
    let value = arith::binary(op, a, b).map_err(|f| f.error)?;
    Ok(match value.0 {
        crate::value::Rep::Double(d) => core.double(d.get()),
        _ => value,
    })
}

fn fold(core: &mut Core, call: &Call<'_>, op: Binary, neutral: i64) -> Result<Value, Exception> {
    let mut result = Value::from(neutral);
    for arg in call.args() {
        result = apply(core, op, &result, arg)?;
    }
    Ok(result)
}

fn less(core: &mut Core, call: &Call<'_>, op: Binary) -> Result<Value, Exception> {
    match call.args() {
        [] => Err(call.usage(1, "value ?value ...?")),
        [one] if op == Binary::Sub => arith::unary(Unary::Minus, one),
        [one] => apply(core, op, &Value::from(1.0), one),
        [first, rest @ ..] => rest.iter().try_fold(first.clone(), |a, b| apply(core, op, &a, b)),
    }
}

fn power(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    let mut args = call.args().iter().rev();
    let last = args.next().cloned().unwrap_or_else(|| Value::from(1i64));
    args.try_fold(last, |right, left| apply(core, Binary::Pow, left, &right))
}

fn two(core: &mut Core, call: &Call<'_>, op: Binary, usage: &str) -> Result<Value, Exception> {
    match call.args() {
        [a, b] => apply(core, op, a, b),
        _ => Err(call.usage(1, usage)),
    }
}

fn one(_: &mut Core, call: &Call<'_>, op: Unary, usage: &str) -> Result<Value, Exception> {
    match call.args() {
        [a] => arith::unary(op, a),
        _ => Err(call.usage(1, usage)),
    }
}

/// Returns true if a relation holds between all neighbours.
fn chain(core: &mut Core, call: &Call<'_>, op: Binary) -> Result<Value, Exception> {
    for pair in call.args().windows(2) {
        if let [a, b] = pair
            && !apply(core, op, a, b)?.to_bool()?
        {
            return Ok(Value::from(false));
        }
    }
    Ok(Value::from(true))
}

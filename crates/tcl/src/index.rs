//! Places in lists and strings: `3`, `end`, `end-1`, `2+1`.

use super::error::Exception;
use super::number::{self, Number, looks_like_bad_octal};
use super::value::{Rep, Value};

/// Tcl takes no places further out.
const LIMIT: u64 = u32::MAX as u64;

/// A place, counted from 0, where the last one is `last`. May lie outside.
pub(crate) fn index(value: &Value, last: i64) -> Result<i64, Exception> {
    if let Rep::Int(i) = value.0
        && i.unsigned_abs() <= LIMIT
    {
        return Ok(i);
    }
    let text = value.as_str();
    parse(&text, last).ok_or_else(|| {
        let mut message = format!("bad index \"{text}\": must be integer?[+-]integer? or end?[+-]integer?");
        if looks_like_bad_octal(&text) {
            message.push_str(" (looks like invalid octal number)");
        }
        Exception::coded(message, &["TCL", "VALUE", "INDEX"])
    })
}

fn integer(text: &str) -> Option<i64> {
    match number::parse(text)? {
        Number::Int(i) if i.unsigned_abs() <= LIMIT => Some(i),
        _ => None,
    }
}

fn parse(text: &str, last: i64) -> Option<i64> {
    if !text.is_empty() && "end".starts_with(text) {
        return Some(last);
    }
    if let Some(i) = integer(text) {
        return Some(i);
    }
    let (base, rest) = match text.strip_prefix("end") {
        Some(rest) => (last, rest),
        None => {
            let (length, number) = number::prefix(number::trim(text))?;
            let text = number::trim(text);
            match number {
                Number::Int(i) => (i, text.get(length..)?),
                _ => return None,
            }
        }
    };
    // A sign or blank after the operator would make it something else.
    let operand = rest.get(1..)?;
    if !operand.starts_with(|c: char| c.is_ascii_digit() || c == '-' || c == '+') {
        return None;
    }
    let by = integer(operand)?;
    match rest.as_bytes().first()? {
        b'+' => Some(base.saturating_add(by)),
        b'-' => Some(base.saturating_sub(by)),
        _ => None,
    }
}

/// The part from `first` to `last`, both included, of `length` things: as a range, empty if there is none.
pub(crate) fn range(first: &Value, last: &Value, length: usize) -> Result<std::ops::Range<usize>, Exception> {
    let end = length as i64 - 1;
    let first = index(first, end)?.max(0);
    let last = index(last, end)?.min(end);
    Ok(if first > last { 0..0 } else { first as usize..last as usize + 1 })
}

//! `lsort`, and the orders that `lsearch` shares with it.

use std::cmp::Ordering;

use num_traits::ToPrimitive as _;

use crate::command::{Call, CommandFn};
use crate::error::Exception;
use crate::index::index;
use crate::interp::Interp;
use crate::number::Number;
use crate::value::{Value, too_large};

pub(crate) fn commands<H>() -> [(&'static str, CommandFn<H>); 1] {
    [("lsort", lsort)]
}

const OPTIONS: [&str; 12] = [
    "-ascii",
    "-command",
    "-decreasing",
    "-dictionary",
    "-increasing",
    "-index",
    "-indices",
    "-integer",
    "-nocase",
    "-real",
    "-stride",
    "-unique",
];

/// Comparison of elements.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Kind {
    Ascii,
    Dictionary,
    Integer,
    Real,
    Command,
}

/// Key of an element, converted for the comparison.
pub(crate) enum Key {
    Text(String),
    Integer(i64),
    Real(f64),
    Value(Value),
}

impl Key {
    pub(crate) fn new(value: &Value, kind: Kind, nocase: bool) -> Result<Key, Exception> {
        Ok(match kind {
            Kind::Ascii if nocase => Key::Text(value.as_str().to_lowercase()),
            Kind::Ascii | Kind::Dictionary => Key::Text(value.as_str().into_owned()),
            Kind::Integer => Key::Integer(wide(value)?),
            Kind::Real => Key::Real(value.to_f64()?),
            Kind::Command => Key::Value(value.clone()),
        })
    }

    pub(crate) fn compare(&self, other: &Key, kind: Kind) -> Ordering {
        match (self, other) {
            (Key::Text(a), Key::Text(b)) if kind == Kind::Dictionary => dictionary(a, b),
            (Key::Text(a), Key::Text(b)) => a.cmp(b),
            (Key::Integer(a), Key::Integer(b)) => a.cmp(b),
            (Key::Real(a), Key::Real(b)) => a.partial_cmp(b).unwrap_or(Ordering::Equal),
            _ => Ordering::Equal,
        }
    }
}

/// An integer of 64 bits; as in Tcl, one that has them all without a sign becomes negative.
fn wide(value: &Value) -> Result<i64, Exception> {
    match value.to_integer() {
        Ok(Number::Big(b)) => b.to_u64().map(|u| u as i64).ok_or_else(too_large),
        Ok(_) => value.to_i64(),
        Err(e) => Err(e),
    }
}

/// The order of a dictionary: case counts only between words that are else the same, digits count as numbers.
pub(crate) fn dictionary(left: &str, right: &str) -> Ordering {
    let mut l = left.chars().peekable();
    let mut r = right.chars().peekable();
    let mut second = Ordering::Equal;
    loop {
        let digit = |c: Option<&char>| c.is_some_and(char::is_ascii_digit);
        match (l.peek().copied(), r.peek().copied()) {
            (None, None) => return second,
            (None, Some(_)) => return Ordering::Less,
            (Some(_), None) => return Ordering::Greater,
            (Some(a), Some(b)) if a.is_ascii_digit() && b.is_ascii_digit() => {
                let number = |chars: &mut std::iter::Peekable<std::str::Chars<'_>>| {
                    let mut text = String::new();
                    while digit(chars.peek()) {
                        text.extend(chars.next());
                    }
                    let zeros = text.len() - text.trim_start_matches('0').len().max(1);
                    (text.split_off(zeros), zeros)
                };
                let (x, x_zeros) = number(&mut l);
                let (y, y_zeros) = number(&mut r);
                second = second.then(x_zeros.cmp(&y_zeros));
                match x.len().cmp(&y.len()).then_with(|| x.cmp(&y)) {
                    Ordering::Equal => {}
                    order => return order,
                }
            }
            (Some(a), Some(b)) => {
                let lower = |c: char| c.to_lowercase().next().unwrap_or(c);
                match lower(a).cmp(&lower(b)) {
                    Ordering::Equal => {}
                    order => return order,
                }
                if a.is_uppercase() && b.is_lowercase() {
                    second = second.then(Ordering::Less);
                } else if b.is_uppercase() && a.is_lowercase() {
                    second = second.then(Ordering::Greater);
                }
                l.next();
                r.next();
            }
        }
    }
}

/// The part of an element that is compared, by a path of places.
pub(crate) fn select(value: &Value, path: &[Value]) -> Result<Value, Exception> {
    let mut value = value.clone();
    for place in path {
        let items = value.to_list()?;
        let at = index(place, items.len() as i64 - 1)?;
        let inner = usize::try_from(at).ok().and_then(|at| items.get(at)).cloned();
        value = match inner {
            Some(v) => v,
            None => {
                let message = format!("element {at} missing from sublist \"{value}\"");
                return Err(Exception::coded(message, &["TCL", "OPERATION", "LSORT", "INDEXFAILED"]));
            }
        };
    }
    Ok(value)
}

/// Merge sort with an order that may fail. Stable; `unique` keeps the last of equal elements.
fn sort<T>(
    mut items: Vec<T>,
    unique: bool,
    compare: &mut dyn FnMut(&T, &T) -> Result<Ordering, Exception>,
) -> Result<Vec<T>, Exception> {
    if items.len() < 2 {
        return Ok(items);
    }
    let second = items.split_off(items.len() / 2);
    let mut left = sort(items, unique, compare)?.into_iter().peekable();
    let mut right = sort(second, unique, compare)?.into_iter().peekable();
    let mut merged = Vec::with_capacity(left.len() + right.len());
    while let (Some(a), Some(b)) = (left.peek(), right.peek()) {
        match compare(a, b)? {
            Ordering::Greater => merged.extend(right.next()),
            Ordering::Equal if unique => {
                left.next();
            }
            _ => merged.extend(left.next()),
        }
    }
    merged.extend(left);
    merged.extend(right);
    Ok(merged)
}

struct Options {
    kind: Kind,
    command: Value,
    decreasing: bool,
    path: Vec<Value>,
    indices: bool,
    nocase: bool,
    group: usize,
    unique: bool,
}

fn lsort<H>(interp: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2.., "lsort ?-option value ...? list")?;
    let last = call.len() - 1;
    let mut o = Options {
        kind: Kind::Ascii,
        command: Value::EMPTY,
        decreasing: false,
        path: vec![],
        indices: false,
        nocase: false,
        group: 1,
        unique: false,
    };
    let mut i = 1;
    while i < last {
        let option = call.choose(i, "option", &OPTIONS, false)?;
        let operand = |what: &str| match call.get(i + 1).filter(|_| i + 1 < last) {
            Some(v) => Ok(v),
            None => {
                let message = format!("\"{}\" option must be followed by {what}", OPTIONS[option]);
                Err(Exception::coded(message, &["TCL", "ARGUMENT", "MISSING"]).at(call.span(i), ""))
            }
        };
        match option {
            0 => o.kind = Kind::Ascii,
            1 => {
                o.command = operand("comparison command")?.clone();
                o.kind = Kind::Command;
                i += 1;
            }
            2 => o.decreasing = true,
            3 => o.kind = Kind::Dictionary,
            4 => o.decreasing = false,
            5 => {
                o.path = operand("list index")?.to_list()?.to_vec();
                for place in &o.path {
                    index(place, 0)?;
                }
                i += 1;
            }
            6 => o.indices = true,
            7 => o.kind = Kind::Integer,
            8 => o.nocase = true,
            9 => o.kind = Kind::Real,
            10 => {
                let stride = operand("stride length")?.to_i64()?;
                if stride < 2 {
                    let code = ["TCL", "OPERATION", "LSORT", "BADSTRIDE"];
                    return Err(Exception::coded("stride length must be at least 2", &code).at(call.span(i + 1), ""));
                }
                o.group = stride as usize;
                i += 1;
            }
            _ => o.unique = true,
        }
        i += 1;
    }
    let items = call.arg(last).to_list()?;
    let sorted = order(interp, &items, &o)?;
    if o.indices {
        // Tcl gives the places of all elements of a group.
        let all = sorted.into_iter().flat_map(|at| (at * o.group..(at + 1) * o.group).map(Value::from));
        return Ok(Value::list(all));
    }
    let groups = sorted.into_iter().flat_map(|at| items[at * o.group..(at + 1) * o.group].iter().cloned());
    Ok(Value::list(groups))
}

/// The numbers of the groups in their new order.
fn order<H>(interp: &mut Interp<H>, items: &[Value], o: &Options) -> Result<Vec<usize>, Exception> {
    let mut offset = 0;
    let mut path = &o.path[..];
    if o.group > 1 {
        if !items.len().is_multiple_of(o.group) {
            let message = "list size must be a multiple of the stride length";
            return Err(Exception::coded(message, &["TCL", "OPERATION", "LSORT", "BADSTRIDE"]));
        }
        if let Some((first, rest)) = path.split_first() {
            let at = index(first, o.group as i64 - 1)?;
            if at < 0 || at >= o.group as i64 {
                let message = "when used with \"-stride\", the leading \"-index\" value must be within the group";
                return Err(Exception::coded(message, &["TCL", "OPERATION", "LSORT", "BADINDEX"]));
            }
            offset = at as usize;
            path = rest;
        }
    }
    let nocase = o.nocase && o.kind == Kind::Ascii;
    let mut keyed = Vec::with_capacity(items.len() / o.group);
    for (at, group) in items.chunks(o.group).enumerate() {
        let value = group.get(offset).cloned().unwrap_or_default();
        let value = if path.is_empty() { value } else { select(&value, path)? };
        keyed.push((Key::new(&value, o.kind, nocase)?, at));
    }
    let flip = |order: Ordering| if o.decreasing { order.reverse() } else { order };
    if o.kind != Kind::Command {
        let sorted = sort(keyed, o.unique, &mut |a, b| Ok(flip(a.0.compare(&b.0, o.kind))))?;
        return Ok(sorted.into_iter().map(|k| k.1).collect());
    }
    let prefix = o.command.to_list()?;
    let sorted = sort(keyed, o.unique, &mut |a, b| {
        let mut words = prefix.to_vec();
        for key in [&a.0, &b.0] {
            if let Key::Value(v) = key {
                words.push(v.clone());
            }
        }
        let result = interp.eval_words(&words).map_err(|e| e.trace(|_| "-compare command".to_owned()))?;
        let number = result.to_i64().map_err(|_| {
            let code = ["TCL", "OPERATION", "LSORT", "COMPARISONFAILED"];
            Exception::coded("-compare command returned non-integer result", &code)
        })?;
        Ok(flip(number.cmp(&0)))
    })?;
    Ok(sorted.into_iter().map(|k| k.1).collect())
}

//! `lsearch`.

use std::cmp::Ordering;

use super::lsort::{Key, Kind, select};
use crate::command::{Call, CommandFn};
use crate::error::Exception;
use crate::glob;
use crate::index::index;
use crate::regex::{self, Flags};
use crate::value::Value;

pub(crate) fn commands<H>() -> [(&'static str, CommandFn<H>); 1] {
    [("lsearch", |_, call| lsearch(call))]
}

const OPTIONS: [&str; 18] = [
    "-all",
    "-ascii",
    "-bisect",
    "-decreasing",
    "-dictionary",
    "-exact",
    "-glob",
    "-increasing",
    "-index",
    "-inline",
    "-integer",
    "-nocase",
    "-not",
    "-real",
    "-regexp",
    "-sorted",
    "-start",
    "-subindices",
];

#[derive(Clone, Copy, PartialEq)]
enum Mode {
    Exact,
    Glob,
    Regexp,
    Sorted,
}

struct Options {
    mode: Mode,
    kind: Kind,
    all: bool,
    inline: bool,
    negated: bool,
    nocase: bool,
    decreasing: bool,
    bisect: bool,
    subindices: bool,
    path: Vec<Value>,
    start: Option<Value>,
}

fn options(call: &Call<'_>) -> Result<Options, Exception> {
    let mut o = Options {
        mode: Mode::Glob,
        kind: Kind::Ascii,
        all: false,
        inline: false,
        negated: false,
        nocase: false,
        decreasing: false,
        bisect: false,
        subindices: false,
        path: vec![],
        start: None,
    };
    let last = call.len() - 2;
    let mut i = 1;
    while i < last {
        let option = call.choose(i, "option", &OPTIONS, false)?;
        match OPTIONS[option] {
            "-all" => o.all = true,
            "-ascii" => o.kind = Kind::Ascii,
            "-bisect" => (o.mode, o.bisect) = (Mode::Sorted, true),
            "-decreasing" => o.decreasing = true,
            "-dictionary" => o.kind = Kind::Dictionary,
            "-exact" => o.mode = Mode::Exact,
            "-glob" => o.mode = Mode::Glob,
            "-increasing" => o.decreasing = false,
            "-inline" => o.inline = true,
            "-integer" => o.kind = Kind::Integer,
            "-nocase" => o.nocase = true,
            "-not" => o.negated = true,
            "-real" => o.kind = Kind::Real,
            "-regexp" => o.mode = Mode::Regexp,
            "-sorted" => o.mode = Mode::Sorted,
            "-subindices" => o.subindices = true,
            name => {
                i += 1;
                let Some(operand) = call.get(i).filter(|_| i < last) else {
                    let message = if name == "-index" {
                        "\"-index\" option must be followed by list index"
                    } else {
                        "missing starting index"
                    };
                    return Err(Exception::coded(message, &["TCL", "ARGUMENT", "MISSING"]).at(call.span(i - 1), ""));
                };
                if name == "-start" {
                    o.start = Some(operand.clone());
                } else {
                    o.path = operand.to_list()?.to_vec();
                    for place in &o.path {
                        index(place, 0)?;
                    }
                }
            }
        }
        i += 1;
    }
    if o.subindices && o.path.is_empty() {
        let code = ["TCL", "OPERATION", "LSEARCH", "BAD_OPTION_MIX"];
        return Err(Exception::coded("-subindices cannot be used without -index option", &code));
    }
    if o.bisect && (o.all || o.negated) {
        let code = ["TCL", "OPERATION", "LSEARCH", "BAD_OPTION_MIX"];
        return Err(Exception::coded("-bisect is not compatible with -all or -not", &code));
    }
    Ok(o)
}

fn lsearch(call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(3.., "lsearch ?-option value ...? list pattern")?;
    let o = options(call)?;
    let items = call.arg(call.len() - 2).to_list()?;
    let pattern = call.arg(call.len() - 1);
    let start = match &o.start {
        None => 0,
        Some(start) => index(start, items.len() as i64 - 1)?.max(0) as usize,
    };
    // A key that is no number is an error even for an empty list.
    let typed = matches!(o.mode, Mode::Exact | Mode::Sorted);
    let folded = o.nocase && o.kind == Kind::Ascii;
    let wanted = if typed { Some(Key::new(pattern, o.kind, folded)?) } else { None };
    let regex = match o.mode {
        Mode::Regexp => Some(regex::compile(pattern, Flags { nocase: o.nocase, ..Flags::default() })?),
        _ => None,
    };
    if start >= items.len() {
        return Ok(if o.all || o.inline { Value::EMPTY } else { Value::from(-1i64) });
    }
    let part = |at: usize| {
        let item = items.get(at).cloned().unwrap_or_default();
        if o.path.is_empty() { Ok(item) } else { select(&item, &o.path) }
    };
    let pattern_text = pattern.as_str();
    let fits = |at: usize| -> Result<bool, Exception> {
        let value = part(at)?;
        let found = match (&wanted, &regex) {
            (Some(key), _) => Key::new(&value, o.kind, folded)?.compare(key, o.kind) == Ordering::Equal,
            (_, Some(regex)) => regex.find(&value.as_str(), 0)?.is_some(),
            _ if o.nocase => glob::matches_nocase(&pattern_text, &value.as_str()),
            _ => glob::matches(&pattern_text, &value.as_str()),
        };
        Ok(found != o.negated)
    };
    let mut found = vec![];
    if let (Mode::Sorted, Some(key), false, false) = (o.mode, &wanted, o.all, o.negated) {
        let order = |at: usize| -> Result<Ordering, Exception> {
            let order = Key::new(&part(at)?, o.kind, folded)?.compare(key, o.kind);
            Ok(if o.decreasing { order.reverse() } else { order })
        };
        // The first element that is not before the wanted one; for -bisect the first one after it.
        let (mut low, mut high) = (start, items.len());
        while low < high {
            let middle = low + (high - low) / 2;
            let before = match order(middle)? {
                Ordering::Less => true,
                Ordering::Equal => o.bisect,
                Ordering::Greater => false,
            };
            if before {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        if o.bisect {
            found.extend((low > start).then(|| low - 1));
        } else if low < items.len() && order(low)? == Ordering::Equal {
            found.push(low);
        }
    } else {
        for at in start..items.len() {
            if fits(at)? {
                found.push(at);
                if !o.all {
                    break;
                }
            }
        }
    }
    let mut results = vec![];
    for at in found {
        results.push(match (o.inline, o.subindices) {
            // One level down Tcl gives the whole element all the same.
            (true, true) if o.path.len() > 1 => part(at)?,
            (true, _) => items.get(at).cloned().unwrap_or_default(),
            (false, true) => Value::list(std::iter::once(Value::from(at)).chain(o.path.iter().cloned())),
            (false, false) => Value::from(at),
        });
    }
    if o.all {
        return Ok(Value::from(results));
    }
    let nothing = if o.inline { Value::EMPTY } else { Value::from(-1i64) };
    Ok(results.pop().unwrap_or(nothing))
}

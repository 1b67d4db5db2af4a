//! Commands on lists, but for sorting and searching.

use crate::command::{Call, CoreFn};
use crate::core::Core;
use crate::error::Exception;
use crate::index::{index, range};
use crate::number;
use crate::value::{Rep, Value};
use crate::vars::VarName;

pub(crate) const COMMANDS: &[(&str, CoreFn)] = &[
    ("concat", |_, call| Ok(concat(call.args()))),
    ("join", join),
    ("lassign", lassign),
    ("lindex", lindex),
    ("linsert", linsert),
    ("list", |_, call| Ok(Value::list(call.args().iter().cloned()))),
    ("llength", llength),
    ("lrange", lrange),
    ("lrepeat", lrepeat),
    ("lreplace", lreplace),
    ("lreverse", lreverse),
    ("split", split),
];

/// Longer lists are refused; they would take gigabytes.
const MAX_LENGTH: usize = 1 << 26;

/// Lists put one after the other; other texts are joined by blanks.
pub(crate) fn concat(words: &[Value]) -> Value {
    let pure = |v: &Value| matches!(v.0, Rep::List(_) | Rep::Empty);
    if words.iter().all(pure) {
        let lists = words.iter().filter_map(|v| v.to_list().ok());
        return Value::from(lists.flat_map(|l| l.to_vec()).collect::<Vec<_>>());
    }
    let mut out = String::new();
    for word in words {
        let text = word.as_str();
        let blank = |c: char| c.is_ascii() && number::is_space(c as u8);
        let mut part = text.trim_start_matches(blank);
        let end = part.trim_end_matches(blank);
        // A backslash before the last blank keeps it.
        let escaped = end.len() < part.len() && end.bytes().rev().take_while(|b| *b == b'\\').count() % 2 == 1;
        part = if escaped { &part[..end.len() + 1] } else { end };
        if part.is_empty() {
            continue;
        }
        if !out.is_empty() {
            out.push(' ');
        }
        out.push_str(part);
    }
    Value::from(out)
}

fn join(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2..=3, "join list ?joinString?")?;
    let items = call.arg(1).to_list()?;
    let between = call.get(2).map_or(std::borrow::Cow::Borrowed(" "), Value::as_str);
    let mut out = String::new();
    for (i, item) in items.iter().enumerate() {
        if i > 0 {
            out.push_str(&between);
        }
        item.write_to(&mut out);
    }
    Ok(Value::from(out))
}

fn split(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2..=3, "split string ?splitChars?")?;
    let text = call.arg(1).as_str();
    let at = call.get(2).map_or(std::borrow::Cow::Borrowed(" \n\t\r"), Value::as_str);
    if text.is_empty() {
        return Ok(Value::EMPTY);
    }
    let element = |part: &str| Value::element(part, || None);
    let items: Vec<Value> = match at.len() {
        0 => text.chars().map(|c| element(c.encode_utf8(&mut [0; 4]))).collect(),
        1 => text.split(at.chars().next().unwrap_or(' ')).map(element).collect(),
        _ => text.split(|c| at.contains(c)).map(element).collect(),
    };
    Ok(Value::from(items))
}

fn llength(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2..=2, "llength list")?;
    Ok(Value::from(call.arg(1).to_list()?.len()))
}

/// One element, by a path of places.
pub(crate) fn element(list: &Value, path: &[Value]) -> Result<Value, Exception> {
    let mut value = list.clone();
    for place in path {
        let items = value.to_list()?;
        let at = index(place, items.len() as i64 - 1)?;
        let inner = usize::try_from(at).ok().and_then(|at| items.get(at)).cloned();
        value = match inner {
            Some(inner) => inner,
            None => {
                // The other places must be right all the same.
                for place in path {
                    index(place, 0)?;
                }
                return Ok(Value::EMPTY);
            }
        };
    }
    Ok(value)
}

fn lindex(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2.., "lindex list ?index ...?")?;
    match call.from(2) {
        [one] => {
            if index(one, 0).is_ok() {
                return element(call.arg(1), std::slice::from_ref(one));
            }
            match one.to_list() {
                Ok(path) if path.len() != 1 => element(call.arg(1), &path),
                _ => element(call.arg(1), std::slice::from_ref(one)),
            }
        }
        path => element(call.arg(1), path),
    }
}

fn lrange(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(4..=4, "lrange list first last")?;
    let items = call.arg(1).to_list()?;
    let part = range(call.arg(2), call.arg(3), items.len())?;
    if part.len() == items.len() && !items.is_empty() {
        return Ok(items.into_value());
    }
    Ok(Value::from(items[part].to_vec()))
}

fn linsert(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(3.., "linsert list index ?element ...?")?;
    let items = call.arg(1).to_list()?;
    let at = index(call.arg(2), items.len() as i64)?.clamp(0, items.len() as i64) as usize;
    let mut new = items[..at].to_vec();
    new.extend_from_slice(call.from(3));
    new.extend_from_slice(&items[at..]);
    Ok(Value::from(new))
}

fn lreplace(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(4.., "lreplace list first last ?element ...?")?;
    let items = call.arg(1).to_list()?;
    let last = items.len() as i64 - 1;
    let first = index(call.arg(2), last)?.clamp(0, items.len() as i64) as usize;
    let end = index(call.arg(3), last)?.min(last);
    let end = usize::try_from(end + 1).unwrap_or(0).max(first);
    let mut new = items[..first].to_vec();
    new.extend_from_slice(call.from(4));
    new.extend_from_slice(&items[end..]);
    Ok(Value::from(new))
}

fn lrepeat(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2.., "lrepeat count ?value ...?")?;
    let count = call.arg(1).to_int()?;
    if count < 0 {
        let message = format!("bad count \"{count}\": must be integer >= 0");
        return Err(Exception::coded(message, &["TCL", "OPERATION", "LREPEAT", "NEGARG"]).at(call.span(1), ""));
    }
    let values = call.from(2);
    let total = (count as usize).checked_mul(values.len()).filter(|n| *n < MAX_LENGTH);
    let Some(total) = total else {
        let message = format!("max length of a Tcl list ({} elements) exceeded", MAX_LENGTH);
        return Err(Exception::coded(message, &["TCL", "MEMORY"]));
    };
    let mut items = Vec::with_capacity(total);
    for _ in 0..count {
        items.extend_from_slice(values);
    }
    Ok(Value::from(items))
}

fn lreverse(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2..=2, "lreverse list")?;
    let items = call.arg(1).to_list()?;
    Ok(if items.is_empty() { call.arg(1).clone() } else { Value::list(items.iter().rev().cloned()) })
}

fn lassign(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2.., "lassign list ?varName ...?")?;
    let items = call.arg(1).to_list()?;
    let names = call.from(2);
    for (i, name) in names.iter().enumerate() {
        let name = VarName::of(name);
        core.assign(&name, items.get(i).cloned().unwrap_or_default())?;
    }
    Ok(Value::from(items.get(names.len()..).unwrap_or_default().to_vec()))
}

//! `dict`, but for the sub-commands that run scripts.

use super::var::incrementable;
use crate::command::{Call, CoreFn};
use crate::core::Core;
use crate::diagnostic;
use crate::dict::Dict;
use crate::error::Exception;
use crate::expr::arith;
use crate::glob;
use crate::number::Number;
use crate::table::Table;
use crate::value::Value;
use crate::vars::VarName;

pub(super) const SUBS: [(&str, CoreFn); 15] = [
    ("append", append),
    ("create", create),
    ("exists", exists),
    ("get", get),
    ("incr", incr),
    ("info", info),
    ("keys", |_, call| listed(call, "keys", true)),
    ("lappend", lappend),
    ("merge", merge),
    ("remove", remove),
    ("replace", replace),
    ("set", set),
    ("size", size),
    ("unset", unset),
    ("values", |_, call| listed(call, "values", false)),
];

fn no_key(dict: &Dict, key: &Value) -> Exception {
    let key = key.as_str();
    let message = format!("key \"{key}\" not known in dictionary");
    let near = if dict.len() > 500 { None } else { diagnostic::nearest(&key, dict.iter().map(|(k, _)| &**k)) };
    Exception::coded(message, &["TCL", "LOOKUP", "DICT", &key]).suggest(&key, near.map(str::to_owned))
}

fn create(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    if call.len() % 2 == 1 {
        return Err(call.wrong_args("dict create ?key value ...?"));
    }
    Ok(Dict::from_list(call.from(2))?.into())
}

fn get(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(3.., "dict get dictionary ?key ...?")?;
    let Some((last, path)) = call.from(3).split_last() else {
        return Ok(call.arg(2).to_dict()?.0.to_list().into_value());
    };
    let mut dict = call.arg(2).to_dict()?;
    for key in path {
        let inner = dict.get(&key.as_str()).ok_or_else(|| no_key(&dict, key))?.to_dict()?;
        dict = inner;
    }
    dict.get(&last.as_str()).cloned().ok_or_else(|| no_key(&dict, last))
}

/// The value at the end of a path of keys, if there is one.
fn find(dict: &Value, path: &[Value]) -> Result<Option<Value>, Exception> {
    let mut value = dict.clone();
    for key in path {
        let inner = value.to_dict()?.get(&key.as_str()).cloned();
        match inner {
            Some(inner) => value = inner,
            None => return Ok(None),
        }
    }
    Ok(Some(value))
}

fn exists(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(4.., "dict exists dictionary key ?key ...?")?;
    Ok(Value::from(matches!(find(call.arg(2), call.from(3)), Ok(Some(_)))))
}

fn size(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(3..=3, "dict size dictionary")?;
    Ok(Value::from(call.arg(2).to_dict()?.len()))
}

fn info(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(3..=3, "dict info dictionary")?;
    Ok(Value::from(format!("{} entries in table", call.arg(2).to_dict()?.len())))
}

fn listed(call: &Call<'_>, name: &str, keys: bool) -> Result<Value, Exception> {
    call.expect(3..=4, &format!("dict {name} dictionary ?pattern?"))?;
    let dict = call.arg(2).to_dict()?;
    let pattern = call.get(3).map(Value::as_str);
    let fits = |text: &str| pattern.as_ref().is_none_or(|p| glob::matches(p, text));
    if keys {
        return Ok(Value::list(dict.iter().filter(|(k, _)| fits(k)).map(|(k, _)| k.to_value())));
    }
    Ok(Value::list(dict.iter().map(|(_, v)| v.clone()).filter(|v| fits(&v.as_str()))))
}

fn merge(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    let Some((first, others)) = call.from(2).split_first() else { return Ok(Value::EMPTY) };
    let mut merged = first.clone();
    merged.to_dict()?;
    for other in others {
        let other = other.to_dict()?;
        let table = merged.dict_mut()?;
        for (key, value) in other.iter() {
            table.insert(key.clone(), value.clone());
        }
    }
    Ok(merged)
}

fn remove(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(3.., "dict remove dictionary ?key ...?")?;
    let mut dict = call.arg(2).clone();
    let table = dict.dict_mut()?;
    for key in call.from(3) {
        table.remove(&key.as_str());
    }
    Ok(dict)
}

fn replace(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(3.., "dict replace dictionary ?key value ...?")?;
    if call.len().is_multiple_of(2) {
        return Err(call.wrong_args("dict replace dictionary ?key value ...?"));
    }
    let mut dict = call.arg(2).clone();
    let table = dict.dict_mut()?;
    for pair in call.from(3).chunks_exact(2) {
        if let [key, value] = pair {
            table.insert(key.to_text(), value.clone());
        }
    }
    Ok(dict)
}

/// Change the dictionary in a variable and give its new value.
fn change(
    core: &mut Core,
    variable: &Value,
    change: impl FnOnce(&mut Table<Value>) -> Result<(), Exception>,
) -> Result<Value, Exception> {
    let name = VarName::of(variable);
    core.update(&name, true, "set", |value, _| change(value.dict_mut()?))?;
    core.value_of(&name)
}

fn append(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(4.., "dict append dictVarName key ?value ...?")?;
    change(core, call.arg(2), |table| {
        let key = call.arg(3).to_text();
        let mut value = table.get_mut(&key).map(std::mem::take).unwrap_or_default();
        let text = value.text_mut();
        for word in call.from(4) {
            word.write_to(text);
        }
        table.insert(key, value);
        Ok(())
    })
}

fn lappend(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(4.., "dict lappend dictVarName key ?value ...?")?;
    change(core, call.arg(2), |table| {
        let key = call.arg(3).to_text();
        if let Some(value) = table.get(&key) {
            value.to_list()?;
        }
        let mut value = table.get_mut(&key).map(std::mem::take).unwrap_or_default();
        value.list_mut()?.extend_from_slice(call.from(4));
        table.insert(key, value);
        Ok(())
    })
}

fn incr(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(4..=5, "dict incr dictVarName key ?increment?")?;
    change(core, call.arg(2), |table| {
        let key = call.arg(3).to_text();
        let by = call.get(4);
        let sum = match (table.get(&key), by) {
            (None, None) => Value::from(1i64),
            (None, Some(by)) => by.to_integer().map(|_| by.clone())?,
            (Some(old), by) => {
                let old = incrementable(old)?;
                let by = by.map_or(Ok(Number::Int(1)), incrementable)?;
                Value::from(arith::big(&old) + arith::big(&by))
            }
        };
        table.insert(key, sum);
        Ok(())
    })
}

/// Go down a path of keys, making dictionaries where there are none, and change the last one.
fn at_path(
    table: &mut Table<Value>,
    path: &[Value],
    create: bool,
    change: impl FnOnce(&mut Table<Value>) -> Result<(), Exception>,
) -> Result<(), Exception> {
    let mut at = table;
    for key in path {
        let text = key.to_text();
        if !at.contains(&text) {
            if !create {
                let dict = Dict::from_table(at.clone());
                return Err(no_key(&dict, key));
            }
            at.insert(text.clone(), Value::EMPTY);
        }
        at = match at.get_mut(&text) {
            Some(inner) => inner.dict_mut()?,
            None => return Ok(()),
        };
    }
    change(at)
}

fn set(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(5.., "dict set dictVarName key ?key ...? value")?;
    let last = call.len() - 1;
    let Some((key, path)) = call.from(3)[..last - 3].split_last() else { return Ok(Value::EMPTY) };
    change(core, call.arg(2), |table| {
        at_path(table, path, true, |t| {
            t.insert(key.to_text(), call.arg(last).clone());
            Ok(())
        })
    })
}

fn unset(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(4.., "dict unset dictVarName key ?key ...?")?;
    let Some((key, path)) = call.from(3).split_last() else { return Ok(Value::EMPTY) };
    change(core, call.arg(2), |table| {
        at_path(table, path, false, |t| {
            t.remove(&key.as_str());
            Ok(())
        })
    })
}

//! `array`.

use crate::command::{Call, CoreFn};
use crate::core::Core;
use crate::ensemble::dispatch;
use crate::error::Exception;
use crate::glob;
use crate::regex::{self, Flags};
use crate::text::Text;
use crate::value::Value;
use crate::vars::{Slot, Trouble, VarName};

pub(crate) const COMMANDS: &[(&str, CoreFn)] =
    &[("array", |core, call| dispatch(core, call, SUBS)), ("parray", parray)];

const SUBS: &[(&str, CoreFn)] = &[
    ("anymore", refuse_search),
    ("donesearch", refuse_search),
    ("exists", exists),
    ("get", get),
    ("names", names),
    ("nextelement", refuse_search),
    ("set", set),
    ("size", size),
    ("startsearch", refuse_search),
    ("statistics", statistics),
    ("unset", unset),
];

fn refuse_search(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    let message = format!("array {}: searches are not supported, use \"array names\"", call.arg(1));
    Err(call.error_at(1, message, "not supported"))
}

fn not_an_array(name: &Value) -> Exception {
    Exception::error(format!("\"{name}\" isn't an array"))
}

fn exists(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(3..=3, "array exists arrayName")?;
    Ok(Value::from(core.array(&VarName::of(call.arg(2)), |_| ()).is_some()))
}

fn size(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(3..=3, "array size arrayName")?;
    let size = core.array(&VarName::of(call.arg(2)), |a| a.iter().filter(|(_, s)| s.exists()).count());
    Ok(Value::from(size.unwrap_or(0)))
}

/// The elements whose names match, in Tcl's order.
fn elements(core: &Core, name: &VarName, fits: impl Fn(&str) -> bool) -> Vec<(Text, Value)> {
    let collect = |array: &crate::table::Table<Slot>| {
        let value = |slot: &Slot| slot.with(|s| if let Slot::Scalar(v) = s { Some(v.clone()) } else { None });
        array.iter_hashed().filter(|(k, _)| fits(k)).filter_map(|(k, s)| Some((k.clone(), value(s)?))).collect()
    };
    core.array(name, collect).unwrap_or_default()
}

fn get(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(3..=4, "array get arrayName ?pattern?")?;
    let pattern = call.get(3).map(Value::as_str);
    let fits = |k: &str| pattern.as_ref().is_none_or(|p| glob::matches(p, k));
    let pairs = elements(core, &VarName::of(call.arg(2)), fits);
    Ok(Value::list(pairs.into_iter().flat_map(|(k, v)| [k.to_value(), v])))
}

fn names(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(3..=5, "array names arrayName ?mode? ?pattern?")?;
    let name = VarName::of(call.arg(2));
    let mode = match call.len() {
        5 => call.choose(3, "option", &["-exact", "-glob", "-regexp"], false)?,
        _ => 1,
    };
    let found = match call.get(call.len() - 1).filter(|_| call.len() > 3) {
        None => elements(core, &name, |_| true),
        Some(pattern) if mode == 2 => {
            let regex = regex::compile(pattern, Flags::default())?;
            elements(core, &name, |k| matches!(regex.find(k, 0), Ok(Some(_))))
        }
        Some(pattern) => {
            let pattern = pattern.as_str();
            elements(core, &name, |k| if mode == 0 { *pattern == *k } else { glob::matches(&pattern, k) })
        }
    };
    Ok(Value::list(found.into_iter().map(|(k, _)| k.to_value())))
}

fn set(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(4..=4, "array set arrayName list")?;
    let items = call.arg(3).to_list()?;
    if items.len() % 2 == 1 {
        let message = "list must have an even number of elements";
        return Err(Exception::coded(message, &["TCL", "ARGUMENT", "FORMAT"]).at(call.span(3), ""));
    }
    let name = VarName::of(call.arg(2));
    if name.element.is_some() {
        let full = call.arg(2).as_str();
        let message = format!("can't set \"{full}\": variable isn't array");
        return Err(Exception::coded(message, &["TCL", "LOOKUP", "VARNAME", &full]));
    }
    if let Err(why) = core.make_array(&name) {
        let first = items.first().map(|k| k.as_str().into_owned());
        let (doing, index) = match (why, &first) {
            (Trouble::NotArray, Some(k)) => ("set", Some(k.as_str())),
            (_, _) => ("array set", None),
        };
        return Err(core.var_error(doing, &name, index, why));
    }
    for pair in items.chunks_exact(2) {
        if let [key, value] = pair {
            core.write(&name, Some(&key.to_text()), value.clone())?;
        }
    }
    Ok(Value::EMPTY)
}

fn unset(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(3..=4, "array unset arrayName ?pattern?")?;
    let name = VarName::of(call.arg(2));
    if core.array(&name, |_| ()).is_none() {
        return Ok(Value::EMPTY);
    }
    match call.get(3) {
        None => core.unset(&name, None)?,
        Some(pattern) => {
            let pattern = pattern.as_str();
            for (key, _) in elements(core, &name, |k| glob::matches(&pattern, k)) {
                core.unset(&name, Some(&key))?;
            }
        }
    }
    Ok(Value::EMPTY)
}

fn statistics(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(3..=3, "array statistics arrayName")?;
    match core.array(&VarName::of(call.arg(2)), |a| a.len()) {
        Some(n) => Ok(Value::from(format!("{n} entries in table"))),
        None => Err(not_an_array(call.arg(2))),
    }
}

fn parray(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2..=3, "parray a ?pattern?")?;
    let name = VarName::of(call.arg(1));
    if core.array(&name, |_| ()).is_none() {
        return Err(not_an_array(call.arg(1)));
    }
    let pattern = call.get(2).map(Value::as_str);
    let mut found = elements(core, &name, |k| pattern.as_ref().is_none_or(|p| glob::matches(p, k)));
    found.sort_by(|a, b| a.0.cmp(&b.0));
    let width = found.iter().map(|(k, _)| k.chars().count()).max().unwrap_or(0) + call.arg(1).char_count() + 2;
    for (key, value) in found {
        let full = format!("{}({})", call.arg(1), &*key);
        core.console.out(&format!("{full:width$} = {value}\n"));
    }
    Ok(Value::EMPTY)
}

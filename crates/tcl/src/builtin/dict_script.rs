//! The sub-commands of `dict` that run scripts.

use super::dict::SUBS;
use crate::command::{Call, CommandFn, choose};
use crate::dict::Dict;
use crate::ensemble::choose_sub;
use crate::error::Exception;
use crate::eval::script_of;
use crate::glob;
use crate::interp::Interp;
use crate::table::Table;
use crate::value::Value;
use crate::vars::VarName;

pub(crate) fn commands<H>() -> [(&'static str, CommandFn<H>); 1] {
    [("dict", dict)]
}

fn dict<H>(interp: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    let own: [(&str, CommandFn<H>); 5] =
        [("filter", filter), ("for", for_each), ("map", map), ("update", update), ("with", with)];
    // One table in alphabetical order, for the list of them in the message.
    let mut names: Vec<&str> = SUBS.iter().map(|s| s.0).chain(own.iter().map(|s| s.0)).collect();
    names.sort_unstable();
    let at = choose_sub(call, names.iter().copied())?;
    let name = names.get(at).copied().unwrap_or_default();
    if let Some((_, function)) = SUBS.iter().find(|s| s.0 == name) {
        return function(&mut interp.core, call);
    }
    match own.iter().find(|s| s.0 == name) {
        Some((_, function)) => function(interp, call),
        None => Ok(Value::EMPTY),
    }
}

/// The names of the variables for key and value.
fn pair_names(call: &Call<'_>, word: usize, sub: &str) -> Result<[std::rc::Rc<VarName>; 2], Exception> {
    match &*call.arg(word).to_list()? {
        [key, value] => Ok([VarName::of(key), VarName::of(value)]),
        _ => {
            let code = ["TCL", "SYNTAX", "dict", sub];
            Err(Exception::coded("must have exactly two variable names", &code).at(call.span(word), ""))
        }
    }
}

fn set_pair<H>(
    interp: &mut Interp<H>,
    names: &[std::rc::Rc<VarName>; 2],
    key: Value,
    value: Value,
) -> Result<(), Exception> {
    let [k, v] = names;
    interp.core.assign(k, key)?;
    interp.core.assign(v, value)
}

fn for_each<H>(interp: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(5..=5, "dict for {keyVarName valueVarName} dictionary script")?;
    each(interp, call, "\"dict for\" body", &mut |_, _| {})?;
    Ok(Value::EMPTY)
}

fn map<H>(interp: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(5..=5, "dict map {keyVarName valueVarName} dictionary script")?;
    let mut mapped: Table<Value> = Table::default();
    let whole = each(interp, call, "\"dict map\" body", &mut |key, value| {
        mapped.insert(key.to_text(), value);
    })?;
    Ok(if whole { Dict::from_table(mapped).into() } else { Value::EMPTY })
}

/// Run a script for each entry; `take` gets the key and the result of each round that ends normally. False after `break`.
fn each<H>(
    interp: &mut Interp<H>,
    call: &Call<'_>,
    what: &str,
    take: &mut dyn FnMut(&Value, Value),
) -> Result<bool, Exception> {
    let names = pair_names(call, 2, if what.contains("map") { "map" } else { "for" })?;
    let dict = call.arg(3).to_dict()?;
    let body = call.arg(4);
    let script = script_of(body);
    for (key, value) in dict.iter() {
        interp.core.tick()?;
        set_pair(interp, &names, key.to_value(), value.clone())?;
        match interp.body_again(&script, body, what) {
            Ok(result) => {
                // The script may have changed the variable of the key.
                let [k, _] = &names;
                let key = interp.core.value_of(k).unwrap_or_else(|_| key.to_value());
                take(&key, result);
            }
            Err(Exception::Continue) => {}
            Err(Exception::Break) => return Ok(false),
            Err(e) => return Err(e),
        }
    }
    Ok(true)
}

fn filter<H>(interp: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(4.., "dict filter dictionary filterType ?arg ...?")?;
    let kind = choose(&call.arg(3).as_str(), "filterType", &["key", "script", "value"], false)
        .map_err(|e| e.at(call.span(3), ""))?;
    let dict = call.arg(2).to_dict()?;
    let mut kept: Table<Value> = Table::default();
    if kind != 1 {
        let patterns: Vec<_> = call.from(4).iter().map(Value::as_str).collect();
        for (key, value) in dict.iter() {
            let value_text = value.as_str();
            let text: &str = if kind == 0 { key } else { &value_text };
            if patterns.iter().any(|p| glob::matches(p, text)) {
                kept.insert(key.clone(), value.clone());
            }
        }
        return Ok(Dict::from_table(kept).into());
    }
    call.expect(6..=6, "dict filter dictionary script {keyVarName valueVarName} filterScript")?;
    let names = pair_names(call, 4, "filter")?;
    let body = call.arg(5);
    let script = script_of(body);
    for (key, value) in dict.iter() {
        set_pair(interp, &names, key.to_value(), value.clone())?;
        match interp.body_again(&script, body, "\"dict filter\" script") {
            Ok(result) => {
                if result.to_bool()? {
                    kept.insert(key.clone(), value.clone());
                }
            }
            Err(Exception::Continue) => {}
            Err(Exception::Break) => break,
            Err(e) => return Err(e),
        }
    }
    Ok(Dict::from_table(kept).into())
}

fn update<H>(interp: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    let usage = "dict update dictVarName key varName ?key varName ...? script";
    call.expect(6.., usage)?;
    if call.len() % 2 == 1 {
        return Err(call.wrong_args(usage));
    }
    let name = VarName::of(call.arg(2));
    let dict = interp.core.value_of(&name)?.to_dict()?;
    let last = call.len() - 1;
    let mut pairs = vec![];
    for pair in call.from(3)[..last - 3].chunks_exact(2) {
        if let [key, variable] = pair {
            let variable = VarName::of(variable);
            match dict.get(&key.as_str()) {
                Some(value) => interp.core.assign(&variable, value.clone())?,
                None => {
                    // A key that is not there leaves its variable unset.
                    let _ = interp.core.unset(&variable, variable.element.as_deref());
                }
            }
            pairs.push((key.clone(), variable));
        }
    }
    let result = interp.body(call, last, "body of \"dict update\"");
    store(interp, &name, &[], &pairs)?;
    result
}

fn with<H>(interp: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(4.., "dict with dictVarName ?key ...? script")?;
    let name = VarName::of(call.arg(2));
    let last = call.len() - 1;
    let path = &call.from(3)[..last - 3];
    let mut dict = interp.core.value_of(&name)?.to_dict()?;
    for key in path {
        let inner = dict.get(&key.as_str()).cloned();
        dict = match inner {
            Some(inner) => inner.to_dict()?,
            None => {
                let text = key.as_str();
                let message = format!("key \"{text}\" not known in dictionary");
                return Err(Exception::coded(message, &["TCL", "LOOKUP", "DICT", &text]));
            }
        };
    }
    let mut pairs = vec![];
    for (key, value) in dict.iter() {
        let key = key.to_value();
        let variable = VarName::of(&key);
        interp.core.assign(&variable, value.clone())?;
        pairs.push((key, variable));
    }
    let result = interp.body(call, last, "body of \"dict with\"");
    store(interp, &name, path, &pairs)?;
    result
}

/// Put the values of variables back into the dictionary of a variable; those that are gone remove their key.
fn store<H>(
    interp: &mut Interp<H>,
    name: &VarName,
    path: &[Value],
    pairs: &[(Value, std::rc::Rc<VarName>)],
) -> Result<(), Exception> {
    let Ok(mut whole) = interp.core.look(name) else { return Ok(()) };
    let mut at = whole.dict_mut()?;
    for key in path {
        at = match at.get_mut(&key.as_str()) {
            Some(inner) => inner.dict_mut()?,
            None => return Ok(()),
        };
    }
    for (key, variable) in pairs {
        match interp.core.look(variable) {
            Ok(value) => {
                at.insert(key.to_text(), value);
            }
            Err(_) => {
                at.remove(&key.as_str());
            }
        }
    }
    interp.core.assign(name, whole)
}

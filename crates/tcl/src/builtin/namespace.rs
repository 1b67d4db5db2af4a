//! `namespace`.

use std::rc::Rc;

use super::control::concat;
use crate::command::{Call, CommandFn, Imp, choose};
use crate::core::{Core, Frame, NsId};
use crate::ensemble::{Ensemble, choose_sub};
use crate::error::Exception;
use crate::glob;
use crate::interp::Interp;
use crate::table::Table;
use crate::text::Text;
use crate::value::Value;
use crate::vars::{VarName, split_qualified};

pub(crate) fn commands<H>() -> [(&'static str, CommandFn<H>); 1] {
    [("namespace", namespace)]
}

fn namespace<H>(interp: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    let subs: [(&str, CommandFn<H>); 18] = [
        ("children", |i, c| children(&i.core, c)),
        ("code", |i, c| code(&i.core, c)),
        ("current", |i, c| {
            c.expect(2..=2, "namespace current")?;
            Ok(i.core.ns(i.core.here()).full.to_value())
        }),
        ("delete", |i, c| delete(&mut i.core, c)),
        ("ensemble", |i, c| ensemble(&mut i.core, c)),
        ("eval", eval),
        ("exists", |i, c| {
            c.expect(3..=3, "namespace exists name")?;
            Ok(Value::from(i.core.find_namespace(&c.arg(2).as_str()).is_some()))
        }),
        ("export", |i, c| export(&mut i.core, c)),
        ("forget", |i, c| forget(&mut i.core, c)),
        ("import", |i, c| import(&mut i.core, c)),
        ("inscope", inscope),
        ("origin", |i, c| origin(&i.core, c)),
        ("parent", |i, c| parent(&i.core, c)),
        ("path", |i, c| path(&mut i.core, c)),
        ("qualifiers", |_, c| {
            c.expect(3..=3, "namespace qualifiers string")?;
            let name = c.arg(2).as_str();
            Ok(Value::from(split_qualified(&name).map_or("", |(path, _)| path)))
        }),
        ("tail", |_, c| {
            c.expect(3..=3, "namespace tail string")?;
            let name = c.arg(2).as_str();
            Ok(Value::from(split_qualified(&name).map_or(&*name, |(_, tail)| tail)))
        }),
        ("unknown", |i, c| unknown(&mut i.core, c)),
        ("upvar", |i, c| upvar(&mut i.core, c)),
    ];
    let names = subs.iter().map(|s| s.0).chain(std::iter::once("which"));
    match subs.get(choose_sub(call, names)?) {
        Some((_, function)) => function(interp, call),
        None => which(&interp.core, call),
    }
}

impl<H> Interp<H> {
    /// Run something with the names of a namespace.
    pub(crate) fn in_namespace<R>(&mut self, ns: NsId, words: Vec<Value>, work: impl FnOnce(&mut Self) -> R) -> R {
        let caller = self.core.calls.active;
        self.core.calls.frames.push(Frame {
            ns,
            vars: Table::default(),
            is_proc: false,
            level: self.core.calls.frames[caller].level + 1,
            caller,
            words,
        });
        self.core.calls.active = self.core.calls.frames.len() - 1;
        let result = work(self);
        self.core.calls.frames.pop();
        self.core.calls.active = caller;
        result
    }
}

fn eval<H>(interp: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(4.., "namespace eval name arg ?arg...?")?;
    let ns = interp.core.make_namespace(&call.arg(2).as_str());
    run_in(interp, call, ns, &concat(call, 3), "eval")
}

fn run_in<H>(interp: &mut Interp<H>, call: &Call<'_>, ns: NsId, body: &Value, what: &str) -> Result<Value, Exception> {
    interp.core.enter()?;
    let full = interp.core.ns(ns).full.clone();
    let what = format!("in namespace {what} \"{}\" script", &*full);
    let words = call.from(0).to_vec();
    let result = interp.in_namespace(ns, words, |interp| interp.dynamic(call, 3, body, &what));
    interp.core.calls.levels -= 1;
    result
}

fn inscope<H>(interp: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(4.., "namespace inscope name arg ?arg...?")?;
    let ns = interp.core.namespace_named(&call.arg(2).as_str())?;
    let mut body = call.arg(3).clone();
    if call.len() > 4 {
        let text = body.text_mut();
        for word in call.from(4) {
            text.push(' ');
            crate::list::write_value(text, word, false);
        }
    }
    run_in(interp, call, ns, &body, "inscope")
}

fn children(core: &Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2..=4, "namespace children ?name? ?pattern?")?;
    let ns = match call.get(2) {
        None => core.here(),
        Some(name) => core.namespace_named(&name.as_str())?,
    };
    let pattern = call.get(3).map(|p| {
        let p = p.as_str();
        if p.starts_with("::") { p.into_owned() } else { core.qualified(ns, &p) }
    });
    let names = core.ns(ns).children.iter_hashed().map(|(_, child)| core.ns(*child).full.clone());
    Ok(Value::list(names.filter(|n| pattern.as_ref().is_none_or(|p| glob::matches(p, n))).map(|n| n.to_value())))
}

fn code(core: &Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(3..=3, "namespace code arg")?;
    let text = call.arg(2).as_str();
    if text.starts_with("::namespace inscope ") {
        return Ok(call.arg(2).clone());
    }
    let words = ["::namespace", "inscope", &core.ns(core.here()).full].map(Value::from);
    Ok(Value::list(words.into_iter().chain(std::iter::once(call.arg(2).clone()))))
}

fn delete(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    for (i, name) in call.from(2).iter().enumerate() {
        let name = name.as_str();
        if core.find_namespace(&name).is_none() {
            let message = format!("unknown namespace \"{name}\" in namespace delete command");
            let code = ["TCL", "LOOKUP", "NAMESPACE", &name];
            return Err(Exception::coded(message, &code).at(call.span(i + 2), ""));
        }
    }
    for name in call.from(2) {
        if let Some(ns) = core.find_namespace(&name.as_str()) {
            core.delete_namespace(ns);
        }
    }
    Ok(Value::EMPTY)
}

fn export(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    let ns = core.here();
    if call.len() == 2 {
        return Ok(Value::list(core.ns(ns).exports.iter().map(Text::to_value)));
    }
    let mut patterns = call.from(2);
    if patterns.first().is_some_and(|p| p.as_str() == "-clear") {
        core.ns_mut(ns).exports.clear();
        patterns = &patterns[1..];
    }
    for pattern in patterns {
        let text = pattern.as_str();
        if text.contains("::") {
            let message = format!("invalid export pattern \"{text}\": pattern can't specify a namespace");
            return Err(Exception::coded(message, &["TCL", "EXPORT", "INVALID"]));
        }
        if !core.ns(ns).exports.iter().any(|e| **e == *text) {
            core.ns_mut(ns).exports.push(pattern.to_text());
        }
    }
    Ok(Value::EMPTY)
}

fn import(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    let here = core.here();
    let mut patterns = call.from(2);
    if patterns.is_empty() {
        let imported =
            core.ns(here).commands.iter_hashed().filter(|(_, id)| {
                matches!(core.table.commands.get(id.0 as usize).map(|d| &d.imp), Some(Imp::Import(_)))
            });
        return Ok(Value::list(imported.map(|(name, _)| name.to_value())));
    }
    let force = patterns.first().is_some_and(|p| p.as_str() == "-force");
    if force {
        patterns = &patterns[1..];
    }
    for pattern in patterns {
        let text = pattern.as_str();
        let refuse = |message: String| Exception::coded(message, &["TCL", "IMPORT", "ORIGIN"]);
        if text.is_empty() {
            return Err(Exception::coded("empty import pattern", &["TCL", "IMPORT", "EMPTY"]));
        }
        let Some((path, tail)) = split_qualified(&text) else {
            return Err(refuse(format!("no namespace specified in import pattern \"{text}\"")));
        };
        let path = if path.is_empty() { "::" } else { path };
        let Some(from) = core.find_namespace(path) else {
            let message = format!("unknown namespace in import pattern \"{text}\"");
            return Err(Exception::coded(message, &["TCL", "LOOKUP", "NAMESPACE", &text]));
        };
        if from == here {
            let name = core.ns(here).full.clone();
            return Err(refuse(format!(
                "import pattern \"{text}\" tries to import from namespace \"{}\" into itself",
                &*name
            )));
        }
        let exports = core.ns(from).exports.clone();
        let exported = |name: &str| exports.iter().any(|p| glob::matches(p, name));
        let found: Vec<_> = core
            .ns(from)
            .commands
            .iter_hashed()
            .filter(|(name, _)| glob::matches(tail, name) && exported(name))
            .map(|(name, id)| (name.clone(), *id))
            .collect();
        for (name, id) in found {
            if let Some(&old) = core.ns(here).commands.get(&name) {
                if matches!(core.table.commands[old.0 as usize].imp, Imp::Import(of) if of == id) {
                    continue;
                }
                if !force {
                    let message = format!("can't import command \"{}\": already exists", &*name);
                    return Err(Exception::coded(message, &["TCL", "IMPORT", "OVERWRITE"]));
                }
            }
            core.define(here, &name, Imp::Import(id));
        }
    }
    Ok(Value::EMPTY)
}

fn forget(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    let here = core.here();
    for pattern in call.from(2) {
        let text = pattern.as_str();
        let (from, tail) = match split_qualified(&text) {
            None => (None, &*text),
            Some((path, tail)) => match core.find_namespace(path) {
                Some(ns) => (Some(ns), tail),
                None => {
                    let message = format!("unknown namespace in namespace forget pattern \"{text}\"");
                    return Err(Exception::coded(message, &["TCL", "LOOKUP", "NAMESPACE", &text]));
                }
            },
        };
        let found: Vec<_> = core
            .ns(here)
            .commands
            .iter()
            .filter(|(name, id)| match core.table.commands[id.0 as usize].imp {
                Imp::Import(of) => {
                    glob::matches(tail, name) && from.is_none_or(|ns| core.table.commands[of.0 as usize].ns == ns)
                }
                _ => false,
            })
            .map(|(_, id)| *id)
            .collect();
        for id in found {
            core.delete_command(id);
        }
    }
    Ok(Value::EMPTY)
}

fn origin(core: &Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(3..=3, "namespace origin name")?;
    let name = call.arg(2).as_str();
    match core.find_command(&name) {
        Some(id) => Ok(Value::from(core.full_name(core.origin_of(id)))),
        None => {
            let message = format!("invalid command name \"{name}\"");
            Err(Exception::coded(message, &["TCL", "LOOKUP", "COMMAND", &name]).at(call.span(2), ""))
        }
    }
}

fn parent(core: &Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2..=3, "namespace parent ?name?")?;
    let ns = match call.get(2) {
        None => core.here(),
        Some(name) => core.namespace_named(&name.as_str())?,
    };
    Ok(core.ns(ns).parent.map(|p| core.ns(p).full.to_value()).unwrap_or_default())
}

fn path(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2..=3, "namespace path ?pathList?")?;
    let here = core.here();
    if call.len() == 2 {
        return Ok(Value::list(core.ns(here).path.iter().map(|p| core.ns(*p).full.to_value())));
    }
    let names = call.arg(2).to_list()?;
    let path = names.iter().map(|n| core.namespace_named(&n.as_str())).collect::<Result<Vec<_>, _>>()?;
    core.ns_mut(here).path = path;
    core.renew_epoch();
    Ok(Value::EMPTY)
}

fn unknown(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2..=3, "namespace unknown ?script?")?;
    let here = core.here();
    if let Some(handler) = call.get(2) {
        core.ns_mut(here).unknown = handler.clone();
        return Ok(handler.clone());
    }
    let handler = core.ns(here).unknown.clone();
    Ok(if handler.is_empty() && here == NsId::GLOBAL { Value::from("::unknown") } else { handler })
}

fn upvar(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    let usage = "namespace upvar ns ?otherVar myVar ...?";
    call.expect(3.., usage)?;
    if call.len().is_multiple_of(2) {
        return Err(call.wrong_args(usage));
    }
    let ns = core.namespace_named(&call.arg(2).as_str())?;
    for pair in call.from(3).chunks_exact(2) {
        let [other, local] = pair else { continue };
        let name = VarName::parse(&core.qualified(ns, &other.as_str()));
        let target = core.variable_in(0, &name)?;
        core.link(&local.as_str(), target)?;
    }
    Ok(Value::EMPTY)
}

fn which(core: &Core, call: &Call<'_>) -> Result<Value, Exception> {
    let usage = "namespace which ?-command? ?-variable? name";
    call.expect(3..=4, usage)?;
    let variable = match call.len() {
        4 => {
            choose(&call.arg(2).as_str(), "option", &["-command", "-variable"], false)
                .map_err(|_| call.wrong_args(usage))?
                == 1
        }
        _ => false,
    };
    let name = call.arg(call.len() - 1).as_str();
    if !variable {
        return Ok(core.find_command(&name).map(|id| Value::from(core.full_name(id))).unwrap_or_default());
    }
    let parsed = VarName::simple(&name);
    let places = [Some(core.here()), Some(NsId::GLOBAL)];
    let found = match split_qualified(&name) {
        Some((path, _)) => {
            let path = if path.is_empty() { "::" } else { path };
            core.find_namespace(path).filter(|ns| has_variable(core, *ns, &parsed.tail))
        }
        None => places.into_iter().flatten().find(|ns| has_variable(core, *ns, &parsed.tail)),
    };
    Ok(found.map(|ns| Value::from(core.qualified(ns, &parsed.tail))).unwrap_or_default())
}

fn has_variable(core: &Core, ns: NsId, tail: &str) -> bool {
    core.ns(ns).vars.contains(tail)
}

fn ensemble(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(3.., "namespace ensemble subcommand ?arg ...?")?;
    match choose(&call.arg(2).as_str(), "subcommand", &["configure", "create", "exists"], false)
        .map_err(|e| e.at(call.span(2), ""))?
    {
        0 => configure_ensemble(core, call),
        1 => create_ensemble(core, call),
        _ => {
            call.expect(4..=4, "namespace ensemble exists cmdname")?;
            let id = core.find_command(&call.arg(3).as_str());
            Ok(Value::from(id.is_some_and(|id| core.ensemble_of(id).is_some())))
        }
    }
}

const ENSEMBLE_OPTIONS: [&str; 6] = ["-command", "-map", "-parameters", "-prefixes", "-subcommands", "-unknown"];

/// Set an option of an ensemble from word `i` and the one after.
fn set_option(core: &Core, call: &Call<'_>, i: usize, option: usize, made: &mut Ensemble) -> Result<(), Exception> {
    let value = call.arg(i + 1);
    match option {
        1 => {
            made.map.clear();
            for (key, target) in value.to_dict()?.iter() {
                let words = target.to_list()?;
                let Some((first, rest)) = words.split_first() else {
                    let message = "ensemble subcommand implementations must be non-empty lists";
                    return Err(Exception::coded(message, &["TCL", "ENSEMBLE", "EMPTY_TARGET"]));
                };
                let command = first.as_str();
                let command =
                    if command.starts_with("::") { command.into_owned() } else { core.qualified(made.ns, &command) };
                let full = std::iter::once(Value::from(command)).chain(rest.iter().cloned());
                made.map.push((key.to_value(), Value::list(full)));
            }
        }
        3 => made.prefixes = value.to_bool()?,
        4 => made.subcommands = value.to_list()?.to_vec(),
        5 => made.unknown = value.clone(),
        _ => {
            let message = format!("ensemble {} is not supported", ENSEMBLE_OPTIONS[option]);
            return Err(call.error_at(i, message, "not supported"));
        }
    }
    Ok(())
}

fn configure_ensemble(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(4.., "namespace ensemble configure cmdname ?-option value ...? ?arg ...?")?;
    let name = call.arg(3).as_str();
    let id = core.find_command(&name).map(|id| core.origin_of(id));
    let Some((id, ensemble)) = id.and_then(|id| Some((id, core.ensemble_of(id)?))) else {
        let message = format!("\"{name}\" is not an ensemble command");
        return Err(Exception::coded(message, &["TCL", "LOOKUP", "ENSEMBLE", &name]).at(call.span(3), ""));
    };
    let get = |option: usize| match option {
        1 => Value::list(ensemble.map.iter().flat_map(|(k, v)| [k.clone(), v.clone()])),
        3 => Value::from(ensemble.prefixes),
        4 => Value::list(ensemble.subcommands.iter().cloned()),
        5 => ensemble.unknown.clone(),
        _ => Value::EMPTY,
    };
    if call.len() == 4 {
        let all = [1, 2, 3, 4, 5].into_iter().flat_map(|o| [Value::from(ENSEMBLE_OPTIONS[o]), get(o)]);
        let ns = [Value::from("-namespace"), core.ns(ensemble.ns).full.to_value()];
        return Ok(Value::list(all.chain(ns)));
    }
    if call.len() == 5 {
        let names = ["-namespace", "-map", "-parameters", "-prefixes", "-subcommands", "-unknown"];
        return Ok(match call.choose(4, "option", &names, false)? {
            0 => core.ns(ensemble.ns).full.to_value(),
            option => get(option),
        });
    }
    let mut made = Ensemble::clone(&ensemble);
    for i in (4..call.len()).step_by(2) {
        let option = call.choose(i, "option", &ENSEMBLE_OPTIONS, false)?;
        set_option(core, call, i, option, &mut made)?;
    }
    core.table.commands[id.0 as usize].imp = Imp::Ensemble(Rc::new(made));
    Ok(Value::EMPTY)
}

fn create_ensemble(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    if call.len().is_multiple_of(2) {
        return Err(call.wrong_args("namespace ensemble create ?option value ...?"));
    }
    let ns = core.here();
    let mut name = core.ns(ns).full.to_string();
    let mut made = Ensemble { ns, map: vec![], subcommands: vec![], prefixes: true, unknown: Value::EMPTY };
    for i in (3..call.len()).step_by(2) {
        match call.choose(i, "option", &ENSEMBLE_OPTIONS, false)? {
            0 => name = call.arg(i + 1).as_str().into_owned(),
            option => set_option(core, call, i, option, &mut made)?,
        }
    }
    let (at, tail) = core.place_for(&name);
    let id = core.define(at, &tail, Imp::Ensemble(Rc::new(made)));
    Ok(Value::from(core.full_name(id)))
}

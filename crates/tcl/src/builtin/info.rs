//! `info`.

use crate::command::{Call, CommandFn, CoreFn, Imp, Proc};
use crate::core::{Core, NsId};
use crate::ensemble::dispatch;
use crate::error::Exception;
use crate::expr::func;
use crate::glob;
use crate::interp::Interp;
use crate::lexer::is_complete;
use crate::text::Text;
use crate::value::Value;
use crate::vars::{Slot, VarName, split_qualified};

pub(crate) fn commands<H>() -> [(&'static str, CommandFn<H>); 1] {
    [("info", info)]
}

fn info<H>(interp: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    dispatch(&mut interp.core, call, SUBS)
}

const SUBS: &[(&str, CoreFn)] = &[
    ("args", args),
    ("body", body),
    ("class", |_, call| unsupported(call)),
    ("cmdcount", |core, call| {
        call.expect(2..=2, "info cmdcount")?;
        Ok(Value::from(i64::try_from(core.calls.command_count).unwrap_or(i64::MAX)))
    }),
    ("commands", commands_sub),
    ("complete", |_, call| {
        call.expect(3..=3, "info complete command")?;
        Ok(Value::from(is_complete(&call.arg(2).as_str())))
    }),
    ("coroutine", |_, call| {
        call.expect(2..=2, "info coroutine")?;
        Ok(Value::EMPTY)
    }),
    ("default", default),
    ("errorstack", |_, call| unsupported(call)),
    ("exists", exists),
    ("frame", frame),
    ("functions", functions),
    ("globals", globals),
    ("hostname", |core, call| {
        call.expect(2..=2, "info hostname")?;
        let read = core.files.read("/etc/hostname").unwrap_or_default();
        Ok(Value::from(String::from_utf8_lossy(&read).trim()))
    }),
    ("level", level),
    ("library", |core, call| {
        call.expect(2..=2, "info library")?;
        core.get_var("::tcl_library")
    }),
    ("loaded", |_, call| {
        call.expect(2..=3, "info loaded ?interp?")?;
        Ok(Value::EMPTY)
    }),
    ("locals", locals),
    ("nameofexecutable", |_, call| {
        call.expect(2..=2, "info nameofexecutable")?;
        let path = std::env::current_exe().unwrap_or_default();
        Ok(Value::from(path.to_string_lossy().into_owned()))
    }),
    ("object", |_, call| unsupported(call)),
    ("patchlevel", |core, call| {
        call.expect(2..=2, "info patchlevel")?;
        core.get_var("::tcl_patchLevel")
    }),
    ("procs", procs),
    ("script", script),
    ("sharedlibextension", |_, call| {
        call.expect(2..=2, "info sharedlibextension")?;
        Ok(Value::from(std::env::consts::DLL_SUFFIX))
    }),
    ("tclversion", |core, call| {
        call.expect(2..=2, "info tclversion")?;
        core.get_var("::tcl_version")
    }),
    ("vars", vars),
];

fn unsupported(call: &Call<'_>) -> Result<Value, Exception> {
    Err(call.error_at(1, format!("info {} is not supported", call.arg(1)), "not supported"))
}

fn proc_named(core: &Core, call: &Call<'_>) -> Result<std::rc::Rc<Proc>, Exception> {
    let name = call.arg(2).as_str();
    let id = core.find_command(&name).map(|id| core.origin_of(id));
    match id.map(|id| &core.table.commands[id.0 as usize].imp) {
        Some(Imp::Proc(proc)) => Ok(proc.clone()),
        _ => {
            let message = format!("\"{name}\" isn't a procedure");
            Err(Exception::coded(message, &["TCL", "LOOKUP", "PROCEDURE", &name]).at(call.span(2), ""))
        }
    }
}

fn args(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(3..=3, "info args procname")?;
    Ok(Value::list(proc_named(core, call)?.params.iter().map(|p| p.name.text.to_value())))
}

fn body(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(3..=3, "info body procname")?;
    Ok(proc_named(core, call)?.body.clone())
}

fn default(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(5..=5, "info default procname arg varname")?;
    let proc = proc_named(core, call)?;
    let wanted = call.arg(3).as_str();
    let Some(param) = proc.params.iter().find(|p| *p.name.text == *wanted) else {
        let message = format!("procedure \"{}\" doesn't have an argument \"{wanted}\"", call.arg(2));
        return Err(Exception::coded(message, &["TCL", "LOOKUP", "ARGUMENT", &wanted]).at(call.span(3), ""));
    };
    let name = VarName::of(call.arg(4));
    core.assign(&name, param.default.clone().unwrap_or_default())?;
    Ok(Value::from(param.default.is_some()))
}

fn exists(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(3..=3, "info exists varName")?;
    let name = VarName::of(call.arg(2));
    let there = match &name.element {
        Some(element) => core.peek(&name, Some(element)).is_ok(),
        None => core.slot(&name).is_some_and(Slot::exists),
    };
    Ok(Value::from(there))
}

/// Names that match a pattern, given back with the qualifiers that the pattern has.
fn qualified_names<'c>(
    core: &'c Core,
    pattern: Option<&str>,
    list: impl Fn(NsId) -> Vec<&'c Text>,
) -> Result<Value, Exception> {
    if let Some((path, tail)) = pattern.and_then(split_qualified) {
        let whole = if path.is_empty() { "::" } else { path };
        let Some(ns) = core.find_namespace(whole) else { return Ok(Value::EMPTY) };
        let found = list(ns).into_iter().filter(|n| glob::matches(tail, n));
        return Ok(Value::list(found.map(|n| Value::from(core.qualified(ns, n)))));
    }
    let here = core.here();
    let fits = |n: &&Text| pattern.is_none_or(|p| glob::matches(p, n));
    let mut names: Vec<&Text> = list(here).into_iter().filter(fits).collect();
    if here != NsId::GLOBAL {
        let own: std::collections::HashSet<&str> = names.iter().map(|n| &***n).collect();
        let more = list(NsId::GLOBAL).into_iter().filter(fits).filter(|n| !own.contains(&***n));
        names.extend(more.collect::<Vec<_>>());
    }
    Ok(Value::list(names.into_iter().map(Text::to_value)))
}

fn commands_sub(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2..=3, "info commands ?pattern?")?;
    let pattern = call.get(2).map(Value::as_str);
    let core = &*core;
    qualified_names(core, pattern.as_deref(), |ns| core.ns(ns).commands.iter_hashed().map(|(k, _)| k).collect())
}

fn procs(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2..=3, "info procs ?pattern?")?;
    let pattern = call.get(2).map(Value::as_str);
    let core = &*core;
    let here = core.here();
    let is_proc =
        |id: crate::command::CmdId| matches!(core.table.commands[core.origin_of(id).0 as usize].imp, Imp::Proc(_));
    // Unlike commands, procedures of the global namespace are not listed elsewhere.
    qualified_names(core, pattern.as_deref(), |ns| {
        if ns == NsId::GLOBAL && here != ns && pattern.as_ref().is_none_or(|p| !p.contains("::")) {
            return vec![];
        }
        core.ns(ns).commands.iter_hashed().filter(|(_, id)| is_proc(**id)).map(|(k, _)| k).collect()
    })
}

fn functions(_: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2..=3, "info functions ?pattern?")?;
    let pattern = call.get(2).map(Value::as_str);
    let fits = |name: &&str| pattern.as_ref().is_none_or(|p| glob::matches(p, name));
    Ok(Value::list(func::names().filter(fits).map(Value::from)))
}

fn globals(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2..=3, "info globals ?pattern?")?;
    let pattern = call.get(2).map(Value::as_str);
    let pattern = pattern.as_deref().map(|p| p.trim_start_matches(':'));
    let names = core.ns(NsId::GLOBAL).vars.iter_hashed().filter(|(_, s)| s.exists()).map(|(k, _)| k);
    Ok(Value::list(names.filter(|n| pattern.is_none_or(|p| glob::matches(p, n))).map(Text::to_value)))
}

fn locals(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2..=3, "info locals ?pattern?")?;
    let frame = core.frame();
    if !frame.is_proc {
        return Ok(Value::EMPTY);
    }
    let pattern = call.get(2).map(Value::as_str);
    let own = frame.vars.iter().filter(|(_, s)| !matches!(s, Slot::Link(_)) && s.exists()).map(|(k, _)| k);
    Ok(Value::list(own.filter(|n| pattern.as_ref().is_none_or(|p| glob::matches(p, n))).map(Text::to_value)))
}

fn vars(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2..=3, "info vars ?pattern?")?;
    let pattern = call.get(2).map(Value::as_str);
    let core = &*core;
    let frame = core.frame();
    let list = |ns: NsId| -> Vec<&Text> {
        core.ns(ns).vars.iter_hashed().filter(|(_, s)| s.exists()).map(|(k, _)| k).collect()
    };
    if frame.is_proc && pattern.as_ref().is_none_or(|p| !p.contains("::")) {
        let names = frame.vars.iter().filter(|(_, s)| s.exists()).map(|(k, _)| k);
        return Ok(Value::list(
            names.filter(|n| pattern.as_ref().is_none_or(|p| glob::matches(p, n))).map(Text::to_value),
        ));
    }
    qualified_names(core, pattern.as_deref(), list)
}

fn level(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2..=3, "info level ?number?")?;
    let here = core.frame().level;
    let Some(word) = call.get(2) else { return Ok(Value::from(here)) };
    let number = word.to_i64()?;
    let absolute = if number > 0 { number } else { here as i64 + number };
    let bad = || {
        let message = format!("bad level \"{word}\"");
        Exception::coded(message, &["TCL", "LOOKUP", "STACK_LEVEL", &word.as_str()]).at(call.span(2), "")
    };
    let target = usize::try_from(absolute).ok().filter(|l| *l > 0).ok_or_else(bad)?;
    let frame = core.frame_at(target).ok_or_else(bad)?;
    Ok(Value::list(core.calls.frames[frame].words.iter().cloned()))
}

fn script(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2..=3, "info script ?filename?")?;
    if let Some(name) = call.get(2) {
        if let Some(current) = core.calls.scripts.last_mut() {
            *current = name.clone();
        }
        return Ok(name.clone());
    }
    Ok(core.calls.scripts.last().cloned().unwrap_or_default())
}

/// The place of the command in its file, as far as it is known.
fn frame(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2..=3, "info frame ?number?")?;
    if call.len() == 2 {
        return Ok(Value::from(core.calls.frames.len()));
    }
    let number = call.arg(2).to_i64()?;
    let depth = core.calls.frames.len() as i64;
    if number > depth || number <= -depth {
        let message = format!("bad level \"{number}\"");
        let code = ["TCL", "LOOKUP", "LEVEL", &number.to_string()];
        return Err(Exception::coded(message, &code).at(call.span(2), ""));
    }
    let mut pairs = vec![];
    match call.whole_span().or(core.calls.site) {
        Some(span) => {
            let location = core.sources.location(span);
            pairs.extend([Value::from("type"), Value::from("source")]);
            pairs.extend([Value::from("line"), Value::from(location.line)]);
            pairs.extend([Value::from("file"), Value::from(&*core.absolute(&location.name))]);
        }
        None => {
            pairs.extend([Value::from("type"), Value::from("eval")]);
            pairs.extend([Value::from("line"), Value::from(1i64)]);
        }
    }
    let text = call.source_text().unwrap_or_default();
    pairs.extend([Value::from("cmd"), Value::from(text)]);
    if let Some(word) = core.frame().words.first().filter(|_| core.frame().is_proc) {
        let full = core.find_command(&word.as_str()).map(|id| core.full_name(id));
        pairs.extend([Value::from("proc"), full.map(Value::from).unwrap_or_else(|| word.clone())]);
    }
    pairs.extend([Value::from("level"), Value::from(core.frame().level)]);
    Ok(Value::from(pairs))
}

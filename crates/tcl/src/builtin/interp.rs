//! `interp`, as far as it is about this interpreter: aliases of commands.

use crate::command::{Call, CoreFn, Imp};
use crate::core::Core;
use crate::error::Exception;
use crate::value::Value;

pub(crate) const COMMANDS: &[(&str, CoreFn)] = &[("interp", interp)];

const NAMES: [&str; 22] = [
    "alias",
    "aliases",
    "bgerror",
    "cancel",
    "children",
    "create",
    "debug",
    "delete",
    "eval",
    "exists",
    "expose",
    "hide",
    "hidden",
    "issafe",
    "invokehidden",
    "limit",
    "marktrusted",
    "recursionlimit",
    "slaves",
    "share",
    "target",
    "transfer",
];

fn interp(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2.., "interp cmd ?arg ...?")?;
    let here = |word: usize| call.arg(word).is_empty();
    match NAMES[call.choose(1, "option", &NAMES, false)?] {
        "alias" if here(2) => alias(core, call),
        "aliases" if here(2) => {
            let all = core.table.commands.iter().filter(|c| matches!(c.imp, Imp::Alias(_)));
            Ok(Value::list(all.map(|c| c.name.to_value())))
        }
        "children" | "slaves" if here(2) => Ok(Value::EMPTY),
        "exists" => Ok(Value::from(here(2))),
        "issafe" if here(2) => Ok(Value::from(false)),
        _ => {
            let code = Value::list(["HYSTERON", "REFUSED", "interp"].map(Value::from));
            let message = "interp: interpreters within a script are not supported";
            Err(call.error_at(1, message, "refused").with_code(code))
        }
    }
}

fn alias(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    let usage = "interp alias slavePath slaveCmd ?masterPath masterCmd? ?arg ...?";
    call.expect(4.., usage)?;
    let name = call.arg(3).as_str();
    let path = format!("::{}", name.trim_start_matches(':'));
    let known = core.find_command(&path).filter(|id| matches!(core.table.commands[id.0 as usize].imp, Imp::Alias(_)));
    let missing = || {
        let code = ["TCL", "LOOKUP", "ALIAS", &name];
        Exception::coded(format!("alias \"{name}\" not found"), &code).at(call.span(3), "")
    };
    if call.len() == 4 {
        return match known.map(|id| &core.table.commands[id.0 as usize].imp) {
            Some(Imp::Alias(words)) => Ok(Value::list(words.iter().cloned())),
            _ => Ok(Value::EMPTY),
        };
    }
    if !call.arg(4).is_empty() || (call.len() == 5 && known.is_none()) {
        return Err(if call.arg(4).is_empty() { missing() } else { call.wrong_args(usage) });
    }
    if call.len() == 5 {
        known.into_iter().for_each(|id| core.delete_command(id));
        return Ok(Value::EMPTY);
    }
    let (ns, tail) = core.place_for(&path);
    core.define(ns, &tail, Imp::Alias(call.from(5).into()));
    Ok(Value::from(&*name))
}

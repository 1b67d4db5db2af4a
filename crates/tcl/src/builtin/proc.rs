//! `proc`, `apply`, `rename`, `tailcall`.

use std::rc::Rc;

use crate::command::{Call, CommandFn, Imp, Proc};
use crate::core::NsId;
use crate::error::Exception;
use crate::interp::Interp;
use crate::value::Value;

pub(crate) fn commands<H>() -> [(&'static str, CommandFn<H>); 6] {
    [
        ("apply", apply),
        ("proc", proc),
        ("rename", rename),
        ("tailcall", tailcall),
        ("coroutine", |_, call| Err(refuse_coroutine(call))),
        ("yield", |_, call| Err(refuse_coroutine(call))),
    ]
}

fn refuse_coroutine(call: &Call<'_>) -> Exception {
    call.error_at(0, format!("{}: coroutines are not supported", call.name()), "not supported")
}

fn proc<H>(interp: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(4..=4, "proc name args body")?;
    let name = call.arg(1).as_str();
    if let Some((path, _)) = crate::vars::split_qualified(&name)
        && !path.is_empty()
        && interp.core.existing_place_for(&name).is_none()
    {
        let message = format!("can't create procedure \"{name}\": unknown namespace");
        return Err(Exception::coded(message, &["TCL", "VALUE", "COMMAND"]));
    }
    let (ns, tail) = interp.core.place_for(&name);
    let proc = Proc::new(ns, call.arg(2), call.arg(3)).map_err(|e| e.at(call.span(2), ""))?;
    interp.core.define(ns, &tail, Imp::Proc(Rc::new(proc)));
    Ok(Value::EMPTY)
}

fn apply<H>(interp: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2.., "apply lambdaExpr ?arg ...?")?;
    let lambda = call.arg(1);
    let bad = || {
        let message = format!("can't interpret \"{lambda}\" as a lambda expression");
        Exception::coded(message, &["TCL", "VALUE", "LAMBDA"]).at(call.span(1), "")
    };
    let parts = lambda.to_list().map_err(|_| bad())?;
    let (params, body, ns) = match &*parts {
        [params, body] => (params, body, NsId::GLOBAL),
        [params, body, ns] => {
            let path = format!("::{}", ns.as_str().trim_start_matches(':'));
            (params, body, interp.core.namespace_named(&path)?)
        }
        _ => return Err(bad()),
    };
    let proc = Rc::new(Proc::new(ns, params, body)?);
    let mut argv = interp.core.take_words();
    argv.extend_from_slice(call.from(0));
    let shown: String = lambda.as_str().chars().take(60).collect();
    let dots = if lambda.char_count() > 60 { "..." } else { "" };
    interp.call_body(
        &proc,
        argv,
        2,
        None,
        |_| "apply lambdaExpr".to_owned(),
        |_, line| format!("lambda term \"{shown}{dots}\" line {line}"),
    )
}

fn rename<H>(interp: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(3..=3, "rename oldName newName")?;
    let (old, new) = (call.arg(1).as_str(), call.arg(2).as_str());
    let core = &mut interp.core;
    let Some(id) = core.find_command(&old) else {
        let doing = if new.is_empty() { "delete" } else { "rename" };
        let near = if core.calls.catching > 0 { None } else { core.nearest_command(&old) };
        let message = format!("can't {doing} \"{old}\": command doesn't exist");
        let e = Exception::coded(message, &["TCL", "LOOKUP", "COMMAND", &old]);
        return Err(e.at(call.span(1), "no such command").suggest(&old, near));
    };
    if new.is_empty() {
        core.delete_command(id);
        return Ok(Value::EMPTY);
    }
    let (ns, tail) = core.place_for(&new);
    if core.ns(ns).commands.contains(&tail) {
        let message = format!("can't rename to \"{new}\": command already exists");
        return Err(Exception::coded(message, &["TCL", "OPERATION", "RENAME", "TARGET_EXISTS"]));
    }
    core.move_command(id, ns, &tail);
    Ok(Value::EMPTY)
}

fn tailcall<H>(interp: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    if !interp.core.frame().is_proc {
        let message = "tailcall can only be called from a proc, lambda or method";
        return Err(Exception::coded(message, &["TCL", "TAILCALL", "ILLEGAL"]));
    }
    interp.core.calls.tailcall = Some(call.args().to_vec());
    Err(Exception::Return(Value::EMPTY))
}

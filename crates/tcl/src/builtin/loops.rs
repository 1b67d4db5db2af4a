//! `while`, `for`, `foreach`, `lmap`.

use std::rc::Rc;

use crate::command::{Call, CommandFn};
use crate::error::Exception;
use crate::eval::script_of;
use crate::interp::Interp;
use crate::list::List;
use crate::value::Value;
use crate::vars::VarName;

pub(crate) fn commands<H>() -> [(&'static str, CommandFn<H>); 4] {
    [
        ("for", for_command),
        ("foreach", |interp, call| each(interp, call, "foreach")),
        ("lmap", |interp, call| each(interp, call, "lmap")),
        ("while", while_command),
    ]
}

/// Returns true if a loop continues after this result of its body.
fn goes_on(result: Result<Value, Exception>) -> Result<bool, Exception> {
    match result {
        Ok(_) | Err(Exception::Continue) => Ok(true),
        Err(Exception::Break) => Ok(false),
        Err(e) => Err(e),
    }
}

fn while_command<H>(interp: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(3..=3, "while test command")?;
    let (test, body) = (call.arg(1), call.arg(2));
    let script = script_of(body);
    while interp.condition(test).map_err(|e| e.at(call.span(1), ""))? {
        interp.core.tick()?;
        if !goes_on(interp.body_again(&script, body, "\"while\" body"))? {
            break;
        }
    }
    Ok(Value::EMPTY)
}

fn for_command<H>(interp: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(5..=5, "for start test next command")?;
    let (test, next, body) = (call.arg(2), call.arg(3), call.arg(4));
    interp.body(call, 1, "\"for\" initial command")?;
    let script = script_of(body);
    let step = script_of(next);
    while interp.condition(test).map_err(|e| e.at(call.span(2), ""))? {
        interp.core.tick()?;
        if !goes_on(interp.body_again(&script, body, "\"for\" body"))? {
            break;
        }
        match interp.body_again(&step, next, "\"for\" loop-end command") {
            Ok(_) => {}
            Err(Exception::Break) => break,
            Err(e) => return Err(e),
        }
    }
    Ok(Value::EMPTY)
}

fn each<H>(interp: &mut Interp<H>, call: &Call<'_>, name: &str) -> Result<Value, Exception> {
    if call.len() < 4 || call.len() % 2 == 1 {
        return Err(call.wrong_args(&format!("{name} varList list ?varList list ...? command")));
    }
    let mut lists: Vec<(Vec<Rc<VarName>>, List)> = vec![];
    let mut rounds = 0;
    for i in (1..call.len() - 1).step_by(2) {
        let names = call.arg(i).to_list()?;
        if names.is_empty() {
            let message = format!("{name} varlist is empty");
            let code = ["TCL", "OPERATION", &name.to_uppercase(), "NEEDVARS"];
            return Err(Exception::coded(message, &code).at(call.span(i), "names of variables belong here"));
        }
        let items = call.arg(i + 1).to_list()?;
        rounds = rounds.max(items.len().div_ceil(names.len()));
        lists.push((names.iter().map(VarName::of).collect(), items));
    }
    let body = call.arg(call.len() - 1);
    let script = script_of(body);
    let what = if name == "lmap" { "\"lmap\" body" } else { "\"foreach\" body" };
    let mut collected = vec![];
    for round in 0..rounds {
        interp.core.tick()?;
        for (names, items) in &lists {
            for (i, name) in names.iter().enumerate() {
                let value = items.get(round * names.len() + i).cloned().unwrap_or_default();
                interp.core.assign(name, value)?;
            }
        }
        match interp.body_again(&script, body, what) {
            Ok(value) => {
                if name == "lmap" {
                    collected.push(value);
                }
            }
            Err(Exception::Continue) => {}
            Err(Exception::Break) => break,
            Err(e) => return Err(e),
        }
    }
    Ok(Value::from(collected))
}

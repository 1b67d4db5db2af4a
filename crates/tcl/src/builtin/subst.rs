//! `subst`.

use std::rc::Rc;

use crate::ast::{Part, Unit};
use crate::command::{Call, CommandFn};
use crate::error::Exception;
use crate::interp::Interp;
use crate::lexer::{Lexer, Substitutions};
use crate::value::Value;

pub(crate) fn commands<H>() -> [(&'static str, CommandFn<H>); 1] {
    [("subst", subst)]
}

fn subst<H>(interp: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2.., "subst ?-nobackslashes? ?-nocommands? ?-novariables? string")?;
    let mut which = Substitutions { backslashes: true, commands: true, variables: true };
    let last = call.len() - 1;
    for i in 1..last {
        match call.choose(i, "option", &["-nobackslashes", "-nocommands", "-novariables"], false)? {
            0 => which.backslashes = false,
            1 => which.commands = false,
            _ => which.variables = false,
        }
    }
    let value = call.arg(last);
    let unit = Rc::new(Unit { text: (*value.as_str()).into(), origin: value.origin().cloned() });
    let (parts, error) = Lexer::new(&unit).template(which);
    let mut out = String::new();
    for part in &parts {
        let result = match part {
            Part::Text(text) => {
                out.push_str(text);
                continue;
            }
            Part::Var(var) => interp.variable(&unit, var),
            Part::Script(script) => interp.run(script),
        };
        match result {
            Ok(value) | Err(Exception::Return(value) | Exception::Other(_, value)) => value.write_to(&mut out),
            Err(Exception::ReturnWith(returned)) => returned.value.write_to(&mut out),
            Err(Exception::Continue) => {}
            Err(Exception::Break) => return Ok(Value::from(out)),
            Err(e) => return Err(e.at(call.span(last), "")),
        }
    }
    match error {
        None => Ok(Value::from(out)),
        Some(e) => {
            let span = unit.span(e.start, e.end).or(call.span(last));
            Err(Exception::error(e.message).at(span, e.label))
        }
    }
}

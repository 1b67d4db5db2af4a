//! `catch`, `try`, `throw`, `error`: making and handling errors.

use crate::command::{Call, CommandFn};
use crate::core::Core;
use crate::dict::Dict;
use crate::error::Exception;
use crate::interp::Interp;
use crate::table::Table;
use crate::value::Value;
use crate::vars::VarName;

pub(crate) fn commands<H>() -> [(&'static str, CommandFn<H>); 4] {
    [("catch", catch), ("error", error), ("throw", throw), ("try", try_command)]
}

fn error<H>(_: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2..=4, "error message ?errorInfo? ?errorCode?")?;
    let mut e = Exception::error_value(call.arg(1).clone()).at(call.whole_span(), "");
    if let Some(code) = call.get(3) {
        e = e.with_code(code.clone());
    }
    let info = call.arg(2).as_str().into_owned();
    Err(if info.is_empty() {
        e
    } else {
        e.map_error(|e| {
            e.error_info = info;
            // The first command of the trace is given with it.
            e.traced = true;
        })
    })
}

fn throw<H>(_: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(3..=3, "throw type message")?;
    if call.arg(1).to_list()?.is_empty() {
        return Err(Exception::coded("type must be non-empty list", &["TCL", "OPERATION", "THROW", "BADEXCEPTION"]));
    }
    Err(Exception::error_value(call.arg(2).clone()).with_code(call.arg(1).clone()).at(call.whole_span(), ""))
}

/// Result of a script in the form that `catch` returns.
struct Outcome {
    code: i32,
    value: Value,
    options: Dict,
    /// The exception, to be raised again if no handler matches.
    exception: Option<Exception>,
}

impl Core {
    /// Split the result of a script into code, value and options. `exit` and an interrupt cannot be caught.
    fn outcome(&mut self, result: Result<Value, Exception>) -> Result<Outcome, Exception> {
        let mut table: Table<Value> = Table::default();
        let mut set = |key: &str, value: Value| {
            table.insert(key.into(), value);
        };
        let (code, value) = match &result {
            Ok(value) => {
                set("-code", Value::from(0i64));
                set("-level", Value::from(0i64));
                (0, value.clone())
            }
            Err(Exception::Error(e)) => {
                let info = if e.error_info.is_empty() { e.result.clone() } else { Value::from(e.error_info.as_str()) };
                let code = e.error_code.clone().unwrap_or_else(|| Value::from("NONE"));
                set("-code", Value::from(1i64));
                set("-level", Value::from(0i64));
                for (key, value) in &e.options {
                    set(&key.as_str(), value.clone());
                }
                set("-errorcode", code.clone());
                set("-errorinfo", info.clone());
                set("-errorline", Value::from(e.line));
                let value = e.result.clone();
                self.set_global("errorInfo", info)?;
                self.set_global("errorCode", code)?;
                (1, value)
            }
            Err(Exception::Return(value)) => {
                set("-code", Value::from(0i64));
                set("-level", Value::from(1i64));
                (2, value.clone())
            }
            Err(Exception::ReturnWith(r)) => {
                for (key, value) in &r.options {
                    set(&key.as_str(), value.clone());
                }
                set("-code", Value::from(i64::from(r.code)));
                set("-level", Value::from(r.level));
                (2, r.value.clone())
            }
            Err(Exception::Exit(status)) => return Err(Exception::Exit(*status)),
            Err(Exception::Interrupted) => return Err(Exception::Interrupted),
            Err(Exception::Break) => {
                set("-code", Value::from(3i64));
                set("-level", Value::from(0i64));
                (3, Value::EMPTY)
            }
            Err(Exception::Continue) => {
                set("-code", Value::from(4i64));
                set("-level", Value::from(0i64));
                (4, Value::EMPTY)
            }
            Err(Exception::Other(code, value)) => {
                set("-code", Value::from(i64::from(*code)));
                set("-level", Value::from(0i64));
                (*code, value.clone())
            }
        };
        Ok(Outcome { code, value, options: Dict::from_table(table), exception: result.err() })
    }
}

fn catch<H>(interp: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2..=4, "catch script ?resultVarName? ?optionVarName?")?;
    interp.core.calls.catching += 1;
    let count = !interp.core.calls.compiled;
    let result = if count { interp.core.enter() } else { Ok(()) };
    let result = match result {
        Ok(()) => {
            let result = interp.body(call, 1, "\"catch\" body");
            interp.core.calls.levels -= usize::from(count);
            result
        }
        Err(e) => Err(e),
    };
    interp.core.calls.catching -= 1;
    let outcome = interp.core.outcome(result)?;
    if let Some(name) = call.get(2) {
        let name = VarName::of(name);
        interp.core.assign(&name, outcome.value)?;
    }
    if let Some(name) = call.get(3) {
        let name = VarName::of(name);
        interp.core.assign(&name, outcome.options.into())?;
    }
    Ok(Value::from(i64::from(outcome.code)))
}

/// A handler of `try`.
struct Handler {
    condition: Condition,
    vars: Value,
    /// Index of the word that is its body.
    body: usize,
}

enum Condition {
    Code(i32),
    Error(Value),
}

fn bad_handler(message: String, code: &[&str]) -> Exception {
    Exception::coded(message, &[&["TCL", "OPERATION", "TRY"], code].concat())
}

/// The handlers and the word of the `finally` body.
fn handlers(call: &Call<'_>) -> Result<(Vec<Handler>, Option<usize>), Exception> {
    let mut all = vec![];
    let mut i = 2;
    while i < call.len() {
        match call.choose(i, "handler type", &["finally", "on", "trap"], false)? {
            0 => {
                if i + 2 != call.len() {
                    let (message, code) = if call.len() == i + 1 {
                        ("wrong # args to finally clause: must be \"... finally script\"", "ARGUMENT")
                    } else {
                        ("finally clause must be last", "NONTERMINAL")
                    };
                    return Err(bad_handler(message.to_owned(), &["FINALLY", code]));
                }
                return Ok((all, Some(i + 1)));
            }
            kind => {
                if call.len() < i + 4 {
                    let (message, clause) = if kind == 1 {
                        ("wrong # args to on clause: must be \"... on code variableList script\"", "ON")
                    } else {
                        ("wrong # args to trap clause: must be \"... trap pattern variableList script\"", "TRAP")
                    };
                    return Err(bad_handler(message.to_owned(), &[clause, "ARGUMENT"]));
                }
                let condition = if kind == 1 {
                    let names = ["ok", "error", "return", "break", "continue"];
                    let word = call.arg(i + 1);
                    let code = names.iter().position(|n| *n == word.as_str()).map(|c| c as i32);
                    match code.or_else(|| word.to_i64().ok().and_then(|c| i32::try_from(c).ok())) {
                        Some(code) => Condition::Code(code),
                        None => {
                            let list = "ok, error, return, break, continue, or an integer";
                            let message = format!("bad completion code \"{word}\": must be {list}");
                            return Err(Exception::coded(message, &["TCL", "RESULT", "ILLEGAL_CODE"]));
                        }
                    }
                } else {
                    if call.arg(i + 1).to_list().is_err() {
                        let message = format!("bad prefix '{}': must be a list", call.arg(i + 1));
                        return Err(bad_handler(message, &["TRAP", "EXNFORMAT"]));
                    }
                    Condition::Error(call.arg(i + 1).clone())
                };
                all.push(Handler { condition, vars: call.arg(i + 2).clone(), body: i + 3 });
                i += 4;
            }
        }
    }
    if let Some(last) = all.last()
        && call.arg(last.body).as_str() == "-"
    {
        let message = "last non-finally clause must not have a body of \"-\"".to_owned();
        return Err(bad_handler(message, &["BADFALLTHROUGH"]));
    }
    Ok((all, None))
}

fn try_command<H>(interp: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2.., "try body ?handler ...? ?finally script?")?;
    let (handlers, finally) = handlers(call)?;
    interp.core.calls.catching += usize::from(!handlers.is_empty());
    let result = interp.body(call, 1, "\"try\" body");
    interp.core.calls.catching -= usize::from(!handlers.is_empty());
    let result = handle(interp, call, &handlers, result);
    let Some(body) = finally else { return result };
    if matches!(result, Err(Exception::Exit(_) | Exception::Interrupted)) {
        return result;
    }
    match interp.body(call, body, "\"try ... finally\" body") {
        Ok(_) => result,
        Err(e) => Err(e),
    }
}

fn handle<H>(
    interp: &mut Interp<H>,
    call: &Call<'_>,
    handlers: &[Handler],
    result: Result<Value, Exception>,
) -> Result<Value, Exception> {
    if handlers.is_empty() {
        return result;
    }
    let outcome = interp.core.outcome(result)?;
    let code = match &outcome.exception {
        Some(Exception::Error(e)) => e.error_code.clone().unwrap_or_else(|| Value::from("NONE")),
        _ => Value::EMPTY,
    };
    let fits = |h: &Handler| match &h.condition {
        Condition::Code(code) => *code == outcome.code,
        Condition::Error(prefix) => {
            let prefix = prefix.to_list().unwrap_or_default();
            outcome.code == 1 && code.to_list().is_ok_and(|c| c.starts_with(&prefix))
        }
    };
    let Some(chosen) = handlers.iter().position(fits) else {
        return match outcome.exception {
            Some(e) => Err(e),
            None => Ok(outcome.value),
        };
    };
    let names = handlers[chosen].vars.to_list()?;
    let values = [outcome.value.clone(), outcome.options.clone().into()];
    for (name, value) in names.iter().zip(values) {
        let name = VarName::of(name);
        interp.core.assign(&name, value)?;
    }
    let body = handlers[chosen..].iter().find(|h| call.arg(h.body).as_str() != "-");
    let Some(body) = body else { return Ok(Value::EMPTY) };
    let result = interp.body(call, body.body, "\"try\" handler");
    result.map_err(|e| {
        e.map_error(|e| {
            e.options.push((Value::from("-during"), outcome.options.into()));
        })
    })
}

//! `if`, `eval`, `expr`, `return`, `exit` and other commands that decide what runs.

use crate::ast::Script;
use crate::command::{Call, CommandFn};
use crate::error::{Exception, Returned};
use crate::interp::Interp;
use crate::proc::finish;
use crate::value::Value;

pub(crate) fn commands<H>() -> [(&'static str, CommandFn<H>); 9] {
    [
        ("break", |_, call| {
            call.expect(1..=1, "break")?;
            Err(Exception::Break)
        }),
        ("continue", |_, call| {
            call.expect(1..=1, "continue")?;
            Err(Exception::Continue)
        }),
        ("eval", eval),
        ("exit", exit),
        ("expr", expr),
        ("if", if_command),
        ("return", return_command),
        ("source", source),
        ("uplevel", uplevel),
    ]
}

impl<H> Interp<H> {
    /// Run a body that is a word of a command; `what` is how `$errorInfo` calls it.
    pub(crate) fn body(&mut self, call: &Call<'_>, word: usize, what: &str) -> Result<Value, Exception> {
        let body = call.arg(word);
        let result = self.body_from(call, word, body);
        result.map_err(|e| self.core.trace_body(e, body, what))
    }

    /// Run a script that was put together from the words of a call from `word` on.
    pub(crate) fn dynamic(
        &mut self,
        call: &Call<'_>,
        word: usize,
        body: &Value,
        what: &str,
    ) -> Result<Value, Exception> {
        let result = self.body_from(call, word, body);
        result.map_err(|e| self.core.trace_always(e, body, what))
    }

    /// Run a body; errors in a text that was put together at run time point at the word that it came from.
    fn body_from(&mut self, call: &Call<'_>, word: usize, body: &Value) -> Result<Value, Exception> {
        let outer = self.core.calls.site;
        if body.origin().is_none()
            && let Some(span) = call.span(word)
        {
            self.core.calls.site = Some(span);
        }
        let compiled = std::mem::replace(&mut self.core.calls.compiled, true);
        let result = self.eval_body(body);
        self.core.calls.compiled = compiled;
        let result = result.map_err(|e| self.core.settle_place(e, None));
        self.core.calls.site = outer;
        result
    }

    /// As [`Interp::body`], for the parsed form of a body that runs often.
    pub(crate) fn body_again(&mut self, script: &Script, body: &Value, what: &str) -> Result<Value, Exception> {
        let compiled = std::mem::replace(&mut self.core.calls.compiled, true);
        let result = self.run(script);
        self.core.calls.compiled = compiled;
        result.map_err(|e| self.core.trace_body(e, body, what))
    }
}

impl crate::core::Core {
    /// Tell in `$errorInfo` in which body an error happened, where Tcl would.
    pub(crate) fn trace_body(&self, e: Exception, body: &Value, what: &str) -> Exception {
        let Exception::Error(e) = e else { return e };
        if self.calls.compiled {
            return Exception::Error(e);
        }
        self.trace_always(Exception::Error(e), body, what)
    }

    pub(crate) fn trace_always(&self, e: Exception, body: &Value, what: &str) -> Exception {
        let Exception::Error(e) = e else { return e };
        let span = body.origin().map(|o| o.span(0, body.as_str().len() as u32));
        let line = self.line_within(&e, span);
        Exception::Error(e).trace(|_| format!("{what} line {line}"))
    }
}

/// The words from `i` on as one script or expression.
pub(crate) fn concat(call: &Call<'_>, i: usize) -> Value {
    match call.from(i) {
        [one] => one.clone(),
        words => super::list::concat(words),
    }
}

fn eval<H>(interp: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(2.., "eval arg ?arg ...?")?;
    interp.core.enter()?;
    let body = concat(call, 1);
    let result = interp.dynamic(call, 1, &body, "\"eval\" body");
    interp.core.calls.levels -= 1;
    result
}

fn exit<H>(_: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    call.expect(1..=2, "exit ?returnCode?")?;
    let code = match call.get(1) {
        None => 0,
        Some(code) => code.to_i64()?,
    };
    Err(Exception::Exit(code as i32))
}

fn expr<H>(interp: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    let result = match call.args() {
        [] => return Err(call.wrong_args("expr arg ?arg ...?")),
        [one] => interp.expr(one),
        words => {
            let mut text = String::new();
            for (i, word) in words.iter().enumerate() {
                if i > 0 {
                    text.push(' ');
                }
                word.write_to(&mut text);
            }
            interp.expr_text(&text)
        }
    };
    result.map_err(|e| e.at(call.span(1), ""))
}

/// The clauses of an `if`: the word of each condition (none for `else`) and that of its body. All words are checked
/// before anything is evaluated.
fn next_clause(call: &Call<'_>, at: &mut usize) -> Result<Option<(Option<usize>, usize)>, Exception> {
    let wrong = |i: usize, message: String| Exception::coded(message, &["TCL", "WRONGARGS"]).at(call.span(i), "");
    let no_script = |i: usize| wrong(i, format!("wrong # args: no script following \"{}\" argument", call.arg(i)));
    let is = |i: usize, word: &str| call.get(i).is_some_and(|w| w.as_str() == word);
    let mut i = *at;
    if i > 1 {
        if call.get(i).is_none() {
            return Ok(None);
        }
        if !is(i, "elseif") {
            i += usize::from(is(i, "else"));
            if call.get(i).is_none() {
                return Err(no_script(i - 1));
            }
            if call.len() > i + 1 {
                let message = "wrong # args: extra words after \"else\" clause in \"if\" command";
                return Err(wrong(i + 1, message.to_owned()));
            }
            *at = i + 1;
            return Ok(Some((None, i)));
        }
        i += 1;
    }
    let condition = i;
    if call.get(i).is_none() {
        let message = format!("wrong # args: no expression after \"{}\" argument", call.arg(i - 1));
        return Err(wrong(i - 1, message));
    }
    i += 1;
    i += usize::from(is(i, "then"));
    if call.get(i).is_none() {
        return Err(no_script(i - 1));
    }
    *at = i + 1;
    Ok(Some((Some(condition), i)))
}

fn if_command<H>(interp: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    let mut at = 1;
    while next_clause(call, &mut at)?.is_some() {}
    at = 1;
    while let Some((condition, body)) = next_clause(call, &mut at)? {
        let Some(word) = condition else { return interp.body(call, body, "\"if\" else script") };
        if interp.condition(call.arg(word)).map_err(|e| e.at(call.span(word), ""))? {
            return interp.body(call, body, "\"if\" then script");
        }
    }
    Ok(Value::EMPTY)
}

/// The number of a code given by name or number.
fn code_of(value: &Value) -> Result<i32, Exception> {
    let names = ["ok", "error", "return", "break", "continue"];
    if let Some(code) = names.iter().position(|n| *n == value.as_str()) {
        return Ok(code as i32);
    }
    value.to_i64().ok().and_then(|c| i32::try_from(c).ok()).ok_or_else(|| {
        let list = "ok, error, return, break, continue, or an integer";
        let message = format!("bad completion code \"{value}\": must be {list}");
        Exception::coded(message, &["TCL", "RESULT", "ILLEGAL_CODE"])
    })
}

fn return_command<H>(_: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    match call.args() {
        [] => return Err(Exception::Return(Value::EMPTY)),
        [value] => return Err(Exception::Return(value.clone())),
        _ => {}
    }
    let words = call.args();
    let pairs = words.len() / 2;
    let value = if words.len() % 2 == 1 { words.last().cloned().unwrap_or_default() } else { Value::EMPTY };
    let mut options: Vec<(Value, Value)> = vec![];
    let mut set = |key: &Value, value: &Value| {
        options.retain(|(k, _)| k != key);
        options.push((key.clone(), value.clone()));
    };
    for pair in words[..pairs * 2].chunks_exact(2) {
        let [key, value] = pair else { continue };
        if key.as_str() == "-options" {
            let dict = value.to_dict().map_err(|_| {
                let message = format!("expected dict but got \"{value}\"");
                Exception::coded(message, &["TCL", "RESULT", "ILLEGAL_OPTIONS"])
            })?;
            for (key, value) in dict.iter() {
                set(&key.to_value(), value);
            }
        } else {
            set(key, value);
        }
    }
    let mut take = |name: &str| {
        let at = options.iter().position(|(k, _)| k.as_str() == name)?;
        Some(options.remove(at).1)
    };
    let mut code = match take("-code") {
        Some(code) => code_of(&code)?,
        None => 0,
    };
    let mut level = match take("-level") {
        None => 1,
        Some(v) => match v.to_i64() {
            Ok(level @ 0..) => level as usize,
            _ => {
                let message = format!("bad -level value: expected non-negative integer but got \"{v}\"");
                return Err(Exception::coded(message, &["TCL", "RESULT", "ILLEGAL_LEVEL"]));
            }
        },
    };
    if code == 2 {
        // `-code return` leaves one procedure more.
        code = 0;
        level += 1;
    }
    if let Some((_, list)) = options.iter().find(|(k, _)| k.as_str() == "-errorcode")
        && list.to_list().is_err()
    {
        let message = format!("bad -errorcode value: expected a list but got \"{list}\"");
        return Err(Exception::coded(message, &["TCL", "RESULT", "ILLEGAL_ERRORCODE"]));
    }
    let returned = Returned { value, code, level, options };
    match (level, code) {
        (0, _) => finish(returned),
        (1, 0) if returned.options.is_empty() => Err(Exception::Return(returned.value)),
        _ => Err(Exception::ReturnWith(Box::new(returned))),
    }
}

fn source<H>(interp: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    let path = match call.args() {
        [path] => path,
        [option, _, path] if option.as_str() == "-encoding" => path,
        [option, _, _] => {
            let message = format!("bad option \"{option}\": must be -encoding");
            return Err(call.error_at(1, message, ""));
        }
        _ => return Err(call.wrong_args("source ?-encoding name? fileName")),
    };
    let path = path.as_str();
    interp.source(&path, &path)
}

fn uplevel<H>(interp: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    let usage = "uplevel ?level? command ?arg ...?";
    call.expect(2.., usage)?;
    let level = call.arg(1).as_str();
    let (frame, from) = match interp.core.find_level(&level) {
        // A lone word is the script, whatever it looks like.
        Some(frame) if call.len() > 2 || level.starts_with('#') => (frame?, 2),
        _ => (default_level(interp)?, 1),
    };
    if call.len() == from {
        return Err(call.wrong_args(usage));
    }
    interp.core.enter()?;
    let body = concat(call, from);
    let active = std::mem::replace(&mut interp.core.calls.active, frame);
    let result = interp.dynamic(call, from, &body, "\"uplevel\" body");
    interp.core.calls.active = active;
    interp.core.calls.levels -= 1;
    result
}

/// The frame one level up.
pub(crate) fn default_level<H>(interp: &Interp<H>) -> Result<usize, Exception> {
    let level = interp.core.frame().level;
    let up = level.checked_sub(1).and_then(|l| interp.core.frame_at(l));
    up.ok_or_else(|| Exception::coded("bad level \"1\"", &["TCL", "LOOKUP", "LEVEL", "1"]))
}

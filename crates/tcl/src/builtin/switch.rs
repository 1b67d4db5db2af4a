//! `switch`.

use crate::command::{Call, CommandFn};
use crate::error::Exception;
use crate::glob;
use crate::interp::Interp;
use crate::list::List;
use crate::regex::{self, Flags};
use crate::value::Value;
use crate::vars::VarName;

pub(crate) fn commands<H>() -> [(&'static str, CommandFn<H>); 1] {
    [("switch", switch)]
}

const OPTIONS: [&str; 7] = ["-exact", "-glob", "-indexvar", "-matchvar", "-nocase", "-regexp", "--"];
const USAGE: &str = "switch ?-option ...? string ?pattern body ...? ?default body?";

#[derive(Clone, Copy, PartialEq)]
enum Mode {
    Exact,
    Glob,
    Regexp,
}

fn refuse(message: String, kind: &str) -> Exception {
    Exception::coded(message, &["TCL", "OPERATION", "SWITCH", kind])
}

fn switch<H>(interp: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    let mut mode: Option<Mode> = None;
    let mut nocase = false;
    let mut match_var = None;
    let mut index_var = None;
    let mut i = 1;
    while i + 2 < call.len() && call.arg(i).as_str().starts_with('-') {
        let option = call.choose(i, "option", &OPTIONS, false)?;
        let named = match option {
            0 => Some(Mode::Exact),
            1 => Some(Mode::Glob),
            5 => Some(Mode::Regexp),
            _ => None,
        };
        if let Some(named) = named {
            if let Some(before) = mode {
                let before = match before {
                    Mode::Exact => "-exact",
                    Mode::Glob => "-glob",
                    Mode::Regexp => "-regexp",
                };
                let message = format!("bad option \"{}\": {before} option already found", call.arg(i));
                return Err(refuse(message, "DOUBLEOPT"));
            }
            mode = Some(named);
        }
        match option {
            2 | 3 => {
                let Some(name) = call.get(i + 1).filter(|_| i + 3 < call.len()) else {
                    let message = format!("missing variable name argument to {} option", OPTIONS[option]);
                    return Err(refuse(message, "NOVAR"));
                };
                if option == 2 {
                    index_var = Some(VarName::of(name));
                } else {
                    match_var = Some(VarName::of(name));
                }
                i += 1;
            }
            4 => nocase = true,
            6 => {
                i += 1;
                break;
            }
            _ => {}
        }
        i += 1;
    }
    let mode = mode.unwrap_or(Mode::Exact);
    if mode != Mode::Regexp && (index_var.is_some() || match_var.is_some()) {
        let option = if index_var.is_some() { "-indexvar" } else { "-matchvar" };
        return Err(refuse(format!("{option} option requires -regexp option"), "MODERESTRICTION"));
    }
    if call.len() < i + 2 {
        return Err(call.wrong_args(USAGE));
    }
    let subject = call.arg(i);
    let arms_at = i + 1;
    let split = call.len() == arms_at + 1;
    let arms = if split { call.arg(arms_at).to_list()? } else { List::from(call.from(arms_at).to_vec()) };
    if split && arms.is_empty() {
        return Err(call.wrong_args("switch ?-option ...? string {?pattern body ...? ?default body?}"));
    }
    if arms.len() % 2 == 1 {
        let mut message = "extra switch pattern with no body".to_owned();
        let comment = arms.iter().step_by(2).any(|p| p.as_str().starts_with('#'));
        if split && comment {
            message.push_str(", this may be due to a comment incorrectly placed outside of a switch body - see the \"switch\" documentation");
        }
        return Err(refuse(message, "BADARM"));
    }
    if let Some([pattern, body]) = arms.chunks_exact(2).next_back()
        && body.as_str() == "-"
    {
        let message = format!("no body specified for pattern \"{pattern}\"");
        let code = ["TCL", "OPERATION", "SWITCH", "BADARM", "FALLTHROUGH"];
        return Err(Exception::coded(message, &code));
    }
    let count = arms.len() / 2;
    for (n, arm) in arms.chunks_exact(2).enumerate() {
        let [pattern, _] = arm else { continue };
        let is_default = n + 1 == count && pattern.as_str() == "default";
        let found = if is_default {
            if let Some(name) = &match_var {
                interp.core.assign(name, Value::EMPTY)?;
            }
            if let Some(name) = &index_var {
                interp.core.assign(name, Value::EMPTY)?;
            }
            true
        } else {
            match mode {
                Mode::Exact if nocase => pattern.as_str().to_lowercase() == subject.as_str().to_lowercase(),
                Mode::Exact => pattern == subject,
                Mode::Glob if nocase => glob::matches_nocase(&pattern.as_str(), &subject.as_str()),
                Mode::Glob => glob::matches(&pattern.as_str(), &subject.as_str()),
                Mode::Regexp => {
                    let regex = regex::compile(pattern, Flags { nocase, ..Flags::default() })?;
                    let text = subject.as_str();
                    match regex.find(&text, 0)? {
                        None => false,
                        Some(groups) => {
                            if let Some(name) = &match_var {
                                let texts = groups.iter().map(|g| Value::from(g.map_or("", |(s, e)| &text[s..e])));
                                interp.core.assign(name, Value::list(texts))?;
                            }
                            if let Some(name) = &index_var {
                                let places = groups.iter().map(|g| super::regexp::indices(&text, *g));
                                interp.core.assign(name, Value::list(places))?;
                            }
                            true
                        }
                    }
                }
            }
        };
        if !found {
            continue;
        }
        let bodies = arms.chunks_exact(2).enumerate().skip(n);
        let Some((at, body)) = bodies.map(|(at, arm)| (at, &arm[1])).find(|(_, body)| body.as_str() != "-") else {
            return Ok(Value::EMPTY);
        };
        let shown: String = pattern.as_str().chars().take(50).collect();
        let what = format!("\"{shown}\" arm");
        if !split {
            return interp.body(call, arms_at + at * 2 + 1, &what);
        }
        let script = crate::eval::script_of(body);
        return interp.body_again(&script, body, &what);
    }
    Ok(Value::EMPTY)
}

//! `switch`.

use crate::command::{Call, CommandFn};
use crate::core::Core;
use crate::error::Exception;
use crate::glob;
use crate::interp::Interp;
use crate::list::List;
use crate::regex::{self, Flags};
use crate::value::Value;
use crate::vars::VarName;
use std::rc::Rc;

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

/// Options of the command.
struct Options {
    mode: Mode,
    nocase: bool,
    match_var: Option<Rc<VarName>>,
    index_var: Option<Rc<VarName>>,
}

impl Options {
    /// Take the options, and the index of the word after them.
    fn take(call: &Call<'_>) -> Result<(Self, usize), Exception> {
        let mut mode: Option<Mode> = None;
        let mut options = Options { mode: Mode::Exact, nocase: false, match_var: None, index_var: None };
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
                        options.index_var = Some(VarName::of(name));
                    } else {
                        options.match_var = Some(VarName::of(name));
                    }
                    i += 1;
                }
                4 => options.nocase = true,
                6 => {
                    i += 1;
                    break;
                }
                _ => {}
            }
            i += 1;
        }
        options.mode = mode.unwrap_or(Mode::Exact);
        if options.mode != Mode::Regexp && (options.index_var.is_some() || options.match_var.is_some()) {
            let option = if options.index_var.is_some() { "-indexvar" } else { "-matchvar" };
            return Err(refuse(format!("{option} option requires -regexp option"), "MODERESTRICTION"));
        }
        Ok((options, i))
    }

    /// Returns true if the pattern matches. A regular expression sets the variables of the options.
    fn matches(&self, core: &mut Core, pattern: &Value, subject: &Value) -> Result<bool, Exception> {
        Ok(match self.mode {
            Mode::Exact if self.nocase => pattern.as_str().to_lowercase() == subject.as_str().to_lowercase(),
            Mode::Exact => pattern == subject,
            Mode::Glob if self.nocase => glob::matches_nocase(&pattern.as_str(), &subject.as_str()),
            Mode::Glob => glob::matches(&pattern.as_str(), &subject.as_str()),
            Mode::Regexp => {
                let regex = regex::compile(pattern, Flags { nocase: self.nocase, ..Flags::default() })?;
                let text = subject.as_str();
                let Some(groups) = regex.find(&text, 0)? else { return Ok(false) };
                if let Some(name) = &self.match_var {
                    let texts = groups.iter().map(|g| Value::from(g.map_or("", |(s, e)| &text[s..e])));
                    core.assign(name, Value::list(texts))?;
                }
                if let Some(name) = &self.index_var {
                    let places = groups.iter().map(|g| super::regexp::indices(&text, *g));
                    core.assign(name, Value::list(places))?;
                }
                true
            }
        })
    }

    /// The arm `default` empties the variables of the options.
    fn clear_variables(&self, core: &mut Core) -> Result<(), Exception> {
        [&self.match_var, &self.index_var].into_iter().flatten().try_for_each(|name| core.assign(name, Value::EMPTY))
    }
}

/// Take the arms, patterns and bodies in turn. `at` is the index of the first word of them.
fn arms(call: &Call<'_>, at: usize) -> Result<List, Exception> {
    let in_one_word = call.len() == at + 1;
    let arms = if in_one_word { call.arg(at).to_list()? } else { List::from(call.from(at).to_vec()) };
    if in_one_word && arms.is_empty() {
        return Err(call.wrong_args("switch ?-option ...? string {?pattern body ...? ?default body?}"));
    }
    if arms.len() % 2 == 1 {
        let mut message = "extra switch pattern with no body".to_owned();
        let comment = arms.iter().step_by(2).any(|p| p.as_str().starts_with('#'));
        if in_one_word && comment {
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
    Ok(arms)
}

fn switch<H>(interp: &mut Interp<H>, call: &Call<'_>) -> Result<Value, Exception> {
    let (options, i) = Options::take(call)?;
    if call.len() < i + 2 {
        return Err(call.wrong_args(USAGE));
    }
    let (subject, arms_at) = (call.arg(i), i + 1);
    let arms = arms(call, arms_at)?;
    let count = arms.len() / 2;
    for (n, arm) in arms.chunks_exact(2).enumerate() {
        let [pattern, _] = arm else { continue };
        if n + 1 == count && pattern.as_str() == "default" {
            options.clear_variables(&mut interp.core)?;
        } else if !options.matches(&mut interp.core, pattern, subject)? {
            continue;
        }
        let bodies = arms.chunks_exact(2).enumerate().skip(n);
        let Some((at, body)) = bodies.map(|(at, arm)| (at, &arm[1])).find(|(_, body)| body.as_str() != "-") else {
            return Ok(Value::EMPTY);
        };
        let shown: String = pattern.as_str().chars().take(50).collect();
        let what = format!("\"{shown}\" arm");
        if call.len() > arms_at + 1 {
            return interp.body(call, arms_at + at * 2 + 1, &what);
        }
        let script = crate::eval::script_of(body);
        return interp.body_again(&script, body, &what);
    }
    Ok(Value::EMPTY)
}

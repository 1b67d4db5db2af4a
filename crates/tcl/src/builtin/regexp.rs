//! `regexp` and `regsub`.

use crate::command::{Call, CoreFn};
use crate::core::Core;
use crate::error::Exception;
use crate::index::index;
use crate::regex::{self, Flags, Groups};
use crate::value::Value;
use crate::vars::VarName;

pub(crate) const COMMANDS: &[(&str, CoreFn)] = &[("regexp", regexp), ("regsub", regsub)];

/// Places of a parenthesis in characters, as `-indices` gives them.
pub(super) fn indices(text: &str, group: Option<(usize, usize)>) -> Value {
    let (start, end) = match group {
        Some((start, end)) => {
            let first = text[..start].chars().count() as i64;
            (first, first + text[start..end].chars().count() as i64 - 1)
        }
        None => (-1, -1),
    };
    Value::list([Value::from(start), Value::from(end)])
}

#[derive(Default)]
struct Options {
    all: bool,
    indices: bool,
    inline: bool,
    flags: Flags,
    start: Option<Value>,
    /// First word after the options.
    next: usize,
}

fn options(call: &Call<'_>, names: &[&str]) -> Result<Options, Exception> {
    let mut o = Options { next: 1, ..Options::default() };
    while call.get(o.next).is_some_and(|w| w.as_str().starts_with('-')) {
        let word = call.arg(o.next).as_str();
        let name = if word.len() > 3 && "-nocase".starts_with(&*word) {
            "-nocase"
        } else {
            names[call.choose(o.next, "option", names, true)?]
        };
        match name {
            "-all" => o.all = true,
            "-indices" => o.indices = true,
            "-inline" => o.inline = true,
            "-expanded" => o.flags.expanded = true,
            "-line" => (o.flags.line_stop, o.flags.line_anchor) = (true, true),
            "-linestop" => o.flags.line_stop = true,
            "-lineanchor" => o.flags.line_anchor = true,
            "-nocase" => o.flags.nocase = true,
            "-about" => {
                return Err(call.error_at(o.next, "regexp -about is not supported", "not supported"));
            }
            "-start" => {
                o.next += 1;
                let Some(start) = call.get(o.next) else { break };
                index(start, 0)?;
                o.start = Some(start.clone());
            }
            _ => {
                o.next += 1;
                break;
            }
        }
        o.next += 1;
    }
    Ok(o)
}

impl Options {
    /// The byte at which the search starts.
    fn start(&self, value: &Value, text: &str) -> Result<usize, Exception> {
        let Some(start) = &self.start else { return Ok(0) };
        let count = value.char_count() as i64;
        let at = index(start, count)?.clamp(0, count) as usize;
        Ok(text.char_indices().nth(at).map_or(text.len(), |(byte, _)| byte))
    }
}

/// Length in bytes of the character at a byte.
fn step(text: &str, at: usize) -> usize {
    text[at..].chars().next().map_or(1, char::len_utf8)
}

fn regexp(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    const NAMES: [&str; 11] = [
        "-all",
        "-about",
        "-indices",
        "-inline",
        "-expanded",
        "-line",
        "-linestop",
        "-lineanchor",
        "-nocase",
        "-start",
        "--",
    ];
    let o = options(call, &NAMES)?;
    if call.len() < o.next + 2 {
        return Err(call.wrong_args("regexp ?-option ...? exp string ?matchVar? ?subMatchVar ...?"));
    }
    let names = call.from(o.next + 2);
    if o.inline && !names.is_empty() {
        let message = "regexp match variables not allowed when using -inline";
        return Err(Exception::coded(message, &["TCL", "OPERATION", "REGEXP", "MIX_VAR_INLINE"]));
    }
    let pattern = call.arg(o.next);
    let regex = regex::compile(pattern, o.flags).map_err(|e| e.at(call.span(o.next), ""))?;
    let subject = call.arg(o.next + 1);
    let text = subject.as_str();
    let mut at = o.start(subject, &text)?;
    let shown = |group: Option<(usize, usize)>| {
        if o.indices { indices(&text, group) } else { Value::from(group.map_or("", |(start, end)| &text[start..end])) }
    };
    let mut count = 0i64;
    let mut collected = vec![];
    let mut last: Option<Groups> = None;
    while at <= text.len() {
        let Some(groups) = regex.find(&text, at)? else { break };
        count += 1;
        let (start, end) = groups.first().copied().flatten().unwrap_or((at, at));
        if o.inline {
            collected.extend(groups.iter().map(|g| shown(*g)));
        } else {
            last = Some(groups);
        }
        // Nothing is found at the end for an empty pattern.
        if !o.all || (at >= text.len() && call.arg(o.next).is_empty()) {
            break;
        }
        at = if start == end { end + step(&text, end.min(text.len())) } else { end };
        // After a match that took the rest there is no empty one at the end.
        if at >= text.len() {
            break;
        }
    }
    if o.inline {
        return Ok(Value::from(collected));
    }
    if let Some(groups) = last {
        for (i, name) in names.iter().enumerate() {
            let name = VarName::of(name);
            let value = shown(groups.get(i).copied().flatten());
            core.assign(&name, value)?;
        }
    }
    Ok(Value::from(if o.all { count } else { count.min(1) }))
}

/// Put the parts of a match into a replacement with `&` and `\1`.
fn substitute(template: &str, text: &str, groups: &Groups, out: &mut String) {
    let part = |n: usize| groups.get(n).copied().flatten().map_or("", |(start, end)| &text[start..end]);
    let mut chars = template.chars();
    while let Some(c) = chars.next() {
        match c {
            '&' => out.push_str(part(0)),
            '\\' => {
                let rest = chars.clone();
                match chars.next() {
                    Some(d @ '0'..='9') => out.push_str(part(d as usize - '0' as usize)),
                    Some(c @ ('&' | '\\')) => out.push(c),
                    _ => {
                        out.push('\\');
                        chars = rest;
                    }
                }
            }
            c => out.push(c),
        }
    }
}

fn regsub(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    const NAMES: [&str; 8] = ["-all", "-nocase", "-expanded", "-line", "-linestop", "-lineanchor", "-start", "--"];
    let o = options(call, &NAMES)?;
    let given = call.len().saturating_sub(o.next);
    if !(3..=4).contains(&given) {
        return Err(call.wrong_args("regsub ?-option ...? exp string subSpec ?varName?"));
    }
    let regex = regex::compile(call.arg(o.next), o.flags).map_err(|e| e.at(call.span(o.next), ""))?;
    let subject = call.arg(o.next + 1);
    let text = subject.as_str();
    let template = call.arg(o.next + 2).as_str();
    let start = o.start(subject, &text)?;
    let mut out = String::from(&text[..start]);
    let mut at = start;
    let mut count = 0i64;
    while at <= text.len() {
        let Some(groups) = regex.find(&text, at)? else { break };
        count += 1;
        let (from, to) = groups.first().copied().flatten().unwrap_or((at, at));
        out.push_str(&text[at..from]);
        substitute(&template, &text, &groups, &mut out);
        at = to;
        if from == to {
            // Pass over one character, so as not to find the same place again.
            let next = at + step(&text, at.min(text.len()));
            out.push_str(text.get(at..next).unwrap_or_default());
            at = next;
        }
        // Nothing is found at the end for an empty pattern.
        if !o.all || (at >= text.len() && call.arg(o.next).is_empty()) {
            break;
        }
    }
    if count == 0 {
        out = text.clone().into_owned();
    } else {
        out.push_str(text.get(at..).unwrap_or_default());
    }
    match call.get(o.next + 3) {
        Some(name) => {
            let name = VarName::of(name);
            core.assign(&name, Value::from(out))?;
            Ok(Value::from(count))
        }
        None => Ok(if count == 0 { subject.clone() } else { Value::from(out) }),
    }
}

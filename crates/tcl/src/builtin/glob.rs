//! `glob`.

use crate::command::{Call, CoreFn};
use crate::core::Core;
use crate::error::Exception;
use crate::files::FileKind;
use crate::glob;
use crate::value::Value;

pub(crate) const COMMANDS: &[(&str, CoreFn)] = &[("glob", glob_command)];

const OPTIONS: [&str; 7] = ["-directory", "-join", "-nocomplain", "-path", "-tails", "-types", "--"];

#[derive(Default)]
struct Options {
    directory: Option<String>,
    path: Option<String>,
    join: bool,
    complain: bool,
    tails: bool,
    types: Vec<String>,
}

fn glob_command(core: &mut Core, call: &Call<'_>) -> Result<Value, Exception> {
    let mut o = Options { complain: true, ..Options::default() };
    let mut i = 1;
    while call.get(i).is_some_and(|w| w.as_str().starts_with('-')) {
        let option = call.choose(i, "option", &OPTIONS, false)?;
        let operand = || match call.get(i + 1) {
            Some(value) => Ok(value.as_str().into_owned()),
            None => {
                let message = format!("missing argument to \"{}\"", OPTIONS[option]);
                Err(Exception::coded(message, &["TCL", "ARGUMENT", "MISSING"]))
            }
        };
        match option {
            0 => o.directory = Some(operand()?),
            1 => o.join = true,
            2 => o.complain = false,
            3 => o.path = Some(operand()?),
            4 => o.tails = true,
            5 => o.types = call.arg(i + 1).to_list()?.iter().map(|t| t.as_str().into_owned()).collect(),
            _ => {
                i += 1;
                break;
            }
        }
        i += if matches!(option, 0 | 3 | 5) { 2 } else { 1 };
    }
    let patterns = call.from(i);
    if patterns.is_empty() {
        return if o.complain {
            Err(Exception::coded("no files matched glob patterns \"\"", &["TCL", "OPERATION", "GLOB", "NOMATCH"]))
        } else {
            Ok(Value::EMPTY)
        };
    }
    if o.tails && o.directory.is_none() && o.path.is_none() {
        let message = "\"-tails\" must be used with either \"-directory\" or \"-path\"";
        return Err(Exception::coded(message, &["TCL", "OPERATION", "GLOB", "BADOPTIONCOMBINATION"]));
    }
    if o.directory.is_some() && o.path.is_some() {
        let message = "\"-directory\" cannot be used with \"-path\"";
        return Err(Exception::coded(message, &["TCL", "OPERATION", "GLOB", "BADOPTIONCOMBINATION"]));
    }
    let texts: Vec<String> = patterns.iter().map(|p| p.as_str().into_owned()).collect();
    let texts = if o.join { vec![texts.join("/")] } else { texts };
    let mut found = vec![];
    for pattern in &texts {
        for pattern in braces(pattern)? {
            find(core, &pattern, &o, &mut found);
        }
    }
    if found.is_empty() && o.complain {
        let plural = if texts.len() > 1 { "s" } else { "" };
        let message = format!("no files matched glob pattern{plural} \"{}\"", texts.join(" "));
        return Err(Exception::coded(message, &["TCL", "OPERATION", "GLOB", "NOMATCH"]).at(call.span(i), ""));
    }
    Ok(Value::list(found.into_iter().map(Value::from)))
}

/// All patterns that one with `{a,b}` stands for.
fn braces(pattern: &str) -> Result<Vec<String>, Exception> {
    let mut done = vec![];
    let mut waiting = vec![pattern.to_owned()];
    while let Some(pattern) = waiting.pop() {
        if done.len() + waiting.len() > 10_000 {
            return Err(Exception::error("too many alternatives in glob pattern"));
        }
        let mut escaped = false;
        let mut open = None;
        for (at, c) in pattern.char_indices() {
            match c {
                _ if escaped => escaped = false,
                '\\' => escaped = true,
                '{' => {
                    open = Some(at);
                    break;
                }
                _ => {}
            }
        }
        let Some(open) = open else {
            done.push(pattern);
            continue;
        };
        let mut depth = 0;
        let mut cuts = vec![open];
        let mut close = None;
        for (at, c) in pattern[open..].char_indices() {
            match c {
                '{' => depth += 1,
                '}' => {
                    depth -= 1;
                    if depth == 0 {
                        close = Some(open + at);
                        break;
                    }
                }
                ',' if depth == 1 => cuts.push(open + at),
                _ => {}
            }
        }
        let Some(close) = close else {
            return Err(Exception::coded(
                "unmatched open-brace in file name",
                &["TCL", "OPERATION", "GLOB", "BALANCE"],
            ));
        };
        cuts.push(close);
        let alternatives = cuts.windows(2).rev().filter_map(|w| pattern.get(w[0] + 1..w[1]));
        waiting.extend(alternatives.map(|a| format!("{}{a}{}", &pattern[..open], &pattern[close + 1..])));
    }
    Ok(done)
}

fn find(core: &Core, pattern: &str, o: &Options, found: &mut Vec<String>) {
    let base = o.directory.clone();
    let full_pattern = match &o.path {
        Some(path) => format!("{}{pattern}", escape(path)),
        None => pattern.to_owned(),
    };
    let prefix = match &base {
        Some(dir) if dir.ends_with('/') => dir.clone(),
        Some(dir) => format!("{dir}/"),
        None => String::new(),
    };
    let (mut at, rest) = match full_pattern.strip_prefix('/') {
        Some(rest) if base.is_none() => (vec!["/".to_owned()], rest.to_owned()),
        _ => (vec![prefix.clone()], full_pattern),
    };
    let parts: Vec<&str> = rest.split('/').filter(|p| !p.is_empty()).collect();
    for (i, part) in parts.iter().enumerate() {
        let last = i + 1 == parts.len();
        let mut next = vec![];
        for dir in &at {
            step(core, dir, part, last, o, &mut next);
        }
        at = if last { next } else { next.into_iter().map(|d| format!("{d}/")).collect() };
    }
    if parts.is_empty() {
        at.retain(|p| core.files.info(&core.absolute(p), true).is_ok());
    }
    let cut = match (&o.path, o.tails) {
        (_, false) => 0,
        (Some(path), true) => path.rfind('/').map_or(0, |at| at + 1),
        (None, true) => prefix.len(),
    };
    found.extend(at.into_iter().map(|p| p.get(cut..).unwrap_or_default().to_owned()));
}

/// A text that is to be taken as it is within a pattern.
fn escape(text: &str) -> String {
    let special = |c: char| matches!(c, '*' | '?' | '[' | '\\');
    text.chars().flat_map(|c| special(c).then_some('\\').into_iter().chain(std::iter::once(c))).collect()
}

/// The names in a folder that match one part of a pattern.
fn step(core: &Core, dir: &str, part: &str, last: bool, o: &Options, next: &mut Vec<String>) {
    let hidden = o.types.iter().any(|t| t == "hidden");
    if glob::is_plain(part) {
        let path = format!("{dir}{part}");
        if fits(core, &path, if last { &o.types } else { &[] }) {
            next.push(path);
        }
        return;
    }
    let folder = core.absolute(if dir.is_empty() { "." } else { dir });
    let Ok(mut names) = core.files.list(&folder) else { return };
    // Tcl gives them in the order of the disk; in order of their names a study comes out the same everywhere.
    names.sort_unstable();
    for name in names {
        if name.starts_with('.') != (part.starts_with('.') || hidden) || !glob::matches(part, &name) {
            continue;
        }
        let path = format!("{dir}{name}");
        let types: &[String] = if last { &o.types } else { &[] };
        if types.is_empty() || fits(core, &path, types) {
            next.push(path);
        }
    }
}

/// Returns true if a file exists and has one of the given types.
fn fits(core: &Core, path: &str, types: &[String]) -> bool {
    let full = core.absolute(path);
    let Ok(info) = core.files.info(&full, true).or_else(|_| core.files.info(&full, false)) else { return false };
    let mut kinds = types.iter().filter(|t| t.len() == 1 && "bcdflps".contains(t.as_str())).peekable();
    let kind_fits = kinds.peek().is_none()
        || kinds.any(|t| match t.as_str() {
            "d" => info.kind == FileKind::Directory,
            "f" => info.kind == FileKind::File,
            "l" => core.files.info(&full, false).is_ok_and(|i| i.kind == FileKind::Link),
            _ => false,
        });
    let may = |letter: &str, mask: u32| !types.iter().any(|t| t == letter) || info.mode & mask != 0;
    kind_fits && may("r", 0o444) && may("w", 0o222) && may("x", 0o111)
}

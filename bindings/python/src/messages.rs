//! Messages as Python's users see them: the call with a mark under the word that is wrong.

use crate::outputs::MEMORY;
use hysteron_opensees::calls::CallNumbers;
use hysteron_opensees::{Command, commands};
use hysteron_tcl::diagnostic::{Diagnostic, SourceMap};
use hysteron_tcl::{Form, Value};
use pyo3::prelude::*;

/// Width of the line that shows a call.
const WIDTH: usize = 100;

/// A diagnostic about a call, with the call's words.
pub(crate) fn render(d: &Diagnostic, words: &[Value], numbers: CallNumbers, sources: &SourceMap) -> String {
    let mut text = d.message.clone();
    let mut label = d.label.as_str();
    match d.span {
        Some(span) if numbers.is_call(span) => {
            if let Some(word) = numbers.word(span) {
                text.push_str(&marked(words, word, label));
                label = "";
            }
        }
        Some(span) => text.push_str(&format!("\n  in {}", sources.location(span))),
        None => {}
    }
    if !label.is_empty() {
        text.push_str(&format!("\n  {label}"));
    }
    for help in &d.help {
        text.push_str("\n  ");
        text.push_str(&in_python(help));
    }
    text
}

/// The call with a mark under a word, or under the whole of it.
fn marked(words: &[Value], word: Option<usize>, label: &str) -> String {
    let shown: Vec<String> = words.iter().enumerate().map(|(i, w)| literal(w, i == 0)).collect();
    let is_hidden = hidden(words);
    let at = word.unwrap_or(0).min(shown.len().saturating_sub(1));
    // Words far from the one that is wrong are left out of long calls.
    let (mut from, mut to) = (at, at + 1);
    let mut width = shown.get(at).map_or(0, |w| w.chars().count()) + shown[0].chars().count();
    loop {
        let before = from.checked_sub(1).filter(|b| *b > 0).map(|b| shown[b].chars().count() + 2);
        let after = shown.get(to).map(|w| w.chars().count() + 2);
        if let Some(w) = before.filter(|w| width + w <= WIDTH) {
            (from, width) = (from - 1, width + w);
        } else if let Some(w) = after.filter(|w| width + w <= WIDTH) {
            (to, width) = (to + 1, width + w);
        } else {
            break;
        }
    }
    let from = from.max(1);
    let mut line = format!("{}(", shown[0]);
    if from > 1 {
        line.push_str("..., ");
    }
    let mut mark = (0, shown[0].chars().count());
    for i in (from..to.max(from)).filter(|i| !is_hidden.contains(i)) {
        if !line.ends_with(['(', ' ']) {
            line.push_str(", ");
        }
        let start = line.chars().count();
        line.push_str(&shown[i]);
        if Some(i) == word {
            mark = (start, shown[i].chars().count());
        }
    }
    line.push_str(if to < shown.len() { ", ...)" } else { ")" });
    if word.is_none() {
        mark = (0, line.chars().count());
    }
    let carets = "^".repeat(mark.1.max(1));
    format!("\n    {line}\n    {}{carets} {label}", " ".repeat(mark.0)).trim_end().to_owned()
}

/// Words that the package itself has put into a call: the place in memory of a recorder, with its option and `-time`.
fn hidden(words: &[Value]) -> std::ops::Range<usize> {
    let at = words.iter().position(|w| w.as_str().starts_with(MEMORY));
    at.map_or(0..0, |at| at.saturating_sub(1)..at + 2)
}

/// A word as Python writes it.
fn literal(word: &Value, is_name: bool) -> String {
    match word.form() {
        Form::Text(text) if !is_name => format!("'{}'", text.escape_debug()),
        Form::Empty => "''".to_owned(),
        _ => word.as_str().into_owned(),
    }
}

/// A line of help in Python's notation.
fn in_python(help: &str) -> String {
    if let Some(usage) = help.strip_prefix("usage: ") {
        return format!("usage: {}", usage_in_python(usage));
    }
    let Some((before, after)) = help.split_once("\"hysteron commands ") else { return help.to_owned() };
    let Some((name, rest)) = after.split_once('"') else { return help.to_owned() };
    format!("{before}hysteron.commands('{name}'){rest}")
}

/// A usage of a command in Python's notation: `node $tag $x` becomes `node(tag, x)`.
#[pyfunction]
pub(crate) fn usage_in_python(usage: &str) -> String {
    // What a command gives may be told behind its call, or by a call around it: `lassign [motionFile $series] dt: a series`.
    let call = usage.split_once(": ").map_or(usage, |(call, _)| call);
    let call = call.strip_prefix("lassign [").and_then(|c| c.split_once(']')).map_or(call, |(inner, _)| inner);
    call.split(" or ").map(call_in_python).collect::<Vec<_>>().join(" or ")
}

fn call_in_python(usage: &str) -> String {
    let Some((name, rest)) = usage.split_once(' ') else {
        return if usage.starts_with('$') { word_in_python(usage) } else { format!("{usage}()") };
    };
    let is_name = |w: &str| w.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    // A body in braces is made of calls of their own in Python.
    let rest = rest.split('{').next().unwrap_or_default().trim_end();
    let (head, tail) = if is_name(name) { (Some(name), rest) } else { (None, usage) };
    let mut out = String::new();
    for word in tail.split(' ').filter(|w| !w.is_empty()) {
        let glued = out.is_empty() || out.ends_with("| ") || matches!(word, "|" | "or");
        out.push_str(match (glued, out.ends_with(' ') || out.is_empty()) {
            (true, true) => "",
            (true, false) => " ",
            (false, _) => ", ",
        });
        match word {
            "|" | "or" => out.push_str("| "),
            _ => out.push_str(&word_in_python(word)),
        }
    }
    match head {
        Some(head) => format!("{head}({})", out.trim_end()),
        None => out.trim_end().to_owned(),
    }
}

fn word_in_python(word: &str) -> String {
    let core = word.trim_start_matches(['<', '(']).trim_end_matches(['>', ')', '.']);
    let Some(at) = word.find(core).filter(|_| !core.is_empty()) else { return word.to_owned() };
    let (before, after) = (&word[..at], &word[at + core.len()..]);
    let part = |p: &str| match p.strip_prefix('$') {
        Some(name) => name.to_owned(),
        None => format!("'{p}'"),
    };
    format!("{before}{}{after}", core.split('|').map(part).collect::<Vec<_>>().join("|"))
}

/// Names of all commands with their usages, and those of the kinds that each makes: `(name, usage, [(names, usage)])`.
#[pyfunction]
#[allow(clippy::type_complexity)]
pub(crate) fn usages() -> Vec<(&'static str, String, Vec<(Vec<&'static str>, String)>)> {
    commands()
        .map(|c| {
            let kinds = c.kinds().into_iter().map(|k| (k.names.to_vec(), usage_in_python(k.usage)));
            (c.name, usage_in_python(&c.usage_line()), kinds.collect())
        })
        .collect()
}

/// The same in the notation of scripts: `(name, usage, [(names, usage)])`.
#[pyfunction]
#[allow(clippy::type_complexity)]
pub(crate) fn script_usages() -> Vec<(&'static str, String, Vec<(Vec<&'static str>, &'static str)>)> {
    let kinds = |c: &Command| c.kinds().into_iter().map(|k| (k.names.to_vec(), k.usage)).collect();
    commands().map(|c| (c.name, c.usage_line(), kinds(c))).collect()
}

/// Sections of the reference of commands: names of commands, or of commands with a kind, and lines in Markdown.
#[pyfunction]
pub(crate) fn reference() -> Vec<(Vec<&'static str>, Vec<&'static str>)> {
    hysteron_lsp::reference::sections().map(|s| (s.names, s.lines)).collect()
}

#[cfg(test)]
mod tests {
    use super::usage_in_python;

    #[test]
    fn usages_are_written_as_calls() {
        assert_eq!(usage_in_python("nodeDisp $node <$dof>"), "nodeDisp(node, <dof>)");
        assert_eq!(
            usage_in_python("section Fiber $tag <-GJ $GJ | -torsion $material> <-noCentroid> {fibers}"),
            "section('Fiber', tag, <'-GJ', GJ | '-torsion', material>, <'-noCentroid'>)"
        );
        assert_eq!(usage_in_python("getTime"), "getTime()");
        let lassign = "lassign [motionFile $series $file <-dt $dt>] dt npts: a measured file, or a series";
        assert_eq!(usage_in_python(lassign), "motionFile(series, file, <'-dt', dt>)");
    }
}

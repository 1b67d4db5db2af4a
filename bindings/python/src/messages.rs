//! Messages as Python's users see them: the call with a mark under the word that is wrong.

use crate::outputs::MEMORY;
use hysteron_opensees::calls::CallNumbers;
use hysteron_opensees::python_usage::{self, help_in_python};
use hysteron_opensees::{Command, commands};
use hysteron_tcl::diagnostic::{Diagnostic, SourceMap};
use hysteron_tcl::{Form, Value};
use pyo3::prelude::*;
use std::collections::BTreeMap;

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
        text.push_str(&help_in_python(help));
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

/// A usage of a command in Python's notation: `node $tag $x` becomes `node(tag, x)`.
#[pyfunction]
pub(crate) fn usage_in_python(usage: &str) -> String {
    python_usage::usage_in_python(usage)
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

/// Lines of the reference in Markdown, by the name of a command, or of a command with a kind.
#[pyfunction]
pub(crate) fn reference() -> BTreeMap<&'static str, &'static [&'static str]> {
    hysteron_lsp::reference::by_name().iter().map(|(name, s)| (name.as_str(), s.lines.as_slice())).collect()
}

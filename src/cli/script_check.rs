//! Summary of the messages of a script, and the result of `hysteron check` for other programs.

use super::messages::Messages;
use hysteron::diagnostic::{Diagnostic, Severity, SourceMap, Span};
use hysteron::opensees::Tcl;
use serde::Serialize;
use std::collections::HashMap;

/// A message with its place.
#[derive(Serialize)]
pub(super) struct MessageTable<'a> {
    severity: &'static str,
    message: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    file: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    line: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    column: Option<usize>,
    /// Words under the place: what was expected there.
    label: &'a str,
    help: &'a [String],
}

impl<'a> MessageTable<'a> {
    pub(super) fn new(d: &'a Diagnostic, sources: &SourceMap) -> Self {
        let location = d.span.map(|s| sources.location(s));
        Self {
            severity: match d.severity {
                Severity::Error => "error",
                Severity::Warning => "warning",
                Severity::Note => "note",
            },
            message: &d.message,
            file: location.as_ref().map(|l| l.name.to_string()),
            line: location.as_ref().map(|l| l.line),
            column: location.as_ref().map(|l| l.column),
            label: &d.label,
            help: &d.help,
        }
    }
}

/// Result of the check of a script.
#[derive(Serialize)]
struct ScriptTable<'a> {
    script: &'a str,
    errors: usize,
    warnings: usize,
    /// Errors that only follow from others, and are left out.
    held_back: usize,
    /// The analyses were rehearsed, as far as the script has some.
    analyses_rehearsed: bool,
    messages: Vec<MessageTable<'a>>,
}

fn count(interp: &Tcl, severity: Severity) -> usize {
    interp.warnings.iter().filter(|w| w.severity == severity).count()
}

/// The result of a check as JSON. `end` is the error that ended the script, if any.
pub(super) fn json(script: &str, interp: &Tcl, end: Option<&Diagnostic>) -> String {
    let all = interp.warnings.iter().chain(end);
    let table = ScriptTable {
        script,
        errors: count(interp, Severity::Error) + usize::from(end.is_some()),
        warnings: count(interp, Severity::Warning),
        held_back: interp.host.check.held_back,
        analyses_rehearsed: !interp.host.check.skipped_analyses,
        messages: all.map(|d| MessageTable::new(d, &interp.sources)).collect(),
    };
    serde_json::to_string_pretty(&table).unwrap_or_default() + "\n"
}

/// Lines of a summary.
const MAX_LINES: usize = 30;

/// Print all warnings again, one line each, so that none is overlooked.
pub(super) fn print_summary(interp: &Tcl) {
    let messages = Messages::new();
    // A warning that comes up again and again has one line; the place of a word takes the length of its line to find.
    let mut counts: Vec<(&Diagnostic, usize)> = vec![];
    let mut known: HashMap<(Option<Span>, &str), usize> = HashMap::new();
    for w in &interp.warnings {
        let at = *known.entry((w.span, &w.message)).or_insert(counts.len());
        match counts.get_mut(at) {
            Some((_, n)) => *n += 1,
            None => counts.push((w, 1)),
        }
    }
    let line = |(w, n): &(&Diagnostic, usize)| {
        let kind = if w.severity == Severity::Error { "error" } else { "warning" };
        (format!("{kind}: {}", messages.line(w, &interp.sources)), *n)
    };
    let lines: Vec<(String, usize)> = counts.iter().take(MAX_LINES).map(line).collect();
    if lines.is_empty() {
        return;
    }
    let plural = |n: usize, what: &str| format!("{n} {what}{}", if n == 1 { "" } else { "s" });
    let totals = [(count(interp, Severity::Error), "error"), (count(interp, Severity::Warning), "warning")];
    let totals: Vec<String> = totals.iter().filter(|t| t.0 > 0).map(|t| plural(t.0, t.1)).collect();
    eprintln!("{}:", totals.join(", "));
    for (line, n) in &lines {
        let times = if *n > 1 { format!(" ({n} times)") } else { String::new() };
        eprintln!("  {line}{times}");
    }
    if counts.len() > MAX_LINES {
        eprintln!("  ... and {} more", counts.len() - MAX_LINES);
    }
    match interp.host.check.held_back {
        0 => {}
        1 => eprintln!("1 further error follows from these"),
        n => eprintln!("{n} further errors follow from these"),
    }
}

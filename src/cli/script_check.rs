//! Summary of the messages of a script, and the result of `hysteron check` for other programs.

use super::messages::Messages;
use hysteron::diagnostic::{Diagnostic, Severity, SourceMap};
use hysteron::opensees::Tcl;
use serde::Serialize;

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
    /// Stable name of the check that found it.
    #[serde(skip_serializing_if = "Option::is_none")]
    code: Option<&'static str>,
    /// Number of times that it came up at this place.
    count: usize,
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
            code: d.check.map(|c| c.code),
            count: d.count,
        }
    }
}

/// A quantity of the block of plausibility.
#[derive(Serialize)]
struct FactTable<'a> {
    quantity: &'static str,
    value: &'a str,
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
    /// What the check found out about the first model that is analysed.
    plausibility: Vec<FactTable<'a>>,
    messages: Vec<MessageTable<'a>>,
}

/// Number of messages of a severity, those at the same place counted one by one.
fn count(interp: &Tcl, severity: Severity) -> usize {
    interp.warnings.iter().filter(|w| w.severity == severity).map(|w| w.count).sum()
}

/// The result of a check without errors, in words.
pub(super) fn found(interp: &Tcl) -> String {
    match count(interp, Severity::Warning) {
        0 => "no mistakes".into(),
        1 => "no errors, 1 warning".into(),
        n => format!("no errors, {n} warnings"),
    }
}

/// The block of plausibility, a line each; empty without an analysis.
pub(super) fn facts(interp: &Tcl) -> String {
    let facts = &interp.host.overview.facts;
    let width = facts.iter().map(|f| f.name.len()).max().unwrap_or(0);
    let lines: String = facts.iter().map(|f| format!("  {:width$}  {}\n", f.name, f.value)).collect();
    let head = if facts.is_empty() { "" } else { "the first model that is analysed, in the units of the script:\n" };
    format!("{head}{lines}")
}

/// The result of a check as JSON. `end` is the error that ended the script, if any.
pub(super) fn json(script: &str, interp: &Tcl, end: Option<&Diagnostic>) -> String {
    let all = interp.warnings.iter().chain(end);
    let facts = interp.host.overview.facts.iter();
    let table = ScriptTable {
        script,
        errors: count(interp, Severity::Error) + usize::from(end.is_some()),
        warnings: count(interp, Severity::Warning),
        held_back: interp.host.check.held_back,
        analyses_rehearsed: !interp.host.check.skipped_analyses,
        plausibility: facts.map(|f| FactTable { quantity: f.name, value: &f.value }).collect(),
        messages: all.map(|d| MessageTable::new(d, &interp.sources)).collect(),
    };
    serde_json::to_string_pretty(&table).unwrap_or_default() + "\n"
}

/// Lines of a summary.
const MAX_LINES: usize = 30;

/// Print all warnings again, one line each, so that none is overlooked.
pub(super) fn print_summary(interp: &Tcl) {
    let messages = Messages::new();
    let line = |w: &Diagnostic| {
        let kind = if w.severity == Severity::Error { "error" } else { "warning" };
        (format!("{kind}: {}", messages.line(w, &interp.sources)), w.count)
    };
    // The place of a word takes the length of its line to find.
    let lines: Vec<(String, usize)> = interp.warnings.iter().take(MAX_LINES).map(line).collect();
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
    if interp.warnings.len() > MAX_LINES {
        eprintln!("  ... and {} more", interp.warnings.len() - MAX_LINES);
    }
    match interp.host.check.held_back {
        0 => {}
        1 => eprintln!("1 further error follows from these"),
        n => eprintln!("{n} further errors follow from these"),
    }
}

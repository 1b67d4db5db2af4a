//! Check of a script: each mistake is reported and the script goes on. Consequences of a mistake are not reported.

use crate::output::{display, figure, print, query, recorder};
use crate::{Outcome, Tcl, commands, report};
use hysteron_tcl::diagnostic::Diagnostic;
use hysteron_tcl::{Call, Exception, Value};
use std::collections::BTreeSet;

/// Mistakes that a check has found, and their consequences.
#[derive(Debug, Default)]
pub struct CheckState {
    /// A definition was rejected: the model is not the one that was meant.
    pub(crate) rejected: bool,
    /// Messages of later commands that only follow from a mistake already reported.
    consequences: BTreeSet<String>,
    /// Analyses were passed over because a definition was rejected.
    pub skipped_analyses: bool,
    /// A check has passed over an analysis: results that the script reads are not there.
    pub waits_for_results: bool,
}

impl CheckState {
    /// An analysis is passed over; what its results would be asked for is not there.
    pub(crate) fn pass_over(&mut self, modes: usize) {
        self.skipped_analyses = true;
        self.consequences.extend((1..=modes).map(|i| format!("there is no mode {i}")));
        if modes > 0 {
            self.consequences.insert("there are no modes to damp".into());
        }
    }

    /// A command was rejected: what it would have defined will be missed.
    fn note(&mut self, words: &[&str]) {
        let name = words.first().copied().unwrap_or_default();
        let looks = [recorder::COMMANDS, query::COMMANDS, print::COMMANDS, display::COMMANDS, figure::COMMANDS];
        self.rejected |= !looks.into_iter().flatten().any(|c| c.name == name);
        let (kind, at) = match name {
            "node" => ("node", 1),
            "region" => ("region", 1),
            "groundMotion" => ("ground motion", 1),
            "uniaxialMaterial" => ("uniaxial material", 2),
            "section" => ("section", 2),
            "geomTransf" => ("geometric transformation", 2),
            "timeSeries" => ("time series", 2),
            "element" => ("element", 2),
            "set" => {
                let variable = words.get(1).copied().unwrap_or_default();
                self.consequences.insert(format!("can't read \"{variable}\": no such variable"));
                return;
            }
            "pattern" => {
                self.consequences.insert("there is no load pattern to put this in".into());
                ("load pattern", 2)
            }
            "analysis" => {
                self.consequences.insert("analyze: there is no analysis".into());
                return;
            }
            "model" => {
                self.consequences.extend(commands().map(|c| format!("{}: there is no model yet", c.name)));
                return;
            }
            _ => return,
        };
        if let Some(tag) = words.get(at).and_then(|w| w.parse::<i32>().ok()) {
            self.consequences.insert(format!("there is no {kind} {tag}"));
        }
    }
}

/// Handle an error of Tcl at the top level of a script: report it and go on with the next command.
///
/// An error that the script raises itself ends it, and so does one that comes of results that a check does not have.
pub(crate) fn handle_error(interp: &mut Tcl, error: Exception) -> Outcome {
    match error {
        Exception::Error(e) if !e.raised && !interp.host.check.waits_for_results => {
            let follows = interp.host.check.consequences.contains(&e.diagnostic.message);
            // The command was not called: what it would have defined stands before the word that is wrong.
            let place = e.diagnostic.span.map(|s| (interp.sources.text(s.source), s.start as usize));
            let before = place.as_ref().and_then(|(text, at)| text.get(..*at)).unwrap_or_default();
            let words: Vec<&str> = before.rsplit(['\n', ';']).next().unwrap_or_default().split_whitespace().collect();
            interp.host.check.rejected = true;
            interp.host.check.note(&words);
            if !follows {
                report(interp, e.diagnostic);
            }
            Ok(Value::EMPTY)
        }
        other => Err(other),
    }
}

/// Run a command for a check: its mistake is reported, and the script goes on.
pub(crate) fn run_command(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let name = call.name();
    let name = name.rsplit("::").next().unwrap_or_default();
    let Some(command) = commands().find(|c| c.name == name) else {
        return Err(Exception::error(format!("the command \"{name}\" was renamed, which a check does not follow")));
    };
    match (command.run)(interp, call) {
        Err(Exception::Error(e)) => {
            let follows = interp.host.check.consequences.contains(&e.diagnostic.message);
            let words: Vec<_> = call.args().iter().take(2).map(Value::as_str).collect();
            let words: Vec<&str> = [name].into_iter().chain(words.iter().map(AsRef::as_ref)).collect();
            interp.host.check.note(&words);
            if !follows {
                report_at(interp, e.diagnostic, call);
            }
            Ok(Value::EMPTY)
        }
        other => other,
    }
}

/// Report a mistake, with the whole command as its place where it names none.
fn report_at(interp: &mut Tcl, mut wrong: Diagnostic, call: &Call<'_>) {
    if wrong.span.is_none() {
        wrong.span = call.whole_span();
    }
    report(interp, wrong);
}

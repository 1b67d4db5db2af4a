//! Check of a script: each mistake is reported and the script goes on. Consequences of a mistake are not reported.

pub(crate) mod stand_in;

use crate::analysis::analyze::warn_of_missing;
use crate::analysis::speeds::warn_of_speedless;
use crate::checks::elements::OUTSIDE_LEARNED_RANGE;
use crate::effect::ends_recorders;
use crate::host::Mode;
use crate::mistakes::CheckState;
use crate::output::{display, figure, print, query, recorder, section_query};
use crate::session::Session;
use crate::{Command, Outcome, Tcl, commands, report, things, warn};
use hysteron_tcl::diagnostic::{Absent, COMMAND, Diagnostic, VARIABLE, nearest};
use hysteron_tcl::{Call, Exception, Value};

/// Commands that only look at the model and its results.
pub(crate) const LOOKING: [&[Command]; 6] = [
    recorder::COMMANDS,
    query::COMMANDS,
    section_query::COMMANDS,
    print::COMMANDS,
    display::COMMANDS,
    figure::COMMANDS,
];

impl CheckState {
    /// A command was rejected: what it would have defined will be missed.
    /// A command that is not known would have defined what the nearest one does.
    fn note(&mut self, words: &[&str], is_known: bool) {
        let name = words.first().copied().unwrap_or_default();
        self.rejected |= !LOOKING.into_iter().flatten().any(|c| c.name == name);
        if name == "set" {
            self.consequences.insert(Absent::new(VARIABLE, words.get(1).unwrap_or(&"")));
            return;
        }
        let name = if is_known { name } else { nearest(name, commands().map(|c| c.name)).unwrap_or(name) };
        let Some((kinds, at)) = crate::command(name).map(|c| c.defines) else { return };
        // A thing without a tag, or the one that is open: it is missed without its name.
        let whole = kinds.iter().filter(|kind| at == 0 || **kind == things::PATTERN);
        self.consequences.extend(whole.map(|kind| Absent::new(kind, "")));
        if let Some(tag) = words.get(at).filter(|_| at > 0).and_then(|w| w.parse::<i32>().ok()) {
            self.consequences.extend(kinds.iter().map(|kind| Absent::new(kind, tag)));
        }
    }
}

/// Handle an error of Tcl at the top level of a script: report it and go on with the next command.
///
/// An error that the script raises itself ends it, and so does one that comes of results that a check does not have.
pub(crate) fn handle_error(interp: &mut Tcl, error: Exception) -> Outcome {
    match error {
        Exception::Error(e) if !e.raised && !interp.host.check.waits_for_results => {
            let held_back = e.diagnostic.absent.as_ref().is_some_and(|a| interp.host.check.holds_back(a));
            // The command was not called: what it would have defined stands in the line of the word that is wrong.
            let place = e.diagnostic.span.map(|s| (interp.sources.text(s.source), s.start as usize));
            let split = place.as_ref().and_then(|(text, at)| text.split_at_checked(*at)).unwrap_or_default();
            let before = split.0.rsplit(['\n', ';']).next().unwrap_or_default();
            let line = format!("{before}{}", split.1.split(['\n', ';']).next().unwrap_or_default());
            let check = &mut interp.host.check;
            check.rejected = true;
            check.left_early |= !e.diagnostic.callers.is_empty() || line.trim_start().starts_with("source ");
            let is_known = e.diagnostic.absent.as_ref().is_none_or(|a| a.kind != COMMAND);
            check.note(&line.split_whitespace().collect::<Vec<_>>(), is_known);
            if !held_back {
                report(interp, e.diagnostic);
            }
            Ok(Value::EMPTY)
        }
        other => Err(other),
    }
}

/// End of a script or of its model: a check warns of what recorders ask for in vain, though no analysis may follow.
pub(crate) fn finish(interp: &mut Tcl) {
    if interp.host.mode != Mode::Check {
        return;
    }
    let missing = warn_of_missing(interp);
    let Session { engine, overview, check, .. } = &mut interp.host;
    // What follows from a mistake that has been reported is no news.
    let findings = if check.rejected {
        vec![]
    } else {
        overview.close(engine);
        std::mem::take(&mut overview.findings)
    };
    let found = findings.into_iter().map(|d| warn(interp, d)).collect::<Vec<_>>();
    for refused in found.into_iter().chain([missing]) {
        if let Err(Exception::Error(e)) = refused {
            report(interp, e.diagnostic);
        }
    }
}

/// End of a script: a check warns of laws that depend on a velocity which they never see.
pub(crate) fn warn_of_speeds(interp: &mut Tcl) {
    if interp.host.mode == Mode::Check
        && !interp.host.check.rejected
        && let Some(warning) = warn_of_speedless(&interp.host)
    {
        report(interp, warning);
    }
}

/// Tells the share of the steps outside the range of the learned laws, at the end of a run.
pub(crate) fn report_ranges(interp: &mut Tcl) {
    let found = interp.host.engine.outside_range();
    for (tag, range) in found {
        let share = 100.0 * range.outside / range.steps;
        let message = format!(
            "element {tag} was outside the range of its learned law in {share:.1} % of its steps: nothing was \
             measured there"
        );
        report(interp, Diagnostic::warning(&OUTSIDE_LEARNED_RANGE, message));
    }
}

/// Run a command for a check: its mistake is reported, and the script goes on.
pub(crate) fn run_command(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let name = call.name();
    let name = name.rsplit("::").next().unwrap_or_default();
    let Some(command) = crate::command(name) else {
        return Err(Exception::error(format!("the command \"{name}\" was renamed, which a check does not follow")));
    };
    run_known(interp, command, call)
}

/// The same for a command that has been looked up.
pub(crate) fn run_known(interp: &mut Tcl, command: &'static Command, call: &Call<'_>) -> Outcome {
    let noting = interp.host.index.is_some().then(|| call.noting());
    let call = noting.as_ref().unwrap_or(call);
    if ends_recorders(command, call.args().first()) {
        finish(interp);
    }
    let result = match (command.run)(interp, call) {
        Err(Exception::Error(e)) => {
            let words: Vec<_> = call.args().iter().take(2).map(Value::as_str).collect();
            let words: Vec<&str> = [command.name].into_iter().chain(words.iter().map(AsRef::as_ref)).collect();
            interp.host.check.note(&words, true);
            let absent = e.diagnostic.absent.clone();
            tell(interp, e.diagnostic, call);
            let done = absent.is_some_and(|absent| stand_in::run_with(interp, command, call, absent));
            if done { Ok(Value::EMPTY) } else { Err(None) }
        }
        other => other.map_err(Some),
    };
    if let Some(index) = &mut interp.host.index {
        index.note(command, call, result.is_ok());
    }
    result.or_else(|e| e.map_or(Ok(Value::EMPTY), Err))
}

/// Report a mistake, unless it only follows from one already reported.
fn tell(interp: &mut Tcl, wrong: Diagnostic, call: &Call<'_>) {
    if !wrong.absent.as_ref().is_some_and(|a| interp.host.check.holds_back(a)) {
        report_at(interp, wrong, call);
    }
}

/// Report a mistake, with the whole command as its place where it names none.
fn report_at(interp: &mut Tcl, mut wrong: Diagnostic, call: &Call<'_>) {
    if wrong.span.is_none() {
        wrong.span = call.whole_span();
    }
    report(interp, wrong);
}

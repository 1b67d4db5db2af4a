//! Errors between a study and its script: variables that are set and not used, outputs that are not written.

use super::load::{Study, StudyError};
use super::run::ObservedChannel;
use super::script_simulator::{EndedRun, ScriptSimulator};
use super::simulator::SimulationError;
use super::trace::Trace;
use crate::checks;
use hysteron_opensees::run::End;
use hysteron_tcl::diagnostic::{Diagnostic, SourceMap, VARIABLE, nearest};
use std::collections::BTreeSet;

/// Variables that the diagnosis reads from the study, so that a script need not.
const CONTEXT: [&str; 1] = ["axial"];
/// A shorter name is no misspelling of another.
const MIN_TYPO_LENGTH: usize = 3;

/// Uses of the variables that the runs of a study set.
#[derive(Default)]
pub(super) struct SetUses {
    /// Variables that some run has read.
    read: BTreeSet<String>,
    /// Variables that no run has read so far: run, number in its `set`.
    unread: Vec<(usize, usize)>,
    /// Names that the script reads.
    known: BTreeSet<String>,
}

impl SetUses {
    /// Take in the uses of a run that has ended. One that was cut short shows nothing.
    pub(super) fn add(&mut self, study: &Study, run: usize, ended: &EndedRun) {
        if !matches!(ended.end, End::Done | End::Exit(0)) {
            return;
        }
        for (i, ((name, _), watch)) in study.runs[run].set.iter().zip(&ended.set_watches).enumerate() {
            match watch {
                Some(watch) if !watch.was_read() => self.unread.push((run, i)),
                _ => {
                    self.read.insert(name.clone());
                }
            }
        }
        for text in ended.script.interp.sources.texts() {
            self.known.extend(names_read(text).map(str::to_owned));
        }
    }

    /// Check that every variable is read in some run that sets it. Returns warnings about conditions of a test that the
    /// script does not need.
    ///
    /// # Errors
    /// A name that no run reads resembles one that the script reads and the run does not set.
    pub(super) fn check(&self, study: &Study) -> Result<Vec<Diagnostic>, StudyError> {
        let name = |(run, i): &(usize, usize)| study.runs[*run].set[*i].0.as_str();
        let is_unused = |at: &&(usize, usize)| !self.read.contains(name(at)) && !CONTEXT.contains(&name(at));
        let mut warnings: Vec<Diagnostic> = vec![];
        for at in self.unread.iter().filter(is_unused) {
            let message = format!("{} never reads the variable {}", study.model, name(at));
            let span = study.spans.set(at.0, at.1);
            let is_set = |k: &str| study.runs[at.0].set.iter().any(|(n, _)| n == k);
            let others = self.known.iter().map(String::as_str).filter(|k| !is_set(k));
            // Any letter resembles any other.
            let near = nearest(name(at), others).filter(|_| name(at).len() >= MIN_TYPO_LENGTH);
            if near.is_some() {
                let d = Diagnostic::error(message).at(span, "expected a variable that it reads");
                return Err(Box::new(d.suggest(name(at), near)));
            }
            if !warnings.iter().any(|w| w.message == message) {
                warnings.push(Diagnostic::warning(&checks::UNREAD_VARIABLE, message).at(span, "changes nothing"));
            }
        }
        Ok(warnings)
    }
}

/// Names that a text reads as `$name`, `${name}` or `info exists name`, without their namespaces and indices.
fn names_read(text: &str) -> impl Iterator<Item = &str> {
    fn name(rest: &str) -> &str {
        let rest = rest.trim_start_matches(['{', ':', ' ']);
        let end = rest.find(|c: char| !(c.is_alphanumeric() || c == '_'));
        &rest[..end.unwrap_or(rest.len())]
    }
    let dollars = text.split('$').skip(1).map(name);
    dollars.chain(text.split("info exists").skip(1).map(name)).filter(|n| !n.is_empty())
}

/// The error of a script that was rejected, in words of the study where the study is the reason.
pub(super) fn explain(study: &Study, run: usize, ended: &EndedRun, d: &Diagnostic, sources: &SourceMap) -> Diagnostic {
    let mut d = d.clone();
    let spec = &study.runs[run];
    let overwritten = ended.set_watches.iter().position(|w| w.as_ref().is_some_and(|w| w.was_overwritten()));
    if let Some(i) = overwritten {
        let name = &spec.set[i].0;
        d.message = format!("the script sets {name} again, before it reads the value of the study");
        d.label = format!("expected: if {{![info exists {name}]}} {{set {name} ...}}");
        if let Some(span) = study.spans.set(run, i) {
            d.help.push(format!("{}: the study sets {name}", sources.location(span)));
        }
        return d;
    }
    let host = &ended.script.interp.host;
    let parameter = host.watches.iter().flatten().find(|(_, watch)| watch.was_overwritten());
    if let Some((name, _)) = parameter {
        d.message = format!("the script sets {name} again, before it reads the value of pset");
        d.label = "overwrites the value of the study".into();
        if let Some(span) = host.declared_at.get(name) {
            d.help.push(format!("{}: pset declares {name}", ended.script.interp.sources.location(*span)));
        }
        return d;
    }
    // A misspelled name in `set` leaves the right one without a value.
    let missing = d.absent.as_ref().filter(|a| a.kind == VARIABLE).map(|a| a.name.clone());
    if let Some(missing) = missing
        && let Some(i) = spec.set.iter().position(|(n, _)| nearest(&missing, [n.as_str()]).is_some())
        && let Some(span) = study.spans.set(run, i)
    {
        d.help.push(format!(
            "{}: the study sets {}: did you mean \"{missing}\"?",
            sources.location(span),
            spec.set[i].0
        ));
    }
    d
}

/// Files of recorders that a message lists.
const MAX_LISTED: usize = 12;

/// A reason why a trace has no channel: message, label and help; `true` if it is the column.
struct Reason {
    message: String,
    label: String,
    help: Option<String>,
    of_column: bool,
}

/// The error of the first observed channel of a run that its outputs do not give.
pub(super) fn output_error(simulator: &ScriptSimulator, run: usize, ended: &EndedRun) -> StudyError {
    let spec = &simulator.study.runs[run];
    let outputs = spec.observe.iter().zip(&simulator.outputs[run]);
    for (i, (o, (path, output))) in outputs.enumerate() {
        let found = output.with(|trace| reason(trace, &o.output, o.column));
        let Some(Reason { message, label, help, of_column }) = found else { continue };
        let span = simulator.study.spans.channel(run, i).map(|s| if of_column { s.column } else { s.output });
        let mut d = Diagnostic::error(message).at(span, label);
        d.help.extend(help);
        if !of_column && output.with(|t| t.times.is_empty()) {
            add_files(&mut d, &o.output, path, ended);
        }
        return Box::new(d.help(format!("in run \"{}\"", spec.name)));
    }
    let error = simulator.channels(run).err().unwrap_or(SimulationError::Defect);
    let span = simulator.study.spans.recording(run);
    Box::new(Diagnostic::error(format!("run \"{}\": {error}", spec.name)).at(span, "in this run"))
}

/// Why a trace does not give a column; `None` if it does.
fn reason(trace: &Trace, output: &str, column: usize) -> Option<Reason> {
    let of_column = |message: String, label: &str, help: Option<&str>| {
        Some(Reason { message, label: label.into(), help: help.map(str::to_owned), of_column: true })
    };
    if trace.times.is_empty() {
        let (message, label) = (format!("{output} has no rows"), "expected a recorder file of the script".into());
        return Some(Reason { message, label, help: None, of_column: false });
    }
    let has_time = starts_with_time(trace);
    if column >= trace.width {
        let last = trace.width - 1;
        let message = format!("{output} has {} columns, and none of number {column}", trace.width);
        let label = match last {
            0 => "columns count from 0; the file has column 0 alone".into(),
            _ => format!("columns count from 0; the file has columns 0 to {last}"),
        };
        let help = (column == trace.width && !has_time).then_some("-time is missing in that recorder, or count from 0");
        return of_column(message, &label, help);
    }
    if trace.no_clock {
        let message = format!("{output} has times that do not increase: the analysis has no clock");
        return Some(Reason {
            message,
            label: "written by a static analysis whose time is no clock".into(),
            help: Some("LoadControl has a clock; the time of DisplacementControl is a load factor".into()),
            of_column: false,
        });
    }
    let values = || trace.values.iter().skip(column).step_by(trace.width);
    if values().any(|v| !v.is_finite()) {
        return of_column(format!("{output} has numbers in column {column} that are not finite"), "", None);
    }
    None
}

/// Warnings of channels that are compared with the time of their output.
pub(super) fn time_columns(simulator: &ScriptSimulator, run: usize) -> Vec<Diagnostic> {
    let outputs = simulator.study.runs[run].observe.iter().zip(&simulator.outputs[run]).enumerate();
    let is_time = |t: &Trace| t.width > 1 && !t.times.is_empty() && starts_with_time(t);
    let times = outputs.filter(|(_, (o, (_, output)))| o.column == 0 && output.with(is_time));
    let warning = |(i, (o, _)): (usize, (&ObservedChannel, _))| {
        let message = format!("column 0 of {} is the time, and {} is compared with it", o.output, o.channel);
        let span = simulator.study.spans.channel(run, i).map(|s| s.column);
        Diagnostic::warning(&checks::TIME_COLUMN, message)
            .at(span, "columns count from 0; with -time the first value is column 1")
    };
    times.map(warning).collect()
}

/// Returns true if the first column of a trace is the time of its rows.
fn starts_with_time(trace: &Trace) -> bool {
    trace.values.iter().step_by(trace.width).zip(&trace.times).all(|(v, t)| v == t)
}

/// Say which files the recorders of the script have.
fn add_files(d: &mut Diagnostic, output: &str, path: &str, ended: &EndedRun) {
    let Ok(files) = ended.files.lock() else { return };
    if files.iter().any(|(_, p)| p == path) {
        d.help.push("its recorder wrote nothing: is it made after the analysis?".into());
        return;
    }
    let mut names: Vec<&str> = files.iter().map(|(n, _)| n.as_str()).collect();
    names.dedup();
    d.add_suggestion(output, nearest(output, names.iter().copied()));
    d.help.push(match names.len() {
        0 => "the script has no recorder with a file".into(),
        n if n > MAX_LISTED => {
            format!("recorders write {}, and {} more", names[..MAX_LISTED].join(", "), n - MAX_LISTED)
        }
        _ => format!("recorders write {}", names.join(", ")),
    });
}

#[cfg(test)]
mod tests {
    use super::names_read;

    #[test]
    fn names_of_variables_are_found_in_a_script() {
        let text =
            "if {![info exists motion]} {set motion a}\nputs $dt; puts ${n pts}$::k(3)\nset unread 1\nexpr {$x_1*2}";
        let names: Vec<&str> = names_read(text).collect();
        assert_eq!(names, ["dt", "n", "k", "x_1", "motion"]);
    }
}

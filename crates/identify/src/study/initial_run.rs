//! The first run of a script, with its own values of the parameters.

use super::checks::{insensitive_parameters, outside_bounds};
use super::load::{Study, StudyError};
use super::script_errors::{SetUses, explain, output_error, time_columns};
use super::script_simulator::{EndedRun, RunMode, ScriptSimulator};
use super::simulator::SimulationError;
use hysteron_opensees::lockstep::Course;
use hysteron_opensees::run::End;
use hysteron_opensees::warn_of_speedless;
use hysteron_tcl::diagnostic::{Diagnostic, SourceMap, Span, nearest};
use std::collections::BTreeMap;
use std::time::Duration;

/// Limits of one run of a script. Commands and steps give the same limit on any machine; the time is the last resort.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RunLimits {
    /// Commands of the script.
    pub commands: u64,
    /// Steps of its analyses.
    pub steps: u64,
    /// Wall-clock time.
    pub time: Duration,
    /// Number of the last analysis of the first run, where no results of it are asked for.
    pub last_analysis: Option<u64>,
}

impl RunLimits {
    /// Limits of a script that has not run yet.
    pub const UNKNOWN: Self =
        Self { commands: 2_000_000_000, steps: 200_000_000, time: Self::MIN_TIME, last_analysis: None };

    /// Least limit of time, and that of the first run.
    const MIN_TIME: Duration = Duration::from_secs(60);

    /// Commands, and steps, of a run over those of the first run.
    const MARGIN: u64 = 50;
    /// Steps that a run may take beyond those.
    const MORE_STEPS: u64 = 1_000;

    /// Limits from the commands and steps of the first run. Values that converge badly take more of both, but not 50 times.
    pub(super) fn from_first_run(commands: u64, steps: u64, time: Duration) -> Self {
        let (commands, steps) = (Self::MARGIN * commands + 10_000, Self::MARGIN * steps + Self::MORE_STEPS);
        Self { commands, steps, time: time.max(Self::MIN_TIME), last_analysis: None }
    }

    /// Steps of the first run.
    pub(crate) fn first_steps(&self) -> u64 {
        self.steps.saturating_sub(Self::MORE_STEPS) / Self::MARGIN
    }
}

/// Results of the first run of a script.
#[derive(Debug)]
pub struct InitialRun {
    /// Values of the script itself for the parameters of the study, in its order; NaN where it gives none.
    pub values: Vec<f64>,
    /// Byte ranges of these values in the script; `None` where another file, or none, gives the value.
    pub value_spans: Vec<Option<(usize, usize)>>,
    /// Warnings of the script, each once. Their texts are in the source map of the run.
    pub warnings: Vec<Diagnostic>,
    /// The error of the script with its own values, if it fails.
    pub failure: Option<SimulationError>,
    /// Limits of the runs that follow, by run of the study.
    pub limits: Vec<RunLimits>,
    /// Time that the script took for each run of the study.
    pub durations: Vec<Duration>,
}

impl InitialRun {
    /// Returns true if the user or a limit stopped it: what it has is incomplete.
    pub fn is_interrupted(&self) -> bool {
        self.failure == Some(SimulationError::Interrupted)
    }
}

impl ScriptSimulator {
    /// Run the script with its own values, and set the limits of the runs that follow. If it fails with them, it runs with
    /// the values in the middle of the ranges.
    ///
    /// Warnings tell of values outside of their bounds, and of parameters that no observed channel depends on. A run that
    /// is interrupted ends without an error; [`InitialRun::is_interrupted`] tells it.
    ///
    /// # Errors
    /// The script is rejected, never declares a parameter of the study, does not use a variable that a run sets, or does
    /// not write an observed output. Texts that the message points into are added to `sources`.
    pub fn run_initially(&mut self, sources: &mut SourceMap) -> Result<InitialRun, StudyError> {
        let study = self.study.clone();
        let mut initial = InitialRun {
            values: vec![f64::NAN; study.space.parameters.len()],
            value_spans: vec![None; study.space.parameters.len()],
            warnings: vec![],
            failure: None,
            limits: vec![],
            durations: vec![],
        };
        let time_limit = study.calibration.time_limit.map(Duration::from_secs_f64);
        if let Some(time) = time_limit {
            self.limits.iter_mut().for_each(|l| l.time = time);
        }
        let mut uses = SetUses::default();
        for (number, spec) in study.runs.iter().enumerate() {
            let (ended, error) = self.first_run(number, &mut initial);
            if initial.is_interrupted() {
                // What the script has not come to yet is no error of the study.
                return Ok(initial);
            }
            if let Some(SimulationError::TooLong(what)) = &error {
                let d = too_long(self.limits[number].time, &ended, what);
                return Err(with_sources_moved(&ended.script.interp.sources, sources, d, &spec.name));
            }
            if let End::Rejected(d) = &ended.end {
                let d = explain(&study, number, &ended, d, sources);
                return Err(with_sources_moved(&ended.script.interp.sources, sources, d, &spec.name));
            }
            check_declared(&study, &ended.script.interp.host.declared)?;
            uses.add(&study, number, &ended);
            if error.is_none() && self.channels(number).is_err() {
                return Err(output_error(self, number, &ended));
            }
            initial.warnings.extend(time_columns(self, number));
            let interp = &ended.script.interp;
            for (value_span, p) in initial.value_spans.iter_mut().zip(&study.space.parameters) {
                let span = interp.host.declared_at.get(&p.name);
                let span = span.filter(|s| *interp.sources.name(s.source) == *study.model);
                *value_span = span.map(|s| (s.start as usize, s.end as usize)).or(*value_span);
            }
            let speedless = warn_of_speedless(&interp.host);
            for w in interp.warnings.iter().chain(&speedless) {
                let w = *with_sources_moved(&interp.sources, sources, w.clone(), &spec.name);
                if !initial.warnings.iter().any(|o| o.message == w.message) {
                    initial.warnings.push(w);
                }
            }
            initial.durations.push(ended.time);
            let commands = RunLimits::UNKNOWN.commands - interp.budget.unwrap_or(0);
            let mut limits = RunLimits::from_first_run(commands, interp.host.engine.steps, 20 * ended.time);
            limits.time = time_limit.unwrap_or(limits.time);
            limits.last_analysis = interp.host.course.and_then(|c| c.last_analysis());
            self.limits[number] = limits;
        }
        initial.limits.clone_from(&self.limits);
        initial.warnings.extend(uses.check(&study)?);
        initial.warnings.extend(outside_bounds(&study, &initial.values));
        let insensitive = insensitive_parameters(self, &initial.values);
        initial.warnings.extend(insensitive);
        Ok(initial)
    }

    /// One run with the script's own values, or with those in the middle of the ranges if it fails; its error.
    fn first_run(&self, number: usize, initial: &mut InitialRun) -> (EndedRun, Option<SimulationError>) {
        let watched = || RunMode { watched: true, course: Some(Course::default()), ..RunMode::default() };
        let ended = self.run(number, None, watched());
        take_declared_values(&self.study, &ended.script.interp.host.declared, &mut initial.values);
        let error = self.error(&ended, number);
        let space = &self.study.space;
        let (Some(error), Ok(middle)) = (&error, space.values_at(&vec![0.5; space.dimension()])) else {
            return (ended, error);
        };
        if matches!(error, SimulationError::TooLong(_)) {
            return (ended, Some(error.clone()));
        }
        // An interrupt ends the run whatever failed before it.
        if initial.failure.is_none() || *error == SimulationError::Interrupted {
            initial.failure = Some(error.clone());
        }
        if initial.is_interrupted() {
            return (ended, None);
        }
        let ended = self.run(number, Some(&middle), watched());
        let error = self.error(&ended, number);
        if error == Some(SimulationError::Interrupted) {
            initial.failure.clone_from(&error);
        }
        (ended, error)
    }
}

/// The error of a script whose first run does not come to its end.
fn too_long(limit: Duration, ended: &EndedRun, what: &str) -> Diagnostic {
    let interp = &ended.script.interp;
    let message = format!("the script exceeds {what}, after {:.0} s", ended.time.as_secs_f64());
    let d = Diagnostic::error(message).at(interp.stopped_at, "stopped here");
    let limit = limit.as_secs_f64();
    d.help(format!("a run may take {limit} s: time_limit of [calibration] gives another limit"))
}

/// Take the declared values of the parameters.
fn take_declared_values(study: &Study, declared: &BTreeMap<String, f64>, values: &mut [f64]) {
    for (v, p) in values.iter_mut().zip(&study.space.parameters) {
        if let Some(x) = declared.get(&p.name) {
            *v = *x;
        }
    }
}

/// Check that the script has declared all parameters.
fn check_declared(study: &Study, declared: &BTreeMap<String, f64>) -> Result<(), StudyError> {
    for (p, span) in study.space.parameters.iter().zip(&study.spans.names) {
        if !declared.contains_key(&p.name) {
            let message = format!("{} never declares the parameter {}", study.model, p.name);
            let d = Diagnostic::error(message).at(Some(*span), "expected the name of a pset command");
            let mut d = d.suggest(&p.name, nearest(&p.name, declared.keys().map(String::as_str)));
            if declared.is_empty() {
                d = d.help(format!("declare it in the script: pset {} VALUE", p.name));
            }
            return Err(Box::new(d));
        }
    }
    Ok(())
}

/// A message about a script, with the texts that it points into moved to another source map.
fn with_sources_moved(from: &SourceMap, to: &mut SourceMap, mut d: Diagnostic, run: &str) -> StudyError {
    let mut shift = |span: &mut Span| {
        let (name, text) = (from.name(span.source), from.text(span.source));
        span.source = to.find(&name, &text).unwrap_or_else(|| to.add(&name, &text));
    };
    d.span.iter_mut().for_each(&mut shift);
    d.callers.iter_mut().for_each(|c| shift(&mut c.span));
    d.help.push(format!("in run \"{run}\""));
    Box::new(d)
}

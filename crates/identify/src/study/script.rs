//! The simulator that runs the script of a study: in this process, its files read once, its recorders in memory.

use super::files::{Contents, StudyFiles};
use super::load::{Rejected, Study};
use super::run::{Role, Setting};
use super::simulator::{Mishap, Simulator};
use super::trace::{Trace, TraceOutput, Unobserved};
use hysteron_engine::analysis::{Cause, Engine, Failure, Options};
use hysteron_engine::record::{Output, RecordError};
use hysteron_opensees::run::{End, Run, Settings};
use hysteron_opensees::{FileFormat, Mode, NumberFiles, Outputs, Progress};
use hysteron_tcl::diagnostic::{Diagnostic, SourceMap, nearest};
use hysteron_tcl::{Console, OverlayFiles, Value};
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

/// What a run may use up before it is cut off. Commands and steps are counted, so that the cut is at the same place
/// whatever the machine does besides; the time is the last resort.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Commands of the script.
    pub commands: u64,
    /// Steps of its analyses.
    pub steps: u64,
    /// Time.
    pub time: Duration,
}

impl Limits {
    /// For a script that is not known yet.
    pub const UNKNOWN: Self = Self { commands: 2_000_000_000, steps: 200_000_000, time: Duration::from_secs(600) };

    /// What a run of the same script may take, when one has taken this: values of parameters that converge badly take
    /// more steps and remedies, but not this many.
    fn of(commands: u64, steps: u64, time: Duration) -> Self {
        Self { commands: 50 * commands + 10_000, steps: 50 * steps + 1_000, time: time.max(Self::LEAST_TIME) }
    }

    const LEAST_TIME: Duration = Duration::from_secs(60);
}

/// What the script does before anything is changed.
#[derive(Debug)]
pub struct Opening {
    /// The values that the script itself gives to the parameters of the study, in its order; NaN where it gives none.
    pub values: Vec<f64>,
    /// Where these values stand: bytes of the script that the study names; none where it gives none, or another file does.
    pub places: Vec<Option<(usize, usize)>>,
    /// Warnings of the script, each told once, and the texts that they point into.
    pub warnings: Vec<Diagnostic>,
    /// Why the script fails with its own values, if it does.
    pub failure: Option<Mishap>,
    /// What the runs may use up from now on.
    pub limits: Vec<Limits>,
}

/// Runs the script of a study.
pub struct ScriptSimulator {
    study: Arc<Study>,
    options: Options,
    limits: Vec<Limits>,
    contents: Contents,
    numbers: NumberFiles,
    stop: Arc<AtomicBool>,
    /// For each run, the outputs that it observes.
    outputs: Vec<Vec<(String, TraceOutput)>>,
}

/// What simulators of a study are made from.
#[derive(Clone)]
pub struct Blueprint {
    study: Arc<Study>,
    options: Options,
    limits: Vec<Limits>,
    contents: Contents,
    numbers: NumberFiles,
    stop: Arc<AtomicBool>,
}

impl Blueprint {
    /// A simulator of another study with the same runs, whose script is the given text.
    pub fn simulator_of(&self, study: Arc<Study>, text: &str) -> ScriptSimulator {
        let contents = self.contents.with(&study.absolute(&study.model), text);
        let fresh = ScriptSimulator::new(study, self.options.clone(), self.stop.clone());
        ScriptSimulator { limits: self.limits.clone(), contents, numbers: self.numbers.clone(), ..fresh }
    }

    /// The same, with another text for one file of the study.
    #[must_use]
    pub fn with_file(&self, file: &str, text: &str) -> Self {
        Self { contents: self.contents.with(&self.study.absolute(file), text), ..self.clone() }
    }

    /// Make the steps of the script in so many parts.
    pub fn refine(&mut self, parts: u32) {
        self.options.refine = parts;
    }

    /// A simulator.
    pub fn simulator(&self) -> ScriptSimulator {
        let fresh = ScriptSimulator::new(self.study.clone(), self.options.clone(), self.stop.clone());
        let (contents, numbers) = (self.contents.clone(), self.numbers.clone());
        ScriptSimulator { limits: self.limits.clone(), contents, numbers, ..fresh }
    }
}

/// Writes nothing.
struct Silent;

impl Console for Silent {
    fn out(&mut self, _: &str) {}
    fn err(&mut self, _: &str) {}
}

/// Outputs that no channel observes, by the name that the script gives them.
type Others = Arc<Mutex<Vec<(String, TraceOutput)>>>;

/// Observed outputs in memory, the others where they are wanted, or nowhere.
struct Observed {
    observed: Vec<(String, TraceOutput)>,
    others: Option<Others>,
}

impl Outputs for Observed {
    fn create(&mut self, name: &str, path: &Path, _: FileFormat) -> Result<Box<dyn Output>, RecordError> {
        if let Some((_, trace)) = self.observed.iter().find(|(p, _)| Path::new(p) == path) {
            trace.clear();
            return Ok(Box::new(trace.clone()));
        }
        let Some(Ok(mut others)) = self.others.as_ref().map(|o| o.lock()) else { return Ok(Box::new(Unobserved)) };
        let trace = TraceOutput::default();
        others.retain(|(n, _)| n != name);
        others.push((name.to_owned(), trace.clone()));
        Ok(Box::new(trace))
    }
}

/// Cuts a run off that takes too long, or that nobody waits for any more.
struct Watch {
    cut: Arc<AtomicBool>,
    stop: Arc<AtomicBool>,
    steps: u64,
    limits: Limits,
    begun: Instant,
}

impl Progress for Watch {
    fn step(&mut self, _: f64, _: Option<f64>) {
        self.steps += 1;
        let looks = self.steps.is_multiple_of(64);
        if self.steps > self.limits.steps
            || looks && (self.stop.load(Ordering::Relaxed) || self.begun.elapsed() > self.limits.time)
        {
            self.cut.store(true, Ordering::Relaxed);
        }
    }
}

/// How a run of the script went.
struct Ended {
    run: Run,
    end: End,
    time: Duration,
}

impl ScriptSimulator {
    /// A simulator of a study. All stop when the flag is set.
    pub fn new(study: Arc<Study>, options: Options, stop: Arc<AtomicBool>) -> Self {
        let path = |output: &str| study.absolute(output);
        let outputs = study.runs.iter().map(|r| {
            let mut all: BTreeMap<String, TraceOutput> = BTreeMap::new();
            for o in &r.observe {
                all.entry(path(&o.output)).or_default();
            }
            // One for each channel, those of a file sharing its rows.
            r.observe.iter().map(|o| (path(&o.output), all.entry(path(&o.output)).or_default().clone())).collect()
        });
        let limits = vec![Limits::UNKNOWN; study.runs.len()];
        let (contents, numbers) = (Contents::default(), NumberFiles::default());
        Self { outputs: outputs.collect(), study, options, limits, contents, numbers, stop }
    }

    /// What others of the same study are made from, in other threads; they share the files that were read.
    pub fn blueprint(&self) -> Blueprint {
        Blueprint {
            study: self.study.clone(),
            options: self.options.clone(),
            limits: self.limits.clone(),
            contents: self.contents.clone(),
            numbers: self.numbers.clone(),
            stop: self.stop.clone(),
        }
    }

    /// The study.
    pub fn study(&self) -> &Arc<Study> {
        &self.study
    }

    /// Run the script, which may be the beginning of one, and look at the model that it has made.
    pub fn look<R>(&self, run: usize, values: &[f64], look: impl FnOnce(&Engine) -> R) -> R {
        look(&self.run(run, Some(values), None).run.interp.host.engine)
    }

    /// Run the script with values of the study's parameters, or with its own.
    fn run(&self, run: usize, values: Option<&[f64]>, others: Option<Others>) -> Ended {
        let spec = &self.study.runs[run];
        let settings = Settings { mode: Mode::Run, strict: false, options: self.options.clone() };
        let files = OverlayFiles::new(Box::new(StudyFiles::new(&self.study.folder_text(), &self.contents)));
        let outputs = Observed { observed: self.outputs[run].clone(), others };
        self.outputs[run].iter().for_each(|(_, t)| t.clear());
        let mut script = Run::new(settings, Box::new(Silent), Box::new(files), Box::new(outputs));
        let begun = Instant::now();
        let limits = self.limits[run];
        let cut = script.interp.interrupt.clone();
        script.interp.host.set_progress(Box::new(Watch { cut, stop: self.stop.clone(), steps: 0, limits, begun }));
        script.interp.host.number_files = self.numbers.clone();
        script.interp.budget = Some(limits.commands);
        if let Some(values) = values {
            let named = self.study.space.parameters.iter().zip(values);
            script.interp.host.parameters = named.map(|(p, v)| (p.name.clone(), *v)).collect();
        }
        let set = spec.set.iter().try_for_each(|(name, value)| script.interp.set_global(name, variable(value)));
        let end = match set {
            Ok(()) => script.script(&self.study.model, &[]),
            Err(_) => End::Rejected(Box::new(Diagnostic::error("a variable of this run cannot be set"))),
        };
        Ended { run: script, end, time: begun.elapsed() }
    }

    /// Why a run that has ended has no answer.
    fn mishap(&self, ended: &Ended, run: usize) -> Option<Mishap> {
        let interp = &ended.run.interp;
        let told = |d: &Diagnostic| match d.span {
            Some(span) => format!("{}: {}", interp.sources.location(span), d.message),
            None => d.message.clone(),
        };
        Some(match &ended.end {
            End::Done | End::Exit(0) => match &interp.host.last_failure {
                Some(failure) => failed(failure),
                None => return None,
            },
            End::Failed(failure) => failed(failure),
            End::Exit(status) => Mishap::Exit(*status),
            // A script that gives up does so because its analysis has failed.
            End::Raised(d) => match &interp.host.last_failure {
                Some(failure) => failed(failure),
                None => Mishap::Raised(told(d)),
            },
            End::Rejected(d) => Mishap::Rejected(told(d)),
            End::Interrupted | End::Enough(_) if self.stop.load(Ordering::Relaxed) => Mishap::Interrupted,
            End::Interrupted | End::Enough(_) => Mishap::TooLong(match interp.budget {
                Some(0) => "the commands that it may run",
                _ if ended.time > self.limits[run].time => "the time that it may take",
                _ => "the steps that it may make",
            }),
        })
    }

    /// The observed channels at the times of the recording.
    fn channels(&self, run: usize) -> Result<Vec<Vec<f64>>, Mishap> {
        let spec = &self.study.runs[run];
        let channel = |(o, (_, output)): (&super::Observe, &(String, TraceOutput))| {
            output.with(|trace| {
                let missing = |why: String| Err(Mishap::NoOutput(format!("{} {why}", o.output)));
                if trace.times.is_empty() {
                    return missing("has no rows".into());
                }
                if o.column >= trace.width {
                    return missing(format!("has {} columns, and none of number {}", trace.width, o.column));
                }
                if trace.no_clock {
                    return missing("has times that do not increase: the analysis has no clock".into());
                }
                let column = trace.values.iter().skip(o.column).step_by(trace.width);
                if column.clone().any(|v| !v.is_finite()) {
                    return Err(Mishap::NotFinite(format!("{} column {}", o.output, o.column)));
                }
                Ok(trace.sample(o.column, &spec.recording.times))
            })
        };
        spec.observe.iter().zip(&self.outputs[run]).map(channel).collect()
    }

    /// What an output that is observed wrote in the last run, by the name that the study gives it.
    pub fn trace(&self, run: usize, output: &str) -> Option<Trace> {
        let at = self.study.runs[run].observe.iter().position(|o| o.output == output)?;
        Some(self.outputs[run][at].1.with(Trace::clone))
    }

    /// What a run moves through: displacements at the times of its recording, and what they are called. Those recorded, where
    /// the recording has them; otherwise the first recorder of the script that is no channel and whose file is called so.
    pub fn displacement(&self, run: usize, values: &[f64]) -> Option<(String, Vec<f64>)> {
        let recording = &self.study.runs[run].recording;
        let is_length = |unit: &str| ["m", "mm", "cm", "in", "ft"].contains(&unit);
        let recorded = recording.columns.iter().find(|c| is_length(&c.unit) || c.name.starts_with("disp"));
        if let Some(c) = recorded {
            return Some((format!("{} [{}]", c.name, c.unit), c.values.clone()));
        }
        let others = Others::default();
        self.run(run, Some(values), Some(others.clone()));
        let others = others.lock().ok()?;
        let (name, trace) = others.iter().find(|(name, _)| name.contains("disp"))?;
        let column = |t: &Trace| (t.width > 1).then(|| t.sample(1, &recording.times));
        Some((format!("{name}, column 1, simulated"), trace.with(column)?))
    }

    /// Run the script with its own values, and set limits for what follows. Where it does not run at all with its own
    /// values, with those in the middle of the ranges.
    ///
    /// # Errors
    /// The script is wrong, or is not the one that the study means: a parameter that it never declares, an output that
    /// it does not write. Texts that the message points into are added to `sources`.
    pub fn open(&mut self, sources: &mut SourceMap) -> Result<Opening, Rejected> {
        let study = self.study.clone();
        let middle = study.space.values(&vec![0.5; study.space.dimension()]).ok();
        let mut opening = Opening {
            values: vec![f64::NAN; study.space.parameters.len()],
            places: vec![None; study.space.parameters.len()],
            warnings: vec![],
            failure: None,
            limits: self.limits.clone(),
        };
        if let Some(seconds) = study.calibration.time_limit {
            self.limits.iter_mut().for_each(|l| l.time = Duration::from_secs_f64(seconds));
        }
        for (number, spec) in study.runs.iter().enumerate() {
            let mut ended = self.run(number, None, None);
            let mut mishap = self.mishap(&ended, number);
            if let (Some(_), Some(values)) = (&mishap, &middle) {
                let own = ended.run.interp.host.declared.clone();
                take_values(&study, &own, &mut opening.values);
                let why = mishap.take();
                if !matches!(why, Some(Mishap::Interrupted)) {
                    ended = self.run(number, Some(values), None);
                    mishap = self.mishap(&ended, number);
                }
                opening.failure = opening.failure.or(why);
            } else {
                take_values(&study, &ended.run.interp.host.declared, &mut opening.values);
            }
            if let End::Rejected(d) = ended.end {
                return Err(moved(&ended.run.interp.sources, sources, *d, &spec.name));
            }
            for (p, span) in study.space.parameters.iter().zip(&study.names) {
                let declared = &ended.run.interp.host.declared;
                if !declared.contains_key(&p.name) {
                    let message = format!("{} never declares the parameter {}", study.model, p.name);
                    let mut d = Diagnostic::error(message).at(Some(*span), "expected the name of a pset command");
                    if let Some(near) = nearest(&p.name, declared.keys().map(String::as_str)) {
                        d = d.help(format!("did you mean \"{near}\"?"));
                    }
                    return Err(Box::new(d));
                }
            }
            if mishap.is_none()
                && let Err(e) = self.channels(number)
            {
                return Err(Box::new(Diagnostic::error(format!("run \"{}\": {e}", spec.name))));
            }
            for (place, p) in opening.places.iter_mut().zip(&study.space.parameters) {
                let interp = &ended.run.interp;
                let span = interp.host.declared_at.get(&p.name);
                let span = span.filter(|s| *interp.sources.name(s.source) == *study.model);
                *place = span.map(|s| (s.start as usize, s.end as usize)).or(*place);
            }
            for w in &ended.run.interp.warnings {
                let w = *moved(&ended.run.interp.sources, sources, w.clone(), &spec.name);
                if !opening.warnings.iter().any(|o| o.message == w.message) {
                    opening.warnings.push(w);
                }
            }
            let used = Limits::UNKNOWN.commands - ended.run.interp.budget.unwrap_or(0);
            let mut limits = Limits::of(used, ended.run.interp.host.engine.steps, 20 * ended.time);
            if let Some(seconds) = study.calibration.time_limit {
                limits.time = Duration::from_secs_f64(seconds);
            }
            self.limits[number] = limits;
        }
        opening.limits.clone_from(&self.limits);
        let fits = study.runs_of(Role::Fit).count();
        debug_assert!(fits > 0, "a study has a run to fit");
        Ok(opening)
    }
}

/// The script's own values of the parameters.
fn take_values(study: &Study, declared: &BTreeMap<String, f64>, values: &mut [f64]) {
    for (v, p) in values.iter_mut().zip(&study.space.parameters) {
        if let Some(x) = declared.get(&p.name) {
            *v = *x;
        }
    }
}

fn failed(failure: &Failure) -> Mishap {
    match failure.cause {
        Cause::Interrupted => Mishap::Interrupted,
        _ => Mishap::Failed(failure.to_string()),
    }
}

fn variable(value: &Setting) -> Value {
    match value {
        Setting::Text(s) => Value::from(s.as_str()),
        Setting::Whole(i) => Value::from(*i),
        Setting::Number(x) => Value::from(*x),
        Setting::List(words) => Value::list(words.iter().map(|w| Value::from(w.as_str()))),
    }
}

/// A message about a script with its places in another collection of texts.
fn moved(from: &SourceMap, to: &mut SourceMap, mut d: Diagnostic, run: &str) -> Rejected {
    let mut shift = |span: &mut hysteron_tcl::diagnostic::Span| {
        let (name, text) = (from.name(span.source), from.text(span.source));
        span.source = to.find(&name, &text).unwrap_or_else(|| to.add(&name, &text));
    };
    d.span.iter_mut().for_each(&mut shift);
    d.callers.iter_mut().for_each(|c| shift(&mut c.span));
    d.help.push(format!("in run \"{run}\""));
    Box::new(d)
}

impl Simulator for ScriptSimulator {
    fn simulate(&mut self, run: usize, values: &[f64]) -> Result<Vec<Vec<f64>>, Mishap> {
        if self.stop.load(Ordering::Relaxed) {
            return Err(Mishap::Interrupted);
        }
        let ended = self.run(run, Some(values), None);
        match self.mishap(&ended, run) {
            Some(mishap) => Err(mishap),
            None => self.channels(run),
        }
    }
}

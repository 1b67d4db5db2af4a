//! The simulator that runs the script of a study in this process, with its recorders in memory.

use super::cached_files::{CachedFiles, FileContents};
use super::initial_run::RunLimits;
use super::load::Study;
use super::loop_measure::LoopMeasure;
use super::run::{ObservedChannel, Run, Setting};
use super::simulator::{Channels, SimulationError, Simulator};
use super::trace::{Trace, TraceOutput, Unobserved};
use hysteron_engine::analysis::{Cause, Engine, Failure, Options};
use hysteron_engine::record::{Output, RecordError};
use hysteron_opensees::lockstep::Course;
use hysteron_opensees::run::{End, Run as ScriptRun, Settings};
use hysteron_opensees::{FileFormat, Mode, NumberFiles, Outputs, Progress};
use hysteron_tcl::diagnostic::Diagnostic;
use hysteron_tcl::{Exception, OverlayFiles, Silent, Value, Watch};
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

/// Runs the script of a study.
pub struct ScriptSimulator {
    pub(super) study: Arc<Study>,
    options: Options,
    pub(super) limits: Vec<RunLimits>,
    contents: FileContents,
    numbers: NumberFiles,
    pub(super) stop: Arc<AtomicBool>,
    /// The outputs of the observed channels, by run: path and trace. Those of the deformations of measures follow.
    pub(super) outputs: Vec<Vec<(String, TraceOutput)>>,
    /// Simulators of candidates that are analysed side by side with those of this one.
    pub(super) beside: Vec<ScriptSimulator>,
}

/// Makes simulators of a study. It can be sent to other threads, unlike the simulators.
#[derive(Clone)]
pub struct SimulatorFactory {
    study: Arc<Study>,
    options: Options,
    limits: Vec<RunLimits>,
    contents: FileContents,
    numbers: NumberFiles,
    stop: Arc<AtomicBool>,
}

impl SimulatorFactory {
    /// A simulator of the study.
    pub fn simulator(&self) -> ScriptSimulator {
        self.with_contents(self.study.clone(), self.contents.clone())
    }

    /// A simulator of another study with the same runs, whose script is `text`.
    pub fn simulator_of_script(&self, study: Arc<Study>, text: &str) -> ScriptSimulator {
        let contents = self.contents.with_text(&study.absolute(&study.model), text);
        self.with_contents(study, contents)
    }

    fn with_contents(&self, study: Arc<Study>, contents: FileContents) -> ScriptSimulator {
        let simulator = ScriptSimulator::new(study, self.options.clone(), self.stop.clone());
        ScriptSimulator { limits: self.limits.clone(), contents, numbers: self.numbers.clone(), ..simulator }
    }

    /// A factory with another text for one file of the study.
    #[must_use]
    pub fn with_file(&self, file: &str, text: &str) -> Self {
        Self { contents: self.contents.with_text(&self.study.absolute(file), text), ..self.clone() }
    }

    /// Divide each step of the script into `parts` steps.
    pub fn refine(&mut self, parts: u32) {
        self.options.refine = parts;
    }
}

/// Traces of recorders that are not observed, by the file name in the script.
pub(super) type UnobservedTraces = Arc<Mutex<Vec<(String, TraceOutput)>>>;

/// Names of the files of all recorders of a run, as the script has them, with their absolute paths.
pub(super) type RecorderFiles = Arc<Mutex<Vec<(String, String)>>>;

/// Outputs of a run: observed ones in memory, the others in memory if they are wanted.
struct RunOutputs {
    observed: Vec<(String, TraceOutput)>,
    others: Option<UnobservedTraces>,
    files: RecorderFiles,
}

impl Outputs for RunOutputs {
    fn create(&mut self, name: &str, path: &Path, _: FileFormat) -> Result<Box<dyn Output>, RecordError> {
        if let Ok(mut files) = self.files.lock() {
            files.push((name.to_owned(), path.to_string_lossy().into_owned()));
        }
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

/// Interrupts a run that exceeds its limits, or whose result is not wanted any more.
struct LimitWatch {
    interrupt: Arc<AtomicBool>,
    stop: Arc<AtomicBool>,
    steps: u64,
    limits: RunLimits,
    begun: Instant,
    last_look: Instant,
    /// The clock is read at every step.
    slow_steps: bool,
}

/// Time between two looks at the clock from which on steps are slow.
const SLOW_STEPS: Duration = Duration::from_millis(20);

impl Progress for LimitWatch {
    fn step(&mut self, _: f64, _: Option<f64>) {
        self.steps += 1;
        // Reading the clock takes longer than a small step.
        if self.slow_steps || self.steps.is_multiple_of(64) {
            let now = Instant::now();
            self.slow_steps = now - self.last_look > SLOW_STEPS;
            self.last_look = now;
            if self.stop.load(Ordering::Relaxed) || now - self.begun > self.limits.time {
                self.interrupt.store(true, Ordering::Relaxed);
            }
        }
        if self.steps > self.limits.steps {
            self.interrupt.store(true, Ordering::Relaxed);
        }
    }
}

/// A run of the script that has ended.
pub(super) struct EndedRun {
    pub(super) script: ScriptRun,
    pub(super) end: End,
    pub(super) time: Duration,
    /// Files of its recorders.
    pub(super) files: RecorderFiles,
    /// First uses of the variables that the run sets, in a watched run.
    pub(super) set_watches: Vec<Option<Watch>>,
}

/// A run of the script that has come to its end, with its recorders open.
pub(super) struct BegunRun {
    pub(super) script: ScriptRun,
    result: Result<Value, Exception>,
    begun: Instant,
    files: RecorderFiles,
    set_watches: Vec<Option<Watch>>,
}

impl BegunRun {
    /// Finish its recorders.
    pub(super) fn conclude(mut self) -> EndedRun {
        let end = self.script.close(self.result);
        let Self { script, begun, files, set_watches, .. } = self;
        EndedRun { script, end, time: begun.elapsed(), files, set_watches }
    }
}

/// Settings of a run besides the values of its parameters.
#[derive(Default)]
pub(super) struct RunMode {
    /// Keep the outputs that are not observed.
    pub(super) others: Option<UnobservedTraces>,
    /// Note the first use of the variables that the study sets.
    pub(super) watched: bool,
    /// Follow the course of the run.
    pub(super) course: Option<Course>,
}

/// The output of each observed channel of a run, with its path, and those of the deformations of its measures. Channels of
/// one file share it: `make` makes it for the columns that they observe, in rising order.
fn outputs(study: &Study, run: &Run, make: impl Fn(&[usize]) -> TraceOutput) -> Vec<(String, TraceOutput)> {
    let mut columns: BTreeMap<String, Vec<usize>> = BTreeMap::new();
    for o in &run.observe {
        columns.entry(study.absolute(&o.output)).or_default().push(o.column);
        if let Some(m) = &o.measure {
            columns.entry(study.absolute(&m.output)).or_default().push(m.column);
        }
    }
    let made = columns.into_iter().map(|(path, mut columns)| {
        columns.sort_unstable();
        columns.dedup();
        (path, make(&columns))
    });
    let made: BTreeMap<String, TraceOutput> = made.collect();
    let channels = run.observe.iter().map(|o| &o.output);
    let deformations = run.observe.iter().filter_map(|o| o.measure.as_ref()).map(|m| &m.output);
    let of = |file: &String| made.get_key_value(&study.absolute(file));
    let all = channels.chain(deformations).filter_map(of);
    all.map(|(path, output)| (path.clone(), output.clone())).collect()
}

impl ScriptSimulator {
    /// A simulator of a study. Its runs end when `stop` is set.
    pub fn new(study: Arc<Study>, options: Options, stop: Arc<AtomicBool>) -> Self {
        let outputs = study.runs.iter().map(|r| outputs(&study, r, |_| TraceOutput::default()));
        let limits = vec![RunLimits::UNKNOWN; study.runs.len()];
        let (contents, numbers) = (FileContents::default(), NumberFiles::default());
        let outputs = outputs.collect();
        Self { outputs, study, options, limits, contents, numbers, stop, beside: vec![] }
    }

    /// The same with outputs that keep nothing but the observed columns.
    pub(super) fn keeping_observed(mut self) -> Self {
        let of = |columns: &[usize]| TraceOutput::of_columns(columns.to_vec());
        self.outputs = self.study.runs.iter().map(|r| outputs(&self.study, r, of)).collect();
        self
    }

    /// A factory of simulators with the same study, limits and cached files.
    pub fn factory(&self) -> SimulatorFactory {
        SimulatorFactory {
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

    /// Files that the scripts of this simulator and its factory have read: absolute paths and texts, in the order of the paths.
    pub fn files_read(&self) -> Vec<(String, String)> {
        self.contents.texts()
    }

    /// Run the script, which may be the beginning of one, and inspect the model at its end.
    pub fn inspect_model<R>(&self, run: usize, values: &[f64], inspect: impl FnOnce(&Engine) -> R) -> R {
        inspect(&self.run(run, Some(values), RunMode::default()).script.interp.host.engine)
    }

    /// Run the script with `values` of the parameters, or with its own values.
    pub(super) fn run(&self, run: usize, values: Option<&[f64]>, mode: RunMode) -> EndedRun {
        self.begin(run, values, mode).conclude()
    }

    /// The same up to the end of the script; its recorders are still open.
    pub(super) fn begin(&self, run: usize, values: Option<&[f64]>, mode: RunMode) -> BegunRun {
        let RunMode { others, watched, course } = mode;
        let spec = &self.study.runs[run];
        let settings = Settings { mode: Mode::Run, strict: false, options: self.options.clone() };
        let files = OverlayFiles::new(Box::new(CachedFiles::new(&self.study.folder_text(), &self.contents)));
        let recorders = RecorderFiles::default();
        let outputs = RunOutputs { observed: self.outputs[run].clone(), others, files: recorders.clone() };
        self.outputs[run].iter().for_each(|(_, t)| t.clear());
        let mut script = ScriptRun::with_course(settings, course, Box::new(Silent), Box::new(files), Box::new(outputs));
        let begun = Instant::now();
        let limits = self.limits[run];
        let interrupt = script.interp.interrupt.clone();
        let watch = LimitWatch {
            interrupt,
            stop: self.stop.clone(),
            steps: 0,
            limits,
            begun,
            last_look: begun,
            slow_steps: false,
        };
        script.interp.host.set_progress(Box::new(watch));
        script.interp.host.number_files = self.numbers.clone();
        script.interp.budget = Some(limits.commands);
        script.interp.deadline = begun.checked_add(limits.time);
        script.interp.group_interrupt = Some(self.stop.clone());
        if let Some(values) = values {
            let named = self.study.space.parameters.iter().zip(values);
            script.interp.host.parameters = named.map(|(p, v)| (p.name.clone(), *v)).collect();
        }
        let set = spec.set.iter().try_for_each(|(name, value)| script.interp.set_global(name, tcl_value(value)));
        let mut set_watches = vec![];
        if watched {
            set_watches.extend(spec.set.iter().map(|(name, _)| script.interp.watch_var(name)));
            script.interp.host.watches = Some(BTreeMap::new());
        }
        let result = match set {
            Ok(()) => script.begin(&self.study.model, &[]),
            Err(_) => Err(Exception::error("a variable of this run cannot be set".to_owned())),
        };
        BegunRun { script, result, begun, files: recorders, set_watches }
    }

    /// The error of a run that has ended, if it failed.
    pub(super) fn error(&self, ended: &EndedRun, run: usize) -> Option<SimulationError> {
        let interp = &ended.script.interp;
        let text = |d: &Diagnostic| match d.span {
            Some(span) => format!("{}: {}", interp.sources.location(span), d.message),
            None => d.message.clone(),
        };
        Some(match &ended.end {
            End::Done | End::Exit(0) => match &interp.host.last_failure {
                Some(failure) => analysis_error(failure),
                None => return None,
            },
            End::Failed(failure) | End::Ignored(failure) => analysis_error(failure),
            End::Exit(status) => SimulationError::Exit(*status),
            // Scripts raise errors after a failed analysis: the analysis is the cause.
            End::Raised(d) => match &interp.host.last_failure {
                Some(failure) => analysis_error(failure),
                None => SimulationError::Raised(text(d)),
            },
            End::Rejected(d) => SimulationError::Rejected(text(d)),
            End::Interrupted | End::Enough(_) if self.stop.load(Ordering::Relaxed) => SimulationError::Interrupted,
            End::Interrupted | End::Enough(_) => SimulationError::TooLong(match interp.budget {
                Some(0) => "the commands that it may run",
                _ if ended.time > self.limits[run].time => "the time that it may take",
                _ => "the steps that it may make",
            }),
        })
    }

    /// The observed channels of the last run at the times of the recording.
    pub(super) fn channels(&self, run: usize) -> Result<Vec<Vec<f64>>, SimulationError> {
        let spec = &self.study.runs[run];
        let channel = |(o, (_, output)): (&ObservedChannel, &(String, TraceOutput))| {
            let times: Cow<'_, [f64]> = match o.shift == 0.0 {
                true => Cow::Borrowed(&spec.recording.times),
                false => spec.recording.times.iter().map(|t| t + o.shift).collect(),
            };
            match &o.measure {
                None => output.with(|trace| sample(trace, &o.output, o.column, &times)),
                Some(measure) => self.measured(run, o, measure, output, &times),
            }
        };
        spec.observe.iter().zip(&self.outputs[run]).map(channel).collect()
    }

    /// A measure of the loops of an output over a deformation, at times of the recording.
    fn measured(
        &self,
        run: usize,
        o: &ObservedChannel,
        measure: &LoopMeasure,
        output: &TraceOutput,
        times: &[f64],
    ) -> Result<Vec<f64>, SimulationError> {
        let path = self.study.absolute(&measure.output);
        let Some((_, deformation)) = self.outputs[run].iter().find(|(p, _)| *p == path) else {
            return Err(SimulationError::NoOutput(measure.output.clone()));
        };
        let rows = output.with(|trace| trace.times.clone());
        let force = output.with(|trace| sample(trace, &o.output, o.column, &rows))?;
        let deformation = deformation.with(|trace| sample(trace, &measure.output, measure.column, &rows))?;
        measure.sample(&rows, &deformation, &force, times).map_err(|t| {
            let Run { name, .. } = &self.study.runs[run];
            let message = format!("{} of run \"{name}\": no complete cycle of {} at {t} s", o.channel, measure.output);
            SimulationError::NoOutput(message)
        })
    }

    /// The trace of an observed output in the last simulation of a run, by its name in the study.
    pub fn trace(&self, run: usize, output: &str) -> Option<Trace> {
        let at = self.study.runs[run].observe.iter().position(|o| o.output == output)?;
        Some(self.outputs[run][at].1.with(Trace::clone))
    }

    /// Names of the recorder columns that the channels of a run observe: "node 3 dof 1". Empty for a column that is not there.
    /// Makes a run.
    pub fn column_names(&self, run: usize, values: &[f64]) -> Vec<String> {
        self.run(run, Some(values), RunMode::default());
        let channels = self.study.runs[run].observe.iter().zip(&self.outputs[run]);
        channels.map(|(o, (_, t))| t.with(|trace| trace.labels.get(o.column).cloned().unwrap_or_default())).collect()
    }

    /// The displacement that forces of a run are plotted over: its label, and samples at the times of the recording.
    ///
    /// A recorded displacement is preferred. Otherwise it is column 1 of the first unobserved recorder whose file name
    /// contains `disp`.
    pub fn displacement(&self, run: usize, values: &[f64]) -> Option<(String, Vec<f64>)> {
        let recording = &self.study.runs[run].recording;
        let is_length = |unit: &str| ["m", "mm", "cm", "in", "ft"].contains(&unit);
        let recorded = recording.columns.iter().find(|c| is_length(&c.unit) || c.name.starts_with("disp"));
        if let Some(c) = recorded {
            // The sign and the unit of the model, as the forces have.
            let observed = self.study.runs[run].observe.iter().find(|o| o.channel == c.name);
            let (unit, values) = observed.map_or((&c.unit, &c.values), |o| (&o.unit, &o.values));
            return Some((format!("{} [{unit}]", c.name), values.clone()));
        }
        let others = UnobservedTraces::default();
        self.run(run, Some(values), RunMode { others: Some(others.clone()), ..RunMode::default() });
        let others = others.lock().ok()?;
        let (name, trace) = others.iter().find(|(name, _)| name.contains("disp"))?;
        let column = |t: &Trace| (t.width > 1).then(|| t.sample(1, &recording.times));
        Some((format!("{name}, column 1, simulated"), trace.with(column)?))
    }
}

/// A column of a trace at some times, or why there is none.
fn sample(trace: &Trace, output: &str, column: usize, times: &[f64]) -> Result<Vec<f64>, SimulationError> {
    let missing = |why: String| Err(SimulationError::NoOutput(format!("{output} {why}")));
    if trace.times.is_empty() {
        return missing("has no rows".into());
    }
    if column >= trace.width {
        return missing(format!("has {} columns, and none of number {column}", trace.width));
    }
    if trace.no_clock {
        return missing("has times that do not increase: the analysis has no clock".into());
    }
    if !trace.is_finite(column) {
        return Err(SimulationError::NotFinite(format!("{output} column {column}")));
    }
    Ok(trace.sample(column, times))
}

fn analysis_error(failure: &Failure) -> SimulationError {
    match failure.cause {
        Cause::Interrupted => SimulationError::Interrupted,
        _ => SimulationError::Failed(failure.to_string()),
    }
}

pub(super) fn tcl_value(setting: &Setting) -> Value {
    match setting {
        Setting::Text(s) => Value::from(s.as_str()),
        Setting::Whole(i) => Value::from(*i),
        Setting::Number(x) => Value::from(*x),
        Setting::List(words) => Value::list(words.iter().map(|w| Value::from(w.as_str()))),
    }
}

impl Simulator for ScriptSimulator {
    fn simulate(&mut self, run: usize, values: &[f64]) -> Channels {
        if self.stop.load(Ordering::Relaxed) {
            return Err(SimulationError::Interrupted);
        }
        let ended = self.run(run, Some(values), RunMode::default());
        match self.error(&ended, run) {
            Some(error) => Err(error),
            None => self.channels(run),
        }
    }

    fn simulate_all(&mut self, run: usize, values: &[&[f64]]) -> Vec<Channels> {
        self.simulate_side_by_side(run, values)
    }
}

//! `hysteron calibrate`.

use super::args::{CalibrateArgs, Compat};
use super::calibration_summary::{plan, replaced, summary};
use super::files::{
    CHECKPOINT_INTERVAL, lock_folder, read_checkpoint, write_atomically, write_channels, write_checkpoint, write_report,
};
use super::messages::Messages;
use super::preflight::{check_channels, threads};
use super::signals::{INTERRUPTED, on_interrupt, stopped_status};
use hysteron::analysis::Options;
use hysteron::calibrate::{
    CalibrationResult, Checkpoint, Displacements, SearchObserver, SearchSettings, SearchStatus, StudyProblem, page,
    posterior, profiles, search, uncertainty,
};
use hysteron::diagnostic::{Diagnostic, Severity, SourceMap};
use hysteron::study::{InitialRun, ScriptSimulator, Study, standalone_script};
use indicatif::{ProgressBar, ProgressStyle};
use serde::{Deserialize, Serialize};
use std::hash::{DefaultHasher, Hash as _, Hasher as _};
use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

/// Exit status if the calibration failed.
pub(super) const FAILURE: i32 = 1;
/// Exit status if the input is wrong.
pub(super) const INPUT_ERROR: i32 = 2;
/// Default folder of the results.
const RESULTS: &str = "results";

/// Calibrate studies one after the other; the greatest exit status.
pub(super) fn calibrate(args: &CalibrateArgs) -> i32 {
    let stop = Arc::new(AtomicBool::new(false));
    on_interrupt(&stop);
    args.limits.enforce(&stop);
    let studies = match studies(&args.studies) {
        Ok(studies) => studies,
        Err(message) => {
            eprintln!("error: {message}");
            return INPUT_ERROR;
        }
    };
    let is_single = studies.len() == 1;
    let studies = with_folders(args, studies);
    eprint!("{}", plan(&studies));
    let mut worst = 0;
    let mut is_stopped = false;
    let mut results = vec![];
    for (file, dir) in &studies {
        is_stopped |= stop.load(Ordering::Relaxed);
        if is_stopped {
            break;
        }
        let end = calibrate_study(args, file, dir, &stop);
        is_stopped = matches!(end, StudyEnd::Stopped(_));
        match end {
            StudyEnd::Failed(status) => worst = worst.max(status),
            StudyEnd::Finished(result) | StudyEnd::Stopped(Some(result)) => {
                if !args.json {
                    print!("{}", summary(&result, dir));
                }
                results.push(*result);
            }
            StudyEnd::Stopped(None) => {}
        }
    }
    if args.json {
        worst = worst.max(print_json(&results, is_single));
    }
    if !is_single && !results.is_empty() {
        let table = super::compare::table(&results);
        if !args.json {
            print!("\n{table}");
        }
        let out = args.out.clone().unwrap_or_else(|| PathBuf::from(RESULTS));
        if let Err(message) = write_atomically(&out.join("comparison.txt"), &table) {
            eprintln!("error: {message}");
            worst = worst.max(FAILURE);
        }
    }
    if is_stopped { stopped_status(&stop).unwrap_or(INTERRUPTED) } else { worst }
}

/// End of the calibration of a study. It is decided where it comes about: an interrupt or a limit that comes later does not
/// change it.
enum StudyEnd {
    Finished(Box<CalibrationResult>),
    /// Stopped by the user or a limit, with a result so far or without one.
    Stopped(Option<Box<CalibrationResult>>),
    /// Exit status without a result.
    Failed(i32),
}

/// Print the results as JSON: that of a single study, or a list. Returns the exit status.
fn print_json(results: &[CalibrationResult], is_single: bool) -> i32 {
    let texts: Result<Vec<String>, _> = results.iter().map(CalibrationResult::json).collect();
    match (texts, is_single) {
        (Err(e), _) => {
            eprintln!("error: the result cannot be written as JSON: {e}");
            return FAILURE;
        }
        (Ok(texts), true) => print!("{}", texts.concat()),
        (Ok(texts), false) => {
            let texts: Vec<&str> = texts.iter().map(|t| t.trim_end()).collect();
            println!("[{}]", texts.join(",\n"));
        }
    }
    0
}

/// The studies with the folders of their results. No two have the same.
fn with_folders(args: &CalibrateArgs, studies: Vec<PathBuf>) -> Vec<(PathBuf, PathBuf)> {
    let is_single = studies.len() == 1;
    let mut out: Vec<(PathBuf, PathBuf)> = vec![];
    for file in studies {
        let first = result_folder(args, &file, is_single);
        let numbered = (2..).map(|n| PathBuf::from(format!("{}-{n}", first.display())));
        let mut all = std::iter::once(first.clone()).chain(numbered);
        let dir = all.find(|d| out.iter().all(|(_, taken)| taken != d)).unwrap_or(first.clone());
        out.push((file, dir));
    }
    out
}

/// The studies of the arguments: files, and all `study.toml` in folders.
fn studies(paths: &[PathBuf]) -> Result<Vec<PathBuf>, String> {
    let mut out = vec![];
    for path in paths {
        if !path.is_dir() {
            out.push(path.clone());
            continue;
        }
        let before = out.len();
        let mut folders = vec![path.clone()];
        while let Some(folder) = folders.pop() {
            let names = hysteron_files::list(&folder).map_err(|e| format!("cannot read {}: {e}", folder.display()))?;
            for entry in names.iter().map(|name| folder.join(name)) {
                if entry.is_dir() {
                    folders.push(entry);
                } else if entry.file_name().is_some_and(|n| n == "study.toml") {
                    out.push(entry);
                }
            }
        }
        if out.len() == before {
            return Err(format!("there is no study.toml in {}", path.display()));
        }
        out[before..].sort();
    }
    Ok(out)
}

/// Folder of the results of a study: that of the arguments, or one below it for each of several studies.
fn result_folder(args: &CalibrateArgs, file: &Path, is_single: bool) -> PathBuf {
    let out = args.out.clone().unwrap_or_else(|| PathBuf::from(RESULTS));
    if is_single {
        return out;
    }
    // The results of a/study.toml go to a, those of a/b.toml to a-b.
    let stem = file.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
    let parent = file.canonicalize().ok().and_then(|f| Some(f.parent()?.file_name()?.to_string_lossy().into_owned()));
    let name = match (parent, stem.as_str()) {
        (Some(p), "study") => p,
        (Some(p), _) => format!("{p}-{stem}"),
        (None, _) => stem,
    };
    out.join(name)
}

/// Print a diagnostic with its source line.
pub(super) fn print_diagnostic(d: &Diagnostic, sources: &SourceMap) {
    eprintln!("{}\n", Messages::new().render(d, sources));
}

/// Calibrate a study.
fn calibrate_study(args: &CalibrateArgs, file: &Path, dir: &Path, stop: &Arc<AtomicBool>) -> StudyEnd {
    let mut sources = SourceMap::default();
    match prepare_with_args(args, file, stop, &mut sources) {
        Ok(prepared) if prepared.initial_run.is_interrupted() => StudyEnd::Stopped(None),
        Ok(prepared) => {
            calibrate_prepared(args, file, dir, (prepared, &sources), stop).unwrap_or_else(StudyEnd::Failed)
        }
        Err(status) => StudyEnd::Failed(status),
    }
}

/// Calibrate a study that has made its initial run; the exit status if there is no result and nothing stopped it.
fn calibrate_prepared(
    args: &CalibrateArgs,
    file: &Path,
    dir: &Path,
    (prepared, sources): (PreparedStudy, &SourceMap),
    stop: &Arc<AtomicBool>,
) -> Result<StudyEnd, i32> {
    let PreparedStudy { simulator, initial_run, settings } = prepared;
    let study = simulator.study().clone();
    let failed = |message: String| {
        eprintln!("error: {}: {message}", file.display());
        FAILURE
    };
    let checkpoint_path = dir.join("checkpoint.json");
    let initial_unit_point = study.space.unit_point(&initial_run.values);
    let start = Checkpoint::new(settings.clone(), initial_unit_point);
    let identity = identity(&simulator);
    let at = if args.resume { earlier_checkpoint(&checkpoint_path, start, identity) } else { Ok(start) };
    let at = at.map_err(|message| {
        eprintln!("error: {message}");
        INPUT_ERROR
    })?;
    for note in replaced(dir, &study) {
        eprintln!("note: {note}");
    }
    let _lock = lock_folder(dir).map_err(&failed)?;
    let threads = threads(args.threads);
    let checked = check_channels(&simulator, &initial_run, threads, false, sources);
    let checked = checked.map_err(|e| failed(e.to_string()))?;
    let problem = StudyProblem::of_script(&simulator, threads).map_err(|e| failed(e.to_string()))?;
    let begun = Instant::now();
    let mut progress = CalibrationProgress::new(&study, (checkpoint_path.clone(), identity), stop.clone());
    let found = search(&problem, at, &mut progress);
    progress.finish();
    let stopped = found.stopped;
    // The result so far is still evaluated. Another interrupt stops that as well.
    stop.store(false, Ordering::Relaxed);
    let wall_time = begun.elapsed().as_secs_f64();
    let mut result = match CalibrationResult::new(&problem, &settings, found, wall_time) {
        Ok(result) => result,
        Err(_) if stopped => {
            stop.store(true, Ordering::Relaxed);
            return Ok(StudyEnd::Stopped(None));
        }
        Err(message) => return Err(failed(message)),
    };
    result.preflight = Some(checked);
    if stopped {
        eprintln!("interrupted: the best so far is kept; --resume continues");
    } else {
        estimate_uncertainty(args, &problem, &mut result);
        let _ = hysteron_files::remove(&checkpoint_path);
    }
    let runs = 0..study.runs.len();
    let displacements = runs.map(|r| simulator.displacement(r, &result.values)).collect();
    result.add_amplitudes(&displacements);
    write(dir, &simulator, &result, &initial_run, &displacements, args.view).map_err(&failed)?;
    if stopped || stop.load(Ordering::Relaxed) {
        stop.store(true, Ordering::Relaxed);
        return Ok(StudyEnd::Stopped(Some(Box::new(result))));
    }
    Ok(StudyEnd::Finished(Box::new(result)))
}

/// Prepare a study with the settings of the arguments, and print its warnings; the exit status if it has errors.
fn prepare_with_args(
    args: &CalibrateArgs,
    file: &Path,
    stop: &Arc<AtomicBool>,
    sources: &mut SourceMap,
) -> Result<PreparedStudy, i32> {
    let refused = |d: Box<Diagnostic>, sources: &SourceMap| {
        print_diagnostic(&d, sources);
        INPUT_ERROR
    };
    let prepared = prepare(file, args.compat, stop, sources);
    let mut prepared = prepared.map_err(|d| refused(d, sources))?;
    let settings = &mut prepared.settings;
    settings.seed = args.seed.unwrap_or(settings.seed);
    settings.repeats = args.repeats.unwrap_or(settings.repeats);
    if let Some(name) = &args.method {
        settings.set_method(name).map_err(|d| refused(d, sources))?;
    }
    let warnings = prepared.simulator.study().warnings.iter().chain(&prepared.initial_run.warnings);
    for w in warnings.filter(|w| w.severity != Severity::Note) {
        print_diagnostic(w, sources);
    }
    if let Some(error) = &prepared.initial_run.failure {
        eprintln!("note: the script fails with its own values: {error}");
    }
    Ok(prepared)
}

/// Estimate the uncertainty of the parameters by the ways that the arguments ask for.
fn estimate_uncertainty(args: &CalibrateArgs, problem: &StudyProblem, result: &mut CalibrationResult) {
    let estimate = match uncertainty(problem, &result.unit_point) {
        Ok(estimate) => estimate,
        Err(why) => {
            eprintln!("note: the uncertainty of the parameters is not known: {why}");
            return;
        }
    };
    if args.profile {
        result.profiles = Some(profiles(problem, &result.unit_point, result.objective, &estimate));
    }
    if let Some(sweeps) = args.posterior {
        match posterior(problem, &result.unit_point, &estimate, sweeps, result.settings.seed) {
            Ok(p) => result.posterior = Some(p),
            Err(why) => eprintln!("note: there is no posterior: {why}"),
        }
    }
    result.uncertainty = Some(estimate);
}

/// A study without errors, whose script has made its initial run.
pub(super) struct PreparedStudy {
    pub(super) simulator: ScriptSimulator,
    pub(super) initial_run: InitialRun,
    settings: SearchSettings,
}

/// Read a study, and run its script with its own values.
pub(super) fn prepare(
    file: &Path,
    compat: Option<Compat>,
    stop: &Arc<AtomicBool>,
    sources: &mut SourceMap,
) -> Result<PreparedStudy, Box<Diagnostic>> {
    let study = Arc::new(Study::load(file, sources)?);
    let settings = SearchSettings::of(&study)?;
    let options = Options { compat: compat.is_some(), ladder: None, ..Options::default() };
    let mut simulator = ScriptSimulator::new(study, options, stop.clone());
    let initial_run = simulator.run_initially(sources)?;
    Ok(PreparedStudy { simulator, initial_run, settings })
}

/// The file of an interrupted calibration.
#[derive(Serialize, Deserialize)]
struct SavedCheckpoint {
    /// Identity of the study with all that it reads.
    identity: u64,
    checkpoint: Checkpoint,
}

/// A number that changes with the study, its recordings, and the files that its script reads.
fn identity(simulator: &ScriptSimulator) -> u64 {
    let mut hasher = DefaultHasher::new();
    let study = simulator.study();
    format!("{:?} {:?}", study.space, study.runs).hash(&mut hasher);
    (simulator.files_read(), env!("CARGO_PKG_VERSION")).hash(&mut hasher);
    hasher.finish()
}

/// The checkpoint of an interrupted calibration that began at `start`; that one itself if there is none.
fn earlier_checkpoint(path: &Path, start: Checkpoint, identity: u64) -> Result<Checkpoint, String> {
    let shown = path.display();
    let Some(SavedCheckpoint { identity: of, checkpoint: old }) = read_checkpoint(path)? else { return Ok(start) };
    if old.settings != start.settings || old.initial_unit_point != start.initial_unit_point {
        return Err(format!("{shown} is of another study, or of another method or seed"));
    }
    if of != identity {
        let changed = "the script, a file that it reads, a recording or hysteron has changed since";
        return Err(format!("cannot go on from {shown}: {changed}"));
    }
    Ok(old)
}

/// Write the files of the result.
fn write(
    dir: &Path,
    simulator: &ScriptSimulator,
    result: &CalibrationResult,
    initial_run: &InitialRun,
    displacements: &Displacements,
    view: bool,
) -> Result<(), String> {
    let study = &result.study;
    let text = hysteron_files::read_text(study.folder.join(&study.model)).map_err(|e| e.to_string())?;
    let (script, missing) = result.script(&text, initial_run);
    // The numbers first: what follows can be made from them.
    write_atomically(&dir.join("calibration.json"), &result.json().map_err(|e| e.to_string())?)?;
    write_atomically(&dir.join("fitted.tcl"), &standalone_script(simulator, dir, &script))?;
    if !missing.is_empty() {
        eprintln!("note: no pset command of {} has {}: fitted.tcl lacks its value", study.model, missing.join(", "));
    }
    let simulated = result.scored_runs.iter().map(|r| r.as_ref().ok()).collect();
    write_channels(dir, study, &[("simulated", simulated)])?;
    write_report(dir, &page(result, displacements), view)
}

/// Shows the progress of a calibration, writes its checkpoints, and stops it on an interrupt.
struct CalibrationProgress {
    /// The progress bar; `None` if standard error is no terminal.
    bar: Option<ProgressBar>,
    checkpoint_path: PathBuf,
    /// Identity of the study with all that it reads.
    identity: u64,
    last_checkpoint: Instant,
    begun: Instant,
    stop: Arc<AtomicBool>,
}

impl CalibrationProgress {
    fn new(study: &Study, (checkpoint_path, identity): (PathBuf, u64), stop: Arc<AtomicBool>) -> Self {
        let bar = std::io::stderr().is_terminal().then(|| {
            let bar = ProgressBar::new(1000);
            let style = ProgressStyle::with_template("{prefix} [{bar:24}] {msg}, left {eta}");
            if let Ok(style) = style {
                bar.set_style(style.progress_chars("=> "));
            }
            bar.set_prefix(study.title.clone());
            bar
        });
        Self { bar, checkpoint_path, identity, last_checkpoint: Instant::now(), begun: Instant::now(), stop }
    }

    fn finish(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

impl SearchObserver for CalibrationProgress {
    fn status(&mut self, s: &SearchStatus<'_>) {
        let Some(bar) = &self.bar else { return };
        bar.set_position((1000.0 * s.progress) as u64);
        let rate = s.evaluations as f64 / self.begun.elapsed().as_secs_f64();
        let repeat =
            if s.repeat.1 > 1 { format!("repeat {} of {}, ", s.repeat.0 + 1, s.repeat.1) } else { String::new() };
        let (stage, generation, best, spread) = (s.stage, s.generation, s.best, s.spread);
        bar.set_message(format!(
            "{repeat}{stage} generation {generation}, best {best:.4e}, spread {spread:.1e}, {rate:.0} evaluations/s"
        ));
    }

    fn wants_checkpoint(&self) -> bool {
        self.last_checkpoint.elapsed() > CHECKPOINT_INTERVAL
    }

    fn checkpoint(&mut self, c: &Checkpoint) {
        self.last_checkpoint = Instant::now();
        let saved = SavedCheckpoint { identity: self.identity, checkpoint: c.clone() };
        if let Err(e) = write_checkpoint(&self.checkpoint_path, &saved) {
            eprintln!("warning: no checkpoint: {e}");
        }
    }

    fn stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}

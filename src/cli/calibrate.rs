//! `hysteron calibrate`.

use super::args::{CalibrateArgs, Compat};
use super::files::{CHECKPOINT_INTERVAL, write_atomically, write_channels};
use super::messages::Messages;
use hysteron::analysis::Options;
use hysteron::calibrate::{
    CalibrationResult, Checkpoint, Displacements, SearchObserver, SearchSettings, SearchStatus, StudyProblem,
    Uncertainty, page, posterior, profiles, search, uncertainty,
};
use hysteron::diagnostic::{Diagnostic, Severity, SourceMap};
use hysteron::study::{InitialRun, Role, ScriptSimulator, Study, standalone_script};
use indicatif::{ProgressBar, ProgressStyle};
use std::fs;
use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

/// Exit status if the calibration failed.
const FAILURE: i32 = 1;
/// Exit status if the input is wrong.
pub(super) const INPUT_ERROR: i32 = 2;
/// Default folder of the results.
const RESULTS: &str = "results";

/// Calibrate studies one after the other; the greatest exit status.
pub(super) fn calibrate(args: &CalibrateArgs) -> i32 {
    let stop = Arc::new(AtomicBool::new(false));
    super::run::on_interrupt(&stop);
    let studies = match studies(&args.studies) {
        Ok(studies) => studies,
        Err(message) => {
            eprintln!("error: {message}");
            return INPUT_ERROR;
        }
    };
    let is_single = studies.len() == 1;
    let mut worst = 0;
    let mut results = vec![];
    for file in &studies {
        if stop.load(Ordering::Relaxed) {
            break;
        }
        let dir = result_folder(args, file, is_single);
        match calibrate_study(args, file, &dir, &stop) {
            Ok(result) => results.push(result),
            Err(status) => worst = worst.max(status),
        }
    }
    if !is_single && !results.is_empty() {
        let table = super::compare::table(&results);
        eprint!("\n{table}");
        let out = args.out.clone().unwrap_or_else(|| PathBuf::from(RESULTS));
        if let Err(message) = write_atomically(&out.join("comparison.txt"), &table) {
            eprintln!("error: {message}");
            worst = worst.max(FAILURE);
        }
    }
    worst
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
            let entries = fs::read_dir(&folder).map_err(|e| format!("cannot read {}: {e}", folder.display()))?;
            for entry in entries.flatten().map(|e| e.path()) {
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

/// Calibrate a study; the exit status if there is no result.
fn calibrate_study(
    args: &CalibrateArgs,
    file: &Path,
    dir: &Path,
    stop: &Arc<AtomicBool>,
) -> Result<CalibrationResult, i32> {
    let PreparedStudy { simulator, initial_run, settings } = prepare_with_args(args, file, stop)?;
    let study = simulator.study().clone();
    let failed = |message: String| {
        eprintln!("error: {}: {message}", file.display());
        FAILURE
    };
    fs::create_dir_all(dir).map_err(|e| failed(format!("cannot make {}: {e}", dir.display())))?;
    let threads = args.threads.unwrap_or_else(|| std::thread::available_parallelism().map_or(1, usize::from));
    let problem = StudyProblem::of_script(&simulator, threads).map_err(|e| failed(e.to_string()))?;
    let begun = Instant::now();
    let checkpoint_path = dir.join("checkpoint.json");
    let initial_unit_point = study.space.unit_point(&initial_run.values);
    let start = Checkpoint::new(settings.clone(), initial_unit_point);
    let at = if args.resume { read_checkpoint(&checkpoint_path, &start) } else { Ok(start) };
    let at = at.map_err(|message| {
        eprintln!("error: {message}");
        INPUT_ERROR
    })?;
    let mut progress = CalibrationProgress::new(&study, checkpoint_path.clone(), stop.clone());
    let found = search(&problem, at, &mut progress);
    progress.finish();
    let stopped = found.stopped;
    // The result so far is still evaluated. Another interrupt stops that as well.
    stop.store(false, Ordering::Relaxed);
    let wall_time = begun.elapsed().as_secs_f64();
    let mut result = CalibrationResult::new(&problem, &settings, found, wall_time).map_err(&failed)?;
    if stopped {
        eprintln!("interrupted: the best so far is kept; --resume goes on");
    } else {
        estimate_uncertainty(args, &problem, &mut result);
        let _ = fs::remove_file(&checkpoint_path);
    }
    let runs = 0..study.runs.len();
    let displacements = runs.map(|r| simulator.displacement(r, &result.values)).collect();
    result.add_amplitudes(&displacements);
    write(dir, &simulator, &result, &initial_run, &displacements).map_err(&failed)?;
    print_summary(&result, dir);
    if stopped {
        stop.store(true, Ordering::Relaxed);
    }
    Ok(result)
}

/// Prepare a study with the settings of the arguments, and print its warnings; the exit status if it has errors.
fn prepare_with_args(args: &CalibrateArgs, file: &Path, stop: &Arc<AtomicBool>) -> Result<PreparedStudy, i32> {
    let mut sources = SourceMap::default();
    let refused = |d: Box<Diagnostic>, sources: &SourceMap| {
        print_diagnostic(&d, sources);
        INPUT_ERROR
    };
    let prepared = prepare(file, args.compat, stop, &mut sources);
    let mut prepared = prepared.map_err(|d| refused(d, &sources))?;
    let settings = &mut prepared.settings;
    settings.seed = args.seed.unwrap_or(settings.seed);
    settings.repeats = args.repeats.unwrap_or(settings.repeats);
    if let Some(name) = &args.method {
        settings.set_method(name).map_err(|d| refused(d, &sources))?;
    }
    let warnings = prepared.simulator.study().warnings.iter().chain(&prepared.initial_run.warnings);
    for w in warnings.filter(|w| w.severity != Severity::Note) {
        print_diagnostic(w, &sources);
    }
    if let Some(error) = &prepared.initial_run.failure {
        eprintln!("note: with its own values the script has no answer: {error}");
    }
    Ok(prepared)
}

/// Estimate the uncertainty of the parameters by the ways that the arguments ask for.
fn estimate_uncertainty(args: &CalibrateArgs, problem: &StudyProblem, result: &mut CalibrationResult) {
    let estimate = match uncertainty(problem, &result.unit_point) {
        Ok(estimate) => estimate,
        Err(why) => {
            eprintln!("note: how sure the parameters are is not known: {why}");
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

/// The checkpoint of an interrupted calibration that began at `start`.
fn read_checkpoint(path: &Path, start: &Checkpoint) -> Result<Checkpoint, String> {
    let shown = path.display();
    let text = fs::read_to_string(path).map_err(|e| format!("cannot go on: {shown}: {e}"))?;
    let old: Checkpoint = serde_json::from_str(&text).map_err(|e| format!("cannot go on: {shown}: {e}"))?;
    if old.settings != start.settings || old.initial_unit_point != start.initial_unit_point {
        return Err(format!("{shown} is of another study, or of another method or seed"));
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
) -> Result<(), String> {
    let study = &result.study;
    let text = fs::read_to_string(study.folder.join(&study.model)).map_err(|e| e.to_string())?;
    let (script, missing) = result.script(&text, initial_run);
    write_atomically(&dir.join("fitted.tcl"), &standalone_script(simulator, dir, &script))?;
    if !missing.is_empty() {
        eprintln!(
            "note: {} stands in no pset command of {}: fitted.tcl has not its value",
            missing.join(", "),
            study.model
        );
    }
    let simulated = result.scored_runs.iter().map(|r| r.as_ref().ok()).collect();
    write_channels(dir, study, &[("simulated", simulated)])?;
    write_atomically(&dir.join("report.html"), &page(result, displacements))?;
    write_atomically(&dir.join("calibration.json"), &result.json().map_err(|e| e.to_string())?)
}

/// Print the result in a few lines.
fn print_summary(result: &CalibrationResult, dir: &Path) {
    let study = &result.study;
    let title = if study.title.is_empty() { study.model.as_str() } else { study.title.as_str() };
    eprintln!(
        "{title}: objective {:.6}, {} evaluations, {:.1} s",
        result.objective,
        result.search.evaluations(),
        result.wall_time
    );
    for (run, scored) in study.runs.iter().zip(&result.scored_runs) {
        let role = if run.role == Role::Fit { "fit" } else { "holdout" };
        match scored {
            Ok(scored) => {
                let dropped: usize = scored.scores.iter().map(|s| s.dropped).sum();
                let note = if dropped > 0 {
                    format!(", {dropped} samples after the end of the analysis left out")
                } else {
                    String::new()
                };
                eprintln!("  {role:8} {}: NMSE {:.6}{note}", run.name, scored.nmse(&run.observe));
            }
            Err(error) => eprintln!("  {role:8} {}: {error}", run.name),
        }
    }
    for (i, (p, v)) in study.space.parameters.iter().zip(&result.values).enumerate() {
        let coordinate = study.space.free().position(|(k, _)| k == i);
        let interval = coordinate.and_then(|k| result.uncertainty.as_ref()?.intervals.get(k));
        let interval = interval.map_or(String::new(), |n| format!("  ({:.6} to {:.6})", n.lower, n.upper));
        eprintln!("  {} = {v:.6}{interval}", p.name);
    }
    for name in result.at_bounds() {
        eprintln!("  note: {name} is at a bound of its range");
    }
    for line in result.uncertainty.iter().flat_map(Uncertainty::notes) {
        eprintln!("  note: {line}");
    }
    for p in result.profiles.iter().flatten() {
        let end = |e: Option<f64>| e.map_or("open".into(), |x| format!("{x:.6}"));
        eprintln!("  profile of {}: {} to {}", p.name, end(p.lower), end(p.upper));
    }
    if let Some(p) = &result.posterior {
        for q in &p.quantiles {
            eprintln!("  posterior of {}: {:.6} ({:.6} to {:.6})", q.name, q.median, q.lower, q.upper);
        }
        eprintln!("  acceptance {:.2}, {:.0} independent draws", p.acceptance, p.effective_draws);
    }
    let statistics = result.repeat_statistics();
    if statistics.repeats > 1 {
        let (best, worst, deviation) = (statistics.best, statistics.worst, statistics.deviation);
        eprintln!("  {} repeats: best {best:.6}, worst {worst:.6}, deviation {deviation:.2e}", statistics.repeats);
    }
    for (kind, n) in result.search.failures() {
        let message = result.search.repeats.iter().find_map(|r| r.failure_messages.get(kind));
        eprintln!("  {n} points without an answer: {}", message.map_or(kind, String::as_str));
    }
    eprintln!("  {}", dir.display());
}

/// Shows the progress of a calibration, writes its checkpoints, and stops it on an interrupt.
struct CalibrationProgress {
    /// The progress bar; `None` if standard error is no terminal.
    bar: Option<ProgressBar>,
    checkpoint_path: PathBuf,
    last_checkpoint: Instant,
    begun: Instant,
    stop: Arc<AtomicBool>,
}

impl CalibrationProgress {
    fn new(study: &Study, checkpoint_path: PathBuf, stop: Arc<AtomicBool>) -> Self {
        let bar = std::io::stderr().is_terminal().then(|| {
            let bar = ProgressBar::new(1000);
            let style = ProgressStyle::with_template("{prefix} [{bar:24}] {msg}, left {eta}");
            if let Ok(style) = style {
                bar.set_style(style.progress_chars("=> "));
            }
            bar.set_prefix(study.title.clone());
            bar
        });
        Self { bar, checkpoint_path, last_checkpoint: Instant::now(), begun: Instant::now(), stop }
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
        let written = serde_json::to_string(c)
            .map_err(|e| e.to_string())
            .and_then(|t| write_atomically(&self.checkpoint_path, &t));
        if let Err(e) = written {
            eprintln!("warning: no checkpoint: {e}");
        }
    }

    fn stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}

//! `hysteron calibrate`.

use super::args::{CalibrateArgs, Compat};
use super::files::{SAVE_EVERY, place};
use super::messages::Messages;
use hysteron::analysis::Options;
use hysteron::calibrate::{
    Calibrated, Checkpoint, Displacements, Plan, Status, StudyProblem, Uncertainty, Watch, page, posterior, profiles,
    search, uncertainty,
};
use hysteron::diagnostic::{Diagnostic, Severity, SourceMap};
use hysteron::study::{Opening, Role, ScriptSimulator, Study};
use indicatif::{ProgressBar, ProgressStyle};
use std::fs;
use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

/// Exit status where the fit failed, and where the input is wrong.
const FAILED: i32 = 1;
pub(super) const WRONG: i32 = 2;
/// Where results go if nothing else is said.
const RESULTS: &str = "results";

/// Calibrate studies one after the other; the exit status is the worst of them.
pub(super) fn calibrate(args: &CalibrateArgs) -> i32 {
    let stop = Arc::new(AtomicBool::new(false));
    super::run::on_interrupt(&stop);
    let studies = match studies(&args.studies) {
        Ok(studies) => studies,
        Err(message) => {
            eprintln!("error: {message}");
            return WRONG;
        }
    };
    let several = studies.len() > 1;
    let mut worst = 0;
    let mut done = vec![];
    for file in &studies {
        if stop.load(Ordering::Relaxed) {
            break;
        }
        let dir = folder(args, file, several);
        match one(args, file, &dir, &stop) {
            Ok(calibrated) => done.push(calibrated),
            Err(status) => worst = worst.max(status),
        }
    }
    if several && !done.is_empty() {
        let table = super::compare::table(&done);
        eprint!("\n{table}");
        let out = args.out.clone().unwrap_or_else(|| PathBuf::from(RESULTS));
        if let Err(message) = place(&out.join("comparison.txt"), &table) {
            eprintln!("error: {message}");
            worst = worst.max(FAILED);
        }
    }
    worst
}

/// The studies of the arguments: files, and all `study.toml` in folders.
fn studies(given: &[PathBuf]) -> Result<Vec<PathBuf>, String> {
    let mut out = vec![];
    for path in given {
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

/// Where the results of a study go: one folder, or one below it for each of several studies.
fn folder(args: &CalibrateArgs, file: &Path, several: bool) -> PathBuf {
    let out = args.out.clone().unwrap_or_else(|| PathBuf::from(RESULTS));
    if !several {
        return out;
    }
    // a/study.toml is called a, a/b.toml is called a-b.
    let stem = file.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
    let parent = file.canonicalize().ok().and_then(|f| Some(f.parent()?.file_name()?.to_string_lossy().into_owned()));
    let name = match (parent, stem.as_str()) {
        (Some(p), "study") => p,
        (Some(p), _) => format!("{p}-{stem}"),
        (None, _) => stem,
    };
    out.join(name)
}

pub(super) fn show(d: &Diagnostic, sources: &SourceMap) {
    eprintln!("{}\n", Messages::new().render(d, sources));
}

/// Calibrate a study; the exit status where there is no result.
fn one(args: &CalibrateArgs, file: &Path, dir: &Path, stop: &Arc<AtomicBool>) -> Result<Calibrated, i32> {
    let mut sources = SourceMap::default();
    let refused = |d: Box<Diagnostic>, sources: &SourceMap| {
        show(&d, sources);
        WRONG
    };
    let Prepared { simulator, opening, mut plan } =
        prepare(file, args.compat, stop, &mut sources).map_err(|d| refused(d, &sources))?;
    plan.seed = args.seed.unwrap_or(plan.seed);
    plan.repeats = args.repeats.unwrap_or(plan.repeats);
    if let Some(name) = &args.method {
        plan.choose(name).map_err(|d| refused(d, &sources))?;
    }
    let study = simulator.study().clone();
    for w in study.warnings.iter().chain(&opening.warnings).filter(|w| w.severity != Severity::Note) {
        show(w, &sources);
    }
    if let Some(why) = &opening.failure {
        eprintln!("note: with its own values the script has no answer: {why}");
    }
    let failed = |message: String| {
        eprintln!("error: {}: {message}", file.display());
        FAILED
    };
    fs::create_dir_all(dir).map_err(|e| failed(format!("cannot make {}: {e}", dir.display())))?;
    let threads = args.threads.unwrap_or_else(|| std::thread::available_parallelism().map_or(1, usize::from));
    let problem = StudyProblem::of_script(&simulator, threads).map_err(|e| failed(e.to_string()))?;
    let begun = Instant::now();
    let saved = dir.join("checkpoint.json");
    let at = resumed(args, &saved, &study, &opening, plan.clone()).map_err(|message| {
        eprintln!("error: {message}");
        WRONG
    })?;
    let mut bar = Bar::new(&study, saved.clone(), stop.clone());
    let outcome = search(&problem, at, &mut bar);
    bar.finish();
    let stopped = outcome.stopped;
    // What the best so far is worth is still worked out; another interrupt cuts that short too.
    stop.store(false, Ordering::Relaxed);
    let mut result = Calibrated::new(&problem, &plan, outcome, begun.elapsed().as_secs_f64()).map_err(&failed)?;
    if stopped {
        eprintln!("interrupted: the best so far is kept; --resume goes on");
    } else {
        how_sure(args, &problem, &mut result);
        let _ = fs::remove_file(&saved);
    }
    let runs = 0..study.runs.len();
    let displacements = runs.map(|r| simulator.displacement(r, &result.values)).collect();
    result.measure(&displacements);
    write(dir, &result, &opening, &displacements).map_err(&failed)?;
    tell(&result, dir);
    if stopped {
        stop.store(true, Ordering::Relaxed);
    }
    Ok(result)
}

/// Work out what the data determine, as far as it is wanted.
fn how_sure(args: &CalibrateArgs, problem: &StudyProblem, result: &mut Calibrated) {
    let sure = match uncertainty(problem, &result.point) {
        Ok(u) => u,
        Err(why) => {
            eprintln!("note: how sure the parameters are is not known: {why}");
            return;
        }
    };
    if args.profile {
        result.profiles = Some(profiles(problem, &result.point, result.objective, &sure));
    }
    if let Some(sweeps) = args.posterior {
        match posterior(problem, &result.point, &sure, sweeps, result.plan.seed) {
            Ok(p) => result.posterior = Some(p),
            Err(why) => eprintln!("note: there is no posterior: {why}"),
        }
    }
    result.uncertainty = Some(sure);
}

/// A study that nothing is wrong with.
pub(super) struct Prepared {
    pub(super) simulator: ScriptSimulator,
    pub(super) opening: Opening,
    plan: Plan,
}

/// Read a study, and run its script with its own values.
pub(super) fn prepare(
    file: &Path,
    compat: Option<Compat>,
    stop: &Arc<AtomicBool>,
    sources: &mut SourceMap,
) -> Result<Prepared, Box<Diagnostic>> {
    let study = Arc::new(Study::load(file, sources)?);
    let plan = Plan::of(&study)?;
    let options = Options { compat: compat.is_some(), ladder: None, ..Options::default() };
    let mut simulator = ScriptSimulator::new(study, options, stop.clone());
    let opening = simulator.open(sources)?;
    Ok(Prepared { simulator, opening, plan })
}

/// Where to begin: at the start, or where an earlier calibration was stopped.
fn resumed(
    args: &CalibrateArgs,
    saved: &Path,
    study: &Study,
    opening: &Opening,
    plan: Plan,
) -> Result<Checkpoint, String> {
    let new = Checkpoint::new(plan, study.space.point(&opening.values));
    if !args.resume {
        return Ok(new);
    }
    let shown = saved.display();
    let text = fs::read_to_string(saved).map_err(|e| format!("cannot go on: {shown}: {e}"))?;
    let old: Checkpoint = serde_json::from_str(&text).map_err(|e| format!("cannot go on: {shown}: {e}"))?;
    if old.plan != new.plan || old.start != new.start {
        return Err(format!("{shown} is of another study, or of another method or seed"));
    }
    Ok(old)
}

fn write(dir: &Path, result: &Calibrated, opening: &Opening, displacements: &Displacements) -> Result<(), String> {
    let study = &result.study;
    let text = fs::read_to_string(study.folder.join(&study.model)).map_err(|e| e.to_string())?;
    let (script, elsewhere) = result.script(&text, opening);
    place(&dir.join("fitted.tcl"), &script)?;
    if !elsewhere.is_empty() {
        eprintln!(
            "note: {} stands in no pset command of {}: fitted.tcl has not its value",
            elsewhere.join(", "),
            study.model
        );
    }
    place(&dir.join("report.html"), &page(result, displacements))?;
    place(&dir.join("calibration.json"), &result.json().map_err(|e| e.to_string())?)
}

/// The result in a few lines.
fn tell(result: &Calibrated, dir: &Path) {
    let study = &result.study;
    let title = if study.title.is_empty() { study.model.as_str() } else { study.title.as_str() };
    eprintln!(
        "{title}: objective {:.6}, {} evaluations, {:.1} s",
        result.objective,
        result.outcome.evaluations(),
        result.wall
    );
    for (run, fit) in study.runs.iter().zip(&result.fits) {
        let role = if run.role == Role::Fit { "fit" } else { "holdout" };
        match fit {
            Ok(fit) => {
                let dropped: usize = fit.scores.iter().map(|s| s.dropped).sum();
                let said = if dropped > 0 {
                    format!(", {dropped} samples after the end of the analysis left out")
                } else {
                    String::new()
                };
                eprintln!("  {role:8} {}: NMSE {:.6}{said}", run.name, fit.nmse(&run.observe));
            }
            Err(why) => eprintln!("  {role:8} {}: {why}", run.name),
        }
    }
    for (i, (p, v)) in study.space.parameters.iter().zip(&result.values).enumerate() {
        let number = study.space.free().position(|(k, _)| k == i);
        let interval = number.and_then(|k| result.uncertainty.as_ref()?.intervals.get(k));
        let sure = interval.map_or(String::new(), |n| format!("  ({:.6} to {:.6})", n.lower, n.upper));
        eprintln!("  {} = {v:.6}{sure}", p.name);
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
    let spread = result.spread();
    if spread.repeats > 1 {
        let (best, worst) = (spread.best, spread.worst);
        eprintln!("  {} repeats: best {best:.6}, worst {worst:.6}, deviation {:.2e}", spread.repeats, spread.deviation);
    }
    for (kind, n) in result.outcome.mishaps() {
        let example = result.outcome.repeats.iter().find_map(|r| r.examples.get(kind));
        eprintln!("  {n} points without an answer: {}", example.map_or(kind, String::as_str));
    }
    eprintln!("  {}", dir.display());
}

/// A line at the bottom of the terminal, the checkpoint, and the interrupt.
struct Bar {
    bar: Option<ProgressBar>,
    saved: PathBuf,
    last: Instant,
    begun: Instant,
    stop: Arc<AtomicBool>,
}

impl Bar {
    fn new(study: &Study, saved: PathBuf, stop: Arc<AtomicBool>) -> Self {
        let bar = std::io::stderr().is_terminal().then(|| {
            let bar = ProgressBar::new(1000);
            let style = ProgressStyle::with_template("{prefix} [{bar:24}] {msg}, left {eta}");
            if let Ok(style) = style {
                bar.set_style(style.progress_chars("=> "));
            }
            bar.set_prefix(study.title.clone());
            bar
        });
        Self { bar, saved, last: Instant::now(), begun: Instant::now(), stop }
    }

    fn finish(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

impl Watch for Bar {
    fn status(&mut self, s: &Status<'_>) {
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
        self.last.elapsed() > SAVE_EVERY
    }

    fn checkpoint(&mut self, c: &Checkpoint) {
        self.last = Instant::now();
        let saved = serde_json::to_string(c).map_err(|e| e.to_string()).and_then(|t| place(&self.saved, &t));
        if let Err(e) = saved {
            eprintln!("warning: no checkpoint: {e}");
        }
    }

    fn stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}

//! `hysteron diagnose`.

use super::args::DiagnoseArgs;
use super::files::{
    CHECKPOINT_INTERVAL, lock_folder, note_replaced, read_checkpoint, write_atomically, write_channels,
    write_checkpoint, write_report,
};
use super::messages::Messages;
use super::pace::tell_diagnosis;
use super::preflight::{check_channels, threads};
use super::progress::PhaseProgress;
use super::signals::{INTERRUPTED, on_interrupt, stopped_status};
use hysteron::analysis::Options;
use hysteron::diagnose::{
    CheckpointEntry, Diagnosis, ProgressMonitor, Settings, diagnose, hypothesis, identity, report,
};
use hysteron::diagnostic::{Diagnostic, Severity, SourceMap, nearest};
use hysteron::study::{InitialRun, ScriptSimulator, Study, standalone_script};
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

/// Exit status of a failed diagnosis.
const FAILED_STATUS: i32 = 1;
/// Exit status for wrong input.
const WRONG_INPUT_STATUS: i32 = 2;

/// Diagnoses a study, writes its files and returns the exit status.
pub(super) fn run(args: &DiagnoseArgs) -> i32 {
    let stop = Arc::new(AtomicBool::new(false));
    on_interrupt(&stop);
    args.limits.enforce(&stop);
    for cause in &args.without {
        if hypothesis::of(cause).is_none() {
            let known = || hypothesis::ALL.iter().map(|h| h.cause);
            eprintln!("error: unknown cause \"{cause}\"");
            if let Some(near) = nearest(cause, known()) {
                eprintln!("  did you mean \"{near}\"?");
            }
            eprintln!("  known: {}", known().collect::<Vec<_>>().join(" "));
            return WRONG_INPUT_STATUS;
        }
    }
    let mut sources = SourceMap::default();
    let show = |d: &Diagnostic, sources: &SourceMap| eprintln!("{}\n", Messages::new().render(d, sources));
    let (simulator, initial_run) = match prepare(args, &stop, &mut sources) {
        Ok((_, initial_run)) if initial_run.is_interrupted() => return stopped_status(&stop).unwrap_or(INTERRUPTED),
        Ok(prepared) => prepared,
        Err(d) => {
            show(&d, &sources);
            return WRONG_INPUT_STATUS;
        }
    };
    let study = simulator.study().clone();
    for w in study.warnings.iter().chain(&initial_run.warnings).filter(|w| w.severity != Severity::Note) {
        show(w, &sources);
    }
    let checked = match check_channels(&simulator, &initial_run, threads(args.threads), !args.as_recorded, &sources) {
        Ok(checked) => checked,
        Err(e) => {
            eprintln!("error: {e}");
            return FAILED_STATUS;
        }
    };
    if checked.has_hard_findings() && !args.as_recorded {
        eprintln!(
            "no diagnosis: it would take this for physics. Mend the study, or take it as it is with --as-recorded"
        );
        return WRONG_INPUT_STATUS;
    }
    tell_diagnosis(&study, &initial_run, threads(args.threads));
    let dir = args.out.clone().unwrap_or_else(|| "results".into());
    let saved = dir.join(CHECKPOINT_FILE);
    let _lock = match lock_folder(&dir) {
        Ok(lock) => lock,
        Err(message) => {
            eprintln!("error: {message}");
            return FAILED_STATUS;
        }
    };
    let read = hysteron_files::read_text(study.folder.join(&study.model)).map_err(|e| e.to_string());
    let found = read.and_then(|text| {
        let identity = identity(&simulator, &initial_run, &text, &args.without);
        let checkpoint = if args.resume { earlier_entries(&saved, identity)? } else { vec![] };
        let settings = Settings {
            excluded_causes: args.without.clone(),
            counted_times_are_seconds: args.clock,
            threads: threads(args.threads),
            checkpoint,
        };
        let mut monitor = ConsoleMonitor::new(stop.clone(), saved.clone(), identity);
        let found = diagnose(&simulator, &initial_run, &text, &settings, &mut monitor);
        monitor.progress.clear();
        found.map(|mut d| {
            d.outcome.preflight = Some(checked);
            (report(&d, &study, &text), d)
        })
    });
    match found.and_then(|(report, d)| write(&dir, &simulator, &d, &report, args.view).map(|()| d)) {
        Ok(d) => {
            let _ = hysteron_files::remove(&saved);
            print_verdict(&d, args);
            eprintln!("report.html, corrected.tcl and diagnosis.json are in {}", dir.display());
            0
        }
        Err(message) => {
            eprintln!("error: {}: {message}", args.study.display());
            if !stop.load(Ordering::Relaxed) {
                return FAILED_STATUS;
            }
            if saved.exists() {
                eprintln!("complete fits are kept; --resume continues");
            }
            stopped_status(&stop).unwrap_or(FAILED_STATUS)
        }
    }
}

fn prepare(
    args: &DiagnoseArgs,
    stop: &Arc<AtomicBool>,
    sources: &mut SourceMap,
) -> Result<(ScriptSimulator, InitialRun), Box<Diagnostic>> {
    let study = Arc::new(Study::load(&args.study, sources)?);
    let options = Options { compat: args.compat.is_some(), ladder: None, ..Options::default() };
    let mut simulator = ScriptSimulator::new(study, options, stop.clone());
    let initial_run = simulator.run_initially(sources)?;
    Ok((simulator, initial_run))
}

/// File of the result.
const RESULT_FILE: &str = "diagnosis.json";
/// File of a learned law.
pub(super) const LEARNED_FILE: &str = "learned_law.json";
/// File of an interrupted diagnosis.
const CHECKPOINT_FILE: &str = "diagnosis-checkpoint.json";

#[derive(Serialize, Deserialize)]
struct Checkpoint {
    /// Identity of the study and the library.
    identity: u64,
    entries: Vec<CheckpointEntry>,
}

/// Entries of an interrupted diagnosis with this identity; none if there is no such diagnosis.
fn earlier_entries(saved: &Path, identity: u64) -> Result<Vec<CheckpointEntry>, String> {
    let Some(old) = read_checkpoint::<Checkpoint>(saved)? else { return Ok(vec![]) };
    if old.identity == identity {
        return Ok(old.entries);
    }
    let why = "it is of another study, or of another version of hysteron";
    Err(format!("cannot go on from {}: {why}", saved.display()))
}

/// Writes the files of a diagnosis.
fn write(dir: &Path, simulator: &ScriptSimulator, d: &Diagnosis, report: &str, view: bool) -> Result<(), String> {
    note_replaced(dir, RESULT_FILE, &d.outcome.study);
    write_atomically(&dir.join("corrected.tcl"), &standalone_script(simulator, dir, &d.repaired_script))?;
    let opensees = dir.join("corrected_opensees.tcl");
    match &d.opensees_script {
        Some(text) => write_atomically(&opensees, &standalone_script(simulator, dir, text))?,
        // That of an earlier diagnosis would be another model's.
        None => drop(hysteron_files::remove(&opensees)),
    }
    let learned = dir.join(LEARNED_FILE);
    match &d.outcome.learned {
        Some(l) => write_atomically(&learned, &l.json)?,
        None => drop(hysteron_files::remove(&learned)),
    }
    let models = [("simulated", &d.baseline_fits), ("repaired", &d.repaired_fits)];
    let models = models.map(|(name, runs)| (name, runs.iter().map(Option::as_ref).collect()));
    write_channels(dir, simulator.study(), &models)?;
    write_report(dir, report, view)?;
    for (name, motion) in d.next_test.iter().flat_map(|t| &t.motions) {
        write_atomically(&dir.join(name), motion)?;
    }
    if let Some(test) = d.next_test.iter().find(|t| !t.script.is_empty()) {
        write_atomically(&dir.join("next_test.tcl"), &test.script)?;
    }
    write_atomically(&dir.join(RESULT_FILE), &json(d)?)
}

/// Content of the result file.
fn json(d: &Diagnosis) -> Result<String, String> {
    serde_json::to_string_pretty(&d.outcome).map(|text| text + "\n").map_err(|e| e.to_string())
}

/// Width of the summary in letters.
const SUMMARY_WIDTH: usize = 80;

/// Prints the result: the summary, with the statistics if they are wanted, or the content of the result file.
fn print_verdict(d: &Diagnosis, args: &DiagnoseArgs) {
    match json(d).ok().filter(|_| args.json) {
        Some(json) => print!("{json}"),
        None => print!("{}", d.outcome.verdict.summary.text(SUMMARY_WIDTH)),
    }
    if args.verbose {
        print_statistics(d);
    }
}

/// Prints explanation, probabilities, errors and ranking.
fn print_statistics(d: &Diagnosis) {
    let v = &d.outcome.verdict;
    println!("\n{} ({:.1} %): {}", v.cause, 100.0 * v.confidence, v.explanation);
    for other in &v.also_possible {
        println!("  also possible: {} ({:.1} %)", other.cause, 100.0 * other.confidence);
    }
    let shown = |x: Option<f64>| x.map_or("-".into(), |x| format!("{x:.4e}"));
    let (b, c) = (&d.outcome.baseline, &d.outcome.corrected);
    println!(
        "NMSE fitted {:.4e} -> {:.4e}, held out {} -> {}",
        b.fit_nmse,
        c.fit_nmse,
        shown(b.holdout_nmse),
        shown(c.holdout_nmse)
    );
    if let Some(reason) = &c.opensees_reason {
        println!("no script in OpenSees' own commands: {reason}");
    }
    println!("the fitted runs were looked at for {} sets of values", d.evaluations);
    if d.structured_share > 0.0 {
        println!("{:.2} of what the best leaves has structure: {}", d.structured_share, d.structure);
    }
    for w in &d.ranking {
        println!(
            "  {:26} {:.4e}  log evidence {:8.2}  {} ({})",
            w.cause, w.objective, w.log_evidence, w.location, w.form
        );
    }
}

/// Progress on standard error, checkpoints, and interruption.
struct ConsoleMonitor {
    progress: PhaseProgress,
    stop: Arc<AtomicBool>,
    saved: PathBuf,
    identity: u64,
    last_save: Instant,
}

impl ConsoleMonitor {
    fn new(stop: Arc<AtomicBool>, saved: PathBuf, identity: u64) -> Self {
        let progress = PhaseProgress::new();
        Self { progress, stop, saved, identity, last_save: Instant::now() }
    }
}

impl ProgressMonitor for ConsoleMonitor {
    fn stage(&mut self, name: &str, done: usize, total: usize) {
        self.progress.stage(name, done, total);
    }

    fn is_cancelled(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }

    fn checkpoint(&mut self, entries: &[CheckpointEntry]) {
        if self.last_save.elapsed() < CHECKPOINT_INTERVAL && !self.is_cancelled() {
            return;
        }
        self.last_save = Instant::now();
        let checkpoint = Checkpoint { identity: self.identity, entries: entries.to_vec() };
        if let Err(message) = write_checkpoint(&self.saved, &checkpoint) {
            self.progress.suspend(|| eprintln!("warning: no checkpoint: {message}"));
        }
    }
}

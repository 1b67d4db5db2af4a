//! `hysteron diagnose`.

use super::args::DiagnoseArgs;
use super::files::{CHECKPOINT_INTERVAL, write_atomically};
use super::messages::Messages;
use hysteron::analysis::Options;
use hysteron::diagnose::{Diagnosis, Kept, Settings, Watch, diagnose, hypothesis, identity, page};
use hysteron::diagnostic::{Diagnostic, Severity, SourceMap, nearest};
use hysteron::study::{InitialRun, ScriptSimulator, Study};
use indicatif::{ProgressBar, ProgressStyle};
use serde::{Deserialize, Serialize};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

/// Exit status where the diagnosis failed, and where the input is wrong.
const FAILED: i32 = 1;
const WRONG: i32 = 2;

/// Diagnose a study.
pub(super) fn run(args: &DiagnoseArgs) -> i32 {
    let stop = Arc::new(AtomicBool::new(false));
    super::run::on_interrupt(&stop);
    for cause in &args.without {
        if hypothesis::of(cause).is_none() {
            let known = || hypothesis::ALL.iter().map(|h| h.cause);
            eprintln!("error: unknown cause \"{cause}\"");
            if let Some(near) = nearest(cause, known()) {
                eprintln!("  did you mean \"{near}\"?");
            }
            eprintln!("  known: {}", known().collect::<Vec<_>>().join(" "));
            return WRONG;
        }
    }
    let mut sources = SourceMap::default();
    let show = |d: &Diagnostic, sources: &SourceMap| eprintln!("{}\n", Messages::new().render(d, sources));
    let (simulator, initial_run) = match prepare(args, &stop, &mut sources) {
        Ok(prepared) => prepared,
        Err(d) => {
            show(&d, &sources);
            return WRONG;
        }
    };
    let study = simulator.study().clone();
    for w in study.warnings.iter().chain(&initial_run.warnings).filter(|w| w.severity != Severity::Note) {
        show(w, &sources);
    }
    let dir = args.out.clone().unwrap_or_else(|| "results".into());
    let saved = dir.join(CHECKPOINT);
    let found = fs::read_to_string(study.folder.join(&study.model)).map_err(|e| e.to_string()).and_then(|text| {
        let of = identity(&simulator, &initial_run, &text, &args.without);
        let earlier = if args.resume { earlier(&saved, of)? } else { vec![] };
        fs::create_dir_all(&dir).map_err(|e| format!("cannot make {}: {e}", dir.display()))?;
        let threads = args.threads.unwrap_or_else(|| std::thread::available_parallelism().map_or(1, usize::from));
        let settings = Settings { without: args.without.clone(), clock: args.clock, threads, earlier };
        let mut bar = Bar::new(stop.clone(), saved.clone(), of);
        let found = diagnose(&simulator, &initial_run, &text, &settings, &mut bar);
        bar.bar.finish_and_clear();
        found.map(|d| (page(&d, &study, &text), d))
    });
    match found.and_then(|(page, d)| write(&dir, &d, &page).map(|()| d)) {
        Ok(d) => {
            let _ = fs::remove_file(&saved);
            tell(&d, args.verbose);
            eprintln!("written to {}", dir.display());
            0
        }
        Err(message) => {
            eprintln!("error: {}: {message}", args.study.display());
            if stop.load(Ordering::Relaxed) && saved.exists() {
                eprintln!("what was worked out is kept; --resume goes on");
            }
            FAILED
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

/// What an interrupted diagnosis leaves in its folder.
const CHECKPOINT: &str = "diagnosis-checkpoint.json";

#[derive(Serialize, Deserialize)]
struct Checkpoint {
    /// Of which study, with which library.
    of: u64,
    kept: Vec<Kept>,
}

/// What was worked out before an interruption.
fn earlier(saved: &Path, of: u64) -> Result<Vec<Kept>, String> {
    let cannot = |e: String| format!("cannot go on: {}: {e}", saved.display());
    let text = fs::read_to_string(saved).map_err(|e| cannot(e.to_string()))?;
    let old: Checkpoint = serde_json::from_str(&text).map_err(|e| cannot(e.to_string()))?;
    if old.of == of {
        Ok(old.kept)
    } else {
        Err(cannot("it is of another study, or of another version of hysteron".into()))
    }
}

fn write(dir: &Path, d: &Diagnosis, page: &str) -> Result<(), String> {
    write_atomically(&dir.join("corrected.tcl"), &d.script)?;
    write_atomically(&dir.join("report.html"), page)?;
    for (name, motion) in d.next_test.iter().flat_map(|t| &t.motions) {
        write_atomically(&dir.join(name), motion)?;
    }
    if let Some(test) = &d.next_test {
        write_atomically(&dir.join("next_test.tcl"), &test.script)?;
    }
    let json = serde_json::to_string_pretty(&d.outcome).map_err(|e| e.to_string())?;
    write_atomically(&dir.join("diagnosis.json"), &(json + "\n"))
}

/// The verdict in a few lines.
fn tell(d: &Diagnosis, verbose: bool) {
    let v = &d.outcome.verdict;
    let also = if v.also.is_empty() { String::new() } else { format!(" and {}", v.also.join(", ")) };
    println!("{}{also} ({:.0} %): {}", v.cause, 100.0 * v.confidence, v.explanation);
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
    if verbose {
        println!("the fitted runs were looked at for {} sets of values", d.looks);
        if d.left.0 > 0.0 {
            println!("{:.2} of what the best leaves has structure: {}", d.left.0, d.left.1);
        }
        for w in &d.weighed {
            println!("  {:26} {:.4e}  log evidence {:8.2}  {} ({})", w.cause, w.objective, w.evidence, w.at, w.form);
        }
    }
}

/// Progress on standard error, the checkpoint, and the interrupt.
struct Bar {
    bar: ProgressBar,
    stop: Arc<AtomicBool>,
    saved: PathBuf,
    of: u64,
    last: Instant,
}

impl Bar {
    fn new(stop: Arc<AtomicBool>, saved: PathBuf, of: u64) -> Self {
        let bar = ProgressBar::new(1);
        let style = ProgressStyle::with_template("{msg} [{bar:30}] {pos}/{len} {per_sec}, {eta} left");
        let bar = bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
        Self { bar, stop, saved, of, last: Instant::now() }
    }
}

impl Watch for Bar {
    fn stage(&mut self, what: &str, done: usize, of: usize) {
        self.bar.set_message(what.to_owned());
        self.bar.set_length(of as u64);
        self.bar.set_position(done as u64);
    }

    fn stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }

    fn keep(&mut self, kept: &[Kept]) {
        if self.last.elapsed() < CHECKPOINT_INTERVAL && !self.stopped() {
            return;
        }
        self.last = Instant::now();
        let checkpoint = Checkpoint { of: self.of, kept: kept.to_vec() };
        let text = serde_json::to_string(&checkpoint).map_err(|e| e.to_string());
        if let Err(message) = text.and_then(|text| write_atomically(&self.saved, &text)) {
            self.bar.suspend(|| eprintln!("warning: no checkpoint: {message}"));
        }
    }
}

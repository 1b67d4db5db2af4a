//! `hysteron learn`.

use super::args::LearnArgs;
use super::diagnose::LEARNED_FILE;
use super::files::{lock_folder, write_atomically};
use super::messages::Messages;
use super::preflight::threads;
use super::progress::PhaseProgress;
use super::signals::{INTERRUPTED, on_interrupt, stopped_status};
use hysteron::analysis::Options;
use hysteron::diagnose::{CheckpointEntry, LearnedStudy, ProgressMonitor, Settings, learn_law};
use hysteron::diagnostic::{Diagnostic, Severity, SourceMap};
use hysteron::study::{ScriptSimulator, Study, standalone_script};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Exit status of a study from which nothing is learned.
const FAILED_STATUS: i32 = 1;
/// Exit status for wrong input.
const WRONG_INPUT_STATUS: i32 = 2;

/// Learns a law from a study, writes its files and returns the exit status.
pub(super) fn run(args: &LearnArgs) -> i32 {
    let stop = Arc::new(AtomicBool::new(false));
    on_interrupt(&stop);
    args.limits.enforce(&stop);
    let mut sources = SourceMap::default();
    let show = |d: &Diagnostic, sources: &SourceMap| eprintln!("{}\n", Messages::new().render(d, sources));
    let opened = Study::load(&args.study, &mut sources).and_then(|study| {
        let mut simulator = ScriptSimulator::new(Arc::new(study), Options::default(), stop.clone());
        let initial_run = simulator.run_initially(&mut sources)?;
        Ok((simulator, initial_run))
    });
    let (simulator, initial_run) = match opened {
        Ok((_, initial_run)) if initial_run.is_interrupted() => return stopped_status(&stop).unwrap_or(INTERRUPTED),
        Ok(opened) => opened,
        Err(d) => {
            show(&d, &sources);
            return WRONG_INPUT_STATUS;
        }
    };
    let study = simulator.study().clone();
    for w in study.warnings.iter().chain(&initial_run.warnings).filter(|w| w.severity != Severity::Note) {
        show(w, &sources);
    }
    let dir = args.out.clone().unwrap_or_else(|| "results".into());
    let found = lock_folder(&dir).and_then(|_lock| {
        let text = hysteron_files::read_text(study.folder.join(&study.model)).map_err(|e| e.to_string())?;
        let settings =
            Settings { counted_times_are_seconds: args.clock, threads: threads(args.threads), ..Settings::default() };
        let mut monitor = Monitor { progress: PhaseProgress::new(), stop: stop.clone() };
        let found = learn_law(&simulator, &initial_run, &text, &settings, &mut monitor);
        monitor.progress.clear();
        found.and_then(|l| write(&dir, &simulator, &l).map(|()| l))
    });
    match found {
        Ok(l) => {
            print_law(&l, &dir);
            0
        }
        Err(message) => {
            eprintln!("error: {}: {message}", args.study.display());
            stopped_status(&stop).unwrap_or(FAILED_STATUS)
        }
    }
}

/// Families that are shown beside that of the law.
const SHOWN_RIVALS: usize = 4;
/// File of the script with the law.
const SCRIPT_FILE: &str = "learned.tcl";

fn write(dir: &Path, simulator: &ScriptSimulator, l: &LearnedStudy) -> Result<(), String> {
    // Files of an earlier law would be another one's.
    for file in [LEARNED_FILE, SCRIPT_FILE] {
        let _ = hysteron_files::remove(dir.join(file));
    }
    if !l.is_worth_writing() {
        return Ok(());
    }
    write_atomically(&dir.join(LEARNED_FILE), &l.json)?;
    let script = l.script.as_ref().map(|text| standalone_script(simulator, dir, text));
    script.map_or(Ok(()), |text| write_atomically(&dir.join(SCRIPT_FILE), &text))
}

fn print_law(l: &LearnedStudy, dir: &Path) {
    let e = &l.learned;
    println!("The learned law of {} is {}.", l.channel, l.statement);
    l.parts.iter().for_each(|p| println!("  {p}"));
    let rivals: Vec<String> =
        e.rivals.iter().take(SHOWN_RIVALS).map(|(f, _, x)| format!("{} {:.2}", f.name(), x.exp())).collect();
    println!("error of other families over that of this one: {}", rivals.join(", "));
    println!("NMSE                 your model   learned law");
    println!("fitted runs          {:10.2e}   {:10.2e}", e.user_fitted, e.fitted);
    println!("blocks held back              -   {:10.2e}", e.blocks);
    if let (Some(before), Some(after)) = (e.user_held_out, e.held_out) {
        println!("runs held out        {before:10.2e}   {after:10.2e}");
    }
    if let Some(beyond) = e.held_out_beyond.filter(|_| e.outside > 0.0) {
        println!("the same beyond range         -   {beyond:10.2e}");
    }
    if let Some([before, after]) = l.simulated {
        println!("the same, simulated  {before:10.2e}   {after:10.2e}");
    }
    l.remarks().iter().for_each(|r| println!("{r}"));
    if !l.is_worth_writing() {
        eprintln!("no law is written");
        return;
    }
    let script = if l.script.is_some() { format!(" and {SCRIPT_FILE}") } else { String::new() };
    eprintln!("{LEARNED_FILE}{script} in {}", dir.display());
    if l.script.is_none() {
        eprintln!(
            "no script is written: the channel is not the force of one element, or the script cannot tell the runs"
        );
    }
}

/// Progress on standard error, and interruption.
struct Monitor {
    progress: PhaseProgress,
    stop: Arc<AtomicBool>,
}

impl ProgressMonitor for Monitor {
    fn stage(&mut self, name: &str, done: usize, total: usize) {
        self.progress.stage(name, done, total);
    }

    fn is_cancelled(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }

    fn checkpoint(&mut self, _: &[CheckpointEntry]) {}
}

//! Analyses of an isolation study on all cores: kept in a folder, resumable, with progress.

use super::calibrate::print_diagnostic;
use super::files::{lock_folder, make_inner_folder, write_atomically};
use super::limits::LimitArgs;
use super::pace::Pace;
use super::progress::count_bar;
use super::signals::{on_interrupt, stopped_status};
use clap::Args;
use hysteron::design::isolate::{self, Job, JobOutcome, Study, is_current, run_job};
use hysteron::design::mistake::Mistake;
use hysteron::design::review::{self, Periods};
use hysteron::diagnostic::{Diagnostic, SourceMap};
use hysteron::study::WorkerPool;
use hysteron_files::FolderLock;
use indicatif::ProgressBar;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};

/// Options of commands that run the analyses of a study.
#[derive(Args, Debug)]
pub(super) struct StudyJobsArgs {
    #[command(flatten)]
    limits: LimitArgs,
    /// The study (.toml); `fragility` takes a table of counts (.csv) too
    pub(super) study: PathBuf,
    /// Number of threads; all cores if it is not given. The result does not depend on it
    #[arg(long, value_name = "N")]
    threads: Option<usize>,
    /// Keep the analyses that an interrupted run has made and whose script, records and files read are the same
    #[arg(long)]
    resume: bool,
    /// Print the results as JSON
    #[arg(long)]
    pub(super) json: bool,
}

/// Reason for which a command on a study ends.
pub(super) enum Refusal {
    /// Described in one sentence.
    Message(String),
    /// A mistake of the study, with the texts that it points into.
    Mistake(Box<Diagnostic>, SourceMap),
}

impl From<String> for Refusal {
    fn from(message: String) -> Self {
        Self::Message(message)
    }
}

impl From<&str> for Refusal {
    fn from(message: &str) -> Self {
        message.to_owned().into()
    }
}

/// Text and exit status of a command, or the reason for which it ends.
pub(super) type Outcome = Result<(String, i32), Refusal>;

/// Read a study and settle it with its script, and say what is to be said about its motions.
pub(super) fn load(path: &Path, stop: &Arc<AtomicBool>) -> Result<Study, Refusal> {
    let mut sources = SourceMap::default();
    let study = isolate::load(path, stop, &mut sources).map_err(|d| Refusal::Mistake(d, sources))?;
    study.notes.iter().chain(&study.agreement.remarks).for_each(|note| eprintln!("warning: {note}"));
    Ok(study)
}

/// The same, and compare its periods and its suite with its model.
pub(super) fn load_agreed(path: &Path, stop: &Arc<AtomicBool>) -> Result<(Study, Periods), Refusal> {
    let study = load(path, stop)?;
    let periods = review::periods(&study);
    let agreed = periods.agree(&study).and_then(|()| review::suite(&study).agree(&study));
    let placed = |m: Mistake| {
        let mut sources = SourceMap::default();
        Refusal::Mistake(study.placed(&m, &mut sources), sources)
    };
    agreed.map_err(placed)?;
    Ok((study, periods))
}

impl StudyJobsArgs {
    /// A flag that Ctrl-C, SIGTERM and the limits set.
    pub(super) fn stop_flag(&self) -> Arc<AtomicBool> {
        let stop = Arc::new(AtomicBool::new(false));
        on_interrupt(&stop);
        self.limits.enforce(&stop);
        stop
    }
}

/// Analyses of a study in a folder.
pub(super) struct StudyJobs<'a> {
    study: &'a Study,
    folder: PathBuf,
    resume: bool,
    stop: Arc<AtomicBool>,
    pool: WorkerPool,
    bar: Option<ProgressBar>,
    pace: Pace,
    /// Analyses that were made, and those that were kept.
    made: AtomicUsize,
    kept: AtomicUsize,
    /// Warnings of the script by place and check, with the number of their analyses.
    warnings: Mutex<BTreeMap<String, (String, usize)>>,
    /// No other run writes into the folder of the results.
    _lock: FolderLock,
}

/// Description of an analysis that was stopped.
const STOPPED: &str = "interrupted";

impl<'a> StudyJobs<'a> {
    /// Make the folder and the threads. `stop` is set by Ctrl-C and SIGTERM.
    pub(super) fn new(a: &StudyJobsArgs, study: &'a Study, out: &Path, stop: &Arc<AtomicBool>) -> Result<Self, String> {
        let (lock, folder) = (lock_folder(out)?, out.join("analyses"));
        make_inner_folder(&folder)?;
        let cores = std::thread::available_parallelism().map_or(1, usize::from);
        let threads = a.threads.unwrap_or(cores).max(1);
        let pool = WorkerPool::new(threads).map_err(|e| e.to_string())?;
        let bar = count_bar("analyses");
        let (made, kept) = (AtomicUsize::new(0), AtomicUsize::new(0));
        Ok(Self {
            study,
            folder,
            resume: a.resume,
            stop: stop.clone(),
            pool,
            bar,
            pace: Pace::begin(threads),
            made,
            kept,
            warnings: Mutex::default(),
            _lock: lock,
        })
    }

    /// An analysis that has been made before for the same study.
    fn earlier(&self, path: &Path) -> Option<JobOutcome> {
        let outcome: JobOutcome = serde_json::from_str(&hysteron_files::read_text(path).ok()?).ok()?;
        let same = outcome.fingerprint == self.study.fingerprint && outcome.failure != STOPPED;
        (same && is_current(&outcome.inputs)).then_some(outcome)
    }

    /// Make an analysis, or find it.
    ///
    /// # Errors
    /// It was interrupted, its script was rejected, or its file cannot be written.
    pub(super) fn one(&self, job: &Job) -> Result<JobOutcome, String> {
        let path = self.folder.join(format!("{}.json", job.name()));
        let earlier = self.resume.then(|| self.earlier(&path)).flatten();
        let outcome = match earlier {
            Some(outcome) => {
                self.kept.fetch_add(1, Ordering::Relaxed);
                outcome
            }
            None if self.stop.load(Ordering::Relaxed) => return Err(STOPPED.into()),
            None => {
                let outcome = run_job(self.study, job, &self.stop);
                if outcome.failure == STOPPED {
                    return Err(STOPPED.into());
                }
                let text = serde_json::to_string(&outcome).map_err(|e| e.to_string())?;
                write_atomically(&path, &text)?;
                self.made.fetch_add(1, Ordering::Relaxed);
                outcome
            }
        };
        self.note(&outcome);
        if let Some(bar) = &self.bar {
            bar.inc(1);
        }
        // A fault of the script is the same in all analyses, and no result.
        if outcome.failure.starts_with("the script was rejected") {
            return Err(outcome.failure);
        }
        Ok(outcome)
    }

    /// Keep the warnings of an analysis. Of different numbers in one warning those of the first text count, in any order of
    /// the threads.
    fn note(&self, outcome: &JobOutcome) {
        let Ok(mut all) = self.warnings.lock() else { return };
        for (key, text) in &outcome.warnings {
            let entry = all.entry(key.clone()).or_insert_with(|| (text.clone(), 0));
            entry.1 += 1;
            if *text < entry.0 {
                entry.0.clone_from(text);
            }
        }
    }

    /// Do tasks of about `analyses` analyses on all threads; results in their order. Tasks behind one with an error are not begun.
    ///
    /// # Errors
    /// The first error of a task, or an interrupt.
    pub(super) fn all<T: Sync, R: Send>(
        &self,
        tasks: &[T],
        analyses: usize,
        work: impl Fn(&T) -> Result<R, String> + Sync,
    ) -> Result<Vec<R>, String> {
        if let Some(bar) = &self.bar {
            bar.set_length(analyses as u64);
        }
        // Those before the first error are done, so that it is the same one for any number of threads.
        let first_error = AtomicUsize::new(usize::MAX);
        let done = self.pool.run(tasks.iter().enumerate(), |(i, task)| {
            if first_error.load(Ordering::Relaxed) < i {
                return Err(STOPPED.into());
            }
            work(task).inspect_err(|_| {
                first_error.fetch_min(i, Ordering::Relaxed);
            })
        });
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
        if self.stop.load(Ordering::Relaxed) {
            return Err("interrupted: go on with --resume".into());
        }
        let [made, kept] = [&self.made, &self.kept].map(|n| n.load(Ordering::Relaxed));
        if let Ok(all) = self.warnings.lock() {
            all.values().for_each(|(text, n)| eprintln!("warning: {text}, in {n} of {} analyses", made + kept));
        }
        self.pace.report(made, kept, "analyses");
        done.into_iter().map(|r| r.unwrap_or_else(|| Err("a defect of this program".into()))).collect()
    }
}

/// Write results and print their text; the exit status.
pub(super) fn finish(result: Outcome, stop: &AtomicBool) -> i32 {
    match result {
        Ok((text, status)) => return super::run::print(Ok(text)).max(status),
        Err(Refusal::Message(message)) => eprintln!("error: {message}"),
        Err(Refusal::Mistake(d, sources)) => print_diagnostic(&d, &sources),
    }
    stopped_status(stop).unwrap_or(super::calibrate::INPUT_ERROR)
}

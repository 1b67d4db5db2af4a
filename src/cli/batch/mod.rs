//! `hysteron batch`: many runs of scripts, on one machine or as the jobs of a cluster.

mod check;
mod jobs;

use super::calibrate::{FAILURE, INPUT_ERROR};
use super::files::{make_folder, make_inner_folder, write_atomically};
use super::limits::LimitArgs;
use super::pace::Pace;
use super::signals::{on_interrupt, stopped_status};
pub(super) use check::check;
use clap::Args;
use hysteron::design::batch::{Case, Plan, is_complete, load, run_case, table};
use hysteron::study::WorkerPool;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use jobs::{Scheduler, scheduled, write_jobs};
use std::io::IsTerminal as _;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

#[derive(Args, Debug)]
pub(super) struct BatchArgs {
    #[command(flatten)]
    limits: LimitArgs,
    /// The plan
    plan: PathBuf,
    /// Where the results go
    #[arg(long, value_name = "DIR", default_value = "batch")]
    out: PathBuf,
    /// Number of threads; all cores if it is not given. The result does not depend on it
    #[arg(long, value_name = "N")]
    threads: Option<usize>,
    /// Keep the cases that an earlier run has completed, unless a file that they read has changed
    #[arg(long)]
    resume: bool,
    /// Run a part of the cases, for instance 2/8; by default that of the environment of a Slurm array or of srun
    #[arg(long, value_name = "I/N", value_parser = shard)]
    shard: Option<(usize, usize)>,
    /// Run nothing: make the table of the cases that the shards have completed
    #[arg(long, conflicts_with_all = ["shard", "resume"])]
    merge: bool,
    /// Run nothing: write the files of a job array for a scheduler
    #[arg(long, value_name = "SCHEDULER", value_enum, conflicts_with_all = ["shard", "resume", "merge"])]
    emit: Option<Scheduler>,
    /// Number of jobs of the array
    #[arg(long, value_name = "N", default_value_t = 8, requires = "emit", value_parser = clap::value_parser!(u32).range(1..=100_000))]
    jobs: u32,
}

fn shard(text: &str) -> Result<(usize, usize), String> {
    let numbers = text.split_once('/').and_then(|(i, n)| Some((i.parse().ok()?, n.parse().ok()?)));
    numbers.filter(|(i, n)| (1..=*n).contains(i)).ok_or_else(|| "expected I/N with I from 1 to N, as 2/8".into())
}

/// Run the command; the exit status.
pub(super) fn batch(a: &BatchArgs) -> i32 {
    let stop = Arc::new(AtomicBool::new(false));
    on_interrupt(&stop);
    a.limits.enforce(&stop);
    match run(a, &stop) {
        Ok(0) => 0,
        Ok(_) => FAILURE,
        Err(message) => {
            eprintln!("error: {message}");
            stopped_status(&stop).unwrap_or(INPUT_ERROR)
        }
    }
}

/// Do what is asked for; the number of cases that failed.
fn run(a: &BatchArgs, stop: &Arc<AtomicBool>) -> Result<usize, String> {
    let plan = load(&a.plan)?;
    warnings(&plan).iter().for_each(|note| eprintln!("warning: {note}"));
    make_folder(&a.out)?;
    if let Some(scheduler) = a.emit {
        write_jobs(scheduler, &a.plan, &a.out, a.jobs)?;
        return Ok(0);
    }
    let folder = a.out.join("cases");
    make_inner_folder(&folder)?;
    if a.merge {
        return write_table(a, &plan, &folder);
    }
    let environment = || scheduled(|name| std::env::var(name).ok());
    let part = match a.shard {
        Some(part) => Some(part),
        None => environment()?,
    };
    let (i, n) = part.unwrap_or((1, 1));
    let own: Vec<&Case> = plan.cases.iter().skip(i - 1).step_by(n).collect();
    if a.shard.is_none() && part.is_some() {
        eprintln!("shard {i}/{n}, as the environment says");
    }
    compute(a, &plan, &own, &folder, stop)?;
    if n > 1 {
        eprintln!("{} of {} cases are complete; --merge makes the table of all", own.len(), plan.cases.len());
        return Ok(0);
    }
    write_table(a, &plan, &folder)
}

/// Findings of a plan that has been read.
fn warnings(plan: &Plan) -> Vec<String> {
    let repeated = format!("{} cases have the inputs of another one: they are run once", plan.repeated);
    plan.notes.iter().cloned().chain((plan.repeated > 0).then_some(repeated)).collect()
}

/// Run cases on all threads.
fn compute(a: &BatchArgs, plan: &Plan, own: &[&Case], folder: &Path, stop: &Arc<AtomicBool>) -> Result<(), String> {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let threads = a.threads.unwrap_or(cores).max(1);
    let pool = WorkerPool::new(threads).map_err(|e| e.to_string())?;
    let kept = if a.resume { own.iter().filter(|case| is_complete(case, folder)).count() } else { 0 };
    let pace = Pace::begin(threads);
    let bar = std::io::stderr().is_terminal().then(|| {
        let bar = ProgressBar::with_draw_target(Some(own.len() as u64), ProgressDrawTarget::stderr());
        let style = ProgressStyle::with_template("{elapsed_precise} [{bar:30}] {pos} of {len} cases, left {eta}");
        style.map_or(bar.clone(), |s| bar.with_style(s.progress_chars("=> ")))
    });
    let done = pool.run(own.iter(), |case| {
        let done = run_case(plan, case, folder, a.resume, stop);
        if let Some(bar) = &bar {
            bar.inc(1);
        }
        done
    });
    if let Some(bar) = &bar {
        bar.finish_and_clear();
    }
    for (case, result) in own.iter().zip(done) {
        result.unwrap_or_else(|| Err(format!("case {}: a defect of this program", case.hash)))?;
    }
    if !stop.load(Ordering::Relaxed) {
        pace.report(own.len() - kept, kept, "cases");
    }
    if stop.load(Ordering::Relaxed) { Err("interrupted: go on with --resume".into()) } else { Ok(()) }
}

/// Write the table of all cases; the number of those that failed.
fn write_table(a: &BatchArgs, plan: &Plan, folder: &Path) -> Result<usize, String> {
    let incomplete = |n| format!("{n} of {} cases are not complete in {}", plan.cases.len(), folder.display());
    let table = table(plan, folder).map_err(incomplete)?;
    write_atomically(&a.out.join("results.csv"), &table.csv)?;
    eprintln!("{} cases, {} of them failed", plan.cases.len(), table.failed);
    if let Some((hash, message)) = &table.first_failure {
        eprintln!("the first of them, {}: {message}", folder.join(hash).display());
    }
    Ok(table.failed)
}

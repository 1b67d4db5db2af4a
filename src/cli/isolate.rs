//! `hysteron isolate`: an isolation study.

use super::calibrate::{FAILURE, INPUT_ERROR};
use super::files::write_atomically;
use super::run::print;
use super::signals::{INTERRUPTED, on_interrupt};
use clap::Args;
use hysteron::design::check::{Status, check_table};
use hysteron::design::isolate::{Job, JobOutcome, Study, jobs, load, report, run_job, summary};
use hysteron::study::WorkerPool;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

#[derive(Args, Debug)]
pub(super) struct IsolateArgs {
    /// The study
    study: PathBuf,
    /// Where the results go
    #[arg(long, value_name = "DIR", default_value = "isolation")]
    out: PathBuf,
    /// Number of threads; all cores if it is not given. The result does not depend on it
    #[arg(long, value_name = "N")]
    threads: Option<usize>,
    /// Keep the analyses that an interrupted run of the same study has made
    #[arg(long)]
    resume: bool,
    /// Print the results as JSON
    #[arg(long)]
    json: bool,
}

/// An analysis that has been made before for the same study.
fn earlier(path: &Path, study: &Study) -> Option<JobOutcome> {
    let outcome: JobOutcome = serde_json::from_str(&fs::read_to_string(path).ok()?).ok()?;
    (outcome.fingerprint == study.fingerprint && outcome.failure != "interrupted").then_some(outcome)
}

fn one(study: &Study, job: &Job, folder: &Path, resume: bool, stop: &Arc<AtomicBool>) -> Result<JobOutcome, String> {
    let path = folder.join(format!("{}.json", job.name()));
    if let Some(outcome) = resume.then(|| earlier(&path, study)).flatten() {
        return Ok(outcome);
    }
    if stop.load(Ordering::Relaxed) {
        return Ok(JobOutcome { failure: "interrupted".into(), ..JobOutcome::default() });
    }
    let outcome = run_job(study, job, stop);
    if outcome.failure != "interrupted" {
        let text = serde_json::to_string(&outcome).map_err(|e| e.to_string())?;
        write_atomically(&path, &text)?;
    }
    Ok(outcome)
}

/// Run the command; the exit status.
pub(super) fn isolate(a: &IsolateArgs) -> i32 {
    let stop = Arc::new(AtomicBool::new(false));
    on_interrupt(&stop);
    match study(a, &stop) {
        Ok((text, status)) => print(Ok(text)).max(status),
        Err(message) => {
            eprintln!("error: {message}");
            if stop.load(Ordering::Relaxed) { INTERRUPTED } else { INPUT_ERROR }
        }
    }
}

fn study(a: &IsolateArgs, stop: &Arc<AtomicBool>) -> Result<(String, i32), String> {
    let study = load(&a.study)?;
    let folder = a.out.join("analyses");
    fs::create_dir_all(&folder).map_err(|e| format!("cannot make {}: {e}", folder.display()))?;
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let pool = WorkerPool::new(a.threads.unwrap_or(cores)).map_err(|e| e.to_string())?;
    let all = jobs(&study);
    let done = pool.run(all.iter(), |job| one(&study, job, &folder, a.resume, stop));
    let mut outcomes = vec![];
    for (job, result) in all.iter().zip(done) {
        outcomes.push(result.unwrap_or_else(|| Err(format!("{}: a defect of this program", job.name())))?);
    }
    if stop.load(Ordering::Relaxed) {
        return Err("interrupted: go on with --resume".into());
    }
    // A fault of the script is the same in all analyses, and no result.
    if let Some(o) = outcomes.iter().find(|o| o.failure.starts_with("the script was rejected")) {
        return Err(o.failure.clone());
    }
    let results = summary(&study, &outcomes);
    let json = report::json(&study, &outcomes, &results);
    let checks = check_table(&results.checks);
    for (name, text) in [
        ("schedule.csv", results.schedule.csv()),
        ("structure.csv", results.structure.csv()),
        ("checks.csv", checks.csv()),
        ("isolation.json", json.clone()),
        ("report.html", report::html(&study, &outcomes, &results)),
    ] {
        write_atomically(&a.out.join(name), &text)?;
    }
    let failed = outcomes.iter().filter(|o| !o.failure.is_empty()).count();
    for o in outcomes.iter().filter(|o| !o.failure.is_empty()).take(3) {
        eprintln!("warning: {} bound, {}: {}", o.bound, o.motion, o.failure);
    }
    let missed = results.checks.iter().filter(|c| c.status == Status::NotMet).count();
    let text = format!(
        "{}\n{}\n{}\n{missed} of {} checks are not met; {}\n",
        results.structure.text(),
        results.schedule.text(),
        checks.text(),
        results.checks.len(),
        study.code.remark()
    );
    Ok((if a.json { json } else { text }, if failed > 0 { FAILURE } else { 0 }))
}

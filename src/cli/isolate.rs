//! `hysteron isolate`: an isolation study.

use super::args::CheckArgs;
use super::calibrate::FAILURE;
use super::files::{make_folder, write_atomically};
use super::script_check::MessageTable;
use super::signals::on_interrupt;
use super::study_jobs::{Outcome, Refusal, StudyJobs, StudyJobsArgs, finish, load_agreed};
use clap::Args;
use hysteron::design::check::check_table;
use hysteron::design::isolate::{self, Job, JobOutcome, Properties, Study, script_text};
use hysteron::design::review;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

#[derive(Args, Debug)]
pub(super) struct IsolateArgs {
    #[command(flatten)]
    jobs: StudyJobsArgs,
    /// Show the difference of two results instead. The study is the folder or the isolation.json of the first, and this that of the second
    #[arg(long, value_name = "DIR")]
    compare: Option<PathBuf>,
    /// Run draws of the properties of a type of bearing instead of bounds: its name, and the posterior.json of prototype. Of the
    /// calibration.json of calibrate --posterior, formulas of its parameters give Q_d and K_d, as in
    /// "LRB=calibration.json;q_d=Fy*(1-b);k_d=b*k". Given once for each type
    #[arg(long, value_name = "NAME=FILE", conflicts_with = "compare")]
    posterior: Vec<String>,
    /// Draws of --posterior; the motions are taken in turn
    #[arg(long, value_name = "N", default_value_t = 40, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    draws: u32,
    /// Where the results go
    #[arg(long, value_name = "DIR", default_value = "isolation")]
    out: PathBuf,
    /// Write a script for each analysis into this folder too, which runs it in OpenSees itself
    #[arg(long, value_name = "DIR")]
    scripts: Option<PathBuf>,
}

/// Run the command; the exit status.
pub(super) fn isolate(a: &IsolateArgs) -> i32 {
    let stop = a.jobs.stop_flag();
    let result = match &a.compare {
        Some(second) => compared(&a.jobs.study, second, a.jobs.json),
        None => study(a, &stop),
    };
    finish(result, &stop)
}

/// The difference of two results.
fn compared(first: &Path, second: &Path, as_json: bool) -> Outcome {
    let read = |path: &Path| -> Result<serde_json::Value, String> {
        let file = if path.is_dir() { path.join("isolation.json") } else { path.to_owned() };
        let text = hysteron_files::read_text(&file).map_err(|e| format!("cannot read \"{}\": {e}", file.display()))?;
        serde_json::from_str(&text).map_err(|e| format!("\"{}\": {e}", file.display()))
    };
    let found = review::compare(&read(first)?, &read(second)?)?;
    if as_json {
        return Ok((found.table.json(), 0));
    }
    let differences = found.table.rows.len();
    Ok((format!("{}\n{differences} values differ, {} are the same\n", found.table.text(), found.same), 0))
}

/// Check an isolation study: its keys, and its values beside those of the script; the exit status.
pub(super) fn check(args: &CheckArgs) -> i32 {
    let stop = Arc::new(AtomicBool::new(false));
    on_interrupt(&stop);
    args.limits.enforce(&stop);
    let checked = load_agreed(Path::new(&args.model), &stop);
    if let (Err(Refusal::Mistake(d, sources)), true) = (&checked, args.json) {
        let messages = [MessageTable::new(d, sources)];
        println!("{}", serde_json::json!({ "study": args.model, "messages": messages }));
    }
    let result = checked.map(|(study, _)| {
        let table = study.agreement.table();
        if args.json {
            return (format!("{}\n", table.json()), 0);
        }
        let jobs = isolate::jobs(&study).len();
        (format!("{}\n{}: {jobs} analyses\n", table.text(), args.model), 0)
    });
    finish(result, &stop)
}

/// The outcome of an analysis of a suite, unless it is no result of its motion.
fn believed(study: &Study, job: &Job, outcome: JobOutcome) -> Result<JobOutcome, String> {
    let doubt = isolate::runaway(study, &outcome).or_else(|| isolate::cut_short(study, job, &outcome));
    doubt.map_or(Ok(outcome), Err)
}

/// Type of bearing and properties of `NAME=FILE`, or of `NAME=FILE;q_d=FORMULA;k_d=FORMULA`.
fn properties(text: &str) -> Result<(String, Properties), String> {
    let wrong = || format!("--posterior {text}: expected NAME=FILE, or NAME=FILE;q_d=FORMULA;k_d=FORMULA");
    let mut parts = text.split(';');
    let (name, file) = parts.next().and_then(|first| first.split_once('=')).ok_or_else(wrong)?;
    let entry = |part: &str| {
        let (key, formula) = part.split_once('=').ok_or_else(wrong)?;
        Ok((key.trim().to_owned(), formula.trim().to_owned()))
    };
    let formulas = parts.map(entry).collect::<Result<BTreeMap<_, _>, String>>()?;
    let json = hysteron_files::read_text(file).map_err(|e| format!("cannot read \"{file}\": {e}"))?;
    let properties = Properties::parse(&json, &formulas).map_err(|e| format!("\"{file}\": {e}"))?;
    Ok((name.to_owned(), properties))
}

/// Write a script for each analysis where they are asked for.
fn write_scripts(a: &IsolateArgs, study: &Study, all: &[Job]) -> Result<(), String> {
    let Some(folder) = &a.scripts else { return Ok(()) };
    make_folder(folder)?;
    let write = |job: &Job| write_atomically(&folder.join(format!("{}.tcl", job.name())), &script_text(study, job));
    all.iter().try_for_each(write)
}

/// Analyses of draws of the properties.
fn drawn(a: &IsolateArgs, study: &mut Study, stop: &Arc<AtomicBool>) -> Outcome {
    let properties = a.posterior.iter().map(|text| properties(text)).collect::<Result<Vec<_>, _>>()?;
    study.draw(&properties, a.draws as usize)?;
    let jobs = StudyJobs::new(&a.jobs, study, &a.out, stop)?;
    let all = isolate::draw_jobs(study);
    write_scripts(a, study, &all)?;
    let outcomes = jobs.all(&all, all.len(), |job| believed(study, job, jobs.one(job)?))?;
    let [percentiles, draws] = review::draw_tables(study, &outcomes);
    write_atomically(&a.out.join("percentiles.csv"), &percentiles.csv())?;
    write_atomically(&a.out.join("draws.csv"), &draws.csv())?;
    let failed = outcomes.iter().filter(|o| !o.failure.is_empty()).count();
    let status = if failed > 0 { FAILURE } else { 0 };
    if a.jobs.json {
        return Ok((percentiles.json(), status));
    }
    Ok((format!("{}\n{} draws, {failed} without convergence\n", percentiles.text(), outcomes.len()), status))
}

fn study(a: &IsolateArgs, stop: &Arc<AtomicBool>) -> Outcome {
    let (mut study, periods) = load_agreed(&a.jobs.study, stop)?;
    if !a.posterior.is_empty() {
        return drawn(a, &mut study, stop);
    }
    let jobs = StudyJobs::new(&a.jobs, &study, &a.out, stop)?;
    let all = isolate::jobs(&study);
    write_scripts(a, &study, &all)?;
    let outcomes = jobs.all(&all, all.len(), |job| believed(&study, job, jobs.one(job)?))?;
    let results = review::review(&study, &outcomes, periods);
    for (name, text) in review::files(&study, &outcomes, &results) {
        write_atomically(&a.out.join(name), &text)?;
    }
    let failed = outcomes.iter().filter(|o| !o.failure.is_empty()).count();
    for o in outcomes.iter().filter(|o| !o.failure.is_empty()).take(3) {
        eprintln!("warning: {} bound, {}: {}", o.bound, o.motion, o.failure);
    }
    let status = if failed > 0 { FAILURE } else { 0 };
    if a.jobs.json {
        return Ok((review::json(&study, &outcomes, &results), status));
    }
    let tables = [
        study.agreement.table(),
        results.procedure(&study),
        results.structure(&study, &outcomes),
        results.schedule(&study),
        results.design_values(),
        check_table(&results.checks),
    ];
    let mut text: String = tables.iter().map(|t| t.text() + "\n").collect();
    let _ = writeln!(text, "{}; {}", results.verdict(), study.code.remark());
    for (heading, part) in results.summary(&study, &outcomes) {
        let _ = writeln!(text, "  {heading:<21}{part}");
    }
    let _ = writeln!(text, "  {:<21}{}", "report", a.out.join("report.html").display());
    Ok((text, status))
}

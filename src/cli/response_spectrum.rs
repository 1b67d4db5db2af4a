//! `hysteron response-spectrum`: the multimode method beside the time histories of an isolation study.

use super::files::{make_folder, write_atomically};
use super::study_jobs::{Outcome, StudyJobs, StudyJobsArgs, finish, load};
use clap::Args;
use hysteron::design::isolate;
use hysteron::design::multimode::{report, respond_at_bounds};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

#[derive(Args, Debug)]
pub(super) struct ResponseSpectrumArgs {
    #[command(flatten)]
    jobs: StudyJobsArgs,
    /// Modes, at most
    #[arg(long, value_name = "N", default_value_t = 12, value_parser = clap::value_parser!(u32).range(1..=1000))]
    modes: u32,
    /// Run the time histories without eccentricity too, for a comparison. With --resume and the --out of isolate they are there already
    #[arg(long)]
    history: bool,
    /// Where the results go
    #[arg(long, value_name = "DIR", default_value = "response_spectrum")]
    out: PathBuf,
}

/// Run the command; the exit status.
pub(super) fn response_spectrum(a: &ResponseSpectrumArgs) -> i32 {
    let stop = a.jobs.stop_flag();
    finish(multimode(a, &stop), &stop)
}

fn multimode(a: &ResponseSpectrumArgs, stop: &Arc<AtomicBool>) -> Outcome {
    let study = load(&a.jobs.study, stop)?;
    let responses = respond_at_bounds(&study, a.modes as usize)?;
    let mut outcomes = vec![];
    if a.history {
        let jobs = StudyJobs::new(&a.jobs, &study, &a.out, stop)?;
        let all: Vec<_> = isolate::jobs(&study).into_iter().filter(|j| j.eccentricity == 0).collect();
        outcomes = jobs.all(&all, all.len(), |job| jobs.one(job))?;
    }
    make_folder(&a.out)?;
    let table = report::response_table(&study, &responses, &outcomes);
    let (bearings, modes) = (report::bearing_table(&study, &responses), report::mode_table(&responses));
    let json = report::json(&study, &responses, &outcomes);
    for (name, text) in [
        ("responses.csv", table.csv()),
        ("bearings.csv", bearings.csv()),
        ("modes.csv", modes.csv()),
        ("response_spectrum.json", json.clone()),
        ("report.html", report::html(&study, &responses, &outcomes)),
    ] {
        write_atomically(&a.out.join(name), &text)?;
    }
    if a.jobs.json {
        return Ok((json, 0));
    }
    let remarks = report::remarks(&study, &responses).join("\n");
    Ok((format!("{}\n{}\n{remarks}\n", table.text(), bearings.text()), 0))
}

//! `hysteron check` of a study.

use super::args::Compat;
use super::calibrate::{INPUT_ERROR, PreparedStudy, prepare, print_diagnostic};
use super::script_check::MessageTable;
use super::signals::{INTERRUPTED, on_interrupt};
use hysteron::diagnostic::{Severity, SourceMap};
use hysteron::study::{InitialRun, Role, ScriptSimulator, Study, simulate_and_score};
use serde::Serialize;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Result of the check of a study.
#[derive(Serialize)]
struct CheckTable<'a> {
    study: String,
    title: &'a str,
    /// Number of free parameters, and of all.
    free: usize,
    parameters: usize,
    /// The error of the script with its own values, if it has no answer.
    #[serde(skip_serializing_if = "Option::is_none")]
    failure: Option<String>,
    runs: Vec<RunTable<'a>>,
    messages: Vec<MessageTable<'a>>,
}

/// A run with the script's own values.
#[derive(Serialize)]
struct RunTable<'a> {
    name: &'a str,
    role: &'static str,
    nmse: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    failure: Option<String>,
    channels: Vec<ChannelTable<'a>>,
}

#[derive(Serialize)]
struct ChannelTable<'a> {
    channel: &'a str,
    nmse: f64,
    samples: usize,
    missing: usize,
    dropped: usize,
}

/// Do all checks that come before a calibration, with a run of the script with its own values. Returns the exit status.
pub(super) fn check(file: &Path, compat: Option<Compat>, strict: bool, json: bool) -> i32 {
    let stop = Arc::new(AtomicBool::new(false));
    on_interrupt(&stop);
    let mut sources = SourceMap::default();
    let prepared = prepare(file, compat, &stop, &mut sources);
    let PreparedStudy { mut simulator, initial_run, .. } = match prepared {
        Ok(prepared) => prepared,
        Err(d) => {
            print_diagnostic(&d, &sources);
            if json {
                print_json(&serde_json::json!({ "study": file, "messages": [MessageTable::new(&d, &sources)] }));
            }
            return if stop.load(Ordering::Relaxed) { INTERRUPTED } else { INPUT_ERROR };
        }
    };
    let study = simulator.study().clone();
    let warnings = study.warnings.iter().chain(&initial_run.warnings).filter(|w| w.severity != Severity::Note);
    let warnings: Vec<_> = warnings.inspect(|w| print_diagnostic(w, &sources)).collect();
    let table = CheckTable {
        study: file.display().to_string(),
        title: &study.title,
        free: study.space.dimension(),
        parameters: initial_run.values.len(),
        failure: initial_run.failure.as_ref().map(ToString::to_string),
        runs: run_tables(&mut simulator, &study, &initial_run),
        messages: warnings.iter().map(|w| MessageTable::new(w, &sources)).collect(),
    };
    if json {
        print_json(&table)
    } else {
        print_text(&table)
    }
    match warnings.len() {
        _ if stop.load(Ordering::Relaxed) => INTERRUPTED,
        1.. if strict => INPUT_ERROR,
        _ => 0,
    }
}

/// All runs with the script's own values within the ranges, and with fixed and tied parameters as in the study.
fn run_tables<'a>(simulator: &mut ScriptSimulator, study: &'a Study, initial_run: &InitialRun) -> Vec<RunTable<'a>> {
    let Ok(values) = study.space.values_at(&study.space.unit_point(&initial_run.values)) else { return vec![] };
    let mut tables = vec![];
    for (number, run) in study.runs.iter().enumerate() {
        let role = if run.role == Role::Fit { "fit" } else { "holdout" };
        let mut table = RunTable { name: &run.name, role, nmse: None, failure: None, channels: vec![] };
        match simulate_and_score(simulator, study, number, &values) {
            Ok(scored) => {
                table.nmse = Some(scored.nmse(&run.observe));
                table.channels.extend(run.observe.iter().zip(&scored.scores).map(|(o, s)| ChannelTable {
                    channel: &o.channel,
                    nmse: s.nmse,
                    samples: s.samples,
                    missing: o.values.iter().filter(|x| x.is_nan()).count(),
                    dropped: s.dropped,
                }));
            }
            Err(error) => table.failure = Some(error.to_string()),
        }
        tables.push(table);
    }
    tables
}

fn print_json(table: &impl Serialize) {
    println!("{}", serde_json::to_string_pretty(table).unwrap_or_default());
}

fn print_text(table: &CheckTable<'_>) {
    println!("{}: {} of {} parameters to be found", table.study, table.free, table.parameters);
    if let Some(error) = &table.failure {
        println!("  with its own values the script has no answer: {error}");
    }
    for run in &table.runs {
        match (&run.failure, run.nmse) {
            (Some(error), _) => println!("  {} {}: {error}", run.role, run.name),
            (None, nmse) => {
                let nmse = nmse.unwrap_or(f64::NAN);
                println!("  {} {}: NMSE {nmse:.6} with the script's own values", run.role, run.name);
            }
        }
        for c in &run.channels {
            println!(
                "    {}: {} samples compared, {} missing, {} after the analysis",
                c.channel, c.samples, c.missing, c.dropped
            );
        }
    }
}

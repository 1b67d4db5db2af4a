//! `hysteron check` of a study.

use super::args::CheckArgs;
use super::calibrate::{FAILURE, INPUT_ERROR, PreparedStudy, prepare, print_diagnostic};
use super::pace::tell_diagnosis;
use super::preflight::{check_channels, threads};
use super::script_check::MessageTable;
use super::signals::{INTERRUPTED, on_interrupt, stopped_status};
use hysteron::diagnostic::{Severity, SourceMap};
use hysteron::preflight::{Preflight, section};
use serde::Serialize;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

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
    preflight: &'a Preflight,
    messages: Vec<MessageTable<'a>>,
}

/// Do all checks that come before a calibration, with a run of the script with its own values. Returns the exit status.
pub(super) fn check(args: &CheckArgs) -> i32 {
    let (file, compat, strict, json) = (Path::new(&args.model), args.script.compat, args.script.strict, args.json);
    let stop = Arc::new(AtomicBool::new(false));
    on_interrupt(&stop);
    args.limits.enforce(&stop);
    let mut sources = SourceMap::default();
    let prepared = prepare(file, compat, &stop, &mut sources);
    let PreparedStudy { simulator, initial_run, .. } = match prepared {
        Ok(prepared) if prepared.initial_run.is_interrupted() => {
            return stopped_status(&stop).unwrap_or(INTERRUPTED);
        }
        Ok(prepared) => prepared,
        Err(d) => {
            print_diagnostic(&d, &sources);
            if json {
                print_json(&serde_json::json!({ "study": file, "messages": [MessageTable::new(&d, &sources)] }));
            }
            return INPUT_ERROR;
        }
    };
    let study = simulator.study().clone();
    let warnings = study.warnings.iter().chain(&initial_run.warnings).filter(|w| w.severity != Severity::Note);
    let warnings: Vec<_> = warnings.inspect(|w| print_diagnostic(w, &sources)).collect();
    // Notes about the study itself; those of the script belong to its run.
    study.warnings.iter().filter(|w| w.severity == Severity::Note).for_each(|n| print_diagnostic(n, &sources));
    let checked = match check_channels(&simulator, &initial_run, threads(None), true, &sources) {
        Ok(checked) => checked,
        Err(e) => {
            eprintln!("error: {e}");
            return FAILURE;
        }
    };
    tell_diagnosis(&study, &initial_run, threads(None));
    let table = CheckTable {
        study: file.display().to_string(),
        title: &study.title,
        free: study.space.dimension(),
        parameters: initial_run.values.len(),
        failure: initial_run.failure.as_ref().map(ToString::to_string),
        preflight: &checked,
        messages: warnings.iter().map(|w| MessageTable::new(w, &sources)).collect(),
    };
    if json {
        print_json(&table);
    } else {
        println!(
            "{}: {} of {} parameters to be found; with the script's own values:",
            table.study, table.free, table.parameters
        );
        print!("{}", section(&checked, &study));
    }
    if let Some(status) = stopped_status(&stop) {
        return status;
    }
    let is_refused = strict && !(warnings.is_empty() && checked.findings.is_empty());
    if checked.has_hard_findings() || is_refused { INPUT_ERROR } else { 0 }
}

fn print_json(table: &impl Serialize) {
    println!("{}", serde_json::to_string_pretty(table).unwrap_or_default());
}

//! `hysteron check` of a plan: its files, and its scripts with the values of the first case of each.

use super::warnings;
use crate::cli::args::{CheckArgs, StepArgs};
use crate::cli::calibrate::INPUT_ERROR;
use crate::cli::progress::ProgressLine;
use crate::cli::run::{execute, settings, status};
use crate::cli::script_check::{MessageTable, print_summary};
use hysteron::design::batch::{Case, Plan, load, prepare, undeclared};
use hysteron::diagnostic::Severity;
use hysteron::opensees::{Mode, NoFiles};
use hysteron::run::{End, Run};
use hysteron::tcl::{OsFiles, OverlayFiles, Silent};
use std::collections::BTreeSet;
use std::path::Path;

/// Check a plan; the exit status.
pub(in crate::cli) fn check(args: &CheckArgs) -> i32 {
    let plan = match load(Path::new(&args.model)) {
        Ok(plan) => plan,
        Err(message) => {
            eprintln!("error: {message}");
            return INPUT_ERROR;
        }
    };
    let warnings = warnings(&plan);
    warnings.iter().for_each(|note| eprintln!("warning: {note}"));
    let mut scripts = BTreeSet::new();
    let first_of_each: Vec<&Case> = plan.cases.iter().filter(|case| scripts.insert(&case.script)).collect();
    let mut messages = vec![];
    let checked = first_of_each.iter().map(|case| check_script(args, &plan, case, &mut messages));
    let worst = checked.max().unwrap_or(0);
    let is_refused = args.script.strict && !warnings.is_empty();
    if args.json {
        let (plan_file, cases) = (&args.model, plan.cases.len());
        println!(
            "{}",
            serde_json::json!({ "plan": plan_file, "cases": cases, "warnings": warnings, "messages": messages })
        );
    } else if worst == 0 {
        let (cases, scripts) = (plan.cases.len(), scripts.len());
        let of = if scripts == 1 { "1 script".to_owned() } else { format!("{scripts} scripts") };
        println!("{}: {cases} cases of {of}, the first of each without a mistake", args.model);
    }
    if is_refused { worst.max(INPUT_ERROR) } else { worst }
}

/// Check the script of a case with its values, and print its messages; the exit status.
fn check_script(args: &CheckArgs, plan: &Plan, case: &Case, messages: &mut Vec<serde_json::Value>) -> i32 {
    let script = case.script.to_string_lossy();
    let settings = settings(&args.script, &StepArgs::default(), Mode::Check);
    let files = OverlayFiles::new(Box::new(OsFiles));
    let mut run = Run::new(settings, Box::new(Silent), Box::new(files), Box::new(NoFiles));
    if let Err(message) = prepare(plan, case, &mut run) {
        eprintln!("error: {message}");
        return INPUT_ERROR;
    }
    let end = execute(&mut run, &ProgressLine::new(), &args.limits, &script, &[]);
    print_summary(&run.interp);
    let last = match &end {
        End::Rejected(d) | End::Raised(d) => Some(&**d),
        _ => None,
    };
    let all = run.interp.warnings.iter().chain(last);
    messages.extend(all.filter_map(|d| serde_json::to_value(MessageTable::new(d, &run.interp.sources)).ok()));
    let is_rejected = run.interp.warnings.iter().any(|w| w.severity == Severity::Error);
    // Parameters are declared before the results of an analysis are needed, at which a check ends.
    let missing = undeclared(plan, &run).filter(|_| !is_rejected && status(&end) == 0);
    if let Some(missing) = &missing {
        eprintln!("error: \"{script}\": {missing}");
        messages.push(serde_json::json!({ "severity": "error", "message": missing, "file": script }));
    }
    if is_rejected || missing.is_some() { INPUT_ERROR } else { status(&end) }
}

//! `hysteron check` of a study.

use super::args::Compat;
use super::calibrate::{INPUT_ERROR, PreparedStudy, prepare, print_diagnostic};
use hysteron::diagnostic::{Severity, SourceMap};
use hysteron::preflight::{preflight, section};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Do all checks that come before a calibration, with a run of the script with its own values. Returns the exit status.
pub(super) fn check(file: &Path, compat: Option<Compat>, strict: bool) -> i32 {
    let stop = Arc::new(AtomicBool::new(false));
    super::run::on_interrupt(&stop);
    let mut sources = SourceMap::default();
    let prepared = prepare(file, compat, &stop, &mut sources);
    let PreparedStudy { simulator, initial_run, .. } = match prepared {
        Ok(prepared) => prepared,
        Err(d) => {
            print_diagnostic(&d, &sources);
            return INPUT_ERROR;
        }
    };
    let study = simulator.study().clone();
    let warnings = study.warnings.iter().chain(&initial_run.warnings).filter(|w| w.severity != Severity::Note);
    let warning_count = warnings.inspect(|w| print_diagnostic(w, &sources)).count();
    eprintln!("{}: {} of {} parameters to be found", file.display(), study.space.dimension(), initial_run.values.len());
    if let Some(error) = &initial_run.failure {
        eprintln!("  with its own values the script has no answer: {error}");
    }
    match preflight(&simulator, &initial_run, threads()) {
        Ok(result) => {
            println!("{}", section(&result, &study));
            for f in &result.findings {
                println!("{}: {}\n  {}", if f.is_hard { "error" } else { "warning" }, f.message, f.help);
            }
        }
        Err(e) => eprintln!("error: {e}"),
    }
    if strict && warning_count > 0 { INPUT_ERROR } else { 0 }
}

fn threads() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

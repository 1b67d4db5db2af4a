//! `hysteron check` of a study.

use super::args::Compat;
use super::calibrate::{FAILURE, INPUT_ERROR, PreparedStudy, prepare, print_diagnostic};
use super::preflight::{check_channels, threads};
use hysteron::diagnostic::{Severity, SourceMap};
use hysteron::preflight::section;
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
    let checked = match check_channels(&simulator, &initial_run, threads(None), true) {
        Ok(checked) => checked,
        Err(e) => {
            eprintln!("error: {e}");
            return FAILURE;
        }
    };
    print!("{}", section(&checked, &study));
    if checked.has_hard_findings() || strict && (warning_count > 0 || !checked.findings.is_empty()) {
        return INPUT_ERROR;
    }
    0
}

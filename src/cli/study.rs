//! `hysteron check` of a study.

use super::args::Compat;
use super::calibrate::{INPUT_ERROR, PreparedStudy, prepare, print_diagnostic};
use hysteron::diagnostic::{Severity, SourceMap};
use hysteron::study::{Role, Run, simulate_and_score};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Do all checks that come before a calibration, with a run of the script with its own values. Returns the exit status.
pub(super) fn check(file: &Path, compat: Option<Compat>, strict: bool) -> i32 {
    let stop = Arc::new(AtomicBool::new(false));
    super::run::on_interrupt(&stop);
    let mut sources = SourceMap::default();
    let prepared = prepare(file, compat, &stop, &mut sources);
    let PreparedStudy { mut simulator, initial_run, .. } = match prepared {
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
    // The script's own values within the ranges, with fixed and tied parameters as in the study.
    if let Ok(values) = study.space.values_at(&study.space.unit_point(&initial_run.values)) {
        for (number, run) in study.runs.iter().enumerate() {
            match simulate_and_score(&mut simulator, &study, number, &values) {
                Ok(scored) => {
                    eprintln!("  {}: NMSE {:.6} with the script's own values", name(run), scored.nmse(&run.observe));
                    for (o, s) in run.observe.iter().zip(&scored.scores) {
                        let missing = o.values.iter().filter(|x| x.is_nan()).count();
                        let (samples, dropped) = (s.samples, s.dropped);
                        eprintln!(
                            "    {}: {samples} samples compared, {missing} missing, {dropped} after the analysis",
                            o.channel
                        );
                    }
                }
                Err(error) => eprintln!("  {}: {error}", name(run)),
            }
        }
    }
    if strict && warning_count > 0 { INPUT_ERROR } else { 0 }
}

fn name(run: &Run) -> String {
    format!("{} {}", if run.role == Role::Fit { "fit" } else { "holdout" }, run.name)
}

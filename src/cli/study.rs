//! `hysteron check` of a study.

use super::args::Compat;
use super::calibrate::{Prepared, WRONG, prepare, show};
use hysteron::diagnostic::{Severity, SourceMap};
use hysteron::study::{Role, Run, fit};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Everything that is looked at before a calibration begins, a run of the script with its own values included; the exit
/// status.
pub(super) fn check(file: &Path, compat: Option<Compat>, strict: bool) -> i32 {
    let stop = Arc::new(AtomicBool::new(false));
    super::run::on_interrupt(&stop);
    let mut sources = SourceMap::default();
    let prepared = prepare(file, compat, &stop, &mut sources);
    let Prepared { mut simulator, opening, .. } = match prepared {
        Ok(prepared) => prepared,
        Err(d) => {
            show(&d, &sources);
            return WRONG;
        }
    };
    let study = simulator.study().clone();
    let warnings = study.warnings.iter().chain(&opening.warnings).filter(|w| w.severity != Severity::Note);
    let told = warnings.inspect(|w| show(w, &sources)).count();
    eprintln!("{}: {} of {} parameters to be found", file.display(), study.space.dimension(), opening.values.len());
    if let Some(why) = &opening.failure {
        eprintln!("  with its own values the script has no answer: {why}");
    }
    // Its own values, as far as the study leaves them alone.
    if let Ok(values) = study.space.values(&study.space.point(&opening.values)) {
        for (number, run) in study.runs.iter().enumerate() {
            match fit(&mut simulator, &study, number, &values) {
                Ok(fit) => {
                    eprintln!("  {}: NMSE {:.6} with the script's own values", name(run), fit.nmse(&run.observe));
                    for (o, s) in run.observe.iter().zip(&fit.scores) {
                        let missing = o.values.iter().filter(|x| x.is_nan()).count();
                        let (samples, dropped) = (s.samples, s.dropped);
                        eprintln!(
                            "    {}: {samples} samples compared, {missing} missing, {dropped} after the analysis",
                            o.channel
                        );
                    }
                }
                Err(why) => eprintln!("  {}: {why}", name(run)),
            }
        }
    }
    if strict && told > 0 { WRONG } else { 0 }
}

fn name(run: &Run) -> String {
    format!("{} {}", if run.role == Role::Fit { "fit" } else { "holdout" }, run.name)
}

//! `hysteron check` of a study, and `hysteron init`.

use super::args::Compat;
use super::calibrate::{INPUT_ERROR, PreparedStudy, prepare, print_diagnostic};
use super::files::write_atomically;
use clap::Args;
use hysteron::diagnostic::{Severity, SourceMap};
use hysteron::study::{Role, Run, draft_study, simulate_and_score};
use std::path::{Path, PathBuf};
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
    // Notes about the study itself; those of the script belong to its run.
    study.warnings.iter().filter(|w| w.severity == Severity::Note).for_each(|n| print_diagnostic(n, &sources));
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

/// Name of the study beside the script.
const STUDY: &str = "study.toml";

#[derive(Args, Debug)]
pub(super) struct InitArgs {
    /// The script
    model: PathBuf,
    /// Recordings, each of one run
    #[arg(required = true)]
    recordings: Vec<PathBuf>,
    /// File of the study; study.toml beside the script if it is not given
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

/// Write a first study of a script and recordings; the exit status.
pub(super) fn init(args: &InitArgs) -> i32 {
    let beside = |p: &Path| p.parent().filter(|f| !f.as_os_str().is_empty()).map_or(PathBuf::from("."), Path::to_owned);
    let out = args.out.clone().unwrap_or_else(|| args.model.with_file_name(STUDY));
    if out.exists() {
        eprintln!("error: {} exists already; give another file with --out", out.display());
        return INPUT_ERROR;
    }
    let stop = Arc::new(AtomicBool::new(false));
    super::run::on_interrupt(&stop);
    let mut sources = SourceMap::default();
    let text = match draft_study(&args.model, &args.recordings, &beside(&out), &stop, &mut sources) {
        Ok(text) => text,
        Err(d) => {
            print_diagnostic(&d, &sources);
            return INPUT_ERROR;
        }
    };
    if let Err(message) = write_atomically(&out, &text) {
        eprintln!("error: {message}");
        return 1;
    }
    eprintln!("written to {0}\nread its comments, then: hysteron check {0}", out.display());
    0
}

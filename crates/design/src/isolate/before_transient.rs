//! Runs of a script up to its first transient analysis.

use super::capture::{Captured, StudyOutputs};
use super::job::{Failure, Job, StopWatch, set_values};
use super::study::Study;
use hysteron_engine::analysis::Options;
use hysteron_opensees::run::{End, Run, Settings};
use hysteron_opensees::{Mode, Tcl};
use hysteron_tcl::{Exception, OsFiles, OverlayFiles, Silent};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Run the script of a study at a bound and an eccentricity up to its first transient analysis. `stop` interrupts it.
///
/// # Errors
/// It fails before, has no transient analysis, or is interrupted.
pub(crate) fn run_to_transient(
    study: &Study,
    bound: &'static str,
    eccentricity: usize,
    stop: &Arc<AtomicBool>,
) -> Result<Run, String> {
    let job = Job { bound, motion: 0, eccentricity, level: 1.0, draw: None };
    run_job_to_transient(study, &job, stop)
}

/// Run the script with the values of an analysis up to its first transient analysis.
///
/// # Errors
/// The errors of [`run_to_transient`].
pub(super) fn run_job_to_transient(study: &Study, job: &Job, stop: &Arc<AtomicBool>) -> Result<Run, String> {
    run_prepared(&study.script, |interp| set_values(interp, study, job), stop)
}

/// Run a script with its own values up to its first transient analysis.
///
/// # Errors
/// The errors of [`run_to_transient`].
pub(super) fn run_alone(script: &Path, stop: &Arc<AtomicBool>) -> Result<Run, String> {
    run_prepared(script, |_| Ok(()), stop)
}

fn run_prepared(
    script: &Path,
    prepare: impl FnOnce(&mut Tcl) -> Result<(), String>,
    stop: &Arc<AtomicBool>,
) -> Result<Run, String> {
    let settings = Settings { mode: Mode::Run, strict: false, options: Options::default() };
    let files = OverlayFiles::new(Box::new(OsFiles));
    let mut run = Run::new(settings, Box::new(Silent), Box::new(files), Box::new(StudyOutputs(Captured::default())));
    let interrupt = run.interp.interrupt.clone();
    run.interp.host.set_progress(Box::new(StopWatch { interrupt, stop: stop.clone(), time: Arc::default() }));
    run.interp.host.before_transient(Box::new(|_| Err(Exception::Exit(0))));
    prepare(&mut run.interp)?;
    let end = run.script(&script.to_string_lossy(), &[]);
    match end {
        End::Exit(0) => Ok(run),
        End::Done => Err("the script has no transient analysis".into()),
        _ => Err(Failure::of(&end, &run).text),
    }
}

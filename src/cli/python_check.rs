//! `hysteron check` of a file of Python: its calls of OpenSees whose arguments are literal.

use super::args::{CheckArgs, StepArgs};
use super::calibrate::INPUT_ERROR;
use super::messages::Messages;
use super::run::{MAX_SHOWN, print, settings};
use super::script_check::{self, print_summary};
use super::signals::{on_interrupt, stopped_status};
use hysteron::calls;
use hysteron::diagnostic::Severity;
use hysteron::opensees::Mode;
use hysteron::tcl::{OsFiles, OverlayFiles};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Check the calls of a file; the exit status, or `None` for a file that has none.
pub(super) fn check(args: &CheckArgs) -> Option<i32> {
    let text = hysteron_files::read_lossy(Path::new(&args.model)).ok()?;
    let stop = Arc::new(AtomicBool::new(false));
    on_interrupt(&stop);
    args.limits.enforce(&stop);
    let run = settings(&args.script, &StepArgs::default(), Mode::Check);
    let files = Box::new(OverlayFiles::new(Box::new(OsFiles)));
    let checked = calls::check(&args.model, &text, calls::Settings { run, files, stop: stop.clone(), index: false })?;
    if let Some(status) = stopped_status(&stop) {
        eprintln!("note: the check was stopped");
        return Some(status);
    }
    let interp = &checked.run.interp;
    for d in interp.warnings.iter().take(MAX_SHOWN) {
        eprintln!("{}\n", Messages::new().render(d, &interp.sources));
    }
    if !checked.is_complete {
        eprintln!(
            "note: some calls are not literal, or in loops, branches or functions: behind the first of them, \
             what depends on the model was not checked"
        );
    }
    print_summary(interp);
    let is_rejected = interp.warnings.iter().any(|w| w.severity == Severity::Error);
    let status = if is_rejected { INPUT_ERROR } else { 0 };
    if args.json {
        return Some(print(Ok(script_check::json(&args.model, interp, None))).max(status));
    }
    if status == 0 {
        return Some(print(Ok(format!("{}: {}\n", args.model, script_check::found(interp)))));
    }
    Some(status)
}

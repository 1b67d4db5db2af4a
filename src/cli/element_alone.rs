//! A bearing taken out of the script of a whole model, for a test of its own.

use super::run;
use hysteron::analysis::Options;
use hysteron::opensees::alone::element_alone;
use hysteron::opensees::{Mode, NoFiles};
use hysteron::run::{End, Run, Settings};
use hysteron::tcl::{OsFiles, OverlayFiles, Silent};

/// The script that makes an element of another script alone. That one is checked, and none of its analyses runs.
///
/// # Errors
/// The script ends with a mistake, or the element is not one that two nodes move.
pub(super) fn script_of(file: &str, tag: i32) -> Result<String, String> {
    let settings = Settings { mode: Mode::Check, strict: false, options: Options::default() };
    let files = OverlayFiles::new(Box::new(OsFiles));
    let mut run = Run::new(settings, Box::new(Silent), Box::new(files), Box::new(NoFiles));
    let index = run.interp.host.index.insert(Box::default());
    index.keeps_definitions = true;
    let end = run.script(file, &[]);
    if matches!(end, End::Rejected(_) | End::Raised(_) | End::Interrupted) {
        run::print_end(&end, &run.interp);
        return Err(format!("element {tag} is not taken out of \"{file}\", which ends with a mistake"));
    }
    let index = run.interp.host.index.take().unwrap_or_default();
    element_alone(&index, tag).map_err(|e| format!("\"{file}\": {e}"))
}

//! The file of a recorder: its folder is there, and no other recorder writes it.

use super::recorder_options::words;
use crate::checks;
use crate::host::Mode;
use crate::{Tcl, warn};
use hysteron_tcl::diagnostic::{Diagnostic, Severity, Span};
use hysteron_tcl::{Call, Exception, FileKind};

/// See to it that a recorder can write a file: its folder is there, and no other recorder writes it.
///
/// # Errors
/// It is a folder, or another recorder's.
pub(super) fn make_room(
    interp: &mut Tcl,
    call: &Call<'_>,
    (name, path): (&str, &str),
    span: Option<Span>,
) -> Result<(), Exception> {
    if interp.files.info(path, true).is_ok_and(|i| i.kind == FileKind::Directory) {
        let d = Diagnostic::error(format!("cannot write {path}: it is a folder"));
        return Err(Exception::diagnosed(d.at(span, "cannot write here")));
    }
    make_missing_folder(interp, name, path, span)?;
    replace_recorder(interp, call, name, span)
}

/// Finish a recorder that writes the same file, with a warning: its rows are lost. OpenSees lets both write, and mixes
/// their rows.
///
/// # Errors
/// The two are different recorders. OpenSees' answer is wanted: then it is a warning.
fn replace_recorder(interp: &mut Tcl, call: &Call<'_>, name: &str, span: Option<Span>) -> Result<(), Exception> {
    let path = interp.absolute(name);
    let Some(other) = interp.host.output.recorders.of_file(&path) else { return Ok(()) };
    let (place, is_same) = (other.span, other.words == words(call));
    let message = format!("another recorder writes {name}{}", if is_same { ": its rows are lost" } else { "" });
    let mut d = Diagnostic::warning(&checks::output::SHARED_FILE, message).at(span, "expected a file of its own");
    if let Some(place) = place {
        d = d.help(format!("{}: the other one", interp.sources.location(place)));
    }
    d = d.help("\"remove recorders\" or \"wipe\" ends the recorders of an earlier analysis");
    if !is_same && !interp.host.follows(&[]) {
        d.severity = Severity::Error;
        return Err(Exception::diagnosed(d));
    }
    warn(interp, d)?;
    let finished = interp.host.output.recorders.finish_file(&path);
    finished.map_err(|e| Exception::diagnosed(Diagnostic::error(e.to_string()).at(span, "")))
}

/// Make the folder of a recorder's file, with a warning. OpenSees goes on without the file.
fn make_missing_folder(interp: &mut Tcl, name: &str, path: &str, span: Option<Span>) -> Result<(), Exception> {
    let is_folder = |interp: &Tcl, p: &str| interp.files.info(p, true).is_ok_and(|i| i.kind == FileKind::Directory);
    let folder = path.rsplit_once('/').map_or("/", |(f, _)| if f.is_empty() { "/" } else { f });
    if is_folder(interp, folder) {
        return Ok(());
    }
    let named = name.rsplit_once('/').map_or(folder, |(f, _)| f).to_owned();
    let d = Diagnostic::warning(&checks::output::FOLDER_MADE, format!("there is no folder {named}; it is made"));
    let help = format!("OpenSees would keep nothing: make it before, with \"file mkdir {named}\"");
    warn(interp, d.at(span, "cannot write here otherwise").help(help))?;
    if interp.host.mode == Mode::Check {
        return Ok(());
    }
    let ends = folder.match_indices('/').map(|(i, _)| i).filter(|i| *i > 0).chain([folder.len()]);
    for end in ends {
        let part = &folder[..end];
        if !is_folder(interp, part) {
            interp.files.make_dir(part).map_err(|e| {
                let d = Diagnostic::error(format!(
                    "cannot write {name}: there is no folder {named}, and it cannot be made: {e}"
                ));
                Exception::diagnosed(d.at(span, "cannot write here"))
            })?;
        }
    }
    Ok(())
}

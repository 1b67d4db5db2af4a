//! Laws that depend on a velocity which no analysis gives them.

use crate::Session;
use crate::checks;
use hysteron_tcl::diagnostic::Diagnostic;

/// Elements that a message names.
const MAX_NAMED: usize = 3;

/// A warning of the elements whose forces depend on velocities and whose nodes had none in any analysis of the script.
pub fn warn_of_speedless(session: &Session) -> Option<Diagnostic> {
    let all: Vec<String> = session.engine.speedless().map(|(class, tag)| format!("{class} {tag}")).collect();
    let (depends, its) = match all.len() {
        0 => return None,
        1 => ("depends", "its"),
        _ => ("depend", "their"),
    };
    let mut names = all[..all.len().min(MAX_NAMED)].join(", ");
    if all.len() > MAX_NAMED {
        names += &format!(" and {} more", all.len() - MAX_NAMED);
    }
    let message = format!("{names} {depends} on velocity, and no analysis of the script gives {its} nodes one");
    let help = if session.is_compat() {
        "without --compat opensees a node that sp moves in time has the velocity of its series"
    } else {
        "a transient analysis gives it, or an imposed displacement (sp) in time, also under LoadControl"
    };
    Some(Diagnostic::warning(&checks::analysis::NO_VELOCITY, message).help(help))
}

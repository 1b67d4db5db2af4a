//! Commands that OpenSees has for its window and its log, which are accepted and do nothing.

use crate::args::Args;
use crate::checks;
use crate::{Command, Outcome, Tcl, warn};
use hysteron_tcl::diagnostic::Diagnostic;
use hysteron_tcl::{Call, Value};

/// They change nothing of the results; a script that has them runs.
pub(crate) const COMMANDS: &[Command] = &[
    Command::new("prp", "prp $x $y $z", nothing),
    Command::new("vrp", "vrp $x $y $z", nothing),
    Command::new("vup", "vup $x $y $z", nothing),
    Command::new("vpn", "vpn $x $y $z", nothing),
    Command::new("viewWindow", "viewWindow $xmin $xmax $ymin $ymax", nothing),
    Command::new("plane", "plane $front $back", nothing),
    Command::new("port", "port $xmin $xmax $ymin $ymax", nothing),
    Command::new("projection", "projection $mode", nothing),
    Command::new("fill", "fill $mode", nothing),
    Command::new("display", "display ...", nothing),
    Command::new("plot", "plot ...", nothing),
    Command::new("logFile", "logFile $file ...", nothing),
    Command::new("logCommands", "logCommands ...", nothing),
    Command::new("setMaxOpenFiles", "setMaxOpenFiles $n", nothing),
    Command::new("start", "start", nothing),
    Command::new("stop", "stop", nothing),
    Command::new("domainChange", "domainChange", nothing),
];

fn nothing(_: &mut Tcl, _: &Call<'_>) -> Outcome {
    Ok(Value::EMPTY)
}

/// Files for the viewers of other programs are no results of the analysis: the script goes on without them.
pub(super) fn of_other_program(interp: &mut Tcl, call: &Call<'_>, a: Args<'_>) -> Outcome {
    let kind = a.last_word();
    let d = Diagnostic::warning(
        &checks::output::NOT_WRITTEN,
        format!("recorder {kind}: a file of this kind is not written"),
    );
    let d = d.at(call.span(1), "expected Node, Element, or PVD for ParaView");
    warn(interp, d.help("the script goes on without it"))?;
    Ok(Value::from(-1i64))
}

//! Commands that OpenSees has for its window and its log, which are accepted and do nothing.

use crate::args::Args;
use crate::checks;
use crate::effect::Effect;
use crate::text::WITHOUT_EFFECT;
use crate::{Command, Outcome, Tcl, warn};
use hysteron_tcl::diagnostic::Diagnostic;
use hysteron_tcl::{Call, Value};

/// They change nothing of the results; a script that has them runs.
pub(crate) const COMMANDS: &[Command] = &[
    without_effect("prp", "prp $x $y $z"),
    without_effect("vrp", "vrp $x $y $z"),
    without_effect("vup", "vup $x $y $z"),
    without_effect("vpn", "vpn $x $y $z"),
    without_effect("viewWindow", "viewWindow $xmin $xmax $ymin $ymax"),
    without_effect("plane", "plane $front $back"),
    without_effect("port", "port $xmin $xmax $ymin $ymax"),
    without_effect("projection", "projection $mode"),
    without_effect("fill", "fill $mode"),
    without_effect("display", "display ..."),
    without_effect("plot", "plot ..."),
    without_effect("logFile", "logFile $file ..."),
    without_effect("logCommands", "logCommands ..."),
    without_effect("setMaxOpenFiles", "setMaxOpenFiles $n"),
    without_effect("start", "start"),
    without_effect("stop", "stop"),
    without_effect("domainChange", "domainChange")
        .about("Accepted without effect: a change of the model is noticed by itself."),
];

const fn without_effect(name: &'static str, usage: &'static str) -> Command {
    Command::new(name, usage, nothing).about(WITHOUT_EFFECT).leaving(Effect::Nothing)
}

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

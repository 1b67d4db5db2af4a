//! Commands that OpenSees has for its window and its log, which are accepted and do nothing.

use crate::{Command, Outcome, Tcl};
use hysteron_tcl::{Call, Value};

/// They change nothing of the results; a script that has them runs.
pub(crate) const COMMANDS: &[Command] = &[
    Command { name: "prp", usage: "prp $x $y $z", run: nothing },
    Command { name: "vrp", usage: "vrp $x $y $z", run: nothing },
    Command { name: "vup", usage: "vup $x $y $z", run: nothing },
    Command { name: "vpn", usage: "vpn $x $y $z", run: nothing },
    Command { name: "viewWindow", usage: "viewWindow $xmin $xmax $ymin $ymax", run: nothing },
    Command { name: "plane", usage: "plane $front $back", run: nothing },
    Command { name: "port", usage: "port $xmin $xmax $ymin $ymax", run: nothing },
    Command { name: "projection", usage: "projection $mode", run: nothing },
    Command { name: "fill", usage: "fill $mode", run: nothing },
    Command { name: "display", usage: "display ...", run: nothing },
    Command { name: "plot", usage: "plot ...", run: nothing },
    Command { name: "logFile", usage: "logFile $file ...", run: nothing },
    Command { name: "logCommands", usage: "logCommands ...", run: nothing },
    Command { name: "setMaxOpenFiles", usage: "setMaxOpenFiles $n", run: nothing },
    Command { name: "start", usage: "start", run: nothing },
    Command { name: "stop", usage: "stop", run: nothing },
    Command { name: "domainChange", usage: "domainChange", run: nothing },
];

fn nothing(_: &mut Tcl, _: &Call<'_>) -> Outcome {
    Ok(Value::EMPTY)
}

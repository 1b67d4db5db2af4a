//! `modalDamping` and `modalDampingQ`.

use crate::args::Args;
use crate::checks;
use crate::text::Arg;
use crate::things;
use crate::{Command, Outcome, Tcl, warn};
use hysteron_engine::model::ModalDamping;
use hysteron_tcl::diagnostic::{Absent, Diagnostic};
use hysteron_tcl::{Call, Value};

const RATIO: Arg = Arg::not_negative("ratio", "damping ratio");

pub(crate) const COMMANDS: &[Command] = &[
    Command::new("modalDamping", USAGE, |i, c| modal_damping(i, c, true))
        .about("Damps modes that `eigen` has found, each by a ratio.")
        .arguments(&[RATIO, Arg::new("ratio1", "damping ratio of the first mode")]),
    Command::new("modalDampingQ", USAGE, |i, c| modal_damping(i, c, false))
        .about("As `modalDamping`, in the forces only and not in the tangent."),
];

const USAGE: &str = "modalDamping $ratio | $ratio1 $ratio2 ...: damping ratios of the modes that eigen has found";

fn modal_damping(interp: &mut Tcl, call: &Call<'_>, in_tangent: bool) -> Outcome {
    let mut a = Args::new(call, USAGE);
    let Some(modes) = interp.host.engine.modes().cloned() else {
        let e = a.refuse_at(call.span(0), "there are no modes to damp", "expected a command \"eigen\" before");
        return Err(e.absent(Absent::new(things::MODE, "")));
    };
    let mut ratios = vec![a.number(&RATIO)?];
    while a.left() > 0 {
        ratios.push(a.number(&RATIO)?);
    }
    let count = modes.lambda.len();
    if ratios.len() == 1 {
        ratios = vec![ratios[0]; count];
    } else if ratios.len() != count {
        let message = format!("{}: {} damping ratios but {count} modes", call.name(), ratios.len());
        let label = if ratios.len() < count { "the other modes are not damped" } else { "the others are left out" };
        warn(interp, Diagnostic::warning(&checks::analysis::DAMPING_OF_MODES, message).at(a.last_span(), label))?;
    }
    let damped = ratios.iter().zip(modes.lambda.iter().zip(modes.shapes));
    let modes = damped.map(|(ratio, (lambda, shape))| (2.0 * ratio * lambda.max(0.0).sqrt(), shape)).collect();
    interp.host.engine.change_model(|m| m.modal_damping = ModalDamping { modes, in_tangent });
    Ok(Value::EMPTY)
}

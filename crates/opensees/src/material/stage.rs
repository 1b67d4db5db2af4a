//! `updateMaterialStage`: switches a soil from elastic to plastic, which no law here knows.

use crate::args::Args;
use crate::checks;
use crate::effect::Effect;
use crate::text::{Arg, Domain};
use crate::{Command, Outcome, Tcl, finish, ignore_unknown, warn};
use hysteron_tcl::diagnostic::Diagnostic;
use hysteron_tcl::{Call, Value};

const TAG: Arg = Arg::of("-material", "material", "tag of the material").within(Domain::Whole);
const STAGE: Arg = Arg::of("-stage", "stage", "number of the stage").within(Domain::Whole);
const PARAMETER: Arg = Arg::of("-parameter", "parameter", "tag of the parameter").within(Domain::Whole);

const USAGE: &str = "updateMaterialStage -material $material -stage $stage <-parameter $parameter>";

pub(crate) const COMMANDS: &[Command] = &[Command::new("updateMaterialStage", USAGE, update_stage)
    .arguments(&[TAG, STAGE, PARAMETER])
    .about("Has no effect and warns: no law here has stages. In OpenSees it switches soils from elastic to plastic.")
    .leaving(Effect::Nothing)];

/// As in OpenSees a law without stages is told of and stays as it is.
fn update_stage(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, USAGE);
    let (mut material, mut stage) = (None, None);
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-material" => material = Some((a.int(TAG.meaning)?, a.last_span())),
            "-stage" => stage = Some(a.int(STAGE.meaning)?),
            "-parameter" => drop(a.int(PARAMETER.meaning)?),
            _ => ignore_unknown(interp, &mut a)?,
        }
    }
    finish(interp, &a)?;
    let (Some((tag, span)), Some(_)) = (material, stage) else {
        return Err(a.refuse("-material and -stage are needed", format!("expected \"{USAGE}\"")));
    };
    let message = format!("the material {tag} has no stages: it stays as it is");
    warn(interp, Diagnostic::warning(&checks::materials::NO_STAGES, message).at(span, "a law without stages"))?;
    Ok(Value::EMPTY)
}

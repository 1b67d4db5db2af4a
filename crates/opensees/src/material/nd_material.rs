//! `nDMaterial`.

use crate::args::Args;
use crate::{Command, Outcome, Tcl, finish};
use hysteron_engine::element::Isotropic;
use hysteron_tcl::{Call, Value};

pub(crate) const COMMANDS: &[Command] = &[Command { name: "nDMaterial", usage: USAGE, run: nd_material }];

const USAGE: &str = "nDMaterial ElasticIsotropic $tag $E $nu <$rho>";

fn nd_material(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, USAGE);
    if a.word("kind of material")? != "ElasticIsotropic" {
        return Err(a.unknown_name("material of continua", ["ElasticIsotropic"]));
    }
    let tag = a.int("tag of the material")?;
    let span = a.last_span();
    let e = a.positive("modulus of elasticity E")?;
    let nu = a.float("Poisson's ratio nu")?;
    let sound = nu > -1.0 && nu <= 0.5;
    if !sound {
        return Err(a.refuse(format!("Poisson's ratio is {nu}"), "expected more than -1, at most 0.5"));
    }
    let rho = if a.left() > 0 { a.not_negative("mass per volume rho")? } else { 0.0 };
    finish(interp, &a)?;
    if !interp.host.definitions.nd_materials.add(tag, Isotropic { e, nu, rho }) {
        return Err(a.refuse_at(span, format!("there is a material {tag} of continua already"), "expected a new tag"));
    }
    Ok(Value::EMPTY)
}

//! `nDMaterial`.

use crate::args::Args;
use crate::{Command, Outcome, Tcl, finish, kind};
use hysteron_engine::element::Isotropic;
use hysteron_tcl::{Call, Exception, Value};

pub(crate) const COMMANDS: &[Command] =
    &[Command::new("nDMaterial", USAGE, nd_material).with_kinds(|| kind::usages(KINDS))];

const USAGE: &str = "nDMaterial ElasticIsotropic $tag ...";

/// A kind of material of continua, made from the words after its tag.
type Kind = kind::Kind<fn(&mut Args<'_>) -> Result<Isotropic, Exception>>;

const KINDS: &[Kind] = &[Kind {
    names: &["ElasticIsotropic"],
    usage: "nDMaterial ElasticIsotropic $tag $E $nu <$rho>",
    make: elastic_isotropic,
}];

fn elastic_isotropic(a: &mut Args<'_>) -> Result<Isotropic, Exception> {
    let e = a.positive("modulus of elasticity E")?;
    let nu = a.float("Poisson's ratio nu")?;
    let sound = nu > -1.0 && nu <= 0.5;
    if !sound {
        return Err(a.refuse(format!("Poisson's ratio is {nu}"), "expected more than -1, at most 0.5"));
    }
    let rho = if a.left() > 0 { a.not_negative("mass per volume rho")? } else { 0.0 };
    Ok(Isotropic { e, nu, rho })
}

fn nd_material(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, USAGE);
    let kind = kind::take(&mut a, "kind of material", "material of continua", KINDS.iter())?;
    let tag = a.int("tag of the material")?;
    let span = a.last_span();
    let material = (kind.make)(&mut a)?;
    finish(interp, &a)?;
    if !interp.host.builder.definitions.nd_materials.add(tag, material) {
        return Err(a.refuse_at(span, format!("there is a material {tag} of continua already"), "expected a new tag"));
    }
    Ok(Value::EMPTY)
}

//! `uniaxialMaterial`, and the commands that try one by itself.

mod bearing;
mod bench;
mod concrete;
mod damper;
mod elastic;
pub(crate) mod friction;
mod hysteretic;
mod impact;
pub(crate) mod nd_material;
mod plastic;
mod rubber;
mod smooth;
mod soil;
mod wrapper;

use crate::args::Args;
use crate::{Command, Outcome, Tcl, finish};
use hysteron_engine::material::Material;
use hysteron_tcl::{Call, Exception, Value};

pub(crate) use bench::Bench;
pub(crate) use rubber::rheology;

pub(crate) const COMMANDS: &[Command] = &[
    Command { name: "uniaxialMaterial", usage: "uniaxialMaterial $kind $tag ...", run: uniaxial_material },
    Command { name: "testUniaxialMaterial", usage: "testUniaxialMaterial $tag", run: bench::test },
    Command { name: "setStrain", usage: bench::SET_STRAIN, run: bench::set_strain },
    Command { name: "getStrain", usage: "getStrain", run: bench::get },
    Command { name: "getStress", usage: "getStress", run: bench::get },
    Command { name: "getTangent", usage: "getTangent", run: bench::get },
    Command { name: "getDampTangent", usage: "getDampTangent", run: bench::get },
];

/// A kind of material and how it is made from the words after its tag.
struct Kind {
    names: &'static [&'static str],
    usage: &'static str,
    make: fn(&mut Tcl, &mut Args<'_>) -> Result<Material, Exception>,
}

/// The kinds of all families.
fn kinds() -> impl Iterator<Item = &'static Kind> {
    [
        elastic::KINDS,
        plastic::KINDS,
        concrete::KINDS,
        hysteretic::KINDS,
        smooth::KINDS,
        soil::KINDS,
        damper::KINDS,
        bearing::KINDS,
        impact::KINDS,
        rubber::KINDS,
        wrapper::KINDS,
    ]
    .into_iter()
    .flatten()
}

/// How the kinds are used.
pub(crate) fn usages() -> impl Iterator<Item = &'static str> {
    kinds().map(|k| k.usage)
}

fn uniaxial_material(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, "uniaxialMaterial $kind $tag ...");
    let name = a.word("kind of material")?;
    let Some(kind) = kinds().find(|k| k.names.contains(&name.as_ref())) else {
        return Err(a.unknown_name("uniaxial material", kinds().map(|k| k.names[0])));
    };
    a.usage(kind.usage);
    let tag = a.int("tag of the material")?;
    let span = a.last_span();
    let material = (kind.make)(interp, &mut a)?;
    finish(interp, &a)?;
    if !interp.host.definitions.materials.add(tag, material) {
        return Err(a.refuse_at(span, format!("there is a uniaxial material {tag} already"), "expected a new tag"));
    }
    Ok(Value::EMPTY)
}

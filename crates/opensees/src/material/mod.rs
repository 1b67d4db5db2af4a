//! `uniaxialMaterial`, and the commands that try one by itself.

pub(crate) mod backbone;
mod bar_slip;
mod bearing;
mod by_rules;
mod concrete;
mod confined_concrete;
mod damper;
mod deteriorating;
mod ecc;
mod elastic;
pub(crate) mod friction;
mod hysteretic;
mod hysteretic_sm;
mod impact;
pub(crate) mod limit_state;
mod masonry;
mod material_test;
mod nd_concrete;
pub(crate) mod nd_material;
mod nd_wrapper;
mod plastic;
mod recipe;
mod rubber;
mod smooth;
mod soil;
pub(crate) mod stage;
mod steel;
mod steel4;
mod steel_drc;
mod wrapper;

use crate::args::Args;
use crate::effect::Effect;
use crate::text::{Arg, Domain};
use crate::things;
use crate::{Command, Outcome, Tcl, finish, kind};
use hysteron_engine::material::Material;
use hysteron_tcl::{Call, Exception, Value};

use recipe::WordsOfMaterial;
use std::sync::Arc;

pub(crate) use material_test::MaterialTests;
pub(crate) use rubber::{CONDUCTION, RHEOLOGY_ARGUMENTS, rheology};

pub(crate) const COMMANDS: &[Command] = &[
    Command::new("uniaxialMaterial", "uniaxialMaterial $kind $tag ...", uniaxial_material)
        .about("Makes a uniaxial law: stress over strain, or force over deformation.")
        .arguments(&[Arg::thing("material", things::MATERIAL), TAG])
        .defining(&[things::MATERIAL], 2)
        .with_kinds(|| kinds().map(kind::Kind::described).collect()),
    Command::new("testUniaxialMaterial", "testUniaxialMaterial $tag", material_test::test)
        .arguments(&[Arg::thing("tag", things::MATERIAL)])
        .about("Chooses the law that `setStrain` drives."),
    Command::new("setStrain", material_test::SET_STRAIN, material_test::set_strain)
        .about("Strains the chosen law and commits its state.")
        .arguments(&[material_test::STRAIN, material_test::RATE]),
    Command::new("getStrain", "getStrain", material_test::get)
        .about("Returns the strain of the chosen law.")
        .leaving(Effect::Nothing),
    Command::new("getStress", "getStress", material_test::get)
        .about("Returns the stress of the chosen law.")
        .leaving(Effect::Nothing),
    Command::new("getTangent", "getTangent", material_test::get)
        .about("Returns the tangent of the chosen law.")
        .leaving(Effect::Nothing),
    Command::new("getDampTangent", "getDampTangent", material_test::get)
        .about("Returns the derivative of the stress of the chosen law with respect to the strain rate.")
        .leaving(Effect::Nothing),
];

const TAG: Arg = Arg::of_domain("tag", "tag of the material", Domain::Whole);

/// A kind of material, made from the words after its tag.
type Kind = kind::Kind<fn(&mut Tcl, &mut Args<'_>) -> Result<Material, Exception>>;

/// The kinds of all families.
fn kinds() -> impl Iterator<Item = &'static Kind> + Clone {
    [
        elastic::KINDS,
        steel::KINDS,
        plastic::KINDS,
        concrete::KINDS,
        ecc::KINDS,
        confined_concrete::KINDS,
        nd_concrete::KINDS,
        masonry::KINDS,
        steel4::KINDS,
        steel_drc::KINDS,
        hysteretic::KINDS,
        hysteretic_sm::KINDS,
        limit_state::KINDS,
        backbone::KINDS,
        bar_slip::KINDS,
        deteriorating::KINDS,
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

fn uniaxial_material(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, "uniaxialMaterial $kind $tag ...");
    let kind = kind::take(&mut a, "kind of material", "uniaxial material", kinds())?;
    interp.host.note_kind("uniaxialMaterial", kind.names[0]);
    let tag = a.int(TAG.meaning)?;
    let span = a.last_span();
    let material = (kind.make)(interp, &mut a)?;
    finish(interp, &a)?;
    let material = material.made_by(Arc::new(WordsOfMaterial::of(interp, kind, call, &a)));
    if !interp.host.builder.definitions.materials.add(tag, material) {
        return Err(a.exists_at(span, things::MATERIAL, tag));
    }
    Ok(Value::EMPTY)
}

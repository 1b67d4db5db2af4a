//! `nDMaterial`.

use crate::args::Args;
use crate::{Command, Outcome, Tcl, finish, kind};
use hysteron_engine::material::Isotropic;
use hysteron_engine::model::NdMaterial;
use hysteron_engine::section::plate::{PlateFromPlaneStress, PlateRebar, SharedPlateMaterial};
use hysteron_tcl::{Call, Exception, Value};
use std::sync::Arc;

pub(crate) const COMMANDS: &[Command] =
    &[Command::new("nDMaterial", USAGE, nd_material).with_kinds(|| kind::usages(KINDS))];

const USAGE: &str = "nDMaterial $kind $tag ...";

/// A kind of material of continua, made from the words after its tag.
type Kind = kind::Kind<fn(&Tcl, &mut Args<'_>) -> Result<NdMaterial, Exception>>;

const KINDS: &[Kind] = &[
    Kind {
        names: &["ElasticIsotropic", "ElasticIsotropic3D"],
        usage: "nDMaterial ElasticIsotropic $tag $E $nu <$rho>",
        make: elastic_isotropic,
    },
    Kind {
        names: &["PlateFiber", "PlateFiberMaterial"],
        usage: "nDMaterial PlateFiber $tag $material",
        make: plate_fiber,
    },
    Kind {
        names: &["PlateFromPlaneStress", "PlateFromPlaneStressMaterial"],
        usage: "nDMaterial PlateFromPlaneStress $tag $material $G",
        make: plate_from_plane_stress,
    },
    Kind {
        names: &["PlateRebar", "PlateRebarMaterial"],
        usage: "nDMaterial PlateRebar $tag $uniaxialMaterial $angle",
        make: plate_rebar,
    },
];

fn elastic_isotropic(_: &Tcl, a: &mut Args<'_>) -> Result<NdMaterial, Exception> {
    let e = a.positive("modulus of elasticity E")?;
    let nu = a.float("Poisson's ratio nu")?;
    let sound = nu > -1.0 && nu <= 0.5;
    if !sound {
        return Err(a.refuse(format!("Poisson's ratio is {nu}"), "expected more than -1, at most 0.5"));
    }
    let rho = if a.left() > 0 { a.not_negative("mass per volume rho")? } else { 0.0 };
    Ok(NdMaterial::Isotropic(Isotropic { e, nu, rho }))
}

/// A material of plates by its tag; an isotropic one has no stress across the plate.
pub(crate) fn of_plates(interp: &Tcl, a: &mut Args<'_>) -> Result<SharedPlateMaterial, Exception> {
    Ok(match a.of(&interp.host.builder.definitions.nd_materials)?.0 {
        NdMaterial::Isotropic(material) => Arc::new(material),
        NdMaterial::Plate(material) => material,
    })
}

fn plate_fiber(interp: &Tcl, a: &mut Args<'_>) -> Result<NdMaterial, Exception> {
    of_plates(interp, a).map(NdMaterial::Plate)
}

fn plate_from_plane_stress(interp: &Tcl, a: &mut Args<'_>) -> Result<NdMaterial, Exception> {
    let membrane = of_plates(interp, a)?;
    let shear = a.not_negative("shear modulus G across the plate")?;
    Ok(NdMaterial::Plate(Arc::new(PlateFromPlaneStress { membrane, shear })))
}

fn plate_rebar(interp: &Tcl, a: &mut Args<'_>) -> Result<NdMaterial, Exception> {
    let (material, tag) = a.of(&interp.host.builder.definitions.materials)?;
    let degrees = a.float("angle of the bars in degrees")?;
    Ok(NdMaterial::Plate(Arc::new(PlateRebar::new(material, tag, degrees))))
}

fn nd_material(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, USAGE);
    let kind = kind::take(&mut a, "kind of material", "material of continua", KINDS.iter())?;
    interp.host.note_kind("nDMaterial", kind.names[0]);
    let tag = a.int("tag of the material")?;
    let span = a.last_span();
    let material = (kind.make)(interp, &mut a)?;
    finish(interp, &a)?;
    if !interp.host.builder.definitions.nd_materials.add(tag, material) {
        return Err(a.refuse_at(span, format!("there is a material {tag} of continua already"), "expected a new tag"));
    }
    Ok(Value::EMPTY)
}

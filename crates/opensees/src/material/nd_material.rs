//! `nDMaterial`.

use crate::args::Args;
use crate::{Command, Outcome, Tcl, finish, kind};
use hysteron_engine::material::{ConcreteCm, Fsam, FsamParameters, Isotropic, J2Plasticity, LAYER, NdMaterial, SharedMultiaxial};
use hysteron_engine::model::Tag;
use hysteron_engine::section::plate::{PlateFromPlaneStress, PlateRebar};
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
        names: &["J2Plasticity", "J2"],
        usage: "nDMaterial J2Plasticity $tag $K $G $sig0 $sigInf $delta $H <$eta> <$rho>",
        make: j2_plasticity,
    },
    Kind {
        names: &["FSAM"],
        usage: "nDMaterial FSAM $tag $rho $steelX $steelY $concrete $ratioX $ratioY $nu $alfadow",
        make: fsam,
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
    Ok(Isotropic { e, nu, rho }.family())
}

fn j2_plasticity(_: &Tcl, a: &mut Args<'_>) -> Result<NdMaterial, Exception> {
    let law = J2Plasticity {
        bulk: a.positive("bulk modulus K")?,
        shear: a.positive("shear modulus G")?,
        yield_stress: a.positive("yield stress sig0")?,
        saturated: a.positive("saturated yield stress sigInf")?,
        delta: a.not_negative("rate of saturation delta")?,
        hardening: a.float("linear hardening modulus H")?,
        viscosity: a.optional_float("viscosity eta")?.unwrap_or(0.0),
        rho: a.optional_float("mass per volume rho")?.unwrap_or(0.0),
    };
    Ok(NdMaterial::of_solid("J2Plasticity", Arc::new(law)))
}

fn fsam(interp: &Tcl, a: &mut Args<'_>) -> Result<NdMaterial, Exception> {
    let rho = a.not_negative("mass per volume rho")?;
    let materials = &interp.host.builder.definitions.materials;
    let bars = [a.of(materials)?, a.of(materials)?];
    let (concrete, tag) = a.of(materials)?;
    let Some(concrete) = concrete.as_any().and_then(|law| law.downcast_ref::<ConcreteCm>()).cloned() else {
        let message = format!("uniaxial material {tag} is {}", concrete.name());
        return Err(a.refuse(message, "expected a ConcreteCM"));
    };
    let ratios = [a.not_negative("ratio of bars along x")?, a.not_negative("ratio of bars along y")?];
    let friction = a.not_negative("coefficient of friction nu")?;
    let dowel = a.not_negative("dowel stiffness alfadow over the modulus of the bars")?;
    let law = Fsam::new(bars, concrete, FsamParameters { rho, ratios, friction, dowel });
    Ok(NdMaterial::of_plane_stress("FSAM", law))
}

/// A material of continua with its tag.
pub(crate) type Family = (NdMaterial, Tag);

/// A material of continua by its tag.
pub(crate) fn family(interp: &Tcl, a: &mut Args<'_>) -> Result<Family, Exception> {
    a.of(&interp.host.builder.definitions.nd_materials)
}

/// A law of a material that the last word names.
pub(crate) fn form<const N: usize>(
    a: &Args<'_>,
    (material, tag): &Family,
    (law, name): (Option<&SharedMultiaxial<N>>, &str),
) -> Result<SharedMultiaxial<N>, Exception> {
    law.cloned().ok_or_else(|| {
        let message = format!("material {tag} ({}) has no law {name}", material.class);
        a.refuse(message, &format!("expected a material that has one {name}"))
    })
}

/// The law of a layer of plates; an isotropic one has no stress across the plate.
pub(crate) fn of_plates(interp: &Tcl, a: &mut Args<'_>) -> Result<SharedMultiaxial<LAYER>, Exception> {
    let family = family(interp, a)?;
    form(a, &family, (family.0.layer.as_ref(), "of layers of plates"))
}

fn plate_fiber(interp: &Tcl, a: &mut Args<'_>) -> Result<NdMaterial, Exception> {
    Ok(NdMaterial::of_layers("PlateFiberMaterial", of_plates(interp, a)?))
}

fn plate_from_plane_stress(interp: &Tcl, a: &mut Args<'_>) -> Result<NdMaterial, Exception> {
    let family = family(interp, a)?;
    let membrane = form(a, &family, (family.0.plane_stress.as_ref(), "in plane stress"))?;
    let shear = a.not_negative("shear modulus G across the plate")?;
    let law = PlateFromPlaneStress { membrane, shear };
    Ok(NdMaterial::of_layers("PlateFromPlaneStressMaterial", Arc::new(law)))
}

fn plate_rebar(interp: &Tcl, a: &mut Args<'_>) -> Result<NdMaterial, Exception> {
    let (material, tag) = a.of(&interp.host.builder.definitions.materials)?;
    let degrees = a.float("angle of the bars in degrees")?;
    Ok(NdMaterial::of_layers("PlateRebarMaterial", Arc::new(PlateRebar::new(material, tag, degrees))))
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

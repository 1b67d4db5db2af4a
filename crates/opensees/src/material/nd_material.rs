//! `nDMaterial`.

use super::{nd_concrete, nd_wrapper};
use crate::args::Args;
use crate::text::{Arg, Domain, Text};
use crate::things;
use crate::{Command, Outcome, Tcl, finish, kind};
use hysteron_engine::material::{
    ConcreteCm, Condensed, Fsam, FsamParameters, InitialStrain, Isotropic, J2Plasticity, LAYER, NdMaterial,
    Orthotropic, ParallelSolids, SOLID, SharedMultiaxial, SimplifiedJ2, WeightedLaws,
};
use hysteron_engine::model::Tag;
use hysteron_engine::section::plate::{PlateFromPlaneStress, PlateRebar};
use hysteron_engine::shared::Shared;
use hysteron_tcl::{Call, Exception, Value};
use std::sync::Arc;

const FSAM: [Arg; 4] = [
    Arg::not_negative("ratioX", "ratio of bars along x"),
    Arg::not_negative("ratioY", "ratio of bars along y"),
    Arg::not_negative("nu", "coefficient of friction nu of the interlock"),
    Arg::not_negative("alfadow", "dowel stiffness alfadow over the modulus of the bars"),
];
pub(super) const PARALLEL_WEIGHT: Arg = Arg::of("-weights", "w1", "weight").within(Domain::Number);

const TAG: Arg = Arg::whole("tag", "tag of the material");
pub(super) const ELASTIC_ISOTROPIC_E: Arg = Arg::positive("E", "modulus of elasticity E");
pub(super) const NU: Arg = Arg::number("nu", "Poisson's ratio nu");
const ELASTIC_ISOTROPIC_RHO: Arg = Arg::not_negative("rho", "mass per volume rho");
const J2_PLASTICITY: [Arg; 6] = [
    Arg::positive("K", "bulk modulus K"),
    Arg::positive("G", "shear modulus G"),
    Arg::positive("sig0", "yield stress sig0"),
    Arg::positive("sigInf", "saturated yield stress sigInf"),
    Arg::not_negative("delta", "rate of saturation delta"),
    Arg::number("H", "linear hardening modulus H"),
];
const ETA: Arg = Arg::number("eta", "viscosity eta");
const J2_PLASTICITY_RHO: Arg = Arg::number("rho", "mass per volume, which has no effect");
const MODULI: [Arg; 3] =
    [Arg::positive("Ex", "modulus Ex"), Arg::positive("Ey", "modulus Ey"), Arg::positive("Ez", "modulus Ez")];
const RATIOS: [Arg; 3] = [
    Arg::number("nu_xy", "Poisson's ratio nu_xy"),
    Arg::number("nu_yz", "Poisson's ratio nu_yz"),
    Arg::number("nu_zx", "Poisson's ratio nu_zx"),
];
const SHEAR_MODULI: [Arg; 3] = [
    Arg::positive("Gxy", "shear modulus Gxy"),
    Arg::positive("Gyz", "shear modulus Gyz"),
    Arg::positive("Gzx", "shear modulus Gzx"),
];
const SIMPLIFIED_J2: [Arg; 5] = [
    J2_PLASTICITY[1],
    J2_PLASTICITY[0],
    J2_PLASTICITY[2],
    Arg::not_negative("H_kin", "modulus of kinematic hardening H_kin"),
    Arg::not_negative("H_iso", "modulus of isotropic hardening H_iso"),
];
const EPS: Arg = Arg::number("eps", "initial strain");
const EPS11: Arg = Arg::number("eps11", "initial strain");
pub(super) const J2_BEAM_FIBER_RHO: Arg = Arg::number("rho", "mass per volume rho");
const PLATE_FROM_PLANE_STRESS_G: Arg = Arg::not_negative("G", "shear modulus G across the plate");
const ANGLE: Arg = Arg::number("angle", "angle of the bars in degrees");

pub(crate) const COMMANDS: &[Command] = &[Command::new("nDMaterial", USAGE, nd_material)
    .arguments(&[Arg::thing("material", things::ND_MATERIAL), TAG])
    .about("Makes a law of a continuum, for `quad`, bricks and plates.")
    .defining(&[things::ND_MATERIAL], 2)
    .with_kinds(|| kind::usages(KINDS))];

const USAGE: &str = "nDMaterial $kind $tag ...";

/// A kind of material of continua, made from the words after its tag.
type Kind = kind::Kind<fn(&mut Tcl, &mut Args<'_>) -> Result<NdMaterial, Exception>>;

const KINDS: &[Kind] = &[
    Kind {
        names: &["ElasticIsotropic", "ElasticIsotropic3D"],
        usage: "nDMaterial ElasticIsotropic $tag $E $nu <$rho>",
        text: Text::new("A linear elastic, isotropic continuum.").arguments(&[
            ELASTIC_ISOTROPIC_E,
            NU,
            ELASTIC_ISOTROPIC_RHO,
        ]),
        make: elastic_isotropic,
    },
    Kind {
        names: &["J2Plasticity", "J2"],
        usage: "nDMaterial J2Plasticity $tag $K $G $sig0 $sigInf $delta $H <$eta> <$rho>",
        text: Text::new("Plasticity of von Mises with isotropic hardening that saturates, and viscosity.")
            .groups(&[&J2_PLASTICITY, &[ETA, J2_PLASTICITY_RHO]]),
        make: j2_plasticity,
    },
    Kind {
        names: &["ElasticOrthotropic", "ElasticOrthotropic3D"],
        usage: "nDMaterial ElasticOrthotropic $tag $Ex $Ey $Ez $nu_xy $nu_yz $nu_zx $Gxy $Gyz $Gzx <$rho>",
        text: Text::new("A linear elastic continuum with other constants along each axis.").groups(&[
            &MODULI,
            &RATIOS,
            &SHEAR_MODULI,
            &[ELASTIC_ISOTROPIC_RHO],
        ]),
        make: elastic_orthotropic,
    },
    Kind {
        names: &["Simplified3DJ2", "3DJ2", "SimplifiedJ2"],
        usage: "nDMaterial Simplified3DJ2 $tag $G $K $sig0 $H_kin $H_iso",
        text: Text::new("Plasticity of von Mises with linear isotropic and kinematic hardening.")
            .groups(&[&SIMPLIFIED_J2]),
        make: |_, a| Ok(NdMaterial::of_solid("SimplifiedJ2", simplified_j2(a)?.shared())),
    },
    Kind {
        names: &["PlaneStressSimplifiedJ2"],
        usage: "nDMaterial PlaneStressSimplifiedJ2 $tag $G $K $sig0 $H_kin $H_iso",
        text: Text::new("Plasticity of von Mises with linear hardening, in plane stress alone.")
            .groups(&[&SIMPLIFIED_J2]),
        make: plane_stress_j2,
    },
    Kind {
        names: &["PlaneStress", "PlaneStressMaterial"],
        usage: "nDMaterial PlaneStress $tag $material",
        text: Text::new("A law in space, used in plane stress."),
        make: |interp, a| {
            Ok(NdMaterial::of_shared_plane_stress("PlaneStressMaterial", of_solid(interp, a, Condensed::plane_stress)?))
        },
    },
    Kind {
        names: &["PlaneStrain", "PlaneStrainMaterial"],
        usage: "nDMaterial PlaneStrain $tag $material",
        text: Text::new("A law in space, used in plane strain."),
        make: |interp, a| {
            Ok(NdMaterial::of_plane_strain("PlaneStrainMaterial", of_solid(interp, a, Condensed::plane_strain)?))
        },
    },
    Kind {
        names: &["InitStrain", "InitStrainMaterial"],
        usage: "nDMaterial InitStrain $tag $material $eps | $eps11 $eps22 $eps33 $eps12 $eps23 $eps13",
        text: Text::new("A law in space with strains at rest.").arguments(&[
            EPS,
            EPS11,
            Arg::number("eps22", "initial strain 1"),
            Arg::number("eps33", "initial strain 2"),
            Arg::number("eps12", "initial strain 3"),
            Arg::number("eps23", "initial strain 4"),
            Arg::number("eps13", "initial strain 5"),
        ]),
        make: initial_strain,
    },
    Kind {
        names: &["Parallel3D"],
        usage: "nDMaterial Parallel3D $tag $material1 $material2 ... <-weights $w1 $w2 ...>",
        text: Text::new("Laws in space with one strain, whose stresses add up.")
            .arguments(&[Arg::thing("material1", things::ND_MATERIAL), PARALLEL_WEIGHT]),
        make: parallel,
    },
    Kind {
        names: &["InitStress", "InitStressND", "InitStressNDMaterial", "InitStressMaterial"],
        usage: "nDMaterial InitStress $tag $material $sigma <$dimensions>",
        text: Text::new("A law in space with a pressure at rest.")
            .arguments(&[nd_wrapper::INITIAL_STRESS, Arg::new("dimensions", "a number that is not used")]),
        make: nd_wrapper::initial_stress,
    },
    Kind {
        names: &["Series3D"],
        usage: "nDMaterial Series3D $tag $material1 $material2 ... <-weights $w1 $w2 ...> <-maxIter $n> <-relTol $tol> <-absTol $tol> \
                <-verbose>",
        text: Text::new("Laws in space with one stress, whose strains add up.").arguments(&[
            Arg::thing("material1", things::ND_MATERIAL),
            PARALLEL_WEIGHT,
            nd_wrapper::SERIES_ITERATIONS,
            nd_wrapper::SERIES_RELATIVE,
            nd_wrapper::SERIES_ABSOLUTE,
            Arg::flag("-verbose", "says nothing more"),
        ]),
        make: nd_wrapper::series,
    },
    Kind {
        names: &["BeamFiber", "BeamFiberMaterial"],
        usage: "nDMaterial BeamFiber $tag $material",
        text: Text::new("A law in space for fibres of beams in space: only the stresses 11, 12 and 13 are not zero."),
        make: nd_wrapper::beam_fiber,
    },
    Kind {
        names: &["BeamFiber2d", "BeamFiberMaterial2d"],
        usage: "nDMaterial BeamFiber2d $tag $material",
        text: Text::new("A law in space for fibres of beams in the plane: only the stresses 11 and 12 are not zero."),
        make: nd_wrapper::plane_beam_fiber,
    },
    Kind {
        names: &["BeamFiber2dPS", "BeamFiberMaterial2dPS"],
        usage: "nDMaterial BeamFiber2dPS $tag $material",
        text: Text::new("A law in plane stress for fibres of beams in the plane: the stress 22 is zero."),
        make: nd_wrapper::beam_fiber_of_plane_stress,
    },
    Kind {
        names: &["J2BeamFiber"],
        usage: "nDMaterial J2BeamFiber $tag $E $nu $sigmaY $Hiso $Hkin <$rho>",
        text: Text::new("Plasticity of von Mises with linear hardening for fibres of beams.").arguments(&[
            ELASTIC_ISOTROPIC_E,
            NU,
            nd_wrapper::SIGMA_Y,
            nd_wrapper::H_ISO,
            nd_wrapper::H_KIN,
            J2_BEAM_FIBER_RHO,
        ]),
        make: nd_wrapper::j2_beam_fiber,
    },
    Kind {
        names: &["ASDConcrete3D"],
        usage: nd_concrete::USAGE,
        text: Text::new(
            "Concrete with plasticity and damage by curves in tension and compression; crack planes are not modelled.",
        )
        .arguments(&[
            nd_concrete::MODULUS,
            nd_concrete::NU,
            nd_concrete::RHO,
            Arg::of("-Kc", "Kc", "shape of the surface of failure, from 2/3 to 1"),
            nd_concrete::CROSS_DAMAGE,
            Arg::flag("-tangent", "the tangent is that of differences, not the secant"),
        ])
        .groups(&[&nd_concrete::CURVES]),
        make: nd_concrete::make,
    },
    Kind {
        names: &["FSAM"],
        usage: "nDMaterial FSAM $tag $rho $steelX $steelY $concrete $ratioX $ratioY $nu $alfadow",
        text: Text::new("Panel of reinforced concrete in plane stress, with cracks at fixed angles.")
            .arguments(&[
                ELASTIC_ISOTROPIC_RHO,
                Arg::thing("steelX", things::MATERIAL),
                Arg::thing("steelY", things::MATERIAL),
                Arg::thing("concrete", things::MATERIAL),
            ])
            .groups(&[&FSAM]),
        make: fsam,
    },
    Kind {
        names: &["PlateFiber", "PlateFiberMaterial"],
        usage: "nDMaterial PlateFiber $tag $material",
        text: Text::new("A continuum without stress across a plate."),
        make: plate_fiber,
    },
    Kind {
        names: &["PlateFromPlaneStress", "PlateFromPlaneStressMaterial"],
        usage: "nDMaterial PlateFromPlaneStress $tag $material $G",
        text: Text::new("A membrane with a shear modulus across the plate.").arguments(&[PLATE_FROM_PLANE_STRESS_G]),
        make: plate_from_plane_stress,
    },
    Kind {
        names: &["PlateRebar", "PlateRebarMaterial"],
        usage: "nDMaterial PlateRebar $tag $uniaxialMaterial $angle",
        text: Text::new("Bars in one direction, smeared over a layer of a plate.")
            .arguments(&[Arg::thing("uniaxialMaterial", things::MATERIAL), ANGLE]),
        make: plate_rebar,
    },
];

fn elastic_isotropic(_: &mut Tcl, a: &mut Args<'_>) -> Result<NdMaterial, Exception> {
    let e = a.number(&ELASTIC_ISOTROPIC_E)?;
    let nu = a.number(&NU)?;
    let sound = nu > -1.0 && nu <= 0.5;
    if !sound {
        return Err(a.refuse(format!("Poisson's ratio is {nu}"), "expected more than -1, at most 0.5"));
    }
    let rho = if a.left() > 0 { a.number(&ELASTIC_ISOTROPIC_RHO)? } else { 0.0 };
    Ok(Isotropic { e, nu, rho }.family())
}

fn j2_plasticity(_: &mut Tcl, a: &mut Args<'_>) -> Result<NdMaterial, Exception> {
    let [bulk, shear, yield_stress, saturated, delta, hardening] = a.numbers(&J2_PLASTICITY)?;
    let viscosity = a.optional_number(&ETA)?.unwrap_or(0.0);
    let rho = a.optional_number(&J2_BEAM_FIBER_RHO)?.unwrap_or(0.0);
    let law = J2Plasticity { bulk, shear, yield_stress, saturated, delta, hardening, viscosity, rho };
    Ok(NdMaterial::of_solid("J2Plasticity", law.shared()))
}

fn elastic_orthotropic(_: &mut Tcl, a: &mut Args<'_>) -> Result<NdMaterial, Exception> {
    let (e, nu) = (a.numbers(&MODULI)?, a.numbers(&RATIOS)?);
    let last = a.last_span();
    let shear = a.numbers(&SHEAR_MODULI)?;
    let rho = if a.left() > 0 { a.number(&ELASTIC_ISOTROPIC_RHO)? } else { 0.0 };
    match (Orthotropic { e, nu, shear, rho }).solid() {
        Some(law) => Ok(NdMaterial::of_solid("ElasticOrthotropicMaterial", law.shared())),
        None => Err(a.refuse_at(
            last,
            "the stiffness is not positive definite with these Poisson's ratios",
            "expected smaller Poisson's ratios",
        )),
    }
}

fn simplified_j2(a: &mut Args<'_>) -> Result<SimplifiedJ2, Exception> {
    let [shear, bulk, yield_stress, kinematic, isotropic] = a.numbers(&SIMPLIFIED_J2)?;
    Ok(SimplifiedJ2 { shear, bulk, yield_stress, kinematic, isotropic })
}

fn plane_stress_j2(_: &mut Tcl, a: &mut Args<'_>) -> Result<NdMaterial, Exception> {
    let solid: SharedMultiaxial<SOLID> = simplified_j2(a)?.shared();
    Ok(NdMaterial::of_shared_plane_stress("PlaneStressSimplifiedJ2", Condensed::plane_stress(&solid)))
}

/// A law made of the law in space of a material.
pub(super) fn of_solid<T>(
    interp: &Tcl,
    a: &mut Args<'_>,
    make: impl FnOnce(&SharedMultiaxial<SOLID>) -> T,
) -> Result<T, Exception> {
    let family = family(interp, a)?;
    Ok(make(&form(a, &family, (family.0.solid.as_ref(), "in space"))?))
}

fn initial_strain(interp: &mut Tcl, a: &mut Args<'_>) -> Result<NdMaterial, Exception> {
    let law = of_solid(interp, a, Arc::clone)?;
    let mut strain = [0.0; SOLID];
    let first = a.number(&EPS)?;
    if a.left() == 0 {
        strain[..3].fill(first);
    } else {
        strain[0] = first;
        for (i, e) in strain.iter_mut().enumerate().skip(1) {
            *e = a.nth_number(&EPS, i)?;
        }
    }
    Ok(NdMaterial::of_solid("InitStrainNDMaterial", InitialStrain { law, strain }.shared()))
}

fn parallel(interp: &mut Tcl, a: &mut Args<'_>) -> Result<NdMaterial, Exception> {
    let mut laws = vec![(of_solid(interp, a, Arc::clone)?, 1.0)];
    while a.at_number() {
        laws.push((of_solid(interp, a, Arc::clone)?, 1.0));
    }
    if a.flag("-weights") {
        for (i, (_, weight)) in laws.iter_mut().enumerate() {
            *weight = a.nth_number(&PARALLEL_WEIGHT, i)?;
        }
    }
    Ok(NdMaterial::of_solid("Parallel3DMaterial", ParallelSolids { laws: WeightedLaws(laws) }.shared()))
}

fn fsam(interp: &mut Tcl, a: &mut Args<'_>) -> Result<NdMaterial, Exception> {
    let rho = a.number(&ELASTIC_ISOTROPIC_RHO)?;
    let materials = &interp.host.builder.definitions.materials;
    let bars = [a.of(materials)?, a.of(materials)?];
    let (concrete, tag) = a.of(materials)?;
    let Some(concrete) = concrete.roles().law.and_then(|law| law.downcast_ref::<ConcreteCm>()).cloned() else {
        let message = format!("uniaxial material {tag} is {}", concrete.name());
        return Err(a.refuse(message, "expected a ConcreteCM"));
    };
    let [x, y, friction, dowel] = a.numbers(&FSAM)?;
    let law = Fsam::new(bars, concrete, FsamParameters { rho, ratios: [x, y], friction, dowel });
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
        a.refuse(message, format!("expected a material that has one {name}"))
    })
}

/// The law of a layer of plates; an isotropic one has no stress across the plate.
pub(crate) fn of_plates(interp: &Tcl, a: &mut Args<'_>) -> Result<SharedMultiaxial<LAYER>, Exception> {
    let family = family(interp, a)?;
    form(a, &family, (family.0.layer.as_ref(), "of layers of plates"))
}

fn plate_fiber(interp: &mut Tcl, a: &mut Args<'_>) -> Result<NdMaterial, Exception> {
    Ok(NdMaterial::of_layers("PlateFiberMaterial", of_plates(interp, a)?))
}

fn plate_from_plane_stress(interp: &mut Tcl, a: &mut Args<'_>) -> Result<NdMaterial, Exception> {
    let family = family(interp, a)?;
    let membrane = form(a, &family, (family.0.plane_stress.as_ref(), "in plane stress"))?;
    let shear = a.number(&PLATE_FROM_PLANE_STRESS_G)?;
    let law = PlateFromPlaneStress { membrane, shear };
    Ok(NdMaterial::of_layers("PlateFromPlaneStressMaterial", law.shared()))
}

fn plate_rebar(interp: &mut Tcl, a: &mut Args<'_>) -> Result<NdMaterial, Exception> {
    let (material, tag) = a.of(&interp.host.builder.definitions.materials)?;
    let degrees = a.number(&ANGLE)?;
    Ok(NdMaterial::of_layers("PlateRebarMaterial", PlateRebar::new(material, tag, degrees).shared()))
}

fn nd_material(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, USAGE);
    let kind = kind::take(&mut a, "kind of material", "material of continua", KINDS.iter())?;
    interp.host.note_kind("nDMaterial", kind.names[0]);
    let tag = a.int(TAG.meaning)?;
    let span = a.last_span();
    let material = (kind.make)(interp, &mut a)?;
    finish(interp, &a)?;
    if !interp.host.builder.definitions.nd_materials.add(tag, material) {
        return Err(a.exists_at(span, things::ND_MATERIAL, tag));
    }
    Ok(Value::EMPTY)
}

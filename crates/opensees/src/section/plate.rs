//! Sections of plates and shells.

use super::{Kind, Make};
use crate::Tcl;
use crate::args::Args;
use crate::material::nd_material::of_plates;
use crate::text::{Arg, Text};
use crate::things;
use hysteron_engine::section::plate::{ElasticPlate, LayeredPlate, SharedPlateSection};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;

const LAYERS: Arg = Arg::count("layers", "number of layers");
const LAYER_THICKNESS: Arg = Arg::positive("h", "thickness h of all layers");

const ELASTIC_MEMBRANE_PLATE_SECTION_E: Arg = Arg::positive("E", "modulus of elasticity E");
const NU: Arg = Arg::number("nu", "Poisson's ratio nu");
const ELASTIC_MEMBRANE_PLATE_SECTION_H: Arg = Arg::positive("h", "thickness h");
const RHO: Arg = Arg::not_negative("rho", "mass per volume rho");
const BENDING_RATIO: Arg = Arg::positive("bendingRatio", "ratio of the modulus in bending");
const H1: Arg = Arg::not_negative("h1", "thickness h of a layer");

pub(super) const ELASTIC: Kind = Kind {
    names: &["ElasticMembranePlateSection", "ElasticPlateSection"],
    usage: "section ElasticMembranePlateSection $tag $E $nu $h <$rho> <$bendingRatio>",
    text: Text::new("An isotropic elastic plate, for shells.")
        .example("section ElasticMembranePlateSection 77 1. 0.2 0.1")
        .arguments(&[ELASTIC_MEMBRANE_PLATE_SECTION_E, NU, ELASTIC_MEMBRANE_PLATE_SECTION_H, RHO, BENDING_RATIO]),
    make: Make::Plate(elastic),
};

pub(super) const UNIFORM: Kind = Kind {
    names: &["PlateFiber", "platefiber"],
    usage: "section PlateFiber $tag $material $h <Lobatto|Gauss>",
    text: Text::new("A plate of one material with five points across its thickness, for shells.")
        .example("section PlateFiber 77 1 0.1")
        .arguments(&[Arg::thing("material", things::ND_MATERIAL), ELASTIC_MEMBRANE_PLATE_SECTION_H]),
    make: Make::Plate(uniform),
};

pub(super) const LAYERED: Kind = Kind {
    names: &["LayeredShell"],
    usage: "section LayeredShell $tag $layers $material1 $h1 $material2 $h2 ... | $layers $material $h",
    text: Text::new("A plate of layers, for shells.").example("section LayeredShell 77 3 1 0.1 1 0.2 1 0.1").arguments(
        &[
            LAYERS,
            Arg::thing("material1", things::ND_MATERIAL),
            H1,
            Arg::not_negative("h2", "thickness h of a layer"),
            Arg::thing("material", things::ND_MATERIAL),
            LAYER_THICKNESS,
            Arg::new("material2", "tags of the materials and thicknesses of the layers from the bottom up"),
        ],
    ),
    make: Make::Plate(layered),
};

fn elastic(_: &mut Tcl, a: &mut Args<'_>) -> Result<SharedPlateSection, Exception> {
    let e = a.number(&ELASTIC_MEMBRANE_PLATE_SECTION_E)?;
    let nu = a.number(&NU)?;
    if nu.abs() >= 1.0 {
        return Err(a.refuse(format!("Poisson's ratio is {nu}"), "expected between -1 and 1"));
    }
    let thickness = a.number(&ELASTIC_MEMBRANE_PLATE_SECTION_H)?;
    let rho = if a.left() > 0 { a.number(&RHO)? } else { 0.0 };
    let bending_ratio = if a.left() > 0 { a.number(&BENDING_RATIO)? } else { 1.0 };
    Ok(ElasticPlate { e, nu, thickness, rho, bending_ratio }.shared())
}

fn uniform(interp: &mut Tcl, a: &mut Args<'_>) -> Result<SharedPlateSection, Exception> {
    let material = of_plates(interp, a)?;
    let thickness = a.number(&ELASTIC_MEMBRANE_PLATE_SECTION_H)?;
    let gauss = a.flag("Gauss") || a.flag("gauss");
    if !gauss && a.left() > 0 {
        a.word("Lobatto or Gauss")?;
    }
    Ok(LayeredPlate::uniform(&material, thickness, gauss).shared())
}

fn layered(interp: &mut Tcl, a: &mut Args<'_>) -> Result<SharedPlateSection, Exception> {
    let [count] = a.parts([&LAYERS])?;
    if count < 3 {
        return Err(a.refuse(format!("there are {count} layers"), "expected 3 or more"));
    }
    let mut layers = vec![];
    if a.left() == 2 {
        let material = of_plates(interp, a)?;
        let thickness = a.number(&LAYER_THICKNESS)?;
        layers.resize(count, (material, thickness / count as f64));
    } else {
        for _ in 0..count {
            layers.push((of_plates(interp, a)?, a.number(&H1)?));
        }
    }
    Ok(LayeredPlate::stacked(layers).shared())
}

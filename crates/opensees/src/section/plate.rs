//! Sections of plates and shells.

use super::{Kind, Make};
use crate::Tcl;
use crate::args::Args;
use crate::material::nd_material::of_plates;
use crate::text::{Arg, Text};
use hysteron_engine::section::plate::{ElasticPlate, LayeredPlate, SharedPlateSection};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;

pub(super) const ELASTIC: Kind = Kind {
    names: &["ElasticMembranePlateSection", "ElasticPlateSection"],
    usage: "section ElasticMembranePlateSection $tag $E $nu $h <$rho> <$bendingRatio>",
    text: Text::new("An isotropic elastic plate, for shells.")
        .example("section ElasticMembranePlateSection 77 1. 0.2 0.1"),
    make: Make::Plate(elastic),
};

pub(super) const UNIFORM: Kind = Kind {
    names: &["PlateFiber", "platefiber"],
    usage: "section PlateFiber $tag $material $h <Lobatto|Gauss>",
    text: Text::new("A plate of one material with five points across its thickness, for shells.")
        .example("section PlateFiber 77 1 0.1"),
    make: Make::Plate(uniform),
};

pub(super) const LAYERED: Kind = Kind {
    names: &["LayeredShell"],
    usage: "section LayeredShell $tag $layers $material1 $h1 $material2 $h2 ... | $layers $material $h",
    text: Text::new("A plate of layers, for shells.")
        .example("section LayeredShell 77 3 1 0.1 1 0.2 1 0.1")
        .arguments(&[Arg::new("material2", "tags of the materials and thicknesses of the layers from the bottom up")]),
    make: Make::Plate(layered),
};

fn elastic(_: &mut Tcl, a: &mut Args<'_>) -> Result<SharedPlateSection, Exception> {
    let e = a.positive("modulus of elasticity E")?;
    let nu = a.float("Poisson's ratio nu")?;
    if nu.abs() >= 1.0 {
        return Err(a.refuse(format!("Poisson's ratio is {nu}"), "expected between -1 and 1"));
    }
    let thickness = a.positive("thickness h")?;
    let rho = if a.left() > 0 { a.not_negative("mass per volume rho")? } else { 0.0 };
    let bending_ratio = if a.left() > 0 { a.positive("ratio of the modulus in bending")? } else { 1.0 };
    Ok(ElasticPlate { e, nu, thickness, rho, bending_ratio }.shared())
}

fn uniform(interp: &mut Tcl, a: &mut Args<'_>) -> Result<SharedPlateSection, Exception> {
    let material = of_plates(interp, a)?;
    let thickness = a.positive("thickness h")?;
    let gauss = a.flag("Gauss") || a.flag("gauss");
    if !gauss && a.left() > 0 {
        a.word("Lobatto or Gauss")?;
    }
    Ok(LayeredPlate::uniform(&material, thickness, gauss).shared())
}

fn layered(interp: &mut Tcl, a: &mut Args<'_>) -> Result<SharedPlateSection, Exception> {
    let [count] = a.parts(["number of layers"])?;
    if count < 3 {
        return Err(a.refuse(format!("there are {count} layers"), "expected 3 or more"));
    }
    let mut layers = vec![];
    if a.left() == 2 {
        let material = of_plates(interp, a)?;
        let thickness = a.positive("thickness h of all layers")?;
        layers.resize(count, (material, thickness / count as f64));
    } else {
        for _ in 0..count {
            layers.push((of_plates(interp, a)?, a.not_negative("thickness h of a layer")?));
        }
    }
    Ok(LayeredPlate::stacked(layers).shared())
}

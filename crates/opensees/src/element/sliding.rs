//! `element flatSliderBearing`, `singleFPBearing` and `RJWatsonEqsBearing`.

use super::bearing::{Placement, materials};
use super::{Ends, Make, orientation};
use crate::args::Args;
use crate::slips;
use crate::text::any_command::{ITERATIONS, MASS, TOLERANCE};
use crate::text::{Arg, Domain, Text};
use crate::{Tcl, ignore_unknown};
use hysteron_engine::element::Element;
use hysteron_engine::element::bearing::sliding::{
    Dish, Kind, PlaneSlider, Setting, SpaceSlider, Substitution, Surface,
};
use hysteron_engine::rules::Consistent;
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use std::sync::Arc;

const K_INIT: Arg = Arg::positive("kInit", "initial stiffness kInit");
const REFF: Arg = Arg::positive("Reff", "effective radius Reff");
const K_FACT_UPLIFT_K_FACT: Arg =
    Arg::of("-kFactUplift", "kFact", "share of the stiffness left in uplift kFactUplift").within(Domain::Positive);

pub(super) const FLAT: super::Kind = super::Kind {
    names: &["flatSliderBearing"],
    usage: "element flatSliderBearing $tag $i $j $frnMdlTag $kInit -P $mat <-T $mat -My $mat> -Mz $mat \
            <-orient <$x1 $x2 $x3> $y1 $y2 $y3> <-shearDist $sDratio> <-doRayleigh> <-mass $m> <-iter $maxIter $tol>",
    text: Text::new("Flat slider.").example("element flatSliderBearing 2 1 2 1 1 -P 1 -Mz 1").arguments(&[K_INIT]),
    make: Make::TwoNodes(|interp, a, ends| make(interp, a, ends, Kind::Flat)),
};

pub(super) const PENDULUM: super::Kind = super::Kind {
    names: &["singleFPBearing", "SFPBearing", "singlePFBearing", "SPFBearing"],
    usage: "element singleFPBearing $tag $i $j $frnMdlTag $Reff $kInit -P $mat <-T $mat -My $mat> -Mz $mat \
            <-orient <$x1 $x2 $x3> $y1 $y2 $y3> <-shearDist $sDratio> <-doRayleigh> <-inclVertDisp> <-mass $m> \
            <-iter $maxIter $tol> <-kFactUplift $kFact>",
    text: Text::new("Single friction pendulum.")
        .example("element singleFPBearing 2 1 2 1 1 1 -P 1 -Mz 1")
        .arguments(&[REFF, K_INIT, K_FACT_UPLIFT_K_FACT]),
    make: Make::TwoNodes(|interp, a, ends| make(interp, a, ends, Kind::Pendulum)),
};

pub(super) const RJ_WATSON: super::Kind = super::Kind {
    names: &["RJWatsonEqsBearing", "RJWatsonBearing", "EQSBearing"],
    usage: "element RJWatsonEqsBearing $tag $i $j $frnMdlTag $kInit -P $mat -Vy $mat <-Vz $mat -T $mat -My $mat> \
            -Mz $mat <-orient <$x1 $x2 $x3> $y1 $y2 $y3> <-shearDist $sDratio> <-doRayleigh> <-mass $m> \
            <-iter $maxIter $tol> <-kFactUplift $kFact>",
    text: Text::new("Slider with an elastic spring (EradiQuake).")
        .example("element RJWatsonEqsBearing 2 1 2 1 1 -P 1 -Vy 1 -Mz 1")
        .arguments(&[K_INIT, K_FACT_UPLIFT_K_FACT]),
    make: Make::TwoNodes(|interp, a, ends| make(interp, a, ends, Kind::Springs)),
};

fn make(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends, kind: Kind) -> Result<Arc<dyn Element>, Exception> {
    let nodes = a.last_span();
    let (friction, _) = a.of(&interp.host.builder.definitions.frictions)?;
    let mut dish = match kind {
        Kind::Pendulum => Some(Dish { radius: a.number(&REFF)?, rises: false }),
        _ => None,
    };
    let k_init = a.number(&K_INIT)?;
    let wanted: &[&str] = match (kind, ends.ndm) {
        (Kind::Springs, 2) => &["-P", "-Vy", "-Mz"],
        (Kind::Springs, _) => &["-P", "-Vy", "-Vz", "-T", "-My", "-Mz"],
        (_, 2) => &["-P", "-Mz"],
        _ => &["-P", "-T", "-My", "-Mz"],
    };
    let materials = materials(interp, a, wanted)?;
    let mut place = Placement::at_nodes(nodes);
    let mut substitution = Substitution { rounds: 25, tolerance: 1e-12 };
    let compat =
        interp.host.follows(&[slips::SLIDER_FORCE, slips::SLIDER_TRIAL, slips::SLIDER_TANGENT, slips::SLIDER_UPLIFT]);
    // OpenSees gives the flat slider no share of its own.
    let uplift = if compat && kind == Kind::Flat { f64::EPSILON } else { 1e-6 };
    let mut setting = Setting { kind, mass: 0.0, rayleigh: false, uplift, rules: Consistent };
    let mut shear_dist = 0.0;
    let known = a.options();
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-orient" => {
                place.orient_span = a.last_span();
                place.orientation = orientation(a, ends.ndm)?;
            }
            "-shearDist" => shear_dist = super::bearing::shear_dist(a)?,
            "-doRayleigh" => setting.rayleigh = true,
            "-mass" => setting.mass = a.number(&MASS)?,
            "-iter" => {
                substitution.rounds = a.count(&ITERATIONS)?;
                substitution.tolerance = a.number(&TOLERANCE)?;
            }
            "-kFactUplift" if known.contains(&"-kFactUplift") => {
                setting.uplift = a.number(&K_FACT_UPLIFT_K_FACT)?;
            }
            "-inclVertDisp" | "-inclVertdisp" if known.contains(&"-inclVertDisp") => {
                dish = dish.map(|d| Dish { rises: true, ..d });
            }
            _ => ignore_unknown(interp, a)?,
        }
    }
    let surface = Surface { friction, k_init, dish };
    match (ends.ndm, ends.ndf) {
        (2, 3) => {
            let (link, length) = place.link(a, ends, shear_dist)?;
            let link = (link, length, shear_dist);
            Ok(match compat {
                true => PlaneSlider::new(surface, link, materials, setting.with(substitution)).shared(),
                false => PlaneSlider::new(surface, link, materials, setting).shared(),
            })
        }
        (3, 6) => {
            let (link, length) = place.link(a, ends, shear_dist)?;
            let link = (link, length, shear_dist);
            Ok(match compat {
                true => SpaceSlider::new(surface, link, materials, setting.with(substitution)).shared(),
                false => SpaceSlider::new(surface, link, materials, setting).shared(),
            })
        }
        _ => Err(ends.wrong(a, "3 degrees of freedom in 2 or 6 in 3 dimensions")),
    }
}

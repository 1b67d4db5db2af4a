//! `element FPBearingPTV`.

use super::bearing::{Placement, shear_dist};
use super::heated_triple::{UNITS, one_of};
use super::{Ends, Make};
use crate::Tcl;
use crate::args::Args;
use crate::model::transform::vector;
use crate::slips;
use crate::text::Text;
use hysteron_engine::element::Element;
use hysteron_engine::element::axes::Orientation;
use hysteron_engine::element::bearing::sliding::{
    Dish, Heat, HeatSetting, Kind, Setting, SpaceSlider, Substitution, Surface,
};
use hysteron_engine::rules::Consistent;
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use std::sync::Arc;

pub(super) const HEATED_PENDULUM: super::Kind = super::Kind {
    names: &["FPBearingPTV"],
    usage: "element FPBearingPTV $tag $i $j $MuRef $IsPressureDependent $pRef $isTemperatureDependent $Diffusivity \
            $Conductivity $IsVelocityDependent $rateParameter $ReffectiveFP $Radius_Contact $kInitial $theMaterialA \
            $theMaterialB $theMaterialC $theMaterialD $x1 $x2 $x3 $y1 $y2 $y3 $shearDist $doRayleigh $mass $iter $tol $unit",
    text: Text::new("Single friction pendulum whose friction depends on pressure, temperature and velocity.").example(
        "element FPBearingPTV 77 1 2 0.06 1 9549. 1 4.44e-6 0.018 1 20. 2. 0.2 8000. 1 2 3 4 0 0 1 1 0 0 0.3 \
         0 0. 20 1e-8 2",
    ),
    make: Make::TwoNodes(make),
};

fn make(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    let nodes = a.last_span();
    if (ends.ndm, ends.ndf) != (3, 6) {
        return Err(ends.wrong(a, "6 degrees of freedom in 3 dimensions"));
    }
    let compat = interp.host.follows(&[slips::PTV_HEAT, slips::PTV_FORCE, slips::PTV_TENSION]);
    let on = |a: &mut Args<'_>, what: &str| Ok::<bool, Exception>(one_of(a, what, 0..=1)? == 1);
    let mu = a.positive("reference coefficient of friction MuRef")?;
    let by_pressure = on(a, "dependence on pressure")?;
    let reference = a.not_negative("reference pressure pRef")?;
    let softens = on(a, "dependence on temperature")?;
    let conduction = [a.positive("thermal diffusivity")?, a.positive("thermal conductivity")?];
    let by_speed = on(a, "dependence on speed")?;
    let rate = a.not_negative("rate of the dependence on speed")?;
    let dish = Dish { radius: a.positive("effective radius ReffectiveFP")?, rises: false };
    let radius = a.positive("radius of contact Radius_Contact")?;
    let k_init = a.positive("initial stiffness kInitial")?;
    let known = &interp.host.builder.definitions.materials;
    let materials = vec![a.of(known)?, a.of(known)?, a.of(known)?, a.of(known)?];
    let mut place = Placement::at_nodes(nodes);
    let x = vector(a, 3, "local x axis")?;
    place.orient_span = a.last_span();
    place.orientation = Orientation { x: Some(x), y: Some(vector(a, 3, "vector of the local x-y plane")?) };
    let shear_dist = shear_dist(a)?;
    let rayleigh = on(a, "Rayleigh damping doRayleigh")?;
    let mass = a.not_negative("mass")?;
    let substitution =
        Substitution { rounds: a.count("largest number of iterations iter")?, tolerance: a.positive("tolerance tol")? };
    let unit = one_of(a, "system of units", 1..=8)?;
    let (mega_pascal, _) = UNITS[usize::try_from(unit - 1).unwrap_or_default()];
    let heat = Heat::new(HeatSetting {
        mu,
        reference: by_pressure.then_some(reference),
        mega_pascal,
        rate: by_speed.then_some(rate),
        softens,
        radius,
        conduction,
        compat,
    });
    let setting = Setting { kind: Kind::Heated, mass, rayleigh, uplift: 1e-6, rules: Consistent };
    let surface = Surface { friction: Arc::new(heat), k_init, dish: Some(dish) };
    let (link, length) = place.link(a, ends, shear_dist)?;
    let link = (link, length, shear_dist);
    Ok(match compat {
        true => SpaceSlider::new(surface, link, materials, setting.with(substitution)).warming(heat).shared(),
        false => SpaceSlider::new(surface, link, materials, setting).warming(heat).shared(),
    })
}

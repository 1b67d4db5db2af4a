//! `element FPBearingPTV`.

use super::bearing::{Placement, shear_dist};
use super::heated_triple::{UNITS, one_of};
use super::{Ends, Make};
use crate::Tcl;
use crate::args::Args;
use crate::model::transform::vector;
use crate::slips;
use crate::text::{Arg, Text};
use crate::things;
use hysteron_engine::element::Element;
use hysteron_engine::element::axes::Orientation;
use hysteron_engine::element::bearing::sliding::{
    Dish, Heat, HeatSetting, Kind, Setting, SpaceSlider, Substitution, Surface,
};
use hysteron_engine::rules::Consistent;
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use std::sync::Arc;

const MU_REF: Arg = Arg::positive("MuRef", "reference coefficient of friction MuRef");
const P_REF: Arg = Arg::not_negative("pRef", "reference pressure pRef");
const CONDUCTION: [Arg; 2] =
    [Arg::positive("Diffusivity", "thermal diffusivity"), Arg::positive("Conductivity", "thermal conductivity")];
const RATE_PARAMETER: Arg = Arg::not_negative("rateParameter", "rate of the dependence on speed");
const DISH: [Arg; 3] = [
    Arg::positive("ReffectiveFP", "effective radius ReffectiveFP"),
    Arg::positive("Radius_Contact", "radius of contact Radius_Contact"),
    Arg::positive("kInitial", "initial stiffness kInitial"),
];
const MASS: Arg = Arg::not_negative("mass", "mass");
const ITER: Arg = Arg::count("iter", "largest number of iterations iter");
const TOL: Arg = Arg::positive("tol", "tolerance tol");

pub(super) const HEATED_PENDULUM: super::Kind = super::Kind {
    names: &["FPBearingPTV"],
    usage: "element FPBearingPTV $tag $i $j $MuRef $IsPressureDependent $pRef $isTemperatureDependent $Diffusivity \
            $Conductivity $IsVelocityDependent $rateParameter $ReffectiveFP $Radius_Contact $kInitial $theMaterialA \
            $theMaterialB $theMaterialC $theMaterialD $x1 $x2 $x3 $y1 $y2 $y3 $shearDist $doRayleigh $mass $iter $tol $unit",
    text: Text::new("Single friction pendulum whose friction depends on pressure, temperature and velocity.")
        .example(
            "element FPBearingPTV 77 1 2 0.06 1 9549. 1 4.44e-6 0.018 1 20. 2. 0.2 8000. 1 2 3 4 0 0 1 1 0 0 0.3 \
         0 0. 20 1e-8 2",
        )
        .arguments(&[
            MU_REF,
            Arg::whole("IsPressureDependent", "dependence on pressure"),
            P_REF,
            Arg::whole("isTemperatureDependent", "dependence on temperature"),
            Arg::whole("IsVelocityDependent", "dependence on speed"),
            RATE_PARAMETER,
            Arg::thing("theMaterialA", things::MATERIAL),
            Arg::thing("theMaterialB", things::MATERIAL),
            Arg::thing("theMaterialC", things::MATERIAL),
            Arg::thing("theMaterialD", things::MATERIAL),
            Arg::number("x1", "x of the local x axis"),
            Arg::number("x2", "y of the local x axis"),
            Arg::number("x3", "z of the local x axis"),
            Arg::number("y1", "x of the vector of the local x-y plane"),
            Arg::number("y2", "y of the vector of the local x-y plane"),
            Arg::number("y3", "z of the vector of the local x-y plane"),
            Arg::number("shearDist", "place of the shear force as a fraction of the length"),
            Arg::whole("doRayleigh", "Rayleigh damping doRayleigh"),
            MASS,
            ITER,
            TOL,
            Arg::whole("unit", "system of units"),
        ])
        .groups(&[&CONDUCTION, &DISH]),
    make: Make::TwoNodes(make),
};

fn make(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    let nodes = a.last_span();
    ends.need(a, (3, 6))?;
    let compat = interp.host.follows(&[slips::PTV_HEAT, slips::PTV_FORCE, slips::PTV_TENSION]);
    let on = |a: &mut Args<'_>, what: &str| Ok::<bool, Exception>(one_of(a, what, 0..=1)? == 1);
    let mu = a.number(&MU_REF)?;
    let by_pressure = on(a, "dependence on pressure")?;
    let reference = a.number(&P_REF)?;
    let softens = on(a, "dependence on temperature")?;
    let conduction = a.numbers(&CONDUCTION)?;
    let by_speed = on(a, "dependence on speed")?;
    let rate = a.number(&RATE_PARAMETER)?;
    let [effective, radius, k_init] = a.numbers(&DISH)?;
    let dish = Dish { radius: effective, rises: false };
    let known = &interp.host.builder.definitions.materials;
    let materials = vec![a.of(known)?, a.of(known)?, a.of(known)?, a.of(known)?];
    let mut place = Placement::at_nodes(nodes);
    let x = vector(a, 3, "local x axis")?;
    place.orient_span = a.last_span();
    place.orientation = Orientation { x: Some(x), y: Some(vector(a, 3, "vector of the local x-y plane")?) };
    let shear_dist = shear_dist(a)?;
    let rayleigh = on(a, "Rayleigh damping doRayleigh")?;
    let mass = a.number(&MASS)?;
    let substitution = Substitution { rounds: a.count(&ITER)?, tolerance: a.number(&TOL)? };
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

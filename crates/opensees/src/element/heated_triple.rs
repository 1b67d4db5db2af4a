//! `element TripleFrictionPendulumX`.

use super::triple::{LENGTHS, TENSION, WEIGHT, lengths, stiffness};
use super::{Ends, Kind, Make};
use crate::args::Args;
use crate::checks;
use crate::slips;
use crate::text::{Arg, Text};
use crate::things;
use crate::{Tcl, warn};
use hysteron_engine::element::Element;
use hysteron_engine::element::bearing::triple::{
    Body, Conduction, Heated, HeatedSetting, Increments, Softening, TriplePendulum, TripleSetting,
};
use hysteron_engine::material::Material;
use hysteron_engine::rules::Consistent;
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::Diagnostic;
use std::sync::Arc;

const COEFFICIENTS: [Arg; 3] = [
    Arg::positive("mu1", "coefficient of friction mu1"),
    Arg::positive("mu2", "coefficient of friction mu2"),
    Arg::positive("mu3", "coefficient of friction mu3"),
];
const DIAMETERS: [Arg; 3] = [
    Arg::positive("b1", "diameter b1 of the slider"),
    Arg::positive("b2", "diameter b2 of the lower plate"),
    Arg::positive("b3", "diameter b3 of the upper plate"),
];
const PRESSURES: [Arg; 3] = [
    Arg::positive("refPres1", "reference pressure 1"),
    Arg::positive("refPres2", "reference pressure 2"),
    Arg::positive("refPres3", "reference pressure 3"),
];
const PLATES: [Arg; 2] =
    [Arg::positive("t2", "thickness t2 of the lower plate"), Arg::positive("t3", "thickness t3 of the upper plate")];
const CONDUCTION: [Arg; 2] =
    [Arg::positive("Diffusivity", "thermal diffusivity"), Arg::positive("Conductivity", "thermal conductivity")];
const TEMPERATURE0: Arg = Arg::number("Temperature0", "temperature at the beginning");
const RATE_PARAM: Arg = Arg::not_negative("rateParam", "rate of the dependence on speed");

pub(super) const TRIPLE_X: Kind = Kind {
    names: &["TripleFrictionPendulumX"],
    usage: "element TripleFrictionPendulumX $tag $i $j $tagT $tagT2 $vertMatTag $rotZMatTag $rotXMatTag $rotYMatTag \
            $tagPres $tagTemp $tagVel $mu1 $mu2 $mu3 $L1 $L2 $L3 $d1 $d2 $d3 $b1 $b2 $b3 $t2 $t3 $W $uy $kvt $minFv $tol \
            $refPres1 $refPres2 $refPres3 $Diffusivity $Conductivity $Temperature0 $rateParam $kTmodel $unit",
    text: Text::new("Triple friction pendulum whose friction depends on pressure, temperature and velocity.")
        .example(
            "element TripleFrictionPendulumX 2 1 2 1 1 1 1 1 1 1 1 1 1 1 1 1 2 2 1 1 1 1 1 1 1 1 1 1 \
                1 1 1 1 1 1 1 1 1 1 1 1",
        )
        .arguments(&[
            Arg::whole("tagT", "way tagT to the displacements of the surfaces"),
            Arg::whole("tagT2", "conduction tagT2 (1 half space, 2 plate)"),
            Arg::thing("vertMatTag", things::MATERIAL),
            Arg::thing("rotZMatTag", things::MATERIAL),
            Arg::thing("rotXMatTag", things::MATERIAL),
            Arg::thing("rotYMatTag", things::MATERIAL),
            Arg::whole("tagPres", "dependence on pressure tagPres"),
            Arg::whole("tagTemp", "dependence on temperature tagTemp"),
            Arg::whole("tagVel", "dependence on speed tagVel"),
            TEMPERATURE0,
            RATE_PARAM,
            Arg::whole("kTmodel", "dependence kTmodel on temperature"),
            Arg::whole("unit", "system of units"),
        ])
        .groups(&[&COEFFICIENTS, &LENGTHS, &DIAMETERS, &PLATES, &WEIGHT, &TENSION, &PRESSURES, &CONDUCTION]),
    make: Make::TwoNodes(make),
};

/// MPa per unit of pressure and m per unit of length, of the units 1 to 8: N m, kN m, N mm, kN mm, lb in, kip in, lb ft, kip ft.
pub(super) const UNITS: [(f64, f64); 8] = [
    (1e-6, 1.0),
    (1e-3, 1.0),
    (1.0, 1e-3),
    (1e3, 1e-3),
    (0.006894, 0.0254),
    (6.894, 0.0254),
    (4.788e-5, 0.3048),
    (0.04788, 0.3048),
];

/// One of a few whole numbers.
pub(super) fn one_of(a: &mut Args<'_>, what: &str, range: std::ops::RangeInclusive<i32>) -> Result<i32, Exception> {
    let n = a.int(what)?;
    if range.contains(&n) {
        return Ok(n);
    }
    let (first, last) = (range.start(), range.end());
    Err(a.refuse(format!("the {what} is {n}"), format!("expected a whole number from {first} to {last}")))
}

/// The vertical material and those of the rotations about Z, X and Y, from the tag of the conduction on. OpenSees starts a word early: it
/// takes the tag of the conduction for that of the vertical material, and leaves the last one out.
fn materials(interp: &Tcl, a: &mut Args<'_>) -> Result<(Body, [(Material, i32); 4]), Exception> {
    let known = &interp.host.builder.definitions.materials;
    let tag = one_of(a, "conduction tagT2 (1 half space, 2 plate)", 1..=2)?;
    let body = if tag == 1 { Body::HalfSpace } else { Body::Plate };
    let compat = interp.host.follows(&[slips::TRIPLE_X_MATERIALS]);
    let early = match known.get(tag) {
        Some(material) => (material.clone(), tag),
        None if compat => {
            let message = format!(
                "OpenSees takes tagT2 for the tag of the vertical material, and there is no {} {tag}",
                known.kind
            );
            return Err(a.refuse(message, "define it, or run without --compat"));
        }
        None => return Ok((body, [a.of(known)?, a.of(known)?, a.of(known)?, a.of(known)?])),
    };
    let [first, second, third, last] = [a.of(known)?, a.of(known)?, a.of(known)?, a.of(known)?];
    Ok((body, if compat { [early, first, second, third] } else { [first, second, third, last] }))
}

fn make(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    ends.need(a, (3, 6))?;
    let compat = interp.host.follows(&[slips::TRIPLE_X_HEAT, slips::TRIPLE_X_CONDUCTION, slips::TRIPLE_X_FORCE]);
    if one_of(a, "way tagT to the displacements of the surfaces", 0..=1)? == 0 {
        let d = Diagnostic::warning(
            &checks::elements::SEGMENTS_IN_SERIES,
            "TripleFrictionPendulumX: the displacements of the surfaces, and with them speeds and heat, are those of the series \
             of segments (tagT 1)",
        );
        warn(interp, d.at(a.last_span(), "their parts by regimes of the force are not available"))?;
    }
    let (body, materials) = materials(interp, a)?;
    let on = |a: &mut Args<'_>, what: &str| Ok::<bool, Exception>(one_of(a, what, 0..=1)? == 1);
    let by_pressure = on(a, "dependence on pressure tagPres")?;
    let by_temperature = on(a, "dependence on temperature tagTemp")?;
    let by_speed = on(a, "dependence on speed tagVel")?;
    let mu = a.numbers(&COEFFICIENTS)?;
    let (l, d) = lengths(a)?;
    let width = a.numbers(&DIAMETERS)?;
    let thickness = a.numbers(&PLATES)?;
    let [weight, uy] = a.numbers(&WEIGHT)?;
    let uy_span = a.last_span();
    let [k_tension, least_normal, tolerance] = a.numbers(&TENSION)?;
    let reference = a.numbers(&PRESSURES)?;
    let [diffusivity, conductivity] = a.numbers(&CONDUCTION)?;
    let conduction = Conduction { diffusivity, conductivity, body, compat };
    let temperature = a.number(&TEMPERATURE0)?;
    let rate = a.number(&RATE_PARAM)?;
    let softening = match one_of(a, "dependence kTmodel on temperature", 1..=3)? {
        1 => Softening::Half,
        2 => Softening::Third,
        _ => Softening::TwoThirds,
    };
    let unit = one_of(a, "system of units", 1..=8)?;
    let (mega_pascal, metre) = UNITS[usize::try_from(unit - 1).unwrap_or_default()];
    let heated = Heated::new(HeatedSetting {
        mu,
        reference: by_pressure.then_some(reference),
        mega_pascal,
        rate: by_speed.then_some(rate * metre),
        softening: by_temperature.then_some(softening),
        radius: width.map(|b| 0.5 * b),
        temperature,
        conduction,
        thickness,
        outer: [l[1], l[2]].map(|r| r / (r - l[0])),
    });
    let e = stiffness(a, uy_span, heated.at_rest()[0], uy, &l)?;
    // The outer segments reach their ends first.
    let whole = 2.0 * d[0] + d[1] + d[2] + 0.5 * width[0];
    let inner = whole - d[1] * (1.0 - l[0] / l[1]) - d[2] * (1.0 - l[0] / l[2]);
    let chain = super::triple::chain(e, &l, &d, inner);
    let height = ends.place.1.z - ends.place.0.z;
    let setting = TripleSetting { weight, k_tension, least_normal, height, rules: Consistent };
    Ok(match compat {
        true => TriplePendulum::heated(chain, heated, materials, setting.with(Increments(tolerance))).shared(),
        false => TriplePendulum::heated(chain, heated, materials, setting).shared(),
    })
}

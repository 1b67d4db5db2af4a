//! `element TripleFrictionPendulum`.

use super::{Ends, Kind, Make};
use crate::Tcl;
use crate::args::Args;
use crate::slips;
use crate::text::{Arg, Text};
use crate::things;
use hysteron_engine::element::Element;
use hysteron_engine::element::bearing::triple::{Chain, Increments, Segment, TriplePendulum, TripleSetting};
use hysteron_engine::element::friction::Friction;
use hysteron_engine::material::Material;
use hysteron_engine::rules::Consistent;
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::Span;
use std::sync::Arc;

/// Weight and yield displacement.
pub(super) const WEIGHT: [Arg; 2] = [Arg::positive("W", "weight W"), Arg::positive("uy", "yield displacement uy")];
/// Numbers of the vertical direction, and the tolerance.
pub(super) const TENSION: [Arg; 3] = [
    Arg::positive("kvt", "vertical stiffness in tension kvt"),
    Arg::not_negative("minFv", "least normal force minFv"),
    Arg::positive("tol", "tolerance tol"),
];

/// Effective radii and displacement limits of the inner, lower and upper surfaces.
pub(super) const LENGTHS: [Arg; 6] = [
    Arg::positive("L1", "effective radius L1 of the inner surfaces"),
    Arg::positive("L2", "effective radius L2 of the lower outer surface"),
    Arg::positive("L3", "effective radius L3 of the upper outer surface"),
    Arg::positive("d1", "displacement limit d1 of the inner surfaces"),
    Arg::positive("d2", "displacement limit d2 of the lower outer surface"),
    Arg::positive("d3", "displacement limit d3 of the upper outer surface"),
];

pub(super) const TRIPLE: Kind = Kind {
    names: &["TripleFrictionPendulum"],
    usage: "element TripleFrictionPendulum $tag $i $j $frnTag1 $frnTag2 $frnTag3 $vertMatTag $rotZMatTag $rotXMatTag \
            $rotYMatTag $L1 $L2 $L3 $d1 $d2 $d3 $W $uy $kvt $minFv $tol",
    text: Text::new("Triple friction pendulum.")
        .example(
            "element TripleFrictionPendulum 77 1 2 2 1 1 1 2 2 2 0.3 1. 1. 0.05 0.25 0.25 300. 0.002 \
                1. 0.1 1e-8",
        )
        .arguments(&[
            Arg::thing("frnTag1", things::FRICTION),
            Arg::thing("frnTag2", things::FRICTION),
            Arg::thing("frnTag3", things::FRICTION),
            Arg::thing("vertMatTag", things::MATERIAL),
            Arg::thing("rotZMatTag", things::MATERIAL),
            Arg::thing("rotXMatTag", things::MATERIAL),
            Arg::thing("rotYMatTag", things::MATERIAL),
        ])
        .groups(&[&LENGTHS, &WEIGHT, &TENSION]),
    make: Make::TwoNodes(make),
};

/// Effective radii and displacement limits of the inner, lower and upper surfaces.
pub(super) fn lengths(a: &mut Args<'_>) -> Result<([f64; 3], [f64; 3]), Exception> {
    let [l1, l2, l3, d1, d2, d3] = &LENGTHS;
    let l1 = a.number(l1)?;
    let mut outer = |arg: &Arg| -> Result<f64, Exception> {
        let (l, what) = (a.number(arg)?, arg.meaning.trim_start_matches("effective radius "));
        let refused = || a.refuse(format!("{what} is {l}"), format!("expected a radius greater than L1, {l1}"));
        if l > l1 { Ok(l) } else { Err(refused()) }
    };
    let l = [l1, outer(l2)?, outer(l3)?];
    Ok((l, [a.number(d1)?, a.number(d2)?, a.number(d3)?]))
}

/// Stiffness of all segments before sliding, from the first coefficient of friction and the yield displacement at `span`.
pub(super) fn stiffness(
    a: &Args<'_>,
    span: Option<Span>,
    mu: f64,
    uy: f64,
    [l1, l2, l3]: &[f64; 3],
) -> Result<f64, Exception> {
    let e = 3.0 * mu / uy;
    let softest = (0.5 / l1).max(1.0 / (l2 - l1)).max(1.0 / (l3 - l1));
    if e > softest {
        return Ok(e);
    }
    let limit = uy * e / softest;
    let message = format!("the yield displacement uy is {uy}: the bearing is not stiffer before sliding than in it");
    Err(a.refuse_at(span, message, format!("expected a displacement less than {limit:.4}")))
}

/// The segments, `inner` being the gap of the first.
pub(super) fn chain(e: f64, [l1, l2, l3]: &[f64; 3], [_, d2, d3]: &[f64; 3], inner: f64) -> Chain {
    let segment = |stiffness: f64, gap: f64, speed: f64| Segment { e, h: e * stiffness / (e - stiffness), gap, speed };
    Chain {
        segments: [
            segment(0.5 / l1, inner, 0.5),
            segment(1.0 / (l2 - l1), d2 * (1.0 - l1 / l2), l2 / (l2 - l1)),
            segment(1.0 / (l3 - l1), d3 * (1.0 - l1 / l3), l3 / (l3 - l1)),
        ],
    }
}

fn make(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    ends.need(a, (3, 6))?;
    let definitions = &interp.host.builder.definitions;
    let mut friction = || a.of(&definitions.frictions).map(|(f, _)| f);
    let frictions: [Friction; 3] = [friction()?, friction()?, friction()?];
    let mut material = || a.of(&definitions.materials);
    let materials: [(Material, i32); 4] = [material()?, material()?, material()?, material()?];
    let (l, d) = lengths(a)?;
    let [weight, uy] = a.numbers(&WEIGHT)?;
    let e = stiffness(a, a.last_span(), frictions[0].coefficient(weight, 0.0).mu, uy, &l)?;
    let [k_tension, least_normal, tolerance] = a.numbers(&TENSION)?;
    let chain = chain(e, &l, &d, 2.0 * (l[0] / l[2] * d[2] + d[0]));
    let height = ends.place.1.z - ends.place.0.z;
    let slips = [
        slips::TRIPLE_FRICTION,
        slips::TRIPLE_FORCE,
        slips::TRIPLE_TENSION,
        slips::TRIPLE_MOMENTS,
        slips::TRIPLE_TANGENT,
        slips::TRIPLE_RAYLEIGH,
    ];
    let setting = TripleSetting { weight, k_tension, least_normal, height, rules: Consistent };
    Ok(match interp.host.follows(&slips) {
        true => TriplePendulum::new(chain, frictions, materials, setting.with(Increments(tolerance))).shared(),
        false => TriplePendulum::new(chain, frictions, materials, setting).shared(),
    })
}

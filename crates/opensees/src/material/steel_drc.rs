//! `uniaxialMaterial SteelDRC`.

use super::Kind;
use crate::args::Args;
use crate::text::{Arg, Domain, Text};
use crate::{Tcl, ignore_unknown, slips};
use hysteron_engine::material::{BauschingerKind, Material, ReportedStiffness, SteelDrc};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;

const PSH: Arg = Arg::of("-Psh", "Psh", "exponent Psh of hardening").within(Domain::Positive);
const POINT: [Arg; 2] = [
    Arg::of("-shPoint", "esh1", "strain esh1 on the hardening curve").within(Domain::Number),
    Arg::of("-shPoint", "fsh1", "stress fsh1 there").within(Domain::Number),
];
const OMEGA_FAC: Arg =
    Arg::of("-omegaFactor", "omegaFac", "factor of the Bauschinger curves omegaFac").within(Domain::Positive);
const EFRACT: Arg = Arg::of("-fractStrain", "efract", "strain of fracture efract").within(Domain::Number);
const DAMPER: [Arg; 2] = [
    Arg::of("-viscousDamper", "C", "damping coefficient C").within(Domain::NotNegative),
    Arg::of("-viscousDamper", "alpha", "velocity exponent alpha").within(Domain::Positive),
];
const DFU: Arg = Arg::of("-Dfu", "Dfu", "length Dfu of the straight line after a reversal").within(Domain::Positive);

const SKELETON: [Arg; 5] = [
    Arg::positive("Es", "elastic modulus Es"),
    Arg::positive("fy", "yield stress fy"),
    Arg::positive("eu", "strain eu of the strength"),
    Arg::positive("fu", "strength fu"),
    Arg::positive("esh", "strain esh where hardening begins"),
];

pub(super) const KINDS: &[Kind] = &[Kind {
    names: &["SteelDRC"],
    usage: "uniaxialMaterial SteelDRC $tag $Es $fy $eu $fu $esh <-Psh $Psh> <-shPoint $esh1 $fsh1> <-omegaFactor $omegaFac> \
            <-fractStrain $efract> <-bausch $type> <-stiffOutput $type> <-viscousDamper $C $alpha> <-Dfu $Dfu>",
    text: Text::new(
        "Reinforcing bar as of `Dodd_Restrepo`, with curves that rejoin the skeleton and softening before \
         fracture.",
    )
    .example("uniaxialMaterial SteelDRC 77 1 1 1 1 0.5")
    .arguments(&[
        PSH,
        OMEGA_FAC,
        EFRACT,
        Arg::of("-bausch", "type", "Bauschinger curves: 0 power, 1 cubic, 2 rational").within(Domain::Whole),
        Arg::of(
            "-stiffOutput",
            "type",
            "stiffness: 0 tangent, 1 secant from the last reversal if that is more, 2 elastic",
        )
        .within(Domain::Whole),
        DFU,
    ])
    .groups(&[&SKELETON, &POINT, &DAMPER]),
    make: steel_drc,
}];

fn steel_drc(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [e, fy, eu, fu, hardening] = a.numbers(&SKELETON)?;
    if hardening >= eu {
        return Err(a.refuse(format!("the strain esh is {hardening}"), format!("expected less than eu, {eu}")));
    }
    let mut law = SteelDrc {
        e,
        fy,
        hardening,
        ultimate: [eu, fu],
        power: 3.0,
        fracture: None,
        omega: 1.0,
        straight: 1.0,
        curve: BauschingerKind::Bezier,
        stiffness: ReportedStiffness::Tangent,
        viscous: [0.0, 1.0],
        compat: interp.host.follows(&[slips::STEEL_DRC_STIFFNESS]),
    };
    let mut point = [0.0; 2];
    while let Some(option) = a.option() {
        match option.to_lowercase().as_str() {
            "-psh" => law.power = a.number(&PSH)?,
            "-shpoint" => point = a.numbers(&POINT)?,
            "-omegafactor" | "-omegafac" => law.omega = a.number(&OMEGA_FAC)?,
            "-fractstrain" => law.fracture = Some(a.number(&EFRACT)?).filter(|x| *x != -1.0),
            "-bausch" => law.curve = curve(a)?,
            "-stiffoutput" => law.stiffness = stiffness(a)?,
            "-viscousdamper" => law.viscous = a.numbers(&DAMPER)?,
            "-dfu" => law.straight = a.number(&DFU)?,
            _ => ignore_unknown(interp, a)?,
        }
    }
    if let Some(fracture) = law.fracture.filter(|x| *x <= eu) {
        let label = format!("expected more than eu, {eu}");
        return Err(a.refuse(format!("the strain of fracture is {fracture}"), label));
    }
    if point[0] != 0.0 && point[1] != 0.0 {
        law.power = law.power_through(point);
        if !law.power.is_finite() {
            return Err(a.refuse("no hardening curve goes through the point", "expected a point between esh and eu"));
        }
    }
    Ok(law.shared())
}

fn curve(a: &mut Args<'_>) -> Result<BauschingerKind, Exception> {
    match a.int("type of the Bauschinger curves")? {
        0 => Ok(BauschingerKind::Power),
        1 => Ok(BauschingerKind::Bezier),
        2 => Ok(BauschingerKind::Rational),
        n => Err(a.refuse(format!("there is no curve {n}"), "expected 0 (power), 1 (cubic) or 2 (rational)")),
    }
}

fn stiffness(a: &mut Args<'_>) -> Result<ReportedStiffness, Exception> {
    match a.int("type of the stiffness")? {
        0 => Ok(ReportedStiffness::Tangent),
        1 => Ok(ReportedStiffness::Secant),
        2 => Ok(ReportedStiffness::Elastic),
        n => Err(a.refuse(format!("there is no stiffness {n}"), "expected 0 (tangent), 1 (secant) or 2 (elastic)")),
    }
}

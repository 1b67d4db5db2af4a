//! Materials whose strength and stiffness deteriorate with cycles.

use super::Kind;
use super::by_rules::by_rules;
use crate::args::Args;
use crate::checks;
use crate::slips;
use crate::text::{Arg, Text};
use crate::{Tcl, warn};
use hysteron_engine::material::{
    Damage, ImkBilin, ImkDeterioration, ImkPeakOriented, ImkPinching, ImkSide, Material, Pinching, Pinching4,
    Pinching4Parameters, Pinching4Side,
};
use hysteron_engine::rules::Consistent;
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::Diagnostic;

const G_E: Arg = Arg::number("gE", "energy capacity gE divided by the energy under monotonic loading");
const DMG_TYPE: Arg = Arg::new("dmgType", "damage by energy or cycle");

const KE: Arg = Arg::positive("Ke", "elastic stiffness Ke");
const POSITIVE: [Arg; 6] = [
    Arg::number("dpPos", "deformation dp up to the cap on the positive side"),
    Arg::number("dpcPos", "deformation dpc beyond the cap on the positive side"),
    Arg::number("duPos", "ultimate deformation du on the positive side"),
    Arg::number("FyPos", "yield strength Fy on the positive side"),
    Arg::positive("FmaxFyPos", "ratio FmaxFy of the largest strength on the positive side"),
    Arg::not_negative("FresFyPos", "ratio FresFy of the residual strength on the positive side"),
];
const NEGATIVE: [Arg; 6] = [
    Arg::number("dpNeg", "deformation dp up to the cap on the negative side"),
    Arg::number("dpcNeg", "deformation dpc beyond the cap on the negative side"),
    Arg::number("duNeg", "ultimate deformation du on the negative side"),
    Arg::number("FyNeg", "yield strength Fy on the negative side"),
    Arg::positive("FmaxFyNeg", "ratio FmaxFy of the largest strength on the negative side"),
    Arg::not_negative("FresFyNeg", "ratio FresFy of the residual strength on the negative side"),
];
const CAPACITIES: [Arg; 4] = [
    Arg::number("LambdaS", "cumulative deformation capacity Lambda of the strength"),
    Arg::number("LambdaC", "cumulative deformation capacity Lambda of the strength beyond the cap"),
    Arg::number("LambdaA", "cumulative deformation capacity Lambda of the reloading stiffness"),
    Arg::number("LambdaK", "cumulative deformation capacity Lambda of the unloading stiffness"),
];
const RATES: [Arg; 4] = [
    Arg::number("cS", "rate of deterioration c of the strength"),
    Arg::number("cC", "rate of deterioration c of the strength beyond the cap"),
    Arg::number("cA", "rate of deterioration c of the reloading stiffness"),
    Arg::number("cK", "rate of deterioration c of the unloading stiffness"),
];
/// Capacities and rates of the bilinear hinge, which does not reload towards a peak.
const BILINEAR_CAPACITIES: [Arg; 3] = [CAPACITIES[0], CAPACITIES[1], CAPACITIES[3]];
const BILINEAR_RATES: [Arg; 3] = [RATES[0], RATES[1], RATES[3]];
pub(super) const SIDES: [Arg; 2] = [
    Arg::not_negative("DPos", "rate of cyclic deterioration D on the positive side"),
    Arg::not_negative("DNeg", "rate of cyclic deterioration D on the negative side"),
];
const PINCHING: [Arg; 2] = [
    Arg::number("kappaF", "ratio kappaF of the force at the end of pinching"),
    Arg::number("kappaD", "ratio kappaD of the deformation at the end of pinching"),
];

pub(super) const KINDS: &[Kind] = &[
    Kind {
        names: &["Pinching4"],
        usage: "uniaxialMaterial Pinching4 $tag $f1p $d1p $f2p $d2p $f3p $d3p $f4p $d4p \
                <$f1n $d1n $f2n $d2n $f3n $d3n $f4n $d4n> $rDispP $rForceP $uForceP <$rDispN $rForceN $uForceN> \
                $gK1 $gK2 $gK3 $gK4 $gKLim $gD1 $gD2 $gD3 $gD4 $gDLim $gF1 $gF2 $gF3 $gF4 $gFLim $gE $dmgType",
        text: Text::new(
            "Pinched hysteresis between envelopes of four points, with damage of stiffness, reloading and strength.",
        )
        .example(
            "uniaxialMaterial Pinching4 77 1.5 0.01 2. 0.02 2.2 0.05 0.5 0.09 -1.2 -0.008 -1.8 -0.025 -2. -0.04 \
             -0.4 -0.1 0.5 0.25 0.05 0.4 0.3 -0.1 0.2 0.1 0.3 0.2 0.9 0.1 0.2 0.5 1. 0.5 0.1 0.1 1. 1. 0.3 10. \
             energy",
        )
        .points([["stress", "f"], ["strain", "d"]])
        .arguments(&[
Arg::number("f1p", "stress 1 on the positive side"),
Arg::number("d1p", "strain 1 on the positive side"),
Arg::number("f2p", "stress 2 on the positive side"),
Arg::number("d2p", "strain 2 on the positive side"),
Arg::number("f3p", "stress 3 on the positive side"),
Arg::number("d3p", "strain 3 on the positive side"),
Arg::number("f4p", "stress 4 on the positive side"),
Arg::number("d4p", "strain 4 on the positive side"),
Arg::new("f1n", "stress 1 on the negative side, negative"),
Arg::new("d1n", "strain 1 on the negative side, negative"),
Arg::new("f2n", "stress 2 on the negative side, negative"),
Arg::new("d2n", "strain 2 on the negative side, negative"),
Arg::new("f3n", "stress 3 on the negative side, negative"),
Arg::new("d3n", "strain 3 on the negative side, negative"),
Arg::new("f4n", "stress 4 on the negative side, negative"),
Arg::new("d4n", "strain 4 on the negative side, negative"),
Arg::number("rDispP", "share of the largest strain at the begin of reloading on the positive side"),
Arg::number("rForceP", "share of the stress at the begin of reloading on the positive side"),
Arg::number("uForceP", "share of the strength at the end of unloading on the positive side"),
Arg::new("rDispN", "share of the largest strain at the begin of reloading, negative side"),
Arg::new("rForceN", "share of the stress at the begin of reloading, negative side"),
Arg::new("uForceN", "share of the strength at the end of unloading, negative side"),
Arg::number("gK1", "coefficient 1 of the damage of the unloading stiffness"),
Arg::number("gK2", "coefficient 2 of the damage of the unloading stiffness"),
Arg::number("gK3", "exponent 3 of the damage of the unloading stiffness"),
Arg::number("gK4", "exponent 4 of the damage of the unloading stiffness"),
Arg::number("gKLim", "limit of the damage of the unloading stiffness"),
Arg::number("gD1", "coefficient 1 of the damage of the reloading strain"),
Arg::number("gD2", "coefficient 2 of the damage of the reloading strain"),
Arg::number("gD3", "exponent 3 of the damage of the reloading strain"),
Arg::number("gD4", "exponent 4 of the damage of the reloading strain"),
Arg::number("gDLim", "limit of the damage of the reloading strain"),
Arg::number("gF1", "coefficient 1 of the damage of the strength"),
Arg::number("gF2", "coefficient 2 of the damage of the strength"),
Arg::number("gF3", "exponent 3 of the damage of the strength"),
Arg::number("gF4", "exponent 4 of the damage of the strength"),
Arg::number("gFLim", "limit of the damage of the strength"),
G_E,
DMG_TYPE,
]),
        make: pinching4,
    },
    Kind {
        names: &["IMKBilin"],
        usage: "uniaxialMaterial IMKBilin $tag $Ke $dpPos $dpcPos $duPos $FyPos $FmaxFyPos $FresFyPos \
                $dpNeg $dpcNeg $duNeg $FyNeg $FmaxFyNeg $FresFyNeg $LambdaS $LambdaC $LambdaK $cS $cC $cK $DPos $DNeg",
        text: Text::new("Plastic hinge that deteriorates, bilinear (Ibarra, Medina and Krawinkler; RESSLab).").example(
            "uniaxialMaterial IMKBilin 77 200. 0.04 0.15 0.3 2. 1.1 0.4 0.05 0.2 0.4 1.8 1.05 0.3 3. 4. 5. 1. 1. 1. 1. \
             0.8",
        ).groups(&[&[KE], &POSITIVE, &NEGATIVE, &BILINEAR_CAPACITIES, &BILINEAR_RATES, &SIDES]),
        make: imk_bilin,
    },
    Kind {
        names: &["IMKPeakOriented"],
        usage: "uniaxialMaterial IMKPeakOriented $tag $Ke $dpPos $dpcPos $duPos $FyPos $FmaxFyPos $FresFyPos \
                $dpNeg $dpcNeg $duNeg $FyNeg $FmaxFyNeg $FresFyNeg $LambdaS $LambdaC $LambdaA $LambdaK \
                $cS $cC $cA $cK $DPos $DNeg",
        text: Text::new("Plastic hinge that deteriorates, peak-oriented (Ibarra, Medina and Krawinkler; RESSLab).")
            .example(
                "uniaxialMaterial IMKPeakOriented 77 200. 0.04 0.15 0.3 2. 1.1 0.4 0.05 0.2 0.4 1.8 1.05 0.3 3. 4. 5. \
                 6. 1. 1. 1. 1. 1. 0.8",
            ).groups(&[&[KE], &POSITIVE, &NEGATIVE, &CAPACITIES, &RATES, &SIDES]),
        make: imk_peak_oriented,
    },
    Kind {
        names: &["IMKPinching"],
        usage: "uniaxialMaterial IMKPinching $tag $Ke $dpPos $dpcPos $duPos $FyPos $FmaxFyPos $FresFyPos \
                $dpNeg $dpcNeg $duNeg $FyNeg $FmaxFyNeg $FresFyNeg $LambdaS $LambdaC $LambdaA $LambdaK \
                $cS $cC $cA $cK $DPos $DNeg $kappaF $kappaD",
        text: Text::new("Plastic hinge that deteriorates, pinched (Ibarra, Medina and Krawinkler; RESSLab).").example(
            "uniaxialMaterial IMKPinching 77 200. 0.04 0.15 0.3 2. 1.1 0.4 0.05 0.2 0.4 1.8 1.05 0.3 3. 4. 5. 6. 1. 1. \
             1. 1. 1. 0.8 0.4 0.6",
        ).groups(&[&[KE], &POSITIVE, &NEGATIVE, &CAPACITIES, &RATES, &SIDES, &PINCHING]),
        make: imk_pinching,
    },
];

/// Words of `Pinching4` with one envelope for both sides.
const SYMMETRIC_WORDS: usize = 28;

/// Names of the damage by energy and by cycles.
const BY_ENERGY: [&str; 4] = ["energy", "Energy", "DamageEnergy", "damageEnergy"];
const BY_CYCLES: [&str; 4] = ["cycle", "Cycle", "DamageCycle", "damageCycle"];

/// Stresses and strains of an envelope; `s` is the sign of its strains.
fn four_points(interp: &mut Tcl, a: &mut Args<'_>, s: f64) -> Result<[[f64; 4]; 2], Exception> {
    let side = if s > 0.0 { "positive" } else { "negative" };
    let mut points = [[0.0; 4]; 2];
    for i in 0..4 {
        points[0][i] = s * a.float(&format!("stress {} on the {side} side", i + 1))?;
        points[1][i] = s * a.float(&format!("strain {} on the {side} side", i + 1))?;
        let (strain, before) = (points[1][i], if i == 0 { 0.0 } else { points[1][i - 1] });
        if strain <= 0.0 {
            let message = format!("strain {} on the {side} side is {}", i + 1, s * strain);
            return Err(a.refuse(message, format!("expected a {side} strain")));
        }
        if strain <= before {
            let message = format!("strain {} on the {side} side is not beyond strain {i}", i + 1);
            warn(
                interp,
                Diagnostic::warning(&checks::materials::UNUSUAL_PARAMETER, message)
                    .at(a.last_span(), "expected strains that go away from zero"),
            )?;
        }
    }
    Ok(points)
}

/// Reloading and unloading of a side.
fn pinching(a: &mut Args<'_>, side: &str) -> Result<[f64; 3], Exception> {
    Ok([
        a.float(&format!("share of the largest strain at the begin of reloading on the {side} side"))?,
        a.float(&format!("share of the stress at the begin of reloading on the {side} side"))?,
        a.float(&format!("share of the strength at the end of unloading on the {side} side"))?,
    ])
}

fn damage(a: &mut Args<'_>, what: &str) -> Result<Damage, Exception> {
    let mut number = |name: &str| a.float(&format!("{name} of the damage of the {what}"));
    let rate = [number("coefficient 1")?, number("coefficient 2")?];
    let exponent = [number("exponent 3")?, number("exponent 4")?];
    Ok(Damage { rate, exponent, limit: number("limit")? })
}

fn pinching4(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let symmetric = a.left() <= SYMMETRIC_WORDS;
    let positive = four_points(interp, a, 1.0)?;
    let negative = if symmetric { positive } else { four_points(interp, a, -1.0)? };
    let forward = pinching(a, "positive")?;
    let backward = if symmetric { forward } else { pinching(a, "negative")? };
    let side = |[stress, strain]: [[f64; 4]; 2], [reloading_strain, reloading_stress, unloading_stress]: [f64; 3]| {
        Pinching4Side { stress, strain, reloading_strain, reloading_stress, unloading_stress }
    };
    let sides = [side(positive, forward), side(negative, backward)];
    let [stiffness, reloading, strength] =
        [damage(a, "unloading stiffness")?, damage(a, "reloading strain")?, damage(a, "strength")?];
    let energy = a.number(&G_E)?;
    let word = a.word(DMG_TYPE.meaning)?;
    let by_cycles = BY_CYCLES.contains(&word.as_ref());
    if !by_cycles && !BY_ENERGY.contains(&word.as_ref()) {
        return Err(a.refuse(format!("the kind of damage is \"{word}\""), "expected energy or cycle"));
    }
    let given = Pinching4Parameters { sides, stiffness, reloading, strength, linear_strength: None, energy, by_cycles };
    Ok(match interp.host.follows(&[slips::PINCHING_TRIALS]) {
        true => Pinching4::as_opensees(given).shared(),
        false => Pinching4::new(given).shared(),
    })
}

/// Elastic stiffness and both backbones, without their rates of deterioration.
fn backbones(interp: &mut Tcl, a: &mut Args<'_>) -> Result<(f64, [ImkSide; 2]), Exception> {
    let ke = a.read(interp, &KE)?;
    let mut side = |[plastic, post_capping, ultimate, strength, peak, residual]: &[Arg; 6], either: bool| {
        let mut positive = |arg: &Arg| {
            let x = a.read(interp, arg)?;
            let x = if either { x.abs() } else { x };
            let message = || format!("{} is {x}", arg.meaning);
            if x > 0.0 { Ok(x) } else { Err(a.refuse(message(), "expected a number greater than 0")) }
        };
        let [plastic, post_capping] = [positive(plastic)?, positive(post_capping)?];
        let [ultimate, strength] = [positive(ultimate)?, positive(strength)?];
        let (peak, residual) = (a.read(interp, peak)?, a.read(interp, residual)?);
        Ok::<_, Exception>(ImkSide { plastic, post_capping, ultimate, strength, peak, residual, rate: 1.0 })
    };
    // OpenSees takes the negative side with either sign.
    let sides = [side(&POSITIVE, false)?, side(&NEGATIVE, true)?];
    Ok((ke, sides))
}

/// Capacities and rates of the modes of deterioration, and the rates of both sides.
fn deterioration<const N: usize>(
    interp: &mut Tcl,
    a: &mut Args<'_>,
    [capacities, rates]: [&[Arg; N]; 2],
    sides: &mut [ImkSide; 2],
) -> Result<[ImkDeterioration; N], Exception> {
    let (capacities, exponents) = (a.read_all(interp, capacities)?, a.read_all(interp, rates)?);
    for (side, rate) in sides.iter_mut().zip(a.read_all(interp, &SIDES)?) {
        side.rate = rate;
    }
    Ok(std::array::from_fn(|i| ImkDeterioration { capacity: capacities[i], exponent: exponents[i] }))
}

fn imk_bilin(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let (ke, mut sides) = backbones(interp, a)?;
    let modes = [&BILINEAR_CAPACITIES, &BILINEAR_RATES];
    let [strength, capping, stiffness] = deterioration(interp, a, modes, &mut sides)?;
    Ok(by_rules!(interp, slips::IMK_TANGENT, rules => ImkBilin { ke, sides, strength, capping, stiffness, rules }))
}

/// The hinge of `IMKPeakOriented` and `IMKPinching`.
fn peak_oriented(interp: &mut Tcl, a: &mut Args<'_>) -> Result<ImkPeakOriented, Exception> {
    let (ke, mut sides) = backbones(interp, a)?;
    let [strength, capping, reloading, stiffness] = deterioration(interp, a, [&CAPACITIES, &RATES], &mut sides)?;
    Ok(ImkPeakOriented { ke, sides, strength, capping, reloading, stiffness, rules: Consistent })
}

fn imk_peak_oriented(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let hinge = peak_oriented(interp, a)?;
    Ok(by_rules!(interp, slips::IMK_TANGENT, rules => hinge.with(rules)))
}

fn imk_pinching(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let hinge = peak_oriented(interp, a)?;
    let [force, deformation] = a.read_all(interp, &PINCHING)?;
    let pinching = Pinching { force, deformation };
    Ok(by_rules!(interp, slips::IMK_TANGENT, rules => ImkPinching { hinge: hinge.with(rules), pinching }))
}

//! Hysteretic materials.

use super::Kind;
use super::by_rules::by_rules;
use super::deteriorating::SIDES;
use crate::args::Args;
use crate::checks;
use crate::slips;
use crate::text::{Arg, Domain, Text};
use crate::{Tcl, warn};
use hysteron_engine::material::{
    Bilin, BilinSide, BoucWen, Deterioration, Envelope, Hysteretic, Material, ModImkPeakOriented, ModImkPinching,
    PinchingPoint, Saws, SawsParameters, SelfCentering,
};
use hysteron_engine::rules::Consistent;
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::Diagnostic;

/// Points of an envelope in tension and in compression. A third one may be left out.
pub(super) const ENVELOPE: [[Arg; 6]; 2] = [
    [
        Arg::number("s1p", "stress 1 in tension"),
        Arg::number("e1p", "strain 1 in tension"),
        Arg::number("s2p", "stress 2 in tension"),
        Arg::number("e2p", "strain 2 in tension"),
        Arg::number("s3p", "stress 3 in tension"),
        Arg::number("e3p", "strain 3 in tension"),
    ],
    [
        Arg::number("s1n", "stress 1 in compression"),
        Arg::number("e1n", "strain 1 in compression"),
        Arg::number("s2n", "stress 2 in compression"),
        Arg::number("e2n", "strain 2 in compression"),
        Arg::number("s3n", "stress 3 in compression"),
        Arg::number("e3n", "strain 3 in compression"),
    ],
];
pub(super) const PINCHING_AND_DAMAGE: [Arg; 4] = [
    Arg::number("pinchX", "pinching factor of strain pinchX"),
    Arg::number("pinchY", "pinching factor of stress pinchY"),
    Arg::number("damage1", "damage by ductility damage1"),
    Arg::number("damage2", "damage by energy damage2"),
];

const BOUC_WEN: [Arg; 9] = [
    Arg::number("alpha", "ratio of post-yield stiffness alpha"),
    Arg::positive("ko", "elastic stiffness ko"),
    Arg::positive("n", "exponent n"),
    Arg::number("gamma", "gamma"),
    Arg::number("beta", "beta"),
    Arg::number("Ao", "Ao"),
    Arg::number("deltaA", "deltaA"),
    Arg::number("deltaNu", "deltaNu"),
    Arg::number("deltaEta", "deltaEta"),
];

const WALL: [Arg; 6] = [
    Arg::positive("F0", "force F0 where the asymptote of the envelope meets zero displacement"),
    Arg::not_negative("FI", "force FI of the pinched line at zero displacement"),
    Arg::positive("DU", "displacement DU at the largest force"),
    Arg::positive("S0", "initial stiffness S0"),
    Arg::number("R1", "ratio R1 of the stiffness of the asymptote"),
    Arg::number("R2", "ratio R2 of the softening stiffness"),
];
const UNLOADING: [Arg; 2] = [
    Arg::positive("R3", "ratio R3 of the unloading stiffness"),
    Arg::not_negative("R4", "ratio R4 of the pinched stiffness"),
];
const DEGRADATION: [Arg; 2] = [
    Arg::not_negative("alpha", "softening alpha of the reloading stiffness"),
    Arg::positive("beta", "growth beta of the displacement"),
];

const FLAG: [Arg; 4] = [
    Arg::positive("k1", "initial stiffness k1"),
    Arg::number("k2", "stiffness after activation k2"),
    Arg::positive("sigAct", "stress at activation sigAct"),
    Arg::not_negative("beta", "height of the flag beta"),
];
const EPS_SLIP: Arg = Arg::number("epsSlip", "strain at slip epsSlip");
const EPS_BEAR: Arg = Arg::number("epsBear", "strain at bearing epsBear");
const R_BEAR: Arg = Arg::number("rBear", "ratio of bearing stiffness rBear");

const HINGE: [Arg; 3] = [
    Arg::positive("Ke", "elastic stiffness Ke"),
    Arg::number("AsPos", "hardening ratio As on the positive side"),
    Arg::number("AsNeg", "hardening ratio As on the negative side"),
];
const STRENGTH: [Arg; 2] = [
    Arg::positive("MyPos", "yield strength My on the positive side"),
    Arg::of_domain("MyNeg", "yield strength My on the negative side", Domain::Negative),
];
const PINCHING: [Arg; 3] = [
    Arg::number("FprPos", "share Fpr of the largest force at the end of pinching on the positive side"),
    Arg::number("FprNeg", "share Fpr of the largest force at the end of pinching on the negative side"),
    Arg::number("APinch", "share APinch of the permanent deformation at the end of pinching"),
];
const CAPACITIES: [Arg; 4] = [
    Arg::not_negative("LambdaS", "cumulative rotation capacity Lambda of the strength"),
    Arg::not_negative("LambdaC", "cumulative rotation capacity Lambda of the strength beyond the cap"),
    Arg::not_negative("LambdaA", "cumulative rotation capacity Lambda of the accelerated stiffness"),
    Arg::not_negative("LambdaK", "cumulative rotation capacity Lambda of the unloading stiffness"),
];
const RATES: [Arg; 4] = [
    Arg::not_negative("cS", "rate of deterioration c of the strength"),
    Arg::not_negative("cC", "rate of deterioration c of the strength beyond the cap"),
    Arg::not_negative("cA", "rate of deterioration c of the accelerated stiffness"),
    Arg::not_negative("cK", "rate of deterioration c of the unloading stiffness"),
];
const CAP: [Arg; 6] = [
    Arg::not_negative("thetaPPos", "plastic rotation up to the cap thetaP on the positive side"),
    Arg::not_negative("thetaPNeg", "plastic rotation up to the cap thetaP on the negative side"),
    Arg::positive("thetaPCPos", "rotation beyond the cap thetaPC on the positive side"),
    Arg::positive("thetaPCNeg", "rotation beyond the cap thetaPC on the negative side"),
    Arg::not_negative("resPos", "residual strength ratio on the positive side"),
    Arg::not_negative("resNeg", "residual strength ratio on the negative side"),
];
const ENDS: [Arg; 4] = [
    Arg::positive("thetaUPos", "ultimate rotation thetaU on the positive side"),
    Arg::positive("thetaUNeg", "ultimate rotation thetaU on the negative side"),
    SIDES[0],
    SIDES[1],
];
const N_FACTOR: Arg = Arg::number("nFactor", "stiffness factor nFactor");
/// Numbers of the hinges of the modified Ibarra-Medina-Krawinkler laws.
const MODIFIED: &[&[Arg]] = &[&HINGE, &STRENGTH, &CAPACITIES, &RATES, &CAP, &ENDS, &[N_FACTOR]];

/// Numbers that the bilinear law takes and does not use.
const UNUSED: &[Arg] = &[
    Arg::new("LambdaA", "rotation capacity of the accelerated deterioration, without part in this law"),
    Arg::new("cA", "exponent of the accelerated deterioration, without part in this law"),
];

/// OpenSees' names of force and deformation at the points of an envelope.
pub(super) const POINTS: [[&str; 2]; 2] = [["mom", "s"], ["rot", "e"]];
pub(super) const UNLOADING_EXPONENT: Arg = Arg::number("beta", "exponent of the unloading stiffness beta");

pub(super) const KINDS: &[Kind] = &[
    Kind {
        names: &["Bilin", "BilinMaterial"],
        usage: "uniaxialMaterial Bilin $tag $Ke $AsPos $AsNeg $MyPos $MyNeg $LambdaS $LambdaC $LambdaA $LambdaK \
                $cS $cC $cA $cK $thetaPPos $thetaPNeg $thetaPCPos $thetaPCNeg $resPos $resNeg $thetaUPos $thetaUNeg \
                $DPos $DNeg <$nFactor>",
        text: Text::new("Plastic hinge of a steel beam that deteriorates (modified Ibarra, Medina and Krawinkler).")
            .example(
                "uniaxialMaterial Bilin 77 200. 0.03 0.02 2. -1.8 3. 4. 3. 5. 1. 1. 1. 1. 0.04 0.05 0.15 0.2 0.3 \
                 0.4 0.5 0.5 1. 0.8 0.",
            )
            .arguments(UNUSED)
            .groups(MODIFIED),
        make: bilin,
    },
    Kind {
        names: &["Bilin02"],
        usage: "uniaxialMaterial Bilin02 $tag $Ke $AsPos $AsNeg $MyPos $MyNeg $LambdaS $LambdaC $LambdaA $LambdaK \
                $cS $cC $cA $cK $thetaPPos $thetaPNeg $thetaPCPos $thetaPCNeg $resPos $resNeg $thetaUPos $thetaUNeg \
                $DPos $DNeg <$nFactor>",
        text: Text::new("As `Bilin`, with a constant slope beyond the cap.")
            .example(
                "uniaxialMaterial Bilin02 77 200. 0.03 0.02 2. -1.8 3. 4. 3. 5. 1. 1. 1. 1. 0.04 0.05 0.15 0.2 0.3 \
                 0.4 0.5 0.5 1. 0.8 0.",
            )
            .arguments(UNUSED)
            .groups(MODIFIED),
        make: bilin02,
    },
    Kind {
        names: &["ModIMKPeakOriented"],
        usage: "uniaxialMaterial ModIMKPeakOriented $tag $Ke $AsPos $AsNeg $MyPos $MyNeg $LambdaS $LambdaC $LambdaA \
                $LambdaK $cS $cC $cA $cK $thetaPPos $thetaPNeg $thetaPCPos $thetaPCNeg $resPos $resNeg $thetaUPos \
                $thetaUNeg $DPos $DNeg <$nFactor>",
        text: Text::new("Plastic hinge that deteriorates, peak-oriented (modified Ibarra, Medina and Krawinkler).")
            .example(
                "uniaxialMaterial ModIMKPeakOriented 77 200. 0.03 0.02 2. -1.8 3. 4. 3. 5. 1. 1. 1. 1. 0.04 0.05 \
                 0.15 0.2 0.3 0.4 0.5 0.5 1. 0.8 0.",
            )
            .groups(MODIFIED),
        make: mod_imk_peak_oriented,
    },
    Kind {
        names: &["ModIMKPinching"],
        usage: "uniaxialMaterial ModIMKPinching $tag $Ke $AsPos $AsNeg $MyPos $MyNeg $FprPos $FprNeg $APinch $LambdaS \
                $LambdaC $LambdaA $LambdaK $cS $cC $cA $cK $thetaPPos $thetaPNeg $thetaPCPos $thetaPCNeg $resPos $resNeg \
                $thetaUPos $thetaUNeg $DPos $DNeg <$nFactor>",
        text: Text::new("Plastic hinge that deteriorates, pinched (modified Ibarra, Medina and Krawinkler).")
            .example(
                "uniaxialMaterial ModIMKPinching 77 200. 0.03 0.02 2. -1.8 0.4 0.5 0.3 3. 4. 3. 5. 1. 1. 1. 1. 0.04 \
                 0.05 0.15 0.2 0.3 0.4 0.5 0.5 1. 0.8 0.",
            )
            .groups(&[&HINGE, &STRENGTH, &PINCHING, &CAPACITIES, &RATES, &CAP, &ENDS, &[N_FACTOR]]),
        make: mod_imk_pinching,
    },
    Kind {
        names: &["BoucWen"],
        usage: "uniaxialMaterial BoucWen $tag $alpha $ko $n $gamma $beta $Ao $deltaA $deltaNu $deltaEta",
        text: Text::new("Bouc-Wen hysteresis with degradation (Baber and Noori).")
            .example("uniaxialMaterial BoucWen 77 1 1 1 1 1 1 1 1 1")
            .groups(&[&BOUC_WEN]),
        make: bouc_wen,
    },
    Kind {
        names: &["Hysteretic"],
        usage: "uniaxialMaterial Hysteretic $tag $s1p $e1p $s2p $e2p <$s3p $e3p> $s1n $e1n $s2n $e2n <$s3n $e3n> \
                $pinchX $pinchY $damage1 $damage2 <$beta>",
        text: Text::new("Trilinear backbone with pinching and damage.")
            .example("uniaxialMaterial Hysteretic 77 1 1 1 2 -1 -1 1 -2 1 1 1 1")
            .points(POINTS)
            .groups(&[&ENVELOPE[0], &ENVELOPE[1], &PINCHING_AND_DAMAGE, &[UNLOADING_EXPONENT]]),
        make: hysteretic,
    },
    Kind {
        names: &["SAWS", "SAWSMaterial"],
        usage: "uniaxialMaterial SAWS $tag $F0 $FI $DU $S0 $R1 $R2 $R3 $R4 $alpha $beta",
        text: Text::new("Nailed wood shear wall (Folz and Filiatrault).")
            .example("uniaxialMaterial SAWS 77 1 1 1 1 1 -1 1 0.5 1 1")
            .groups(&[&WALL, &UNLOADING, &DEGRADATION]),
        make: saws,
    },
    Kind {
        names: &["SelfCentering"],
        usage: "uniaxialMaterial SelfCentering $tag $k1 $k2 $sigAct $beta <$epsSlip> <$epsBear> <$rBear>",
        text: Text::new("Flag-shaped hysteresis.")
            .example("uniaxialMaterial SelfCentering 77 1 1 1 1")
            .groups(&[&FLAG, &[EPS_SLIP, EPS_BEAR, R_BEAR]]),
        make: self_centering,
    },
];

/// Parameters of a hinge of the modified Ibarra-Medina-Krawinkler laws.
struct Hinge {
    ke: f64,
    sides: [BilinSide; 2],
    /// Deterioration of strength, strength beyond the cap, reloading stiffness and unloading stiffness.
    modes: [Deterioration; 4],
    n: f64,
    /// End of pinching.
    pinching: PinchingPoint,
}

fn hinge(interp: &mut Tcl, a: &mut Args<'_>, pinched: bool) -> Result<Hinge, Exception> {
    let [ke, hardening @ ..] = a.read_all(interp, &HINGE)?;
    if let Some(ratio) = hardening.into_iter().find(|r| *r >= 1.0) {
        return Err(a.refuse(format!("the hardening ratio is {ratio}"), "expected less than 1"));
    }
    let [positive, negative] = a.read_all(interp, &STRENGTH)?;
    let mut pinching = PinchingPoint { force: [1.0; 2], deformation: 0.0 };
    if pinched {
        [pinching.force[0], pinching.force[1], pinching.deformation] = a.read_all(interp, &PINCHING)?;
    }
    let (capacities, rates) = (a.read_all(interp, &CAPACITIES)?, a.read_all(interp, &RATES)?);
    let modes = std::array::from_fn(|i| Deterioration { capacity: capacities[i], exponent: rates[i] });
    let cap = a.read_all(interp, &CAP)?;
    if let Some(ratio) = cap[4..].iter().find(|r| **r > 1.0) {
        return Err(a.refuse(format!("the residual strength ratio is {ratio}"), "expected at most 1"));
    }
    let ends = a.read_all(interp, &ENDS)?;
    let n = a.read_or(interp, &N_FACTOR, 0.0)?;
    if n < 0.0 {
        return Err(a.refuse(format!("the stiffness factor nFactor is {n}"), "expected 0 or more"));
    }
    let sides = [0, 1].map(|i| BilinSide {
        strength: [positive, -negative][i],
        hardening: hardening[i],
        plastic: cap[i],
        post_capping: cap[2 + i],
        residual: cap[4 + i],
        ultimate: ends[i],
        rate: ends[2 + i],
    });
    Ok(Hinge { ke, sides, modes, n, pinching })
}

fn bilin(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    bilinear(interp, a, false)
}

fn bilin02(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    bilinear(interp, a, true)
}

fn bilinear(interp: &mut Tcl, a: &mut Args<'_>, steady_cap: bool) -> Result<Material, Exception> {
    // The deterioration of the accelerated stiffness has no part in bilinear hysteresis.
    let Hinge { ke, sides, modes: [strength, capping, _, stiffness], n, .. } = hinge(interp, a, false)?;
    Ok(
        by_rules!(interp, slips::BILIN_DETERIORATION, rules => Bilin { ke, sides, strength, capping, stiffness, n, steady_cap, rules }),
    )
}

/// The hinge of `ModIMKPeakOriented` and `ModIMKPinching`.
fn mod_imk(
    interp: &mut Tcl,
    a: &mut Args<'_>,
    pinched: bool,
) -> Result<(ModImkPeakOriented, PinchingPoint), Exception> {
    let Hinge { ke, sides, modes: [strength, capping, reloading, stiffness], n, pinching } = hinge(interp, a, pinched)?;
    let rules = Consistent;
    Ok((ModImkPeakOriented { ke, sides, strength, capping, reloading, stiffness, n, rules }, pinching))
}

fn mod_imk_peak_oriented(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let (hinge, _) = mod_imk(interp, a, false)?;
    Ok(by_rules!(interp, slips::MOD_IMK_DETERIORATION, rules => hinge.with(rules)))
}

fn mod_imk_pinching(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let (hinge, pinching) = mod_imk(interp, a, true)?;
    Ok(by_rules!(interp, slips::MOD_IMK_DETERIORATION, rules => ModImkPinching { hinge: hinge.with(rules), pinching }))
}

fn bouc_wen(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [alpha, ko, n, gamma, beta, ao, delta_a, delta_nu, delta_eta] = a.read_all(interp, &BOUC_WEN)?;
    let law = BoucWen { alpha, ko, n, gamma, beta, ao, delta_a, delta_nu, delta_eta };
    // Tolerance and number of iterations: the root is always found to round-off.
    a.optional_float("tolerance")?;
    a.optional_int("largest number of iterations")?;
    if law.beta + law.gamma <= 0.0 {
        let message = "BoucWen: beta + gamma is not greater than 0, so the hysteretic force is not bounded";
        warn(interp, Diagnostic::warning(&checks::materials::UNBOUNDED_FORCE, message).at(None, ""))?;
    }
    Ok(law.shared())
}

/// The envelope on one side; `s` is the sign of its strains.
pub(super) fn envelope(a: &mut Args<'_>, points: usize, s: f64) -> Result<Envelope, Exception> {
    let (mut stress, mut strain) = ([0.0; 3], [0.0; 3]);
    let (words, side) = if s > 0.0 { (&ENVELOPE[0], "in tension") } else { (&ENVELOPE[1], "in compression") };
    for i in 0..points {
        stress[i] = s * a.number(&words[2 * i])?;
        if i == 0 && stress[0] <= 0.0 {
            let message = format!("stress 1 {side} is {}", s * stress[0]);
            return Err(a.refuse(message, "expected a stress with the sign of the strains of its side"));
        }
        strain[i] = s * a.number(&words[2 * i + 1])?;
        let before = if i == 0 { 0.0 } else { strain[i - 1] };
        if strain[i] <= before {
            let message = format!("strain {} {side} is {}, not beyond {}", i + 1, s * strain[i], s * before);
            return Err(a.refuse(message, "expected strains that go away from zero"));
        }
    }
    Ok(if points == 3 {
        Envelope::new(stress, strain)
    } else {
        Envelope::bilinear([stress[0], stress[1]], [strain[0], strain[1]])
    })
}

fn hysteretic(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    // Two points a side with pinching and damage are 12 numbers, three are 16; beta may follow.
    let points = if a.left() <= 13 { 2 } else { 3 };
    let (tension, compression) = (envelope(a, points, 1.0)?, envelope(a, points, -1.0)?);
    let [pinch_x, pinch_y, damage1, damage2] = a.read_all(interp, &PINCHING_AND_DAMAGE)?;
    let (pinch, damage) = ([pinch_x, pinch_y], [damage1, damage2]);
    let beta = a.read_or(interp, &UNLOADING_EXPONENT, 0.0)?;
    Ok(Hysteretic::new(tension, compression, pinch, damage, beta).shared())
}

fn self_centering(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [k1, k2, activation, beta] = a.read_all(interp, &FLAG)?;
    if beta > 1.0 {
        return Err(a.refuse(format!("the height of the flag beta is {beta}"), "expected beta, 0 to 1"));
    }
    let slip = a.read_or(interp, &EPS_SLIP, 0.0)?;
    let bearing = a.read_or(interp, &EPS_BEAR, 0.0)?;
    let bearing_ratio = a.read_or(interp, &R_BEAR, 0.0)?;
    Ok(
        by_rules!(interp, slips::SELF_CENTERING_JUMP, rules => SelfCentering { k1, k2, activation, beta, slip, bearing, bearing_ratio, rules }),
    )
}

fn saws(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [fo, fi, du, so, r1, r2] = a.read_all(interp, &WALL)?;
    if r2 >= 0.0 {
        return Err(a.refuse(format!("the ratio R2 of the softening stiffness is {r2}"), "expected it negative"));
    }
    let [r3, r4] = a.read_all(interp, &UNLOADING)?;
    if r4 >= r3 {
        return Err(
            a.refuse(format!("the ratio R4 of the pinched stiffness is {r4}"), format!("expected less than R3, {r3}"))
        );
    }
    let [alpha, beta] = a.read_all(interp, &DEGRADATION)?;
    let wall = SawsParameters { fo, fi, du, so, r: [r1, r2, r3, r4], alpha, beta };
    let law = match interp.host.follows(&[slips::SAWS_ENVELOPE]) {
        true => Saws::as_opensees(wall).map(|w| w.shared()),
        false => Saws::new(wall).map(|w| w.shared()),
    };
    law.ok_or_else(|| {
        let message = "SAWS: the pinched line FI + R4 S0 u does not meet the envelope";
        a.refuse(message, "expected less FI or R4, so that it does before 2 DU")
    })
}

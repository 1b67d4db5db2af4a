//! Materials of pounding.

use super::Kind;
use crate::args::Args;
use crate::checks;
use crate::slips;
use crate::text::{Arg, Text};
use crate::{Tcl, warn};
use hysteron_engine::material::{HertzDamp, Impact, JankowskiImpact, Material, Ratchet, Teeth, ViscoelasticGap};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::Diagnostic;

const BILINEAR: [Arg; 2] =
    [Arg::positive("K1", "initial stiffness K1"), Arg::not_negative("K2", "secondary stiffness K2")];
const DELTA_Y: Arg = Arg::number("deltaY", "yield displacement deltaY");
const GAP: Arg = Arg::number("gap", "displacement gap at which contact begins");
const HERTZ: [Arg; 2] =
    [Arg::positive("Kh", "contact stiffness Kh"), Arg::not_negative("xiNorm", "normalised damping coefficient xiNorm")];
const JANKOWSKI: [Arg; 3] = [
    Arg::positive("Kh", "contact stiffness Kh"),
    Arg::not_negative("xi", "impact damping ratio xi"),
    Arg::not_negative("mEff", "effective mass mEff"),
];
const EXPONENT: Arg = Arg::number("n", "exponent n");
const KELVIN: [Arg; 2] = [Arg::positive("K", "stiffness K"), Arg::not_negative("C", "damping coefficient C")];
const STRUT: [Arg; 3] = [
    Arg::positive("E", "stiffness E"),
    Arg::positive("freeTravel", "free travel"),
    Arg::number("freeTravelInitial", "free travel at the beginning"),
];

pub(super) const KINDS: &[Kind] = &[
    Kind {
        names: &["ImpactMaterial", "Impact"],
        usage: "uniaxialMaterial ImpactMaterial $tag $K1 $K2 $deltaY $gap",
        text: Text::new("Pounding: a bilinear approximation of Hertz contact.")
            .example("uniaxialMaterial ImpactMaterial 77 1 1 1 1")
            .groups(&[&BILINEAR, &[DELTA_Y, GAP]]),
        make: impact,
    },
    Kind {
        names: &["HertzDamp", "Hertzdamp"],
        usage: "uniaxialMaterial HertzDamp $tag $Kh $xiNorm $gap <$n>",
        text: Text::new("Pounding: Hertz contact with a damping force.")
            .example("uniaxialMaterial HertzDamp 77 1 1 1")
            .groups(&[&HERTZ, &[GAP, EXPONENT]]),
        make: hertz_damp,
    },
    Kind {
        names: &["JankowskiImpact"],
        usage: "uniaxialMaterial JankowskiImpact $tag $Kh $xi $mEff $gap <$n>",
        text: Text::new("Pounding: Hertz contact, damped on approach (Jankowski).")
            .example("uniaxialMaterial JankowskiImpact 77 1 1 1 1")
            .groups(&[&JANKOWSKI, &[GAP, EXPONENT]]),
        make: jankowski,
    },
    Kind {
        names: &["ViscoelasticGap"],
        usage: "uniaxialMaterial ViscoelasticGap $tag $K $C $gap",
        text: Text::new("Contact with a spring and a dashpot, in compression alone.")
            .example("uniaxialMaterial ViscoelasticGap 77 1 1 1")
            .groups(&[&KELVIN, &[GAP]]),
        make: viscoelastic_gap,
    },
    Kind {
        names: &["Ratchet"],
        usage: "uniaxialMaterial Ratchet $tag $E $freeTravel $freeTravelInitial 1|2",
        text: Text::new("Strut that follows the closing of its ends and resists their opening.")
            .example("uniaxialMaterial Ratchet 77 200. 0.02 0.01 1")
            .groups(&[&STRUT]),
        make: ratchet,
    },
];

/// A displacement on the compression side; a positive one is turned, as OpenSees does.
fn compressive(interp: &mut Tcl, a: &mut Args<'_>, arg: &Arg) -> Result<f64, Exception> {
    let x = a.read(interp, arg)?;
    if x > 0.0 {
        let message = format!("the {} is {x}, which is in tension: {} is taken", arg.meaning, -x);
        warn(
            interp,
            Diagnostic::warning(&checks::words::REPLACED_VALUE, message)
                .at(a.last_span(), "expected a number not greater than 0"),
        )?;
    }
    Ok(-x.abs())
}

fn impact(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [k1, k2] = a.read_all(interp, &BILINEAR)?;
    if k2 > k1 {
        return Err(a.refuse(format!("K2 is {k2}"), format!("expected a stiffness from 0 to K1, {k1}")));
    }
    let delta_y = compressive(interp, a, &DELTA_Y)?;
    let gap = compressive(interp, a, &GAP)?;
    Ok(Impact { k1, k2, delta_y, gap, compat: interp.host.follows(&[slips::IMPACT_GAP]) }.shared())
}

fn exponent(interp: &mut Tcl, a: &mut Args<'_>) -> Result<f64, Exception> {
    let n = a.read_or(interp, &EXPONENT, 1.5)?;
    if n < 1.0 {
        return Err(a.refuse(format!("the exponent n is {n}"), "expected an exponent of at least 1"));
    }
    Ok(n)
}

fn hertz_damp(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [kh, xi] = a.read_all(interp, &HERTZ)?;
    let gap = compressive(interp, a, &GAP)?;
    let n = exponent(interp, a)?;
    Ok(HertzDamp { kh, xi, gap, n, compat: interp.host.follows(&[slips::IMPACT_TANGENT]) }.shared())
}

fn jankowski(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [kh, xi, mass] = a.read_all(interp, &JANKOWSKI)?;
    let gap = compressive(interp, a, &GAP)?;
    let n = exponent(interp, a)?;
    Ok(JankowskiImpact { kh, xi, mass, gap, n, compat: interp.host.follows(&[slips::IMPACT_TANGENT]) }.shared())
}

fn viscoelastic_gap(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [k, c] = a.read_all(interp, &KELVIN)?;
    Ok(ViscoelasticGap { k, c, gap: compressive(interp, a, &GAP)? }.shared())
}

fn ratchet(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [e, travel, first] = a.read_all(interp, &STRUT)?;
    let teeth = match a.int("kind of ratchet")? {
        1 => Teeth::Spaced,
        2 => Teeth::Continuous,
        n => return Err(a.refuse(format!("there is no ratchet {n}"), "expected 1 (teeth) or 2 (none)")),
    };
    Ok(Ratchet { e, travel, first, teeth }.shared())
}

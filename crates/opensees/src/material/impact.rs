//! Materials of pounding.

use super::Kind;
use crate::args::Args;
use crate::checks;
use crate::slips;
use crate::text::Text;
use crate::{Tcl, warn};
use hysteron_engine::material::{HertzDamp, Impact, JankowskiImpact, Material, Ratchet, Teeth, ViscoelasticGap};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::Diagnostic;

pub(super) const KINDS: &[Kind] = &[
    Kind {
        names: &["ImpactMaterial", "Impact"],
        usage: "uniaxialMaterial ImpactMaterial $tag $K1 $K2 $deltaY $gap",
        text: Text::new("Pounding: a bilinear approximation of Hertz contact."),
        make: impact,
    },
    Kind {
        names: &["HertzDamp", "Hertzdamp"],
        usage: "uniaxialMaterial HertzDamp $tag $Kh $xiNorm $gap <$n>",
        text: Text::new("Pounding: Hertz contact with a damping force."),
        make: hertz_damp,
    },
    Kind {
        names: &["JankowskiImpact"],
        usage: "uniaxialMaterial JankowskiImpact $tag $Kh $xi $mEff $gap <$n>",
        text: Text::new("Pounding: Hertz contact, damped on approach (Jankowski)."),
        make: jankowski,
    },
    Kind {
        names: &["ViscoelasticGap"],
        usage: "uniaxialMaterial ViscoelasticGap $tag $K $C $gap",
        text: Text::new("Contact with a spring and a dashpot, in compression alone."),
        make: viscoelastic_gap,
    },
    Kind {
        names: &["Ratchet"],
        usage: "uniaxialMaterial Ratchet $tag $E $freeTravel $freeTravelInitial 1|2",
        text: Text::new("Strut that follows the closing of its ends and resists their opening.")
            .example("uniaxialMaterial Ratchet 77 200. 0.02 0.01 1"),
        make: ratchet,
    },
];

/// A displacement on the compression side; a positive one is turned, as OpenSees does.
fn compressive(interp: &mut Tcl, a: &mut Args<'_>, what: &str) -> Result<f64, Exception> {
    let x = a.float(what)?;
    if x > 0.0 {
        let message = format!("the {what} is {x}, which is in tension: {} is taken", -x);
        warn(
            interp,
            Diagnostic::warning(&checks::words::REPLACED_VALUE, message)
                .at(a.last_span(), "expected a number not greater than 0"),
        )?;
    }
    Ok(-x.abs())
}

const GAP: &str = "displacement gap at which contact begins";

fn impact(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let k1 = a.positive("initial stiffness K1")?;
    let k2 = a.not_negative("secondary stiffness K2")?;
    if k2 > k1 {
        return Err(a.refuse(format!("K2 is {k2}"), format!("expected a stiffness from 0 to K1, {k1}")));
    }
    let delta_y = compressive(interp, a, "yield displacement deltaY")?;
    let gap = compressive(interp, a, GAP)?;
    Ok(Impact { k1, k2, delta_y, gap, compat: interp.host.follows(&[slips::IMPACT_GAP]) }.shared())
}

fn exponent(a: &mut Args<'_>) -> Result<f64, Exception> {
    let n = a.optional_float("exponent n")?.unwrap_or(1.5);
    if n < 1.0 {
        return Err(a.refuse(format!("the exponent n is {n}"), "expected an exponent of at least 1"));
    }
    Ok(n)
}

fn hertz_damp(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let kh = a.positive("contact stiffness Kh")?;
    let xi = a.not_negative("normalised damping coefficient xiNorm")?;
    let gap = compressive(interp, a, GAP)?;
    let n = exponent(a)?;
    Ok(HertzDamp { kh, xi, gap, n, compat: interp.host.follows(&[slips::IMPACT_TANGENT]) }.shared())
}

fn jankowski(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let kh = a.positive("contact stiffness Kh")?;
    let xi = a.not_negative("impact damping ratio xi")?;
    let mass = a.not_negative("effective mass mEff")?;
    let gap = compressive(interp, a, GAP)?;
    let n = exponent(a)?;
    Ok(JankowskiImpact { kh, xi, mass, gap, n, compat: interp.host.follows(&[slips::IMPACT_TANGENT]) }.shared())
}

fn viscoelastic_gap(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let (k, c) = (a.positive("stiffness K")?, a.not_negative("damping coefficient C")?);
    Ok(ViscoelasticGap { k, c, gap: compressive(interp, a, GAP)? }.shared())
}

fn ratchet(_: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let e = a.positive("stiffness E")?;
    let travel = a.positive("free travel")?;
    let first = a.float("free travel at the beginning")?;
    let teeth = match a.int("kind of ratchet")? {
        1 => Teeth::Spaced,
        2 => Teeth::Continuous,
        n => return Err(a.refuse(format!("there is no ratchet {n}"), "expected 1 (teeth) or 2 (none)")),
    };
    Ok(Ratchet { e, travel, first, teeth }.shared())
}

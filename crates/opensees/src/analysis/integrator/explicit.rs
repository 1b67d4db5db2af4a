//! Explicit integrators of transient analyses.

use super::{BETA, HHT, IntegratorResult, Kind, alpha_parameters};
use crate::Tcl;
use crate::args::Args;
use crate::slips;
use crate::text::{Arg, Text};
use hysteron_engine::analysis::integrator::{
    AlphaParameters, CentralDifference, CentralDifferenceAlternative, ExplicitAlpha, ExplicitBathe, ExplicitDifference,
    KrAlpha,
};

const P: Arg = Arg::positive("p", "share p of the first part of a step");

pub(super) const KINDS: &[Kind] = &[
    Kind {
        names: &["CentralDifference"],
        usage: "integrator CentralDifference <$alphaM $betaK $betaK0 $betaKc>",
        text: Text::new("Central differences."),
        make: |interp, a| central_difference(interp, a, "CentralDifference", true),
    },
    Kind {
        names: &["CentralDifferenceAlternative"],
        usage: "integrator CentralDifferenceAlternative <$alphaM $betaK $betaK0 $betaKc>",
        text: Text::new("Central differences in another form."),
        make: central_difference_alternative,
    },
    Kind {
        names: &["CentralDifferenceNoDamping"],
        usage: "integrator CentralDifferenceNoDamping <$alphaM $betaK $betaK0 $betaKc>",
        text: Text::new("Central differences without damping."),
        make: |interp, a| central_difference(interp, a, "CentralDifferenceNoDamping", false),
    },
    Kind {
        names: &["ExplicitDifference", "Explicitdifference"],
        usage: "integrator ExplicitDifference",
        text: Text::new("The leap-frog method."),
        make: |interp, _| Ok(Box::new(ExplicitDifference::new(interp.host.follows(&[slips::EXPLICIT_START])))),
    },
    Kind {
        names: &["ExplicitBathe"],
        usage: "integrator ExplicitBathe $p",
        text: Text::new("The explicit method of Noh and Bathe.").arguments(&[P]),
        make: explicit_bathe,
    },
    Kind {
        names: &["NewmarkExplicit"],
        usage: "integrator NewmarkExplicit $gamma",
        text: Text::new("Newmark's explicit method."),
        make: newmark_explicit,
    },
    Kind {
        names: &["HHTExplicit"],
        usage: "integrator HHTExplicit $alpha <$gamma> <-updateElemDisp>",
        text: Text::new("The explicit method of Hilber, Hughes and Taylor.").arguments(HHT),
        make: hht_explicit,
    },
    Kind {
        names: &["HHTGeneralizedExplicit"],
        usage: "integrator HHTGeneralizedExplicit $rhoB $alphaF | $alphaI $alphaF $beta $gamma <-updateElemDisp>",
        text: Text::new("The explicit generalised alpha method.").arguments(&[
            Arg::new("rhoB", "spectral radius at the bifurcation"),
            Arg::positive("alphaF", "weight alphaF of the forces at the end"),
            Arg::not_negative("alphaI", "weight alphaI of the inertia at the end"),
            BETA,
        ]),
        make: hht_generalized_explicit,
    },
    Kind {
        names: &["KRAlphaExplicit"],
        usage: "integrator KRAlphaExplicit $rhoInf <-updateElemDisp>",
        text: Text::new("The explicit method of Kolay and Ricles."),
        make: kolay_ricles,
    },
];

/// Older scripts give factors of Rayleigh damping here.
fn central_difference(interp: &mut Tcl, a: &mut Args<'_>, name: &'static str, damped: bool) -> IntegratorResult {
    super::rayleigh(interp, a)?;
    Ok(Box::new(CentralDifference::new(name, damped, interp.host.follows(&[slips::CENTRAL_DIFFERENCE_START]))))
}

fn central_difference_alternative(interp: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    if interp.host.follows(&[slips::CENTRAL_DIFFERENCE_START]) {
        super::rayleigh(interp, a)?;
        return Ok(Box::new(CentralDifferenceAlternative::default()));
    }
    central_difference(interp, a, "CentralDifferenceAlternative", true)
}

fn explicit_bathe(interp: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    let p = a.number(&P)?;
    if p >= 1.0 {
        return Err(a.refuse(format!("p is {p}"), "expected more than 0 and less than 1"));
    }
    // 1 makes OpenSees print the longest stable step.
    a.optional_int("0 or 1")?;
    Ok(Box::new(ExplicitBathe::new(p, interp.host.follows(&[slips::EXPLICIT_START]))))
}

fn newmark_explicit(_: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    let p = alpha_parameters(1.0, 1.0, 0.0, a.positive("gamma")?);
    Ok(Box::new(ExplicitAlpha::new("NewmarkExplicit", p, true)))
}

/// Take the flag by which OpenSees updates the elements' displacements. It is always set without `--compat`.
fn updates_elements(interp: &Tcl, a: &mut Args<'_>) -> bool {
    a.flag("-updateElemDisp") || !interp.host.follows(&[slips::EXPLICIT_ELEMENTS])
}

fn hht_explicit(interp: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    let force = a.positive("alpha")?;
    let gamma = a.optional_float("gamma")?.unwrap_or(0.5);
    let update = updates_elements(interp, a);
    Ok(Box::new(ExplicitAlpha::new("HHTExplicit", alpha_parameters(1.0, force, 0.0, gamma), update)))
}

fn hht_generalized_explicit(interp: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    let (first, force) = (a.not_negative("spectral radius rhoB, or alphaI")?, a.positive("alphaF")?);
    let p = if a.at_number() {
        alpha_parameters(first, force, a.not_negative("beta")?, a.positive("gamma")?)
    } else {
        if force == 1.0 || first == 2.0 {
            return Err(a.refuse(format!("alphaF is {force}"), "expected alphaF other than 1 and rhoB other than 2"));
        }
        AlphaParameters::explicit_by_bifurcation(first, force)
    };
    let update = updates_elements(interp, a);
    Ok(Box::new(ExplicitAlpha::new("HHTGeneralizedExplicit", p, update)))
}

fn kolay_ricles(interp: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    let rho = a.not_negative("spectral radius rhoInf")?;
    if rho > 1.0 {
        return Err(a.refuse(format!("the spectral radius is {rho}"), "expected 0 to 1"));
    }
    let update = updates_elements(interp, a);
    Ok(Box::new(KrAlpha::new(rho, update)))
}

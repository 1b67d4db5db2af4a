//! Explicit integrators of transient analyses.

use super::{
    ALPHA, ALPHA_F, ALPHA_I, BETA_OR_0, GAMMA, IntegratorResult, Kind, RHO_B, RHO_INF_TO_1, alpha_parameters,
    by_bifurcation,
};
use crate::Tcl;
use crate::args::Args;
use crate::slips;
use crate::text::{Arg, Text};
use hysteron_engine::analysis::integrator::{
    CentralDifference, CentralDifferenceAlternative, ExplicitAlpha, ExplicitBathe, ExplicitDifference, KrAlpha,
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
        text: Text::new("The explicit method of Hilber, Hughes and Taylor."),
        make: hht_explicit,
    },
    Kind {
        names: &["HHTGeneralizedExplicit"],
        usage: "integrator HHTGeneralizedExplicit $rhoB $alphaF | $alphaI $alphaF $beta $gamma <-updateElemDisp>",
        text: Text::new("The explicit generalised alpha method.").arguments(&[RHO_B, BETA_OR_0]),
        make: hht_generalized_explicit,
    },
    Kind {
        names: &["KRAlphaExplicit"],
        usage: "integrator KRAlphaExplicit $rhoInf <-updateElemDisp>",
        text: Text::new("The explicit method of Kolay and Ricles.").arguments(&[RHO_INF_TO_1]),
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
    let p = alpha_parameters(1.0, 1.0, 0.0, a.number(&GAMMA)?);
    Ok(Box::new(ExplicitAlpha::new("NewmarkExplicit", p, true)))
}

/// Take the flag by which OpenSees updates the elements' displacements. It is always set without `--compat`.
fn updates_elements(interp: &Tcl, a: &mut Args<'_>) -> bool {
    a.flag("-updateElemDisp") || !interp.host.follows(&[slips::EXPLICIT_ELEMENTS])
}

fn hht_explicit(interp: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    let force = a.number(&ALPHA)?;
    let gamma = a.optional_number(&GAMMA)?.unwrap_or(0.5);
    let update = updates_elements(interp, a);
    Ok(Box::new(ExplicitAlpha::new("HHTExplicit", alpha_parameters(1.0, force, 0.0, gamma), update)))
}

fn hht_generalized_explicit(interp: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    let p = if a.numbers_ahead() > 2 {
        let [inertia, force, beta, gamma] = a.read_all(interp, &[ALPHA_I, ALPHA_F, BETA_OR_0, GAMMA])?;
        alpha_parameters(inertia, force, beta, gamma)
    } else {
        let [rho, force] = a.read_all(interp, &[RHO_B, ALPHA_F])?;
        by_bifurcation(a, rho, force)?
    };
    let update = updates_elements(interp, a);
    Ok(Box::new(ExplicitAlpha::new("HHTGeneralizedExplicit", p, update)))
}

fn kolay_ricles(interp: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    let rho = a.number(&RHO_INF_TO_1)?;
    let update = updates_elements(interp, a);
    Ok(Box::new(KrAlpha::new(rho, update)))
}

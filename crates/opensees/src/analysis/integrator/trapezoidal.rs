//! `integrator HHT_TP` and its kin: the trapezoidal rule weights the forces of both ends of a step.

use super::{
    ALPHA, ALPHA_F, ALPHA_I, BETA, GAMMA, IntegratorResult, Kind, RHO_B, RHO_INF_TO_1, alpha_parameters, by_bifurcation,
};
use crate::args::Args;
use crate::slips;
use crate::text::{Arg, Domain, Text};
use crate::{Tcl, ignore_unknown};
use hysteron_engine::analysis::integrator::{
    AlphaParameters, KrAlpha, Trapezoidal, TrapezoidalExplicit, TrapezoidalSplitting,
};
use hysteron_tcl::Exception;

/// The weight of the inertia of methods that divide by it.
pub(super) const ALPHA_I_ABOVE_0: Arg = ALPHA_I.within(Domain::Positive);
/// The Newmark parameter of methods that have no use for it.
const ANY_BETA: Arg = BETA.within(Domain::Number);

pub(super) const KINDS: &[Kind] = &[
    Kind {
        names: &["HHT_TP"],
        usage: "integrator HHT_TP $alpha <$gamma $beta>",
        text: Text::new(
            "The method of Hilber, Hughes and Taylor with trapezoidal weights on the forces of both ends of a step.",
        ),
        make: hht,
    },
    Kind {
        names: &["HHTGeneralized_TP"],
        usage: "integrator HHTGeneralized_TP $rhoInf | $alphaI $alphaF $beta $gamma",
        text: Text::new("The generalised alpha method with trapezoidal weights.")
            .arguments(&[RHO_INF_TO_1, ALPHA_I_ABOVE_0]),
        make: hht_generalized,
    },
    Kind {
        names: &["HHTExplicit_TP"],
        usage: "integrator HHTExplicit_TP $alpha <$gamma>",
        text: Text::new("The explicit HHT method with trapezoidal weights."),
        make: hht_explicit,
    },
    Kind {
        names: &["HHTGeneralizedExplicit_TP"],
        usage: "integrator HHTGeneralizedExplicit_TP $rhoB $alphaF | $alphaI $alphaF $beta $gamma",
        text: Text::new("The explicit generalised alpha method with trapezoidal weights.").arguments(&[
            RHO_B,
            ALPHA_I_ABOVE_0,
            ANY_BETA,
        ]),
        make: hht_generalized_explicit,
    },
    Kind {
        names: &["AlphaOS_TP"],
        usage: "integrator AlphaOS_TP $alpha <$beta $gamma> <-updateElemDisp>",
        text: Text::new("Operator splitting with trapezoidal weights."),
        make: alpha_os,
    },
    Kind {
        names: &["AlphaOSGeneralized_TP"],
        usage: "integrator AlphaOSGeneralized_TP $rhoInf | $alphaI $alphaF $beta $gamma <-updateElemDisp>",
        text: Text::new("Generalised operator splitting with trapezoidal weights.")
            .arguments(&[RHO_INF_TO_1, ALPHA_I_ABOVE_0]),
        make: alpha_os_generalized,
    },
    Kind {
        names: &["KRAlphaExplicit_TP"],
        usage: "integrator KRAlphaExplicit_TP $rhoInf",
        text: Text::new("The method of Kolay and Ricles with trapezoidal weights.").arguments(&[RHO_INF_TO_1]),
        make: kolay_ricles,
    },
];

/// Arguments of the generalised methods.
const GENERALIZED: [&Arg; 4] = [&ALPHA_I_ABOVE_0, &ALPHA_F, &BETA, &GAMMA];
/// The same of an explicit method, which has no use for β.
const EXPLICIT: [&Arg; 4] = [&ALPHA_I_ABOVE_0, &ALPHA_F, &ANY_BETA, &GAMMA];

/// Take the numbers of a method that has no options.
fn numbers(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Vec<f64>, Exception> {
    let numbers = a.floats("parameter")?;
    while a.option().is_some() {
        ignore_unknown(interp, a)?;
    }
    Ok(numbers)
}

fn wrong_number(a: &Args<'_>, name: &str, numbers: &[f64]) -> Exception {
    a.refuse(format!("{name}: {} parameters do not fit", numbers.len()), "expected as below")
}

/// Parameters of a generalised method: the spectral radius, or all four.
pub(super) fn generalized(a: &Args<'_>, name: &str, numbers: &[f64]) -> Result<AlphaParameters, Exception> {
    match *numbers {
        [rho] => {
            a.judge(&[&RHO_INF_TO_1], numbers)?;
            Ok(AlphaParameters::spectral(rho))
        }
        [inertia, force, beta, gamma] => {
            a.judge(&GENERALIZED, numbers)?;
            Ok(alpha_parameters(inertia, force, beta, gamma))
        }
        _ => Err(wrong_number(a, name, numbers)),
    }
}

/// Refuse parameters of which one does not come out positive. An explicit method has no use for β.
fn positive(a: &Args<'_>, name: &str, p: AlphaParameters, explicit: bool) -> Result<AlphaParameters, Exception> {
    let good = [p.inertia, p.force, p.gamma].iter().all(|x| *x > 0.0) && (explicit || p.beta > 0.0);
    if good {
        Ok(p)
    } else {
        Err(a.refuse(format!("{name}: a parameter is not greater than 0"), "expected positive numbers"))
    }
}

fn hht(interp: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    const NAME: &str = "HHT_TP";
    let numbers = numbers(interp, a)?;
    let p = match numbers[..] {
        [alpha] => {
            a.judge(&[&ALPHA], &numbers)?;
            positive(a, NAME, AlphaParameters::second_order(1.0, alpha), false)?
        }
        // The manual's order is gamma, beta; OpenSees takes the two the other way round.
        [alpha, beta, gamma] if interp.host.follows(&[slips::HHT_TP_ORDER]) => {
            a.judge(&[&ALPHA, &BETA, &GAMMA], &numbers)?;
            alpha_parameters(1.0, alpha, beta, gamma)
        }
        [alpha, gamma, beta] => {
            a.judge(&[&ALPHA, &GAMMA, &BETA], &numbers)?;
            alpha_parameters(1.0, alpha, beta, gamma)
        }
        _ => return Err(wrong_number(a, NAME, &numbers)),
    };
    Ok(Box::new(Trapezoidal::new(NAME, p)))
}

fn hht_generalized(interp: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    const NAME: &str = "HHTGeneralized_TP";
    let numbers = numbers(interp, a)?;
    Ok(Box::new(Trapezoidal::new(NAME, generalized(a, NAME, &numbers)?)))
}

fn hht_explicit(interp: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    const NAME: &str = "HHTExplicit_TP";
    let numbers = numbers(interp, a)?;
    a.judge(&[&ALPHA, &GAMMA], &numbers)?;
    let p = match numbers[..] {
        [alpha] => alpha_parameters(1.0, alpha, 0.0, 0.5),
        [alpha, gamma] => alpha_parameters(1.0, alpha, 0.0, gamma),
        _ => return Err(wrong_number(a, NAME, &numbers)),
    };
    Ok(Box::new(TrapezoidalExplicit::new(NAME, p)))
}

fn hht_generalized_explicit(interp: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    const NAME: &str = "HHTGeneralizedExplicit_TP";
    let numbers = numbers(interp, a)?;
    let p = match numbers[..] {
        [rho, force] => {
            a.judge(&[&RHO_B, &ALPHA_F], &numbers)?;
            positive(a, NAME, by_bifurcation(a, rho, force)?, true)?
        }
        [inertia, force, beta, gamma] => {
            a.judge(&EXPLICIT, &numbers)?;
            alpha_parameters(inertia, force, beta, gamma)
        }
        _ => return Err(wrong_number(a, NAME, &numbers)),
    };
    Ok(Box::new(TrapezoidalExplicit::new(NAME, p)))
}

fn alpha_os(interp: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    const NAME: &str = "AlphaOS_TP";
    let (numbers, update_elements) = splitting_numbers(interp, a)?;
    let p = operator_splitting(a, NAME, &numbers)?;
    Ok(Box::new(TrapezoidalSplitting::new(NAME, p, update_elements)))
}

fn alpha_os_generalized(interp: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    const NAME: &str = "AlphaOSGeneralized_TP";
    let (numbers, update_elements) = splitting_numbers(interp, a)?;
    Ok(Box::new(TrapezoidalSplitting::new(NAME, generalized(a, NAME, &numbers)?, update_elements)))
}

fn kolay_ricles(interp: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    const NAME: &str = "KRAlphaExplicit_TP";
    let numbers = numbers(interp, a)?;
    let [rho] = numbers[..] else { return Err(wrong_number(a, NAME, &numbers)) };
    a.judge(&[&RHO_INF_TO_1], &numbers)?;
    Ok(Box::new(KrAlpha::trapezoidal(rho)))
}

/// Take the numbers of a method of operator splitting, and its flag `-updateElemDisp`.
pub(super) fn splitting_numbers(interp: &mut Tcl, a: &mut Args<'_>) -> Result<(Vec<f64>, bool), Exception> {
    let numbers = a.floats("parameter")?;
    let mut update_elements = false;
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-updateElemDisp" => update_elements = true,
            _ => ignore_unknown(interp, a)?,
        }
    }
    Ok((numbers, update_elements))
}

/// Parameters of operator splitting: the weight of the forces alone, or with those of Newmark.
pub(super) fn operator_splitting(a: &Args<'_>, name: &str, numbers: &[f64]) -> Result<AlphaParameters, Exception> {
    a.judge(&[&ALPHA, &BETA, &GAMMA], numbers)?;
    match *numbers {
        [alpha] => positive(a, name, AlphaParameters::second_order(1.0, alpha), false),
        [alpha, beta, gamma] => Ok(alpha_parameters(1.0, alpha, beta, gamma)),
        _ => Err(wrong_number(a, name, numbers)),
    }
}

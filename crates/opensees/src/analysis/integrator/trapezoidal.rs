//! `integrator HHT_TP` and its kin: the trapezoidal rule weights the forces of both ends of a step.

use super::{IntegratorResult, Kind, alpha_parameters};
use crate::args::Args;
use crate::slips;
use crate::text::{Arg, Text};
use crate::{Tcl, ignore_option, ignore_unknown};
use hysteron_engine::analysis::integrator::{
    AlphaParameters, KrAlpha, Trapezoidal, TrapezoidalExplicit, TrapezoidalSplitting,
};
use hysteron_tcl::Exception;

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
        text: Text::new("The generalised alpha method with trapezoidal weights."),
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
        text: Text::new("The explicit generalised alpha method with trapezoidal weights.")
            .arguments(&[Arg::new("rhoB", "a parameter")]),
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
        text: Text::new("Generalised operator splitting with trapezoidal weights."),
        make: alpha_os_generalized,
    },
    Kind {
        names: &["KRAlphaExplicit_TP"],
        usage: "integrator KRAlphaExplicit_TP $rhoInf",
        text: Text::new("The method of Kolay and Ricles with trapezoidal weights."),
        make: kolay_ricles,
    },
];

/// Take the numbers of a method that has no options.
fn numbers(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Vec<f64>, Exception> {
    let numbers = a.floats("parameter")?;
    while a.option().is_some() {
        ignore_option(interp, a, &[])?;
    }
    Ok(numbers)
}

/// Take the numbers of a method of operator splitting, and its flag `-updateElemDisp`.
fn splitting_numbers(interp: &mut Tcl, a: &mut Args<'_>) -> Result<(Vec<f64>, bool), Exception> {
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

fn wrong_number(a: &Args<'_>, name: &str, numbers: &[f64]) -> Exception {
    a.refuse(format!("{name}: {} parameters do not fit", numbers.len()), "expected as below")
}

/// Parameters by the spectral radius at infinite frequency.
fn spectral(a: &Args<'_>, rho: f64) -> Result<AlphaParameters, Exception> {
    if !(0.0..=1.0).contains(&rho) {
        return Err(a.refuse(format!("the spectral radius is {rho}"), "expected 0 to 1"));
    }
    Ok(AlphaParameters::spectral(rho))
}

/// Refuse parameters that are not positive. An explicit method has no use for β.
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
        [alpha] => AlphaParameters::second_order(1.0, alpha),
        // The manual's order is gamma, beta; OpenSees takes the two the other way round.
        [alpha, beta, gamma] if interp.host.follows(&[slips::HHT_TP_ORDER]) => {
            alpha_parameters(1.0, alpha, beta, gamma)
        }
        [alpha, gamma, beta] => alpha_parameters(1.0, alpha, beta, gamma),
        _ => return Err(wrong_number(a, NAME, &numbers)),
    };
    Ok(Box::new(Trapezoidal::new(NAME, positive(a, NAME, p, false)?)))
}

fn hht_generalized(interp: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    const NAME: &str = "HHTGeneralized_TP";
    let numbers = numbers(interp, a)?;
    let p = match numbers[..] {
        [rho] => spectral(a, rho)?,
        [inertia, force, beta, gamma] => alpha_parameters(inertia, force, beta, gamma),
        _ => return Err(wrong_number(a, NAME, &numbers)),
    };
    Ok(Box::new(Trapezoidal::new(NAME, positive(a, NAME, p, false)?)))
}

fn hht_explicit(interp: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    const NAME: &str = "HHTExplicit_TP";
    let numbers = numbers(interp, a)?;
    let p = match numbers[..] {
        [alpha] => alpha_parameters(1.0, alpha, 0.0, 0.5),
        [alpha, gamma] => alpha_parameters(1.0, alpha, 0.0, gamma),
        _ => return Err(wrong_number(a, NAME, &numbers)),
    };
    Ok(Box::new(TrapezoidalExplicit::new(NAME, positive(a, NAME, p, true)?)))
}

fn hht_generalized_explicit(interp: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    const NAME: &str = "HHTGeneralizedExplicit_TP";
    let numbers = numbers(interp, a)?;
    let p = match numbers[..] {
        [rho, force] => {
            if force == 1.0 || rho == 2.0 {
                let message = format!("alphaF is {force}, rhoB {rho}");
                return Err(a.refuse(message, "expected alphaF other than 1 and rhoB other than 2"));
            }
            AlphaParameters::explicit_by_bifurcation(rho, force)
        }
        [inertia, force, beta, gamma] => alpha_parameters(inertia, force, beta, gamma),
        _ => return Err(wrong_number(a, NAME, &numbers)),
    };
    Ok(Box::new(TrapezoidalExplicit::new(NAME, positive(a, NAME, p, true)?)))
}

fn alpha_os(interp: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    const NAME: &str = "AlphaOS_TP";
    let (numbers, update_elements) = splitting_numbers(interp, a)?;
    let p = match numbers[..] {
        [alpha] => AlphaParameters::second_order(1.0, alpha),
        [alpha, beta, gamma] => alpha_parameters(1.0, alpha, beta, gamma),
        _ => return Err(wrong_number(a, NAME, &numbers)),
    };
    Ok(Box::new(TrapezoidalSplitting::new(NAME, positive(a, NAME, p, false)?, update_elements)))
}

fn alpha_os_generalized(interp: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    const NAME: &str = "AlphaOSGeneralized_TP";
    let (numbers, update_elements) = splitting_numbers(interp, a)?;
    let p = match numbers[..] {
        [rho] => spectral(a, rho)?,
        [inertia, force, beta, gamma] => alpha_parameters(inertia, force, beta, gamma),
        _ => return Err(wrong_number(a, NAME, &numbers)),
    };
    Ok(Box::new(TrapezoidalSplitting::new(NAME, positive(a, NAME, p, false)?, update_elements)))
}

fn kolay_ricles(interp: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    const NAME: &str = "KRAlphaExplicit_TP";
    let numbers = numbers(interp, a)?;
    let [rho] = numbers[..] else { return Err(wrong_number(a, NAME, &numbers)) };
    positive(a, NAME, spectral(a, rho)?, true)?;
    Ok(Box::new(KrAlpha::trapezoidal(rho)))
}

//! Integrators for hybrid simulation: implicit ones with restrained or counted iterations, and operator splitting.

use super::{IntegratorResult, Kind, alpha_parameters};
use crate::args::Args;
use crate::text::{Arg, Domain, Text};
use crate::{Tcl, ignore_option, ignore_unknown};
use hysteron_engine::analysis::integrator::{
    AlphaOs, AlphaParameters, Collocation, FixedIterations, Form, GeneralizedAlpha, Integrator, Newmark, Restrained,
    Restraint, Trapezoidal,
};

/// Method of integration inside.
#[derive(Clone, Copy)]
enum Method {
    Newmark,
    Hht,
    HhtTrapezoidal,
    Collocation,
}

/// Treatment of the increments of a step's iterations.
#[derive(Clone, Copy, PartialEq)]
enum Increments {
    Reduced,
    Limited,
    FixedNumber,
}

use Increments::{FixedNumber, Limited, Reduced};

const NORM_TYPE_P: Arg = Arg::of("-normType", "p", "p of the norm").within(Domain::Whole);

pub(super) const KINDS: &[Kind] = &[
    Kind {
        names: &["NewmarkHSIncrReduct"],
        usage: "integrator NewmarkHSIncrReduct $gamma $beta $factor",
        text: Text::new(
            "Newmark's, HHT and collocation methods for hybrid simulation, with corrections reduced by a factor.",
        ),
        make: |interp, a| implicit(interp, a, "NewmarkHSIncrReduct", Method::Newmark, Reduced),
    },
    Kind {
        names: &["NewmarkHSIncrLimit"],
        usage: "integrator NewmarkHSIncrLimit $gamma $beta $limit <-normType $p>",
        text: Text::new("Newmark's method for hybrid simulation, with corrections of limited size.")
            .arguments(&[NORM_TYPE_P]),
        make: |interp, a| implicit(interp, a, "NewmarkHSIncrLimit", Method::Newmark, Limited),
    },
    Kind {
        names: &["NewmarkHSFixedNumIter"],
        usage: "integrator NewmarkHSFixedNumIter $gamma $beta <-polyOrder 1|2|3>",
        text: Text::new("Newmark's method for hybrid simulation, with a fixed number of iterations."),
        make: |interp, a| implicit(interp, a, "NewmarkHSFixedNumIter", Method::Newmark, FixedNumber),
    },
    Kind {
        names: &["HHTHSIncrReduct"],
        usage: "integrator HHTHSIncrReduct $rhoInf|{$alphaI $alphaF $beta $gamma} $factor",
        text: Text::new(
            "The method of Hilber, Hughes and Taylor for hybrid simulation, with corrections reduced by a factor.",
        ),
        make: |interp, a| implicit(interp, a, "HHTHSIncrReduct", Method::Hht, Reduced),
    },
    Kind {
        names: &["HHTHSIncrLimit"],
        usage: "integrator HHTHSIncrLimit $rhoInf|{$alphaI $alphaF $beta $gamma} $limit <-normType $p>",
        text: Text::new("The same with corrections of limited size.").arguments(&[NORM_TYPE_P]),
        make: |interp, a| implicit(interp, a, "HHTHSIncrLimit", Method::Hht, Limited),
    },
    Kind {
        names: &["HHTHSFixedNumIter"],
        usage: "integrator HHTHSFixedNumIter $rhoInf|{$alphaI $alphaF $beta $gamma} <-polyOrder 1|2|3>",
        text: Text::new("The same with a fixed number of iterations."),
        make: |interp, a| implicit(interp, a, "HHTHSFixedNumIter", Method::Hht, FixedNumber),
    },
    Kind {
        names: &["HHTHSIncrReduct_TP"],
        usage: "integrator HHTHSIncrReduct_TP $rhoInf|{$alphaI $alphaF $beta $gamma} $factor",
        text: Text::new("`HHTHSIncrReduct` with trapezoidal weights."),
        make: |interp, a| implicit(interp, a, "HHTHSIncrReduct_TP", Method::HhtTrapezoidal, Reduced),
    },
    Kind {
        names: &["HHTHSIncrLimit_TP"],
        usage: "integrator HHTHSIncrLimit_TP $rhoInf|{$alphaI $alphaF $beta $gamma} $limit <-normType $p>",
        text: Text::new("`HHTHSIncrLimit` with trapezoidal weights.").arguments(&[NORM_TYPE_P]),
        make: |interp, a| implicit(interp, a, "HHTHSIncrLimit_TP", Method::HhtTrapezoidal, Limited),
    },
    Kind {
        names: &["HHTHSFixedNumIter_TP"],
        usage: "integrator HHTHSFixedNumIter_TP $rhoInf|{$alphaI $alphaF $beta $gamma} <-polyOrder 1|2|3>",
        text: Text::new("`HHTHSFixedNumIter` with trapezoidal weights."),
        make: |interp, a| implicit(interp, a, "HHTHSFixedNumIter_TP", Method::HhtTrapezoidal, FixedNumber),
    },
    Kind {
        names: &["CollocationHSIncrReduct"],
        usage: "integrator CollocationHSIncrReduct $theta <$beta $gamma> $factor",
        text: Text::new("The collocation method for hybrid simulation, with corrections reduced by a factor."),
        make: |interp, a| implicit(interp, a, "CollocationHSIncrReduct", Method::Collocation, Reduced),
    },
    Kind {
        names: &["CollocationHSIncrLimit"],
        usage: "integrator CollocationHSIncrLimit $theta <$beta $gamma> $limit <-normType $p>",
        text: Text::new("The same with corrections of limited size.").arguments(&[NORM_TYPE_P]),
        make: |interp, a| implicit(interp, a, "CollocationHSIncrLimit", Method::Collocation, Limited),
    },
    Kind {
        names: &["CollocationHSFixedNumIter"],
        usage: "integrator CollocationHSFixedNumIter $theta <$beta $gamma> <-polyOrder 1|2|3>",
        text: Text::new("The same with a fixed number of iterations."),
        make: |interp, a| implicit(interp, a, "CollocationHSFixedNumIter", Method::Collocation, FixedNumber),
    },
    Kind {
        names: &["AlphaOS"],
        usage: "integrator AlphaOS $alpha <$beta $gamma> <-updateElemDisp>",
        text: Text::new("Operator splitting."),
        make: |interp, a| operator_splitting(interp, a, "AlphaOS"),
    },
    Kind {
        names: &["AlphaOSGeneralized"],
        usage: "integrator AlphaOSGeneralized $rhoInf|{$alphaI $alphaF $beta $gamma} <-updateElemDisp>",
        text: Text::new("Generalised operator splitting."),
        make: |interp, a| operator_splitting(interp, a, "AlphaOSGeneralized"),
    },
];

fn operator_splitting(interp: &mut Tcl, a: &mut Args<'_>, name: &'static str) -> IntegratorResult {
    let numbers = a.floats("parameter")?;
    let mut update_elements = false;
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-updateElemDisp" => update_elements = true,
            _ => ignore_unknown(interp, a)?,
        }
    }
    let p = match (name, numbers.as_slice()) {
        ("AlphaOS", [alpha]) => AlphaParameters::second_order(1.0, *alpha),
        ("AlphaOS", [force, beta, gamma]) => alpha_parameters(1.0, *force, *beta, *gamma),
        ("AlphaOSGeneralized", [rho]) => AlphaParameters::spectral(*rho),
        ("AlphaOSGeneralized", [inertia, force, beta, gamma]) => alpha_parameters(*inertia, *force, *beta, *gamma),
        _ => return Err(a.refuse(format!("{} parameters do not fit", numbers.len()), "expected as below")),
    };
    let positive = [p.inertia, p.force, p.beta, p.gamma].iter().all(|x| *x > 0.0);
    if !positive {
        return Err(a.refuse("a parameter is not greater than 0", "expected positive numbers"));
    }
    Ok(Box::new(AlphaOs::new(name, p, update_elements)))
}

fn implicit(
    interp: &mut Tcl,
    a: &mut Args<'_>,
    name: &'static str,
    method: Method,
    increments: Increments,
) -> IntegratorResult {
    let numbers = a.floats("parameter")?;
    let (mut norm, mut order) = (2, 2);
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-normType" => norm = a.int(NORM_TYPE_P.meaning)?,
            "-polyOrder" => {
                order = a.count("order of the polynomial")?;
                if order > 3 {
                    return Err(a.refuse(format!("the order of the polynomial is {order}"), "expected 1, 2 or 3"));
                }
            }
            _ => ignore_option(interp, a, &["-normType", "-polyOrder"])?,
        }
    }
    let (restraint, parameters) = match (increments, numbers.split_last()) {
        (FixedNumber, _) => (None, numbers.as_slice()),
        (Reduced, Some((factor, before))) => (Some((*factor, Restraint::Factor(*factor))), before),
        (Limited, Some((size, before))) => (Some((*size, Restraint::Limit { size: *size, norm })), before),
        (_, None) => return Err(a.refuse(format!("{name}: the parameters are missing"), "expected as below")),
    };
    if numbers.iter().any(|x| *x < 0.0) || restraint.is_some_and(|(last, _)| last == 0.0) {
        return Err(a.refuse(format!("{name}: a parameter is not greater than 0"), "expected positive numbers"));
    }
    let Some(inner) = inner(name, method, parameters) else {
        let before = if increments == FixedNumber { "" } else { " before the last" };
        let message = format!("{name}: {} parameters{before}, or beta is 0", parameters.len());
        return Err(a.refuse(message, "expected as below"));
    };
    Ok(match restraint {
        Some((_, restraint)) => Box::new(Restrained::new(name, inner, restraint)),
        None => Box::new(FixedIterations::new(name, inner, order)),
    })
}

/// The integrator whose iterations are restrained; `None` if the number of parameters does not fit or β is 0.
fn inner(name: &'static str, method: Method, parameters: &[f64]) -> Option<Box<dyn Integrator>> {
    let alpha = match *parameters {
        [rho] => Some(AlphaParameters::spectral(rho)),
        [inertia, force, beta, gamma] if beta > 0.0 => Some(alpha_parameters(inertia, force, beta, gamma)),
        _ => None,
    };
    Some(match (method, parameters) {
        (Method::Newmark, [gamma, beta]) if *beta > 0.0 => Box::new(Newmark::new(*gamma, *beta, Form::Displacement)),
        (Method::Hht, _) => Box::new(GeneralizedAlpha::new(name, alpha?, false)),
        (Method::HhtTrapezoidal, _) => Box::new(Trapezoidal::new(name, alpha?)),
        (Method::Collocation, [theta]) => Box::new(Collocation::stable(*theta)),
        (Method::Collocation, [theta, beta, gamma]) if *beta > 0.0 => Box::new(Collocation::new(*theta, *beta, *gamma)),
        _ => return None,
    })
}

//! Integrators for hybrid simulation: implicit ones with restrained or counted iterations, and operator splitting.

use super::trapezoidal::{ALPHA_I_ABOVE_0, generalized, operator_splitting, splitting_numbers};
use super::{ALPHA_F, ALPHA_I, BETA, GAMMA, IntegratorResult, Kind, RHO_INF, RHO_INF_TO_1, THETA, alpha_parameters};
use crate::args::Args;
use crate::text::{Arg, Domain, Text};
use crate::{Tcl, ignore_unknown};
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

pub(super) const POLY_ORDER: Arg =
    Arg::of("-polyOrder", "", "order of the polynomial between steps").within(Domain::Count);
pub(super) const FACTOR: Arg = Arg::positive("factor", "factor of the corrections");
pub(super) const LIMIT: Arg = Arg::positive("limit", "limit of a correction");

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
        make: alpha_os,
    },
    Kind {
        names: &["AlphaOSGeneralized"],
        usage: "integrator AlphaOSGeneralized $rhoInf | $alphaI $alphaF $beta $gamma <-updateElemDisp>",
        text: Text::new("Generalised operator splitting.").arguments(&[RHO_INF_TO_1, ALPHA_I_ABOVE_0]),
        make: alpha_os_generalized,
    },
];

fn alpha_os(interp: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    const NAME: &str = "AlphaOS";
    let (numbers, update_elements) = splitting_numbers(interp, a)?;
    Ok(Box::new(AlphaOs::new(NAME, operator_splitting(a, NAME, &numbers)?, update_elements)))
}

fn alpha_os_generalized(interp: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    const NAME: &str = "AlphaOSGeneralized";
    let (numbers, update_elements) = splitting_numbers(interp, a)?;
    Ok(Box::new(AlphaOs::new(NAME, generalized(a, NAME, &numbers)?, update_elements)))
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
                order = a.count(&POLY_ORDER)?;
                if order > 3 {
                    return Err(a.refuse(format!("the order of the polynomial is {order}"), "expected 1, 2 or 3"));
                }
            }
            _ => ignore_unknown(interp, a)?,
        }
    }
    let (restraint, parameters) = match (increments, numbers.split_last()) {
        (FixedNumber, _) => (None, numbers.as_slice()),
        (Reduced, Some((factor, before))) => (Some((*factor, Restraint::Factor(*factor))), before),
        (Limited, Some((size, before))) => (Some((*size, Restraint::Limit { size: *size, norm })), before),
        (_, None) => return Err(a.refuse(format!("{name}: the parameters are missing"), "expected as below")),
    };
    let declared: &[&Arg] = match (method, parameters.len()) {
        (Method::Newmark, _) => &[&GAMMA, &BETA],
        (Method::Hht | Method::HhtTrapezoidal, 1) => &[&RHO_INF],
        (Method::Hht | Method::HhtTrapezoidal, _) => &[&ALPHA_I, &ALPHA_F, &BETA, &GAMMA],
        (Method::Collocation, _) => &[&THETA, &BETA, &GAMMA],
    };
    a.judge(declared, parameters)?;
    a.judge(&[if increments == Limited { &LIMIT } else { &FACTOR }], restraint.map(|(last, _)| last).as_slice())?;
    let Some(inner) = inner(name, method, parameters) else {
        let before = if increments == FixedNumber { "" } else { " before the last" };
        let message = format!("{name}: {} parameters{before}", parameters.len());
        return Err(a.refuse(message, "expected as below"));
    };
    Ok(match restraint {
        Some((_, restraint)) => Box::new(Restrained::new(name, inner, restraint)),
        None => Box::new(FixedIterations::new(name, inner, order)),
    })
}

/// The integrator whose iterations are restrained; `None` if the number of parameters does not fit.
fn inner(name: &'static str, method: Method, parameters: &[f64]) -> Option<Box<dyn Integrator>> {
    let alpha = match *parameters {
        [rho] => Some(AlphaParameters::spectral(rho)),
        [inertia, force, beta, gamma] => Some(alpha_parameters(inertia, force, beta, gamma)),
        _ => None,
    };
    Some(match (method, parameters) {
        (Method::Newmark, [gamma, beta]) => Box::new(Newmark::new(*gamma, *beta, Form::Displacement)),
        (Method::Hht, _) => Box::new(GeneralizedAlpha::new(name, alpha?, false)),
        (Method::HhtTrapezoidal, _) => Box::new(Trapezoidal::new(name, alpha?)),
        (Method::Collocation, [theta]) => Box::new(Collocation::stable(*theta)),
        (Method::Collocation, [theta, beta, gamma]) => Box::new(Collocation::new(*theta, *beta, *gamma)),
        _ => return None,
    })
}

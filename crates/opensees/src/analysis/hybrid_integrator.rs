//! `integrator NewmarkHSIncrReduct` and the like: implicit integrators for hybrid simulation.

use crate::args::Args;
use crate::slips;
use crate::{Tcl, ignore_option};
use hysteron_engine::analysis::integrator::{
    AlphaOs, AlphaParameters, Collocation, FixedIterations, Form, GeneralizedAlpha, Integrator, KrAlpha, Newmark,
    Restrained, Restraint, Trapezoidal,
};
use hysteron_tcl::Exception;

/// Names, that of the integrator inside first.
pub(crate) const NAMES: [(&str, &str); 12] = [
    ("Newmark", "NewmarkHSIncrReduct"),
    ("Newmark", "NewmarkHSIncrLimit"),
    ("HHT", "HHTHSIncrReduct"),
    ("HHT", "HHTHSIncrLimit"),
    ("Collocation", "CollocationHSIncrReduct"),
    ("Collocation", "CollocationHSIncrLimit"),
    ("Newmark", "NewmarkHSFixedNumIter"),
    ("HHT", "HHTHSFixedNumIter"),
    ("Collocation", "CollocationHSFixedNumIter"),
    ("HHT_TP", "HHTHSIncrReduct_TP"),
    ("HHT_TP", "HHTHSIncrLimit_TP"),
    ("HHT_TP", "HHTHSFixedNumIter_TP"),
];

const USAGE: &str = "integrator NewmarkHSIncrReduct $gamma $beta $factor | HHTHSIncrReduct $rhoInf|{$alphaI $alphaF $beta \
                     $gamma} $factor | CollocationHSIncrReduct $theta <$beta $gamma> $factor, and ...HSIncrLimit with \
                     $limit <-normType $p> or ...HSFixedNumIter with <-polyOrder 1|2|3> in place of $factor; HHTHS..._TP as HHTHS...";

const OPERATOR_SPLITTING: &str = "integrator AlphaOS $alpha <$beta $gamma> <-updateElemDisp> | \
                                  AlphaOSGeneralized $rhoInf|{$alphaI $alphaF $beta $gamma} <-updateElemDisp>";

/// `AlphaOS` and `AlphaOSGeneralized`.
pub(crate) fn operator_splitting(
    interp: &mut Tcl,
    a: &mut Args<'_>,
    generalized: bool,
) -> Result<Box<dyn Integrator>, Exception> {
    a.usage(OPERATOR_SPLITTING);
    let numbers = a.floats("parameter")?;
    let mut update_elements = false;
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-updateElemDisp" => update_elements = true,
            _ => ignore_option(interp, a, &["-updateElemDisp"])?,
        }
    }
    let p = match (generalized, numbers.as_slice()) {
        (false, [alpha]) => AlphaParameters::second_order(1.0, *alpha),
        (false, [force, beta, gamma]) => AlphaParameters { inertia: 1.0, force: *force, beta: *beta, gamma: *gamma },
        (true, [rho]) => AlphaParameters::spectral(*rho),
        (true, [inertia, force, beta, gamma]) => {
            AlphaParameters { inertia: *inertia, force: *force, beta: *beta, gamma: *gamma }
        }
        _ => return Err(a.refuse(format!("{} parameters do not fit", numbers.len()), "expected as below")),
    };
    let positive = [p.inertia, p.force, p.beta, p.gamma].iter().all(|x| *x > 0.0);
    if !positive {
        return Err(a.refuse("a parameter is not greater than 0", "expected positive numbers"));
    }
    Ok(Box::new(AlphaOs::new(if generalized { "AlphaOSGeneralized" } else { "AlphaOS" }, p, update_elements)))
}

/// `KRAlphaExplicit`.
pub(crate) fn kolay_ricles(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Box<dyn Integrator>, Exception> {
    a.usage("integrator KRAlphaExplicit $rhoInf <-updateElemDisp>");
    let rho = a.not_negative("spectral radius rhoInf")?;
    if rho > 1.0 {
        return Err(a.refuse(format!("the spectral radius is {rho}"), "expected 0 to 1"));
    }
    let update = a.flag("-updateElemDisp") || !interp.host.follows(&[slips::EXPLICIT_ELEMENTS]);
    Ok(Box::new(KrAlpha::new(rho, update)))
}

/// One of these integrators, by its name; `None` if it is none of them.
pub(crate) fn take(interp: &mut Tcl, a: &mut Args<'_>, word: &str) -> Result<Option<Box<dyn Integrator>>, Exception> {
    let Some((base, name)) = NAMES.into_iter().find(|(_, name)| *name == word) else { return Ok(None) };
    a.usage(USAGE);
    let numbers = a.floats("parameter")?;
    let (mut norm, mut order) = (2, 2);
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-normType" => norm = a.int("p of the norm")?,
            "-polyOrder" => {
                order = a.count("order of the polynomial")?;
                if order > 3 {
                    return Err(a.refuse(format!("the order of the polynomial is {order}"), "expected 1, 2 or 3"));
                }
            }
            _ => ignore_option(interp, a, &["-normType", "-polyOrder"])?,
        }
    }
    let fixed = name.contains("FixedNumIter");
    let (restraint, own) = match numbers.split_last() {
        _ if fixed => (None, numbers.as_slice()),
        Some((factor, own)) if name.contains("Reduct") => (Some((*factor, Restraint::Factor(*factor))), own),
        Some((size, own)) => (Some((*size, Restraint::Limit { size: *size, norm })), own),
        None => return Err(a.refuse(format!("{name}: the parameters are missing"), "expected as below")),
    };
    if numbers.iter().any(|x| *x < 0.0) || restraint.is_some_and(|(last, _)| last == 0.0) {
        return Err(a.refuse(format!("{name}: a parameter is not greater than 0"), "expected positive numbers"));
    }
    let inner: Box<dyn Integrator> = match (base, own) {
        ("Newmark", [gamma, beta]) if *beta > 0.0 => Box::new(Newmark::new(*gamma, *beta, Form::Displacement)),
        ("HHT", [rho]) => Box::new(GeneralizedAlpha::new(name, AlphaParameters::spectral(*rho), false)),
        ("HHT_TP", [rho]) => Box::new(Trapezoidal::new(name, AlphaParameters::spectral(*rho))),
        ("HHT" | "HHT_TP", [inertia, force, beta, gamma]) if *beta > 0.0 => {
            let p = AlphaParameters { inertia: *inertia, force: *force, beta: *beta, gamma: *gamma };
            match base {
                "HHT" => Box::new(GeneralizedAlpha::new(name, p, false)),
                _ => Box::new(Trapezoidal::new(name, p)),
            }
        }
        ("Collocation", [theta]) => Box::new(Collocation::stable(*theta)),
        ("Collocation", [theta, beta, gamma]) if *beta > 0.0 => Box::new(Collocation::new(*theta, *beta, *gamma)),
        _ => {
            let before = if fixed { "" } else { " before the last" };
            let message = format!("{name}: {} parameters{before}, or beta is 0", own.len());
            return Err(a.refuse(message, "expected as below"));
        }
    };
    Ok(Some(match restraint {
        Some((_, restraint)) => Box::new(Restrained::new(name, inner, restraint)),
        None => Box::new(FixedIterations::new(name, inner, order)),
    }))
}

//! `integrator NewmarkHSIncrReduct` and the like: implicit integrators for hybrid simulation.

use super::args::Args;
use super::{Tcl, ignore_option};
use crate::analysis::integrator::{
    AlphaOs, AlphaParameters, Collocation, Form, GeneralizedAlpha, Integrator, Newmark, Restrained, Restraint,
};
use crate::script::Exception;

/// Names, that of the integrator inside first.
pub(super) const NAMES: [(&str, &str); 6] = [
    ("Newmark", "NewmarkHSIncrReduct"),
    ("Newmark", "NewmarkHSIncrLimit"),
    ("HHT", "HHTHSIncrReduct"),
    ("HHT", "HHTHSIncrLimit"),
    ("Collocation", "CollocationHSIncrReduct"),
    ("Collocation", "CollocationHSIncrLimit"),
];

const USAGE: &str = "integrator NewmarkHSIncrReduct $gamma $beta $factor | HHTHSIncrReduct $rhoInf|{$alphaI $alphaF $beta \
                     $gamma} $factor | CollocationHSIncrReduct $theta <$beta $gamma> $factor, and ...HSIncrLimit with \
                     $limit <-normType $p> in place of $factor";

const OPERATOR_SPLITTING: &str = "integrator AlphaOS $alpha <$beta $gamma> <-updateElemDisp> | \
                                  AlphaOSGeneralized $rhoInf|{$alphaI $alphaF $beta $gamma} <-updateElemDisp>";

/// `AlphaOS` and `AlphaOSGeneralized`.
pub(super) fn operator_splitting(
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
    if p.force != 1.0 {
        let message = format!("alphaF is {}: of these methods only those with alphaF = 1 are there yet", p.force);
        return Err(a.refuse(message, "expected 1"));
    }
    Ok(Box::new(AlphaOs::new(if generalized { "AlphaOSGeneralized" } else { "AlphaOS" }, p, update_elements)))
}

/// One of these integrators, by its name; `None` if it is none of them.
pub(super) fn take(interp: &mut Tcl, a: &mut Args<'_>, word: &str) -> Result<Option<Box<dyn Integrator>>, Exception> {
    let Some((base, name)) = NAMES.into_iter().find(|(_, name)| *name == word) else { return Ok(None) };
    a.usage(USAGE);
    let numbers = a.floats("parameter")?;
    let mut norm = 2;
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-normType" => norm = a.int("p of the norm")?,
            _ => ignore_option(interp, a, &["-normType"])?,
        }
    }
    let Some((last, own)) = numbers.split_last() else {
        return Err(a.refuse(format!("{name}: the parameters are missing"), "expected as below"));
    };
    if numbers.iter().any(|x| *x < 0.0) || *last == 0.0 {
        return Err(a.refuse(format!("{name}: a parameter is not greater than 0"), "expected positive numbers"));
    }
    let restraint =
        if name.ends_with("Reduct") { Restraint::Factor(*last) } else { Restraint::Limit { size: *last, norm } };
    let inner: Box<dyn Integrator> = match (base, own) {
        ("Newmark", [gamma, beta]) if *beta > 0.0 => Box::new(Newmark::new(*gamma, *beta, Form::Displacement)),
        ("HHT", [rho]) => Box::new(GeneralizedAlpha::new(name, AlphaParameters::spectral(*rho), false)),
        ("HHT", [inertia, force, beta, gamma]) if *beta > 0.0 => {
            let p = AlphaParameters { inertia: *inertia, force: *force, beta: *beta, gamma: *gamma };
            Box::new(GeneralizedAlpha::new(name, p, false))
        }
        ("Collocation", [theta]) => Box::new(Collocation::stable(*theta)),
        ("Collocation", [theta, beta, gamma]) if *beta > 0.0 => Box::new(Collocation::new(*theta, *beta, *gamma)),
        _ => {
            let message = format!("{name}: {} parameters before the last, or beta is 0", own.len());
            return Err(a.refuse(message, "expected as below"));
        }
    };
    Ok(Some(Box::new(Restrained::new(name, inner, restraint))))
}

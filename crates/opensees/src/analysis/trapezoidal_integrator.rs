//! `integrator HHT_TP` and the like: the forces of both ends of a step are weighted, by the trapezoidal rule.

use crate::args::Args;
use crate::slips;
use crate::{Tcl, ignore_option};
use hysteron_engine::analysis::integrator::{
    AlphaParameters, Integrator, KrAlpha, Trapezoidal, TrapezoidalExplicit, TrapezoidalSplitting,
};
use hysteron_tcl::Exception;

/// Names, and what the words of each are.
const KINDS: [(&str, &str); 7] = [
    ("HHT_TP", "integrator HHT_TP $alpha <$gamma $beta>"),
    ("HHTGeneralized_TP", "integrator HHTGeneralized_TP $rhoInf | $alphaI $alphaF $beta $gamma"),
    ("HHTExplicit_TP", "integrator HHTExplicit_TP $alpha <$gamma>"),
    ("HHTGeneralizedExplicit_TP", "integrator HHTGeneralizedExplicit_TP $rhoB $alphaF | $alphaI $alphaF $beta $gamma"),
    ("AlphaOS_TP", "integrator AlphaOS_TP $alpha <$beta $gamma> <-updateElemDisp>"),
    (
        "AlphaOSGeneralized_TP",
        "integrator AlphaOSGeneralized_TP $rhoInf | $alphaI $alphaF $beta $gamma <-updateElemDisp>",
    ),
    ("KRAlphaExplicit_TP", "integrator KRAlphaExplicit_TP $rhoInf"),
];

/// Names.
pub(crate) fn names() -> impl Iterator<Item = &'static str> {
    KINDS.into_iter().map(|(name, _)| name)
}

/// One of these integrators, by its name; `None` if it is none of them.
pub(crate) fn take(interp: &mut Tcl, a: &mut Args<'_>, word: &str) -> Result<Option<Box<dyn Integrator>>, Exception> {
    let Some((name, usage)) = KINDS.into_iter().find(|(name, _)| *name == word) else { return Ok(None) };
    a.usage(usage);
    let numbers = a.floats("parameter")?;
    let splits = name.starts_with("AlphaOS");
    let mut update_elements = false;
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-updateElemDisp" if splits => update_elements = true,
            _ => ignore_option(interp, a, if splits { &["-updateElemDisp"] } else { &[] })?,
        }
    }
    let four = |inertia, force, beta, gamma| AlphaParameters { inertia, force, beta, gamma };
    let p = match (name, numbers.as_slice()) {
        ("HHT_TP" | "AlphaOS_TP", &[alpha]) => AlphaParameters::second_order(1.0, alpha),
        // The manual's order is gamma, beta; OpenSees takes the two the other way round.
        ("HHT_TP", &[alpha, beta, gamma]) if interp.host.follows(&[slips::HHT_TP_ORDER]) => {
            four(1.0, alpha, beta, gamma)
        }
        ("HHT_TP", &[alpha, gamma, beta]) | ("AlphaOS_TP", &[alpha, beta, gamma]) => four(1.0, alpha, beta, gamma),
        ("HHTExplicit_TP", &[alpha]) => four(1.0, alpha, 0.0, 0.5),
        ("HHTExplicit_TP", &[alpha, gamma]) => four(1.0, alpha, 0.0, gamma),
        ("HHTGeneralizedExplicit_TP", &[rho, force]) => {
            if force == 1.0 || rho == 2.0 {
                let message = format!("alphaF is {force}, rhoB {rho}");
                return Err(a.refuse(message, "expected alphaF other than 1 and rhoB other than 2"));
            }
            AlphaParameters::explicit_by_bifurcation(rho, force)
        }
        ("HHTGeneralized_TP" | "AlphaOSGeneralized_TP" | "KRAlphaExplicit_TP", &[rho]) => {
            if !(0.0..=1.0).contains(&rho) {
                return Err(a.refuse(format!("the spectral radius is {rho}"), "expected 0 to 1"));
            }
            AlphaParameters::spectral(rho)
        }
        (
            "HHTGeneralized_TP" | "HHTGeneralizedExplicit_TP" | "AlphaOSGeneralized_TP",
            &[inertia, force, beta, gamma],
        ) => four(inertia, force, beta, gamma),
        _ => return Err(a.refuse(format!("{name}: {} parameters do not fit", numbers.len()), "expected as below")),
    };
    let explicit = name.contains("Explicit");
    let positive = [p.inertia, p.force, p.gamma].iter().all(|x| *x > 0.0);
    if !positive || (!explicit && p.beta <= 0.0) {
        return Err(a.refuse(format!("{name}: a parameter is not greater than 0"), "expected positive numbers"));
    }
    Ok(Some(match name {
        "KRAlphaExplicit_TP" => Box::new(KrAlpha::trapezoidal(numbers[0])),
        _ if splits => Box::new(TrapezoidalSplitting::new(name, p, update_elements)),
        _ if explicit => Box::new(TrapezoidalExplicit::new(name, p)),
        _ => Box::new(Trapezoidal::new(name, p)),
    }))
}

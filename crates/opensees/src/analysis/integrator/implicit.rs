//! Implicit integrators of transient analyses.

use super::{
    ALPHA, ALPHA_F, ALPHA_I, BETA, BETA_OR_0, GAMMA, IntegratorResult, Kind, RHO_INF, THETA, alpha_parameters,
};
use crate::args::Args;
use crate::checks;
use crate::slips;
use crate::text::{Arg, Text};
use crate::{Tcl, ignore_unknown, warn};
use hysteron_engine::analysis::Coefficients;
use hysteron_engine::analysis::integrator::{
    AlphaParameters, Collocation, Form, GeneralizedAlpha, GimmeMck, Hht, Newmark, backward_euler, houbolt, park_lms3,
    trbdf2, trbdf3,
};
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::Diagnostic;

const GENERALIZED_ALPHA_ALPHA_M: Arg = Arg::positive("alphaM", "alphaM");
const GIMME_MCK_M: Arg = Arg::number("m", "share of the mass");
const GIMME_MCK_C: Arg = Arg::number("c", "share of the damping");
const GIMME_MCK_K: Arg = Arg::number("k", "share of the stiffness");

pub(super) const KINDS: &[Kind] = &[
    Kind {
        names: &["Newmark"],
        usage: "integrator Newmark $gamma $beta <-form D|V|A>",
        text: Text::new("Newmark's method.").arguments(&[BETA_OR_0]),
        make: newmark,
    },
    Kind {
        names: &["Newmark1"],
        usage: "integrator Newmark1 $gamma $beta <$alphaM $betaK $betaK0 $betaKc>",
        text: Text::new("Newmark's method in its older form."),
        make: newmark1,
    },
    Kind {
        names: &["HHT"],
        usage: "integrator HHT $alpha <$gamma $beta>",
        text: Text::new("The method of Hilber, Hughes and Taylor."),
        make: hht,
    },
    Kind {
        names: &["HHTGeneralized"],
        usage: "integrator HHTGeneralized $rhoInf | $alphaI $alphaF $beta $gamma",
        text: Text::new("The generalised alpha method by a spectral radius."),
        make: hht_generalized,
    },
    Kind {
        names: &["GeneralizedAlpha"],
        usage: "integrator GeneralizedAlpha $alphaM $alphaF <$beta $gamma>",
        text: Text::new("The generalised alpha method.").arguments(&[GENERALIZED_ALPHA_ALPHA_M]),
        make: generalized_alpha,
    },
    Kind {
        names: &["Collocation"],
        usage: "integrator Collocation $theta <$beta $gamma>",
        text: Text::new("The collocation method."),
        make: collocation,
    },
    Kind {
        names: &["WilsonTheta"],
        usage: "integrator WilsonTheta $theta",
        text: Text::new("Wilson's method."),
        make: wilson_theta,
    },
    Kind {
        names: &["TRBDF2", "Bathe"],
        usage: "integrator TRBDF2",
        text: Text::new("The composite method of Bank and others."),
        make: |_, _| Ok(trbdf2()),
    },
    Kind {
        names: &["TRBDF3", "Bathe3"],
        usage: "integrator TRBDF3",
        text: Text::new("A composite method of three steps."),
        make: |_, _| Ok(trbdf3()),
    },
    Kind {
        names: &["Houbolt"],
        usage: "integrator Houbolt",
        text: Text::new("Houbolt's method."),
        make: |_, _| Ok(houbolt()),
    },
    Kind {
        names: &["ParkLMS3"],
        usage: "integrator ParkLMS3",
        text: Text::new("Park's method."),
        make: |_, _| Ok(park_lms3()),
    },
    Kind {
        names: &["BackwardEuler"],
        usage: "integrator BackwardEuler <0 | 1>",
        text: Text::new("Backward differences."),
        make: |_, a| Ok(backward_euler(a.optional_int("option")? == Some(1))),
    },
    Kind {
        names: &["GimmeMCK", "ZZTop"],
        usage: "integrator GimmeMCK $m $c $k",
        text: Text::new("No motion: the matrix $m M + c C + k K$, for `printA`.").arguments(&[
            GIMME_MCK_M,
            GIMME_MCK_C,
            GIMME_MCK_K,
        ]),
        make: gimme_mck,
    },
];

fn newmark(interp: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    let gamma = a.number(&GAMMA)?;
    let at = a.last_span();
    let beta = a.number(&BETA_OR_0)?;
    let span = a.last_span();
    if gamma < 0.5 {
        let mut d = Diagnostic::warning(
            &checks::analysis::UNSTABLE_METHOD,
            format!("Newmark: gamma is {gamma}, so that the motion grows by itself"),
        );
        if beta >= 0.5 {
            d = d.help("gamma comes first, then beta: are they the wrong way round?");
        }
        warn(interp, d.at(at, "expected gamma, at least 0.5"))?;
    }
    let mut form = Form::Displacement;
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-form" => {
                form = match a.word("form: D, V or A")?.as_ref() {
                    "D" | "d" => Form::Displacement,
                    "V" | "v" => Form::Velocity,
                    "A" | "a" => Form::Acceleration,
                    _ => return Err(a.unknown_name("form of Newmark's method", ["D", "V", "A"])),
                };
            }
            _ => ignore_unknown(interp, a)?,
        }
    }
    if beta == 0.0 && form != Form::Acceleration {
        return Err(a.refuse_at(span, "beta is 0: the method is explicit", "expected -form A with it"));
    }
    Ok(Box::new(Newmark::new(gamma, beta, form)))
}

fn newmark1(interp: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    let (gamma, beta) = (a.number(&GAMMA)?, a.number(&BETA)?);
    super::rayleigh(interp, a)?;
    Ok(Box::new(Newmark::new(gamma, beta, Form::Displacement)))
}

fn hht(interp: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    let alpha = a.number(&ALPHA)?;
    let good = (2.0 / 3.0 - 1e-3..=1.0).contains(&alpha);
    if !good {
        let message = format!("HHT: alpha is {alpha}, so that the method is not stable whatever the step");
        let help = "here alpha is 1 less what the paper calls minus alpha: 1 is Newmark's method";
        let d = Diagnostic::warning(&checks::analysis::UNSTABLE_METHOD, message)
            .at(a.last_span(), "expected 2/3 to 1")
            .help(help);
        warn(interp, d)?;
    }
    Ok(match a.optional_number(&GAMMA)? {
        Some(gamma) => Box::new(Hht::new(alpha, gamma, a.number(&BETA)?)),
        None => Box::new(Hht::second_order(alpha)),
    })
}

fn hht_generalized(_: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    let p = if a.left() <= 1 {
        AlphaParameters::spectral(a.number(&RHO_INF)?)
    } else {
        alpha_parameters(a.number(&ALPHA_I)?, a.number(&ALPHA_F)?, a.number(&BETA)?, a.number(&GAMMA)?)
    };
    Ok(Box::new(GeneralizedAlpha::new("HHTGeneralized", p, false)))
}

fn generalized_alpha(interp: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    let (inertia, force) = (a.number(&GENERALIZED_ALPHA_ALPHA_M)?, a.number(&ALPHA_F)?);
    let p = if a.left() == 0 {
        AlphaParameters::second_order(inertia, force)
    } else {
        alpha_parameters(inertia, force, a.number(&BETA)?, a.number(&GAMMA)?)
    };
    Ok(Box::new(GeneralizedAlpha::new("GeneralizedAlpha", p, interp.host.follows(&[slips::GENERALIZED_ALPHA]))))
}

/// Take the collocation point θ, in steps. Warn where the method is not stable for every step.
fn collocation_point(interp: &mut Tcl, a: &mut Args<'_>, least: f64) -> Result<f64, Exception> {
    let theta = a.number(&THETA)?;
    if theta < least {
        let message = format!("theta is {theta}, so that the method is not stable whatever the step");
        warn(
            interp,
            Diagnostic::warning(&checks::analysis::UNSTABLE_METHOD, message)
                .at(a.last_span(), format!("expected at least {least}")),
        )?;
    }
    Ok(theta)
}

fn collocation(interp: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    let theta = collocation_point(interp, a, 1.0)?;
    Ok(Box::new(match a.optional_number(&BETA)? {
        Some(beta) => Collocation::new(theta, beta, a.number(&GAMMA)?),
        None => Collocation::stable(theta),
    }))
}

/// Smallest θ for which Wilson's method is stable for every step.
const WILSON_STABLE_THETA: f64 = 1.37;

fn wilson_theta(interp: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    Ok(Box::new(Collocation::wilson(collocation_point(interp, a, WILSON_STABLE_THETA)?)))
}

fn gimme_mck(_: &mut Tcl, a: &mut Args<'_>) -> IntegratorResult {
    let (m, c) = (a.number(&GIMME_MCK_M)?, a.number(&GIMME_MCK_C)?);
    Ok(Box::new(GimmeMck(Coefficients { k: a.number(&GIMME_MCK_K)?, c, m })))
}

//! `integrator`.

use crate::analysis::hybrid_integrator;
use crate::analysis::trapezoidal_integrator;
use crate::args::Args;
use crate::model::nodes::node_of;
use crate::slips;
use crate::{Command, Outcome, Tcl, finish, ignore_option, warn};
use hysteron_engine::analysis::integrator::{
    Adaptive, AlphaParameters, ArcLength, CentralDifference, CentralDifferenceAlternative, Collocation,
    DisplacementControl, ExplicitAlpha, ExplicitBathe, ExplicitDifference, Form, GeneralizedAlpha, GimmeMck, Hht,
    Integrator, LoadControl, MinUnbalDispNorm, Newmark, Sense, backward_euler, houbolt, park_lms3, trbdf2, trbdf3,
};
use hysteron_engine::analysis::{Coefficients, TangentMix};
use hysteron_tcl::diagnostic::Diagnostic;
use hysteron_tcl::{Call, Exception, Value};

pub(crate) const COMMANDS: &[Command] = &[Command { name: "integrator", usage: INTEGRATOR, run: integrator }];

const INTEGRATOR: &str = "integrator LoadControl | DisplacementControl | ArcLength | Newmark | HHT | ... <options>";

/// Numbers after the step of a static integrator: iterations wanted, smallest and largest step.
fn adaptive(a: &mut Args<'_>, step: f64) -> Result<Adaptive, Exception> {
    let Some(desired) = a.optional_int("number of iterations wanted")? else { return Ok(Adaptive::fixed(step)) };
    if desired < 1 {
        return Err(a.refuse(format!("the number of iterations wanted is {desired}"), "expected at least 1"));
    }
    let min = a.optional_float("smallest step")?.unwrap_or(step);
    let max = a.optional_float("largest step")?.unwrap_or(step);
    Ok(Adaptive { desired_iterations: desired as usize, min, max })
}

const INTEGRATORS: [&str; 29] = [
    "LoadControl",
    "DisplacementControl",
    "ArcLength",
    "ArcLength1",
    "MinUnbalDispNorm",
    "Newmark",
    "Newmark1",
    "HHT",
    "HHTGeneralized",
    "GeneralizedAlpha",
    "Collocation",
    "WilsonTheta",
    "TRBDF2",
    "TRBDF3",
    "Houbolt",
    "ParkLMS3",
    "BackwardEuler",
    "CentralDifference",
    "CentralDifferenceAlternative",
    "CentralDifferenceNoDamping",
    "ExplicitDifference",
    "ExplicitBathe",
    "NewmarkExplicit",
    "HHTExplicit",
    "HHTGeneralizedExplicit",
    "GimmeMCK",
    "AlphaOS",
    "AlphaOSGeneralized",
    "KRAlphaExplicit",
];

/// Factors of Rayleigh damping that may end the command of an integrator: they count as the command `rayleigh`.
fn integrator_rayleigh(interp: &mut Tcl, a: &mut Args<'_>) -> Result<(), Exception> {
    if a.at_number() {
        crate::analysis::damping::set_rayleigh(interp, a)?;
    }
    Ok(())
}

fn integrator(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, INTEGRATOR);
    let made: Box<dyn Integrator> = match a.word("kind of integrator")?.as_ref() {
        "LoadControl" => {
            a.usage("integrator LoadControl $increment <$iterations $min $max>");
            let step = a.float("increment of the load factor")?;
            Box::new(LoadControl::new(step, adaptive(&mut a, step)?))
        }
        "DisplacementControl" => {
            a.usage("integrator DisplacementControl $node $dof $increment <$iterations $min $max>");
            let node = node_of(interp, &mut a, "tag of the node")?;
            let (ndf, offset) = {
                let n = &interp.host.engine.model().nodes[node.0];
                (n.ndf, n.offset)
            };
            let dof = a.dof("degree of freedom", ndf)?;
            let step = a.float("increment of the displacement")?;
            let adaptive = adaptive(&mut a, step)?;
            let mix = if a.flag("-initial") { TangentMix::INITIAL } else { TangentMix::CURRENT };
            Box::new(DisplacementControl::new(offset + dof, step, adaptive, mix))
        }
        "Newmark" => newmark(interp, &mut a)?,
        "HHT" => {
            a.usage("integrator HHT $alpha <$gamma $beta>");
            let alpha = a.positive("alpha")?;
            let good = (2.0 / 3.0 - 1e-3..=1.0).contains(&alpha);
            if !good {
                let message = format!("HHT: alpha is {alpha}, so that the method is not stable whatever the step");
                let help = "here alpha is 1 less what the paper calls minus alpha: 1 is Newmark's method";
                let d = Diagnostic::warning(message).at(a.last_span(), "expected 2/3 to 1").help(help);
                warn(interp, d)?;
            }
            match a.optional_float("gamma")? {
                Some(gamma) => Box::new(Hht::new(alpha, gamma, a.positive("beta")?)),
                None => Box::new(Hht::second_order(alpha)),
            }
        }
        "ArcLength" => {
            a.usage("integrator ArcLength $length <$alpha>");
            let length = a.positive("arc length")?;
            Box::new(ArcLength::new(length, a.optional_float("weight alpha of the load factor")?.unwrap_or(1.0)))
        }
        "ArcLength1" => {
            a.usage("integrator ArcLength1 $length <$alpha>");
            let length = a.positive("arc length")?;
            Box::new(ArcLength::linearised(length, a.optional_float("weight alpha of the load factor")?.unwrap_or(1.0)))
        }
        "MinUnbalDispNorm" => {
            a.usage("integrator MinUnbalDispNorm $increment <$iterations $min $max> <-determinant>");
            let increment = a.float("first increment of the load factor")?;
            let adaptive = adaptive(&mut a, increment)?;
            let by_stiffness = a.flag("-determinant") || a.flag("-det");
            let sense = if by_stiffness { Sense::Stiffness } else { Sense::LastStep };
            Box::new(MinUnbalDispNorm::new(increment, adaptive, sense))
        }
        "HHTGeneralized" => {
            a.usage("integrator HHTGeneralized $rhoInf | $alphaI $alphaF $beta $gamma");
            let first = a.not_negative("spectral radius rhoInf, or alphaI")?;
            let p = if a.left() == 0 {
                AlphaParameters::spectral(first)
            } else {
                let force = a.positive("alphaF")?;
                AlphaParameters { inertia: first, force, beta: a.positive("beta")?, gamma: a.positive("gamma")? }
            };
            Box::new(GeneralizedAlpha::new("HHTGeneralized", p, false))
        }
        "GeneralizedAlpha" => {
            a.usage("integrator GeneralizedAlpha $alphaM $alphaF <$beta $gamma>");
            let (inertia, force) = (a.positive("alphaM")?, a.positive("alphaF")?);
            let p = if a.left() == 0 {
                AlphaParameters::second_order(inertia, force)
            } else {
                AlphaParameters { inertia, force, beta: a.positive("beta")?, gamma: a.positive("gamma")? }
            };
            Box::new(GeneralizedAlpha::new("GeneralizedAlpha", p, interp.host.follows(&[slips::GENERALIZED_ALPHA])))
        }
        "Collocation" => {
            a.usage("integrator Collocation $theta <$beta $gamma>");
            let theta = collocation_place(interp, &mut a, 1.0)?;
            Box::new(match a.optional_float("beta")? {
                Some(beta) if beta > 0.0 => Collocation::new(theta, beta, a.positive("gamma")?),
                Some(beta) => return Err(a.refuse(format!("beta is {beta}"), "expected a number greater than 0")),
                None => Collocation::stable(theta),
            })
        }
        "WilsonTheta" => {
            a.usage("integrator WilsonTheta $theta");
            Box::new(Collocation::wilson(collocation_place(interp, &mut a, 1.37)?))
        }
        "TRBDF2" | "Bathe" => trbdf2(),
        "TRBDF3" | "Bathe3" => trbdf3(),
        "Houbolt" => houbolt(),
        "ParkLMS3" => park_lms3(),
        "BackwardEuler" => {
            a.usage("integrator BackwardEuler <0 | 1>");
            backward_euler(a.optional_int("option")? == Some(1))
        }
        name @ ("CentralDifference" | "CentralDifferenceAlternative" | "CentralDifferenceNoDamping") => {
            let (name, damped) = match name {
                "CentralDifference" => ("CentralDifference", true),
                "CentralDifferenceAlternative" => ("CentralDifferenceAlternative", true),
                _ => ("CentralDifferenceNoDamping", false),
            };
            // Factors of Rayleigh damping may follow, which older scripts give here.
            integrator_rayleigh(interp, &mut a)?;
            let compat = interp.host.follows(&[slips::CENTRAL_DIFFERENCE_START]);
            if compat && name == "CentralDifferenceAlternative" {
                Box::new(CentralDifferenceAlternative::default())
            } else {
                Box::new(CentralDifference::new(name, damped, compat))
            }
        }
        "ExplicitDifference" | "Explicitdifference" => {
            a.usage("integrator ExplicitDifference");
            Box::new(ExplicitDifference::new(interp.host.follows(&[slips::EXPLICIT_START])))
        }
        "ExplicitBathe" => {
            a.usage("integrator ExplicitBathe $p");
            let p = a.positive("share p of the first part of a step")?;
            if p >= 1.0 {
                return Err(a.refuse(format!("p is {p}"), "expected more than 0 and less than 1"));
            }
            // Whether OpenSees prints the longest stable step.
            a.optional_int("0 or 1")?;
            Box::new(ExplicitBathe::new(p, interp.host.follows(&[slips::EXPLICIT_START])))
        }
        "NewmarkExplicit" => {
            a.usage("integrator NewmarkExplicit $gamma");
            let gamma = a.positive("gamma")?;
            let p = AlphaParameters { inertia: 1.0, force: 1.0, beta: 0.0, gamma };
            Box::new(ExplicitAlpha::new("NewmarkExplicit", p, true))
        }
        "HHTExplicit" => {
            a.usage("integrator HHTExplicit $alpha <$gamma> <-updateElemDisp>");
            let force = a.positive("alpha")?;
            let gamma = a.optional_float("gamma")?.unwrap_or(0.5);
            let update = a.flag("-updateElemDisp") || !interp.host.follows(&[slips::EXPLICIT_ELEMENTS]);
            let p = AlphaParameters { inertia: 1.0, force, beta: 0.0, gamma };
            Box::new(ExplicitAlpha::new("HHTExplicit", p, update))
        }
        "HHTGeneralizedExplicit" => {
            a.usage("integrator HHTGeneralizedExplicit $rhoB $alphaF | $alphaI $alphaF $beta $gamma <-updateElemDisp>");
            let (first, force) = (a.not_negative("spectral radius rhoB, or alphaI")?, a.positive("alphaF")?);
            let p = if a.at_number() {
                AlphaParameters { inertia: first, force, beta: a.not_negative("beta")?, gamma: a.positive("gamma")? }
            } else {
                if force == 1.0 || first == 2.0 {
                    return Err(
                        a.refuse(format!("alphaF is {force}"), "expected alphaF other than 1 and rhoB other than 2")
                    );
                }
                AlphaParameters::explicit_by_bifurcation(first, force)
            };
            let update = a.flag("-updateElemDisp") || !interp.host.follows(&[slips::EXPLICIT_ELEMENTS]);
            Box::new(ExplicitAlpha::new("HHTGeneralizedExplicit", p, update))
        }
        "GimmeMCK" | "ZZTop" => {
            a.usage("integrator GimmeMCK $m $c $k");
            let (m, c) = (a.float("share of the mass")?, a.float("share of the damping")?);
            Box::new(GimmeMck(Coefficients { k: a.float("share of the stiffness")?, c, m }))
        }
        name @ ("AlphaOS" | "AlphaOSGeneralized") => {
            hybrid_integrator::operator_splitting(interp, &mut a, name == "AlphaOSGeneralized")?
        }
        "KRAlphaExplicit" => hybrid_integrator::kolay_ricles(interp, &mut a)?,
        "Newmark1" => {
            a.usage("integrator Newmark1 $gamma $beta <$alphaM $betaK $betaK0 $betaKc>");
            let (gamma, beta) = (a.positive("gamma")?, a.positive("beta")?);
            integrator_rayleigh(interp, &mut a)?;
            Box::new(Newmark::new(gamma, beta, Form::Displacement))
        }
        other => {
            let made = match hybrid_integrator::take(interp, &mut a, other)? {
                Some(made) => Some(made),
                None => trapezoidal_integrator::take(interp, &mut a, other)?,
            };
            made.ok_or_else(|| {
                let hybrid = hybrid_integrator::NAMES.iter().map(|(_, name)| *name);
                let all = INTEGRATORS.into_iter().chain(hybrid).chain(trapezoidal_integrator::names());
                a.unknown_name("integrator", all)
            })?
        }
    };
    finish(interp, &a)?;
    let is_static = made.is_static();
    let fits = interp.host.engine.setup().is_some_and(|s| s.integrator.is_static() == is_static);
    if fits {
        interp.host.engine.change_setup(|s| s.integrator = made);
    } else {
        interp.host.parts.integrator = Some(made);
    }
    Ok(Value::EMPTY)
}

/// The place θ of collocation, in steps, and a warning where the method is not stable whatever the step.
fn collocation_place(interp: &mut Tcl, a: &mut Args<'_>, least: f64) -> Result<f64, Exception> {
    let theta = a.positive("theta")?;
    if theta < least {
        let message = format!("theta is {theta}, so that the method is not stable whatever the step");
        warn(interp, Diagnostic::warning(message).at(a.last_span(), format!("expected at least {least}")))?;
    }
    Ok(theta)
}

fn newmark(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Box<dyn Integrator>, Exception> {
    a.usage("integrator Newmark $gamma $beta <-form D|V|A>");
    let gamma = a.positive("gamma")?;
    let at = a.last_span();
    let beta = a.not_negative("beta")?;
    let span = a.last_span();
    if gamma < 0.5 {
        let mut d = Diagnostic::warning(format!("Newmark: gamma is {gamma}, so that the motion grows by itself"));
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
            _ => ignore_option(interp, a, &["-form"])?,
        }
    }
    if beta == 0.0 && form != Form::Acceleration {
        return Err(a.refuse_at(span, "beta is 0: the method is explicit", "expected -form A with it"));
    }
    Ok(Box::new(Newmark::new(gamma, beta, form)))
}

//! `integrator`.

mod explicit;
mod hybrid;
mod implicit;
mod load_stepping;
mod trapezoidal;

use crate::args::Args;
use crate::checks;
use crate::text::{Arg, Domain};
use crate::{Command, Outcome, Tcl, finish, kind, slips, warn};
use hysteron_engine::analysis::integrator::{AlphaParameters, Integrator};
use hysteron_tcl::diagnostic::Diagnostic;
use hysteron_tcl::{Call, Exception, Value};

pub(crate) const COMMANDS: &[Command] = &[Command::new("integrator", INTEGRATOR, integrator)
    .about("Chooses how a step advances time or load.")
    .arguments(&[
        Arg::number("alphaM", "factor of the mass alphaM"),
        Arg::number("betaK", "factor of the current stiffness betaK"),
        Arg::number("betaK0", "factor of the initial stiffness betaK0"),
        Arg::number("betaKc", "factor of the committed stiffness betaKc"),
        hybrid::FACTOR,
        Arg::new("{$alphaI $alphaF $beta $gamma}", "a parameter"),
        ITERATIONS,
        RHO_INF,
        THETA,
        hybrid::LIMIT,
        hybrid::POLY_ORDER,
        GAMMA,
        BETA,
        ALPHA_I,
        ALPHA_F,
        ALPHA,
    ])
    .with_kinds(|| FAMILIES.iter().flat_map(|kinds| kind::usages(kinds)).collect())];

const INTEGRATOR: &str = "integrator LoadControl | DisplacementControl | ArcLength | Newmark | HHT | ... <options>";

/// Iterations wanted: the step grows where fewer are needed.
const ITERATIONS: Arg = Arg::count("iterations", "number of iterations wanted");
const GAMMA: Arg = Arg::positive("gamma", "Newmark parameter gamma");
const BETA: Arg = Arg::positive("beta", "Newmark parameter beta");
/// The Newmark parameter of methods for which it may be 0.
const BETA_OR_0: Arg = BETA.within(Domain::NotNegative);
const ALPHA: Arg = Arg::positive("alpha", "weight alpha of the forces at the end");
const ALPHA_I: Arg = Arg::not_negative("alphaI", "weight alphaI of the inertia at the end");
const ALPHA_F: Arg = Arg::positive("alphaF", "weight alphaF of the forces at the end");
const RHO_INF: Arg = Arg::not_negative("rhoInf", "spectral radius rhoInf at infinite frequency");
/// The spectral radius of methods that have none over 1.
const RHO_INF_TO_1: Arg = RHO_INF.within(Domain::Fraction);
const RHO_B: Arg = Arg::not_negative("rhoB", "spectral radius rhoB at the bifurcation");
const THETA: Arg = Arg::positive("theta", "collocation parameter theta");

type IntegratorResult = Result<Box<dyn Integrator>, Exception>;

/// A kind of integrator, made from the words after its name.
type Kind = kind::Kind<fn(&mut Tcl, &mut Args<'_>) -> IntegratorResult>;

const FAMILIES: &[&[Kind]] =
    &[load_stepping::KINDS, implicit::KINDS, explicit::KINDS, hybrid::KINDS, trapezoidal::KINDS];

fn integrator(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, INTEGRATOR);
    let taken = kind::take(&mut a, "kind of integrator", "integrator", FAMILIES.iter().copied().flatten());
    let kind = match taken {
        Err(_) if interp.host.follows(&[slips::UNKNOWN_INTEGRATOR]) && call.len() > 1 => {
            let d = Diagnostic::warning(
                &checks::analysis::UNKNOWN_INTEGRATOR,
                format!("the integrator \"{}\" is not known, and the command does nothing", call.arg(1).as_str()),
            );
            return warn(interp, d.at(call.span(1), "not known")).map(|()| Value::EMPTY);
        }
        taken => taken?,
    };
    interp.host.note_kind("integrator", kind.names[0]);
    let made = (kind.make)(interp, &mut a)?;
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

/// Take the factors of Rayleigh damping that may end the command: they count as the command `rayleigh`.
fn rayleigh(interp: &mut Tcl, a: &mut Args<'_>) -> Result<(), Exception> {
    if a.at_number() {
        crate::analysis::damping::set_rayleigh(interp, a)?;
    }
    Ok(())
}

/// Parameters of an explicit method by its spectral radius at the bifurcation.
fn by_bifurcation(a: &Args<'_>, rho: f64, force: f64) -> Result<AlphaParameters, Exception> {
    if force == 1.0 || rho == 2.0 {
        let message = format!("alphaF is {force}, rhoB {rho}");
        return Err(a.refuse(message, "expected alphaF other than 1 and rhoB other than 2"));
    }
    Ok(AlphaParameters::explicit_by_bifurcation(rho, force))
}

/// Parameters of a method with the equation of motion at fractions of the step.
fn alpha_parameters(inertia: f64, force: f64, beta: f64, gamma: f64) -> AlphaParameters {
    AlphaParameters { inertia, force, beta, gamma }
}

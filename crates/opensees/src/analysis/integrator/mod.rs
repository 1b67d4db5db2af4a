//! `integrator`.

mod explicit;
mod hybrid;
mod implicit;
mod load_stepping;
mod trapezoidal;

use crate::args::Args;
use crate::checks;
use crate::text::Arg;
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
        Arg::new("factor", "a parameter"),
        Arg::new("{$alphaI $alphaF $beta $gamma}", "a parameter"),
        Arg::new("iterations", "iterations wanted: the step grows where fewer are needed"),
        Arg::not_negative("rhoInf", "spectral radius at infinite frequency"),
        Arg::positive("theta", "collocation parameter theta"),
        Arg::new("limit", "limit of a correction, for `...HSIncrLimit`"),
        Arg::flag("-polyOrder", "order of the polynomial between steps"),
        Arg::positive("gamma", "Newmark parameter gamma"),
        Arg::positive("beta", "Newmark parameter beta"),
        Arg::not_negative("alphaI", "weight alphaI of the inertia at the end"),
        Arg::positive("alphaF", "weight alphaF of the forces at the end"),
        Arg::number("alpha", "weight alpha of the forces at the end"),
    ])
    .with_kinds(|| FAMILIES.iter().flat_map(|kinds| kind::usages(kinds)).collect())];

const INTEGRATOR: &str = "integrator LoadControl | DisplacementControl | ArcLength | Newmark | HHT | ... <options>";

/// The Newmark parameter of methods for which it may be 0.
const BETA: Arg = Arg::not_negative("beta", "Newmark parameter beta");

/// Arguments of the methods of Hilber, Hughes and Taylor.
const HHT: &[Arg] =
    &[Arg::positive("alpha", "weight alpha of the forces at the end"), Arg::number("gamma", "Newmark parameter gamma")];

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

/// Parameters of a method with the equation of motion at fractions of the step.
fn alpha_parameters(inertia: f64, force: f64, beta: f64, gamma: f64) -> AlphaParameters {
    AlphaParameters { inertia, force, beta, gamma }
}

//! Derivatives of the response with respect to parameters: `sensitivityAlgorithm computeGradients sensNodeDisp ...`.

use super::{PARAMETER_PATTERN, Place, read, refusal, write};
use crate::args::Args;
use crate::checks;
use crate::host::Mode;
use crate::model::nodes::{DOF, NODE, node_of};
use crate::output::query::ELE_RESPONSE_ELEMENT;
use crate::text::Arg;
use crate::things;
use crate::{Command, Outcome, Tcl, finish, warn};
use hysteron_engine::analysis::{Engine, State};
use hysteron_engine::model::Tag;
use hysteron_engine::parameter::NewValue;
use hysteron_engine::record::{ElementResponse, Known};
use hysteron_tcl::diagnostic::Diagnostic;
use hysteron_tcl::{Call, Exception, Value};

/// Distance of the two values of a parameter from its own, as a fraction of it. The error of the central difference is its
/// square, 1e-8, and the round-off of the solution, 1e-13, over it.
const DISTANCE: f64 = 1e-4;
/// The same where only one side can be had: the error is the distance itself.
const ONE_SIDED: f64 = 1e-6;

const PARAMETER: Arg = Arg::whole("parameter", "tag of the parameter");
const SECTION: Arg = Arg::count("section", "number of the section from 1; left out of an element with one section");

const ALGORITHM: &str = "sensitivityAlgorithm -computeAtEachStep | -computeByCommand";
const OF_NODE: &str = "sensNodeDisp $node $dof $parameter";
const OF_FACTOR: &str = "sensLambda $pattern $parameter";
const OF_SECTION: &str = "sensSectionForce $element <$section> $dof $parameter";

pub(crate) const COMMANDS: &[Command] = &[
    Command::new("sensitivityAlgorithm", ALGORITHM, algorithm)
        .arguments(&[
            Arg::flag("-computeAtEachStep", "the derivatives follow each step"),
            Arg::flag("-computeByCommand", "the same: the history of a law takes part in each step"),
        ])
        .about(
            "Begins derivatives of the response with respect to all parameters. They are central differences of two more \
             analyses for each parameter, which make the same steps. Every law and element has them.",
        ),
    Command::asking("computeGradients", "computeGradients", compute)
        .about("Has no effect: derivatives are those of the last step."),
    Command::asking("sensNodeDisp", OF_NODE, |i, c| of_node(i, c, |s| &s.disp))
        .arguments(&[NODE, DOF, PARAMETER])
        .about("Returns the derivative of a displacement with respect to a parameter."),
    Command::asking("sensNodeVel", OF_NODE, |i, c| of_node(i, c, |s| &s.vel))
        .about("Returns the derivative of a velocity with respect to a parameter."),
    Command::asking("sensNodeAccel", OF_NODE, |i, c| of_node(i, c, |s| &s.accel))
        .about("Returns the derivative of an acceleration with respect to a parameter."),
    Command::asking("sensLambda", OF_FACTOR, of_factor)
        .arguments(&[PARAMETER_PATTERN, PARAMETER])
        .about("Returns the derivative of the load factor of a pattern with respect to a parameter."),
    Command::asking("sensSectionForce", OF_SECTION, of_section)
        .arguments(&[ELE_RESPONSE_ELEMENT, SECTION, DOF, PARAMETER])
        .about("Returns the derivative of a resultant of a section with respect to a parameter."),
];

fn algorithm(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, ALGORITHM);
    match a.word("time of the derivatives")?.as_ref() {
        "-computeAtEachStep" | "-computeByCommand" => {}
        _ => return Err(a.unknown_name("time of the derivatives", ["-computeAtEachStep", "-computeByCommand"])),
    }
    finish(interp, &a)?;
    if interp.host.output.recorders.journal.is_some() {
        return Err(a.refuse("checkpoints do not keep derivatives", "run the script without checkpoints"));
    }
    interp.host.derived.get_or_insert_default();
    Ok(Value::EMPTY)
}

fn compute(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let a = Args::new(call, "computeGradients");
    finish(interp, &a)?;
    warn_without(interp, call)?;
    Ok(Value::from(0i64))
}

/// Engines for the derivatives of the analysis that is going to begin.
pub(crate) fn begin(interp: &mut Tcl) {
    let session = &mut interp.host;
    let parameters = &session.builder.parameters;
    let Some(derived) = session.derived.as_mut().filter(|_| session.mode == Mode::Run) else { return };
    if derived == parameters && session.engine.derivatives_are_current() {
        return;
    }
    derived.clone_from(parameters);
    let engines = derived.clone().into_iter().filter_map(|(tag, p)| {
        let places = present(interp, &p.places);
        let (ends, distance) = ends(interp, &places, p.value)?;
        Some((tag, ends, distance))
    });
    let engines: Vec<_> = engines.collect();
    interp.host.engine.set_derivatives(engines);
}

/// Places of a parameter that are in the model.
fn present(interp: &mut Tcl, places: &[Place]) -> Vec<Place> {
    places.iter().filter(|place| read(interp, place).is_some()).cloned().collect()
}

/// Engines with less and with more of a parameter, and the difference. `None` where it is nowhere, or no other value is taken.
fn ends(interp: &mut Tcl, places: &[Place], value: f64) -> Option<([Engine; 2], f64)> {
    if places.is_empty() {
        return None;
    }
    let size = if value == 0.0 { 1.0 } else { value.abs() };
    let d = DISTANCE * size;
    if let (Some(less), Some(more)) = (engine_with(interp, places, -d), engine_with(interp, places, d)) {
        return Some(([less, more], 2.0 * d));
    }
    let d = ONE_SIDED * size;
    let own = interp.host.engine.beside();
    if let Some(more) = engine_with(interp, places, d) {
        return Some(([own, more], d));
    }
    engine_with(interp, places, -d).map(|less| ([less, own], d))
}

/// An engine beside that of the script with other values at some places. `None` where one of them is refused.
fn engine_with(interp: &mut Tcl, places: &[Place], more: f64) -> Option<Engine> {
    let more = NewValue::Plus(more);
    for place in places {
        let own = read(interp, place)?;
        let is_negative_mass =
            matches!(place, Place::Mass { .. }) && more.instead_of(own).is_some_and(|mass| mass < 0.0);
        if is_negative_mass || refusal(interp, place, more).is_some() {
            return None;
        }
    }
    let beside = interp.host.engine.beside();
    let own = std::mem::replace(&mut interp.host.engine, beside);
    let words = interp.host.builder.element_words.clone();
    places.iter().for_each(|place| write(interp, place, more));
    interp.host.builder.element_words = words;
    Some(std::mem::replace(&mut interp.host.engine, own))
}

/// A parameter by its tag.
fn parameter(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Tag, Exception> {
    let tag = super::known(interp, a)?;
    finish(interp, a)?;
    Ok(tag)
}

/// Warns where no derivatives have been asked for: OpenSees returns zeros without a word.
fn warn_without(interp: &mut Tcl, call: &Call<'_>) -> Result<(), Exception> {
    if interp.host.derived.is_some() {
        return Ok(());
    }
    let message = "there are no derivatives: the command \"sensitivityAlgorithm\" is missing";
    let d = Diagnostic::warning(&checks::analysis::NO_DERIVATIVES, message);
    warn(
        interp,
        d.at(call.span(0), "expected \"sensitivityAlgorithm -computeAtEachStep\" before the analysis: returns 0"),
    )
}

/// The derivative of a number of an engine. It is zero before the first step, and for a parameter that is nowhere in the model.
fn derivative(
    interp: &mut Tcl,
    call: &Call<'_>,
    parameter: Tag,
    number: impl FnMut(&Engine) -> f64,
) -> Result<Value, Exception> {
    warn_without(interp, call)?;
    match interp.host.engine.derivative(parameter).map(|d| d.of(number)) {
        Some(Ok(derivative)) => Ok(Value::from(derivative)),
        None => {
            // Before the first step, and after `reset`, there are none yet.
            let has_begun = interp.host.engine.derivatives_are_current();
            let derived =
                interp.host.derived.as_ref().filter(|_| has_begun).and_then(|all| all.get(&parameter)).cloned();
            if derived.is_none_or(|p| present(interp, &p.places).is_empty()) {
                return Ok(Value::from(0.0));
            }
            let message = format!("there is no derivative with respect to parameter {parameter}");
            Err(call.error_at(0, message, "it takes no other value near its own"))
        }
        Some(Err(failure)) => {
            let message = format!("there is no derivative with respect to parameter {parameter}: {failure}");
            Err(call.error_at(0, message, "an analysis with another value of the parameter has failed"))
        }
    }
}

fn of_node(interp: &mut Tcl, call: &Call<'_>, field: fn(&State) -> &Vec<f64>) -> Outcome {
    let mut a = Args::new(call, OF_NODE);
    let node = node_of(interp, &mut a, NODE.meaning)?;
    let node = &interp.host.engine.model().nodes[node.0];
    let at = node.offset + a.dof(DOF.meaning, node.ndf)?;
    let parameter = parameter(interp, &mut a)?;
    derivative(interp, call, parameter, |e| field(e.state()).get(at).copied().unwrap_or(0.0))
}

fn of_factor(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, OF_FACTOR);
    let pattern = a.tag(things::PATTERN, PARAMETER_PATTERN.meaning)?;
    if !interp.host.engine.model().patterns.contains_key(&pattern) {
        return Err(a.absent(things::PATTERN, pattern, "expected the tag of a pattern"));
    }
    let parameter = parameter(interp, &mut a)?;
    let factor = |e: &Engine| e.model().patterns.get(&pattern).map_or(0.0, |p| p.factor(e.state().time));
    derivative(interp, call, parameter, factor)
}

fn of_section(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, OF_SECTION);
    let element = a.tag(things::ELEMENT, ELE_RESPONSE_ELEMENT.meaning)?;
    let Some(id) = interp.host.engine.model().element(element) else {
        return Err(a.absent(things::ELEMENT, element, "expected the tag of an element"));
    };
    let section = if a.left() == 2 { None } else { Some(a.count(&SECTION)?.to_string()) };
    let words: Vec<&str> = ["section"].into_iter().chain(section.as_deref()).chain(["force"]).collect();
    let Some(forces) = ElementResponse::evaluate(&interp.host.engine, id, &words, &mut Known::default()) else {
        let refused = a.refuse(format!("element {element} has no such section"), "expected a number from 1 on");
        return Err(refused.by(&checks::output::NO_RESPONSE));
    };
    let at = a.dof(DOF.meaning, forces.len())?;
    let parameter = parameter(interp, &mut a)?;
    derivative(interp, call, parameter, |e| {
        let forces = ElementResponse::evaluate(e, id, &words, &mut Known::default());
        forces.and_then(|f| f.get(at).copied()).unwrap_or(0.0)
    })
}

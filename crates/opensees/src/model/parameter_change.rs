//! Parameters of `pset` that have another value for a time: `amend parameter`.
//!
//! A parameter may stand behind any number of an element. The script is therefore run a second time, up to its first
//! analysis, with the other value. The elements that it makes take the places of those that the model had there, and keep
//! their state. An element that was made or changed since is not one of these, and is refused.

use crate::args::Args;
use crate::text::{Arg, Domain};
use crate::{Outcome, Tcl, finish};
use hysteron_engine::analysis::integrator::Adaptive;
use hysteron_engine::analysis::{Failure, Kind};
use hysteron_engine::element::Element;
use hysteron_engine::model::{ElementId, Tag};
use hysteron_tcl::{Call, Exception, Value};
use std::collections::BTreeMap;
use std::sync::Arc;

pub(crate) const FACTOR: Arg = Arg::of("-factor", "f", "factor on the parameter").within(Domain::Positive);
pub(crate) const FROM: Arg = Arg::of("-from", "t1", "time from which it has the other value").within(Domain::Number);
pub(crate) const REACHED: Arg =
    Arg::of("-reached", "t2", "time at which it has the whole of the other value").within(Domain::Number);
pub(crate) const TO: Arg = Arg::of("-to", "t3", "time up to which it has the other value").within(Domain::Number);
pub(crate) const RECOVERED: Arg =
    Arg::of("-recovered", "t4", "time at which it has its own value again").within(Domain::Number);

/// Makes elements by a second run of a script.
pub(crate) type MakeElements = fn(&mut Tcl, &ScriptStart, BTreeMap<String, f64>) -> Result<Elements, Exception>;

/// The script of a run, and the variables that it began with.
#[derive(Clone)]
pub(crate) struct ScriptStart {
    /// Makes the elements of the script up to its first analysis, with values of its parameters.
    pub(crate) elements: MakeElements,
    pub(crate) path: String,
    pub(crate) args: Vec<String>,
    pub(crate) globals: Vec<(String, Value)>,
}

/// A factor on a parameter for a time.
#[derive(Clone, Debug, PartialEq)]
struct Change {
    name: String,
    factor: f64,
    from: f64,
    /// Time at which a ramp from the own value ends; not after `from` for a step.
    reached: f64,
    to: f64,
    /// Time at which a ramp back to the own value ends; not after `to` where it has it at once.
    recovered: f64,
}

/// Steps of a ramp. Each needs another run of the script up to its first analysis.
const RAMP_STEPS: usize = 16;
/// Part of a step below which it counts as none, and beyond the rest of which as all: round-off of sums of time steps.
const ROUND_OFF: f64 = 1e-9;

impl Change {
    /// Part of the other value that the parameter has in the mean of a step, so that the response is continuous in all times.
    fn part(&self, begin: f64, end: f64) -> f64 {
        let (begin, end) = (begin.min(end), begin.max(end));
        let ends = moments(self.to, self.recovered);
        let until = |to: f64| mean(moments(self.from, self.reached).map(|from| shared(from, to, begin, end)));
        mean(ends.map(until))
    }
}

/// Times at which the parts of a ramp hold, the same for all its steps; the time alone where there is none.
fn moments(first: f64, last: f64) -> impl ExactSizeIterator<Item = f64> {
    let (count, step) = if last > first { (RAMP_STEPS, (last - first) / RAMP_STEPS as f64) } else { (1, 0.0) };
    (0..count).map(move |i| if step == 0.0 { first } else { first + (i as f64 + 0.5) * step })
}

fn mean(parts: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = parts.len() as f64;
    parts.sum::<f64>() / count
}

/// Part of a step between two times.
fn shared(from: f64, to: f64, begin: f64, end: f64) -> f64 {
    if begin == end {
        return f64::from(u8::from(from <= begin && begin < to));
    }
    match (to.min(end) - from.max(begin)) / (end - begin) {
        part if part < ROUND_OFF => 0.0,
        part if part > 1.0 - ROUND_OFF => 1.0,
        part => part,
    }
}

/// Elements by tag.
pub(crate) type Elements = BTreeMap<Tag, Arc<dyn Element>>;

/// Elements with their places in the model.
type PlacedElements = Vec<(ElementId, Arc<dyn Element>)>;

/// Changes of parameters in time.
#[derive(Default)]
pub(crate) struct ParameterChanges {
    all: Vec<Change>,
    /// Part of each that the elements of the model have.
    parts: Vec<f64>,
    /// Elements made for parts of the changes. The first are those of the model at the first analysis.
    made: Vec<(Vec<f64>, Elements)>,
    /// Index in `made` of the elements that the model has.
    present: usize,
}

impl ParameterChanges {
    pub(crate) fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// Parts of the changes in a step.
    fn parts_of(&self, begin: f64, end: f64) -> Vec<f64> {
        self.all.iter().map(|c| c.part(begin, end)).collect()
    }

    /// Factors on the parameters for parts of the changes.
    fn factors(&self, parts: &[f64]) -> BTreeMap<&str, f64> {
        let mut factors = BTreeMap::new();
        for (change, part) in self.all.iter().zip(parts) {
            *factors.entry(change.name.as_str()).or_insert(1.0) *= 1.0 + part * (change.factor - 1.0);
        }
        factors
    }
}

/// `amend parameter $name -factor $f <-from $t1> <-reached $t2> <-to $t3> <-recovered $t4>`, behind the first two words.
pub(crate) fn amend_parameter(interp: &mut Tcl, a: &mut Args<'_>) -> Outcome {
    let name = a.word("name of the parameter")?.into_owned();
    if !interp.host.declared.contains_key(&name) {
        let known: Vec<&str> = interp.host.declared.keys().map(String::as_str).collect();
        let there =
            if known.is_empty() { "none is declared".to_owned() } else { format!("declared: {}", known.join(" ")) };
        return Err(a.refuse(format!("no number \"{name}\" is declared by pset"), there));
    }
    let (mut factor, mut from, mut reached, mut to, mut recovered) = (None, None, None, None, None);
    while let Some(word) = a.option() {
        match word.as_ref() {
            "-factor" => factor = Some(a.number(&FACTOR)?),
            "-from" => from = Some(a.number(&FROM)?),
            "-reached" => reached = Some(a.number(&REACHED)?),
            "-to" => to = Some(a.number(&TO)?),
            "-recovered" => recovered = Some(a.number(&RECOVERED)?),
            _ => return Err(a.unknown_name("option", ["-factor", "-from", "-reached", "-to", "-recovered"])),
        }
    }
    let Some(factor) = factor.filter(|_| from.is_some() || to.is_some()) else {
        let message = "amend parameter: the factor, or both times are missing";
        return Err(a.refuse(message, "expected -factor $f, and -from $t1 or -to $t3 or both"));
    };
    if reached.is_some() && from.is_none() {
        let message = "amend parameter: -reached ends a ramp, which needs a beginning";
        return Err(a.refuse(message, "expected -from $t1 with it"));
    }
    if recovered.is_some() && to.is_none() {
        let message = "amend parameter: -recovered ends a way back, which needs a beginning";
        return Err(a.refuse(message, "expected -to $t3 with it"));
    }
    finish(interp, a)?;
    let session = &mut interp.host;
    if session.start.is_none() {
        let message = "a parameter that changes in time needs a script, which is run again for its other value";
        return Err(a.refuse(message, "expected a script in a file, not single commands"));
    }
    if session.engine.steps > 0 {
        return Err(a.refuse("the analysis has begun", "amend the parameter before the first analysis"));
    }
    // In a search the end may come before the beginning: the other value is never taken then.
    let (from, to) = (from.unwrap_or(f64::NEG_INFINITY), to.unwrap_or(f64::INFINITY));
    let (reached, recovered) = (reached.unwrap_or(from), recovered.unwrap_or(to));
    session.changes.all.push(Change { name, factor, from, reached, to, recovered });
    session.changes.parts.push(0.0);
    Ok(Value::EMPTY)
}

/// Analyses step by step, with the elements that each step is to have.
pub(crate) fn analyze(
    interp: &mut Tcl,
    call: &Call<'_>,
    steps: usize,
    dt: f64,
    lengths: Option<Adaptive>,
) -> Result<Result<(), Failure>, Exception> {
    if interp.host.output.recorders.journal.is_some() {
        return Err(call.error_at(
            0,
            "checkpoints do not follow a parameter that changes in time",
            "run it without one",
        ));
    }
    let setup = interp.host.engine.setup();
    let is_static = setup.is_some_and(|s| s.kind == Kind::Static);
    let length = if is_static { setup.and_then(|s| s.integrator.fixed_increment()).unwrap_or(0.0) } else { dt };
    for _ in 0..steps {
        let time = interp.host.engine.state().time;
        take_elements(interp, call, time, time + length)?;
        let session = &mut interp.host;
        let recorders = &mut session.output.recorders;
        let done = match lengths {
            Some(lengths) => session.engine.analyze_variable(1, dt, lengths, recorders),
            None => session.engine.analyze(1, dt, recorders),
        };
        if done.is_err() {
            return Ok(done);
        }
    }
    Ok(Ok(()))
}

/// Gives the model the elements that a step is to have.
fn take_elements(interp: &mut Tcl, call: &Call<'_>, begin: f64, end: f64) -> Result<(), Exception> {
    let changes = &mut interp.host.changes;
    if changes.made.is_empty() {
        let elements = interp.host.engine.model().elements.iter().map(|e| (e.tag, e.element.clone()));
        changes.made.push((changes.parts.clone(), elements.collect()));
    }
    let parts = changes.parts_of(begin, end);
    if parts == changes.parts {
        return Ok(());
    }
    let index = match changes.made.iter().position(|(known, _)| *known == parts) {
        Some(index) => index,
        None => {
            let elements = elements_for(interp, call, &parts)?;
            interp.host.changes.made.push((parts.clone(), elements));
            interp.host.changes.made.len() - 1
        }
    };
    let replaced = replacements(interp, call, index)?;
    let session = &mut interp.host;
    session.engine.change_model(|model| model.replace_elements(replaced));
    (session.changes.parts, session.changes.present) = (parts, index);
    Ok(())
}

/// Elements of an index of [`ParameterChanges::made`], with their places in the model.
fn replacements(interp: &Tcl, call: &Call<'_>, index: usize) -> Result<PlacedElements, Exception> {
    let (model, changes) = (interp.host.engine.model(), &interp.host.changes);
    let (present, new) = (&changes.made[changes.present].1, &changes.made[index].1);
    let mut replaced = Vec::with_capacity(new.len());
    for tag in model.element_tags() {
        let Some(id) = model.element(tag) else { continue };
        let old = &model.elements[id.0].element;
        let own = present.get(&tag).is_some_and(|given| Arc::ptr_eq(old, given));
        let Some(new) = new.get(&tag).filter(|_| own) else {
            let message = format!("element {tag} was made or changed after the first analysis began");
            let expected = "a parameter that changes in time makes elements as they were before the first analysis";
            return Err(call.error_at(0, message, expected));
        };
        let lengths = |e: &Arc<dyn Element>| (e.class(), e.dofs(), e.state_len(), e.load_len());
        if lengths(old) != lengths(new) {
            let message = format!("element {tag} has other parts with the other value of the parameter");
            return Err(call.error_at(0, message, "expected a parameter that changes numbers of its laws alone"));
        }
        replaced.push((id, new.clone()));
    }
    Ok(replaced)
}

/// Elements that the script makes with parts of the changes.
fn elements_for(interp: &mut Tcl, call: &Call<'_>, parts: &[f64]) -> Result<Elements, Exception> {
    let session = &interp.host;
    let Some(start) = session.start.clone() else { return Ok(Elements::new()) };
    let mut parameters = session.parameters.clone();
    for (name, factor) in session.changes.factors(parts) {
        parameters.extend(session.declared.get(name).map(|value| (name.to_owned(), factor * value)));
    }
    let made = (start.elements)(interp, &start, parameters);
    made.map_err(|e| match e {
        Exception::Error(e) => {
            let message = format!("with the other value of the parameter: {}", e.diagnostic.message);
            call.error_at(0, message, "expected a script that makes its model with this value too")
        }
        other => other,
    })
}

#[cfg(test)]
mod tests {
    use super::{Change, ParameterChanges};

    fn change(factor: f64, from: f64, to: f64) -> Change {
        Change { name: "Fy".into(), factor, from, reached: from, to, recovered: to }
    }

    #[test]
    fn a_step_has_the_part_of_the_time_that_it_shares() {
        let c = change(2.0, 1.0, 1.5);
        assert_eq!(
            [c.part(0.0, 1.0), c.part(1.0, 1.2), c.part(1.4, 1.6), c.part(1.5, 1.7)].map(|x| (1e6 * x).round()),
            [0.0, 1e6, 5e5, 0.0]
        );
        // A span without a length, and a step without one.
        assert_eq!([change(2.0, 1.0, 0.5).part(0.0, 2.0), c.part(1.2, 1.2), c.part(1.6, 1.6)], [0.0, 1.0, 0.0]);
    }

    /// A ramp from 1 to 3 s: linear, with steps of 1/8 s, and whole up to 4 s.
    #[test]
    fn a_ramp_is_linear_in_time() {
        let c = Change { reached: 3.0, ..change(2.0, 1.0, 4.0) };
        let parts = [(0.0, 1.0), (1.0, 1.5), (1.5, 2.5), (2.5, 3.0), (3.0, 4.0), (4.0, 5.0)].map(|(b, e)| c.part(b, e));
        assert_eq!(parts, [0.0, 0.125, 0.5, 0.875, 1.0, 0.0]);
        assert_eq!(c.part(1.0, 1.05), 0.0);
        // A ramp that ends before it begins is a step.
        assert_eq!(Change { reached: 0.0, ..c }.part(1.0, 1.1), 1.0);
    }

    /// From 1 s on, and on the way back from there to 3 s.
    #[test]
    fn a_value_recovers_linearly_in_time() {
        let c = Change { recovered: 3.0, ..change(2.0, 1.0, 1.0) };
        let parts = [(0.0, 1.0), (1.0, 1.5), (1.5, 2.5), (2.5, 3.0), (3.0, 4.0)].map(|(b, e)| c.part(b, e));
        assert_eq!(parts, [0.0, 0.875, 0.5, 0.125, 0.0]);
        // A way back that ends before it begins is a step back.
        let back = Change { recovered: 1.0, ..change(2.0, 1.0, 4.0) };
        assert_eq!([back.part(3.0, 4.0), back.part(4.0, 5.0)], [1.0, 0.0]);
    }

    #[test]
    fn changes_of_one_parameter_multiply() {
        let all = vec![change(2.0, 0.0, 9.0), change(0.5, 0.0, 9.0)];
        let changes = ParameterChanges { all, ..Default::default() };
        assert_eq!(changes.factors(&[0.5, 1.0])["Fy"], 0.75);
    }
}

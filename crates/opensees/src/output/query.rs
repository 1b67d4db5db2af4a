//! Queries of a script: responses of nodes and elements, time, tags. Commands that set them by hand.

use super::recorder::unknown_response;
use crate::args::Args;
use crate::checks;
use crate::model::nodes::{DOF, NODE, node_of};
use crate::slips;
use crate::text::Arg;
use crate::things;
use crate::{Command, Outcome, Tcl, finish, ignore_unknown, warn};
use hysteron_engine::analysis::{Failure, ReactionKind, State, Test};
use hysteron_engine::model::{ElementId, NodeId};
use hysteron_engine::record::ElementResponse;
use hysteron_tcl::diagnostic::Diagnostic;
use hysteron_tcl::{Call, Exception, Value};

const NODE_EIGENVECTOR_MODE: Arg = Arg::count("mode", "number of the mode");
const VALUE: Arg = Arg::number("value", "value");
const MASS: Arg = Arg::not_negative("mass", "mass");
pub(crate) const ELE_RESPONSE_ELEMENT: Arg = Arg::whole("element", "tag of the element");
const ELE_RESPONSE_RESPONSE: Arg = Arg::new("response", "name of the response");
const GET_LOAD_FACTOR_PATTERN: Arg = Arg::whole("pattern", "tag of the pattern");

pub(super) const DOF_OR_ALL: &[Arg] = &[Arg::new("dof", "number from 1; all values where it is left out")];

const PROCESS: &[Arg] = &[Arg::of("-pid", "process", "number of the other process")];

const FIELD: &str = "nodeDisp $node <$dof>";
const SET: &str = "setNodeDisp $node $dof $value <-commit>";
const RESPONSE: &str = "eleResponse $element $response ...";

pub(crate) const COMMANDS: &[Command] = &[
    Command::asking("nodeDisp", FIELD, |i, c| node_field(i, c, |s| &s.disp))
        .arguments(&[NODE])
        .about("Returns the displacement of a node.")
        .groups(&[DOF_OR_ALL]),
    Command::asking("nodeVel", FIELD, |i, c| node_field(i, c, |s| &s.vel)).about("Returns the velocity of a node."),
    Command::asking("nodeAccel", FIELD, |i, c| node_field(i, c, |s| &s.accel))
        .about("Returns the acceleration of a node."),
    Command::asking("nodeReaction", FIELD, node_reaction)
        .about("Returns the reaction of a node in the present state; `reactions` chooses what it includes."),
    Command::asking("nodeUnbalance", FIELD, node_unbalance).about("Returns the unbalanced load of a node."),
    Command::asking("nodeCoord", "nodeCoord $node <$direction>", node_coord)
        .about("Returns the coordinates of a node.")
        .arguments(&[NODE, Arg::new("direction", "direction from 1; all where it is left out")]),
    Command::asking("nodeMass", FIELD, node_mass).about("Returns the mass of a node."),
    Command::asking("nodeEigenvector", "nodeEigenvector $node $mode <$dof>", node_eigenvector)
        .arguments(&[NODE, NODE_EIGENVECTOR_MODE])
        .about("Returns the mode shape at a node.")
        .groups(&[DOF_OR_ALL]),
    Command::new("reactions", "reactions <-dynamic> <-rayleigh>", reactions)
        .about("Chooses what `nodeReaction` includes: inertia with `-dynamic`, Rayleigh damping with `-rayleigh`."),
    Command::new("setNodeDisp", SET, |i, c| set_node(i, c, |s| &mut s.disp))
        .arguments(&[NODE, DOF, VALUE])
        .about("Sets the displacement of a node."),
    Command::new("setNodeVel", SET, |i, c| set_node(i, c, |s| &mut s.vel)).about("Sets the velocity of a node."),
    Command::new("setNodeAccel", SET, |i, c| set_node(i, c, |s| &mut s.accel))
        .about("Sets the acceleration of a node."),
    Command::new("setNodeMass", "setNodeMass $node $dof $mass", set_mass)
        .arguments(&[NODE, DOF, MASS])
        .about("Sets the mass of a node in one direction."),
    Command::asking("eleResponse", RESPONSE, ele_response)
        .arguments(&[ELE_RESPONSE_ELEMENT, ELE_RESPONSE_RESPONSE])
        .about("Returns a response of an element, by the names that recorders use."),
    Command::asking("eleForce", "eleForce $element <$dof>", |i, c| named(i, c, "force"))
        .arguments(&[ELE_RESPONSE_ELEMENT])
        .about("Returns the global forces of an element.")
        .groups(&[DOF_OR_ALL]),
    Command::asking("eleDynamicalForce", DYNAMIC, dynamic_force)
        .arguments(&[ELE_RESPONSE_ELEMENT])
        .about("Returns the global forces of an element with those of its damping and its inertia.")
        .groups(&[DOF_OR_ALL]),
    Command::asking("localForce", "localForce $element <$dof>", |i, c| named(i, c, "localForce"))
        .arguments(&[ELE_RESPONSE_ELEMENT])
        .about("Returns the local forces of an element.")
        .groups(&[DOF_OR_ALL]),
    Command::asking("basicForce", "basicForce $element <$dof>", |i, c| named(i, c, "basicForce"))
        .arguments(&[ELE_RESPONSE_ELEMENT])
        .about("Returns the basic forces of an element.")
        .groups(&[DOF_OR_ALL]),
    Command::asking("basicDeformation", "basicDeformation $element <$dof>", |i, c| named(i, c, "basicDeformation"))
        .arguments(&[ELE_RESPONSE_ELEMENT])
        .about("Returns the basic deformations of an element.")
        .groups(&[DOF_OR_ALL]),
    Command::asking("basicStiffness", "basicStiffness $element", |i, c| named(i, c, "basicStiffness"))
        .arguments(&[ELE_RESPONSE_ELEMENT])
        .about("Returns the basic stiffness of an element."),
    Command::asking("eleNodes", "eleNodes $element", ele_nodes)
        .arguments(&[ELE_RESPONSE_ELEMENT])
        .about("Returns the tags of the nodes of an element."),
    Command::asking("eleType", "eleType $element", ele_type)
        .arguments(&[ELE_RESPONSE_ELEMENT])
        .about("Returns the kind of an element."),
    Command::asking("getTime", "getTime", |i, _| Ok(Value::from(i.host.engine.state().time)))
        .about("Returns the time of the domain."),
    Command::asking("getLoadFactor", "getLoadFactor $pattern", load_factor)
        .arguments(&[GET_LOAD_FACTOR_PATTERN])
        .about("Returns the load factor of a pattern."),
    Command::asking("getNodeTags", "getNodeTags", node_tags).about("Returns the tags of all nodes."),
    Command::asking("getEleTags", "getEleTags", ele_tags).about("Returns the tags of all elements."),
    Command::asking("nodeBounds", "nodeBounds", node_bounds)
        .about("Returns the smallest and largest coordinates of all nodes."),
    // Scripts that may be run in parallel ask how many they are: this one is alone.
    Command::asking("getPID", "getPID", |_, _| Ok(Value::from(0i64))).about("Returns 0: there is one process."),
    Command::asking("getNP", "getNP", |_, _| Ok(Value::from(1i64))).about("Returns 1: there is one process."),
    Command::asking("barrier", "barrier", alone).about("Has no effect: there is one process."),
    Command::asking("partition", "partition <$element>", alone)
        .about("Has no effect: there is one process.")
        .arguments(&[Arg::new("element", "tag of an element")]),
    Command::asking("send", "send -pid $process $data", alone)
        .about("Has no effect: there is one process.")
        .arguments(PROCESS),
    Command::asking("recv", "recv -pid $process $variable", alone)
        .about("Has no effect: there is one process. The variable stays as it is.")
        .arguments(PROCESS),
    Command::asking("Bcast", "Bcast $data", alone)
        .about("Has no effect: there is one process.")
        .arguments(&[Arg::new("data", "value")]),
    Command::asking("getNDM", "getNDM", |i, _| Ok(Value::from(i.host.builder.ndm as i64)))
        .about("Returns the number of dimensions."),
    Command::asking("getNDF", "getNDF <$node>", ndf)
        .about("Returns the number of degrees of freedom of a node.")
        .arguments(&[Arg::new("node", "tag of a node; the number of the model where it is left out")]),
    Command::asking("nodeDOFs", "nodeDOFs $node", node_dofs)
        .arguments(&[NODE])
        .about("Returns the numbers of the equations of a node."),
    Command::asking("systemSize", "systemSize", system_size).about("Returns the number of equations."),
    Command::asking("testIter", "testIter", iterations).about("Returns the number of iterations of the last step."),
    Command::asking("numIter", "numIter", algorithm_iterations).about(
        "Returns the number of iterations of the last step; 0 of an algorithm that searches along lines or has \
         no test.",
    ),
    Command::asking("testNorm", "testNorm", norms)
        .about("Returns the norms of the last test: one of each iteration, and zeros up to the iterations allowed."),
    Command::asking("testNorms", "testNorms", norms)
        .about("Returns the norms of the last test: one of each iteration, and zeros up to the iterations allowed."),
    Command::asking("numFact", "numFact", factorizations)
        .about("Returns the number of factorisations of the last step."),
    Command::asking("version", "version", |_, _| Ok(Value::from(env!("CARGO_PKG_VERSION"))))
        .about("Returns the version of hysteron."),
];

/// What processes tell each other: a process that is alone has nobody to wait for or to talk to, as in OpenSees.
fn alone(_: &mut Tcl, _: &Call<'_>) -> Outcome {
    Ok(Value::EMPTY)
}

pub(super) fn list(values: &[f64]) -> Value {
    Value::list(values.iter().map(|x| Value::from(*x)))
}

/// All values of a node, or the one of a degree of freedom.
pub(super) fn pick(interp: &mut Tcl, a: &mut Args<'_>, values: &[f64], what: &str) -> Outcome {
    if a.left() == 0 {
        return Ok(list(values));
    }
    // OpenSees gives all values for 0, which scripts with one degree of freedom at a node rely on.
    if what == DOF.meaning && a.peek().is_some_and(|w| w == "0") {
        a.option();
        let d = Diagnostic::warning(&checks::output::ALL_VALUES, "the degree of freedom is 0: all values are given");
        warn(interp, d.at(a.last_span(), format!("expected the degree of freedom, 1 to {}", values.len())))?;
        finish(interp, a)?;
        return Ok(list(values));
    }
    let i = a.dof(what, values.len())?;
    finish(interp, a)?;
    Ok(Value::from(values[i]))
}

fn of_node(interp: &Tcl, node: NodeId, field: &[f64]) -> Vec<f64> {
    field[interp.host.engine.model().nodes[node.0].dofs()].to_vec()
}

fn node_field(interp: &mut Tcl, call: &Call<'_>, field: fn(&State) -> &Vec<f64>) -> Outcome {
    let mut a = Args::new(call, FIELD);
    let node = node_of(interp, &mut a, NODE.meaning)?;
    let values = of_node(interp, node, field(interp.host.engine.state()));
    pick(interp, &mut a, &values, DOF.meaning)
}

fn failed(call: &Call<'_>, f: &Failure) -> Exception {
    call.error_at(0, f.to_string(), "")
}

fn node_reaction(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, FIELD);
    let node = node_of(interp, &mut a, NODE.meaning)?;
    let all = interp.host.reactions().map_err(|f| failed(call, &f))?;
    let values = of_node(interp, node, &all);
    pick(interp, &mut a, &values, DOF.meaning)
}

fn node_unbalance(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, FIELD);
    let node = node_of(interp, &mut a, NODE.meaning)?;
    let mut all = vec![];
    interp.host.engine.unbalanced(false, &mut all).map_err(|f| failed(call, &f))?;
    let values = of_node(interp, node, &all);
    pick(interp, &mut a, &values, DOF.meaning)
}

/// Set the kind of reactions that `nodeReaction` gives. They belong to the present state, and in OpenSees to that of this command.
fn reactions(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, "reactions <-dynamic> <-rayleigh>");
    interp.host.output.reaction_kind = ReactionKind::Static;
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-dynamic" | "-incInertia" | "-dynamical" | "-Dynamic" => {
                interp.host.output.reaction_kind = ReactionKind::Dynamic;
            }
            "-rayleigh" | "-Rayleigh" => interp.host.output.reaction_kind = ReactionKind::Rayleigh,
            _ => ignore_unknown(interp, &mut a)?,
        }
    }
    if interp.host.follows(&[slips::KEPT_REACTIONS]) {
        let session = &mut interp.host;
        let (engine, output) = (&mut session.engine, &mut session.output);
        let mut all = vec![];
        engine.reactions(output.reaction_kind, &mut all).map_err(|f| failed(call, &f))?;
        engine.keep_reactions(&all);
    }
    Ok(Value::EMPTY)
}

fn node_coord(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, "nodeCoord $node <$direction>");
    let node = node_of(interp, &mut a, NODE.meaning)?;
    let coords = interp.host.engine.model().nodes[node.0].coords.clone();
    if let Some(i) = a.peek().and_then(|w| ["X", "Y", "Z"].iter().position(|n| w.eq_ignore_ascii_case(n))) {
        a.option();
        return Ok(Value::from(coords.get(i).copied().unwrap_or(0.0)));
    }
    pick(interp, &mut a, &coords, "direction")
}

fn node_mass(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, FIELD);
    let node = node_of(interp, &mut a, NODE.meaning)?;
    let mass = interp.host.engine.model().nodes[node.0].mass.clone();
    pick(interp, &mut a, &mass, "degree of freedom of the mass")
}

fn node_eigenvector(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, "nodeEigenvector $node $mode <$dof>");
    let node = node_of(interp, &mut a, NODE.meaning)?;
    let count = interp.host.engine.modes().map_or(0, |m| m.shapes.len());
    let mode = a.count(&NODE_EIGENVECTOR_MODE)?;
    let Some(shape) = interp.host.engine.modes().and_then(|m| m.shapes.get(mode - 1)) else {
        let label =
            if count == 0 { "expected a command \"eigen\" before".into() } else { format!("expected 1 to {count}") };
        return Err(a.absent(things::MODE, mode, label));
    };
    let dofs = interp.host.engine.model().nodes[node.0].dofs();
    let values = shape.get(dofs).map(<[f64]>::to_vec).unwrap_or_default();
    pick(interp, &mut a, &values, DOF.meaning)
}

fn set_node(interp: &mut Tcl, call: &Call<'_>, field: fn(&mut State) -> &mut Vec<f64>) -> Outcome {
    let mut a = Args::new(call, SET);
    let node = node_of(interp, &mut a, NODE.meaning)?;
    let (offset, ndf) = {
        let n = &interp.host.engine.model().nodes[node.0];
        (n.offset, n.ndf)
    };
    let dof = a.dof(DOF.meaning, ndf)?;
    let value = a.number(&VALUE)?;
    a.flag("-commit");
    finish(interp, &a)?;
    interp.host.engine.change_state(|s, _| field(s)[offset + dof] = value);
    Ok(Value::EMPTY)
}

fn set_mass(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, "setNodeMass $node $dof $mass");
    let node = node_of(interp, &mut a, NODE.meaning)?;
    let dof = a.dof(DOF.meaning, interp.host.engine.model().nodes[node.0].ndf)?;
    let mass = a.number(&MASS)?;
    finish(interp, &a)?;
    interp.host.engine.change_model(|m| m.nodes[node.0].mass[dof] = mass);
    Ok(Value::EMPTY)
}

pub(super) fn element_of(interp: &Tcl, a: &mut Args<'_>) -> Result<ElementId, Exception> {
    let tag = a.tag(things::ELEMENT, ELE_RESPONSE_ELEMENT.meaning)?;
    let id = interp.host.engine.model().element(tag);
    id.ok_or_else(|| a.absent(things::ELEMENT, tag, "expected the tag of an element"))
}

pub(super) fn evaluate(interp: &mut Tcl, id: ElementId, words: &[&str]) -> Option<Vec<f64>> {
    let session = &mut interp.host;
    ElementResponse::evaluate(&session.engine, id, words, &mut session.output.known)
}

fn ele_response(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, RESPONSE);
    let id = element_of(interp, &mut a)?;
    a.word(ELE_RESPONSE_RESPONSE.meaning)?;
    let words: Vec<_> = call.args()[1..].iter().map(Value::as_str).collect();
    let words: Vec<&str> = words.iter().map(AsRef::as_ref).collect();
    match evaluate(interp, id, &words) {
        Some(values) => Ok(list(&values)),
        None => {
            let (index, d) = unknown_response(&interp.host.engine, id, &words);
            Err(Exception::diagnosed(d.at(call.span(index + 2), "not known here").by(&checks::output::NO_RESPONSE)))
        }
    }
}

/// A response with a command of its own: all of it, or one column.
fn named(interp: &mut Tcl, call: &Call<'_>, response: &str) -> Outcome {
    let mut a = Args::new(call, "eleForce $element <$dof>");
    let id = element_of(interp, &mut a)?;
    match evaluate(interp, id, &[response]) {
        Some(values) => pick(interp, &mut a, &values, "number of the column"),
        None => {
            let (_, d) = unknown_response(&interp.host.engine, id, &[response]);
            Err(Exception::diagnosed(d.at(call.span(0), "not known here").by(&checks::output::NO_RESPONSE)))
        }
    }
}

const DYNAMIC: &str = "eleDynamicalForce $element <$dof>";

/// The force of an element with its damping and inertia.
fn dynamic_force(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, DYNAMIC);
    let id = element_of(interp, &mut a)?;
    let mut values = vec![];
    let done = interp.host.engine.dynamic_element_force(id, &mut values);
    done.map_err(|failure| failed(call, &failure))?;
    pick(interp, &mut a, &values, "number of the column")
}

fn ele_nodes(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, "eleNodes $element");
    let id = element_of(interp, &mut a)?;
    let model = interp.host.engine.model();
    Ok(Value::list(model.elements[id.0].nodes.iter().map(|n| Value::from(i64::from(model.nodes[n.0].tag)))))
}

fn ele_type(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, "eleType $element");
    let id = element_of(interp, &mut a)?;
    Ok(Value::from(interp.host.engine.model().elements[id.0].element.class().name))
}

fn load_factor(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, "getLoadFactor $pattern");
    let tag = a.tag(things::PATTERN, GET_LOAD_FACTOR_PATTERN.meaning)?;
    let engine = &interp.host.engine;
    match engine.model().patterns.get(&tag) {
        Some(p) => Ok(Value::from(p.factor(engine.state().time))),
        None => Err(a.absent(things::PATTERN, tag, "expected the tag of a pattern")),
    }
}

fn node_tags(interp: &mut Tcl, _: &Call<'_>) -> Outcome {
    Ok(Value::list(interp.host.engine.model().node_tags().map(|t| Value::from(i64::from(t)))))
}

fn ele_tags(interp: &mut Tcl, _: &Call<'_>) -> Outcome {
    Ok(Value::list(interp.host.engine.model().element_tags().map(|t| Value::from(i64::from(t)))))
}

/// Least x, y and z of the nodes, then the greatest.
fn node_bounds(interp: &mut Tcl, _: &Call<'_>) -> Outcome {
    let mut bounds: Option<([f64; 3], [f64; 3])> = None;
    for node in &interp.host.engine.model().nodes {
        let at = [0, 1, 2].map(|i| node.coords.get(i).copied().unwrap_or(0.0));
        let (low, high) = bounds.get_or_insert((at, at));
        for i in 0..3 {
            low[i] = low[i].min(at[i]);
            high[i] = high[i].max(at[i]);
        }
    }
    let (low, high) = bounds.unwrap_or_default();
    Ok(list(&[low, high].concat()))
}

fn ndf(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, "getNDF <$node>");
    if a.left() == 0 {
        return Ok(Value::from(interp.host.builder.ndf as i64));
    }
    let node = node_of(interp, &mut a, NODE.meaning)?;
    Ok(Value::from(interp.host.engine.model().nodes[node.0].ndf as i64))
}

/// Equation numbers of a node, -1 where it is held.
fn node_dofs(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, "nodeDOFs $node");
    let node = node_of(interp, &mut a, NODE.meaning)?;
    let engine = &interp.host.engine;
    let number = |dof| match engine.prepared().map(|p| p.plan.map.terms(dof)) {
        Some([(e, _)]) => i64::from(*e),
        _ => -1,
    };
    Ok(Value::list(engine.model().nodes[node.0].dofs().map(|d| Value::from(number(d)))))
}

fn system_size(interp: &mut Tcl, _: &Call<'_>) -> Outcome {
    Ok(Value::from(interp.host.engine.prepared().map_or(0, |p| p.plan.equations()) as i64))
}

fn iterations(interp: &mut Tcl, _: &Call<'_>) -> Outcome {
    let tests = interp.host.engine.setup().map_or(0, |s| s.test.iteration);
    let more = usize::from(interp.host.follows(&[slips::FAILED_TEST]) && interp.host.last_failure.is_some());
    Ok(Value::from((tests + more) as i64))
}

/// Iterations of the algorithm. As in OpenSees those that search along lines or have no test count none.
fn algorithm_iterations(interp: &mut Tcl, _: &Call<'_>) -> Outcome {
    const UNCOUNTED: [&str; 5] = ["NewtonLineSearch", "BFGS", "Broyden", "Linear", "ExpressNewton"];
    let setup = interp.host.engine.setup();
    let counted = setup.filter(|s| !UNCOUNTED.contains(&s.algorithm.name()));
    Ok(Value::from(counted.map_or(0, |s| s.test.iteration) as i64))
}

fn norms(interp: &mut Tcl, _: &Call<'_>) -> Outcome {
    // As long as the iterations that are allowed, with zeros for those that were not made.
    let padded = |test: &Test| {
        let mut norms = test.norms.clone();
        norms.resize(test.max_iterations.min(Test::KEPT).max(norms.len()), 0.0);
        list(&norms)
    };
    Ok(interp.host.engine.setup().map_or(Value::EMPTY, |s| padded(&s.test)))
}

fn factorizations(interp: &mut Tcl, _: &Call<'_>) -> Outcome {
    Ok(Value::from(interp.host.engine.prepared().map_or(0, |p| p.solver.factorizations) as i64))
}

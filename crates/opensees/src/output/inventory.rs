//! Queries of what a model consists of: patterns, constraints and the responses of nodes by number.

use crate::args::Args;
use crate::model::nodes::{DOF, NODE, node_of};
use crate::text::Arg;
use crate::{Command, Outcome, Tcl, finish};
use hysteron_engine::model::{Model, NodeId};
use hysteron_tcl::{Call, Value};
use std::collections::BTreeSet;

const NODE_RESPONSE_RESPONSE: Arg = Arg::whole("response", "number of the response");

const LEADS: Arg = Arg::new("retained", "tag of the node that leads; all where it is left out");

const FOLLOWS: Arg = Arg::new("constrained", "tag of the node that follows; all where it is left out");

const AT_OTHER: Arg = Arg::new("dof", "degree of freedom of that node; all where it is left out");

const RESPONSE: &str = "nodeResponse $node $dof $response (1 displacement, 2 velocity, 3 acceleration)";

pub(crate) const COMMANDS: &[Command] = &[
    Command::asking("getNumElements", "getNumElements", |i, _| {
        Ok(Value::from(i.host.engine.model().elements.len() as i64))
    })
    .about("Returns the number of elements."),
    Command::asking("getPatterns", "getPatterns", |i, _| Ok(tags(i.host.engine.model().patterns.keys().copied())))
        .about("Returns the tags of all load patterns."),
    Command::asking("getFixedNodes", "getFixedNodes", |i, _| {
        let model = i.host.engine.model();
        Ok(nodes(model, held(model).map(|(node, _)| node)))
    })
    .about("Returns the tags of all nodes with a constraint of their own."),
    Command::asking("getFixedDOFs", "getFixedDOFs $node", fixed_dofs)
        .arguments(&[NODE])
        .about("Returns the degrees of freedom of a node that are held."),
    Command::asking("getConstrainedNodes", "getConstrainedNodes <$retained>", |i, c| joined(i, c, true))
        .about("Returns the tags of the nodes that follow others.")
        .arguments(&[LEADS]),
    Command::asking("getRetainedNodes", "getRetainedNodes <$constrained>", |i, c| joined(i, c, false))
        .about("Returns the tags of the nodes that others follow.")
        .arguments(&[FOLLOWS]),
    Command::asking("getConstrainedDOFs", "getConstrainedDOFs $node <$retained> <$dof>", |i, c| {
        joined_dofs(i, c, true)
    })
    .about("Returns the degrees of freedom of a node that follow others.")
    .arguments(&[NODE, LEADS, AT_OTHER]),
    Command::asking("getRetainedDOFs", "getRetainedDOFs $node <$constrained> <$dof>", |i, c| joined_dofs(i, c, false))
        .about("Returns the degrees of freedom of a node that others follow.")
        .arguments(&[NODE, FOLLOWS, AT_OTHER]),
    Command::asking("nodeResponse", RESPONSE, node_response)
        .arguments(&[NODE, DOF, NODE_RESPONSE_RESPONSE])
        .about("Returns a displacement, velocity or acceleration of a node by number."),
];

fn tags(tags: impl IntoIterator<Item = i32>) -> Value {
    Value::list(tags.into_iter().map(|t| Value::from(i64::from(t))))
}

/// Tags of nodes, each once and rising.
fn nodes(model: &Model, ids: impl Iterator<Item = NodeId>) -> Value {
    tags(ids.map(|id| model.nodes[id.0].tag).collect::<BTreeSet<_>>())
}

/// Degrees of freedom from 1 on, each once and rising.
fn dofs(dofs: impl Iterator<Item = usize>) -> Value {
    Value::list(dofs.collect::<BTreeSet<_>>().into_iter().map(|d| Value::from(d as i64 + 1)))
}

/// Degrees of freedom with a support, or with a motion that a pattern imposes.
fn held(model: &Model) -> impl Iterator<Item = (NodeId, usize)> {
    let moved = model.patterns.values().flat_map(|p| p.motions.iter().map(|m| (m.node, m.dof)));
    model.fixes.iter().map(|f| (f.node, f.dof)).chain(moved)
}

fn fixed_dofs(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, "getFixedDOFs $node");
    let node = node_of(interp, &mut a, NODE.meaning)?;
    finish(interp, &a)?;
    let model = interp.host.engine.model();
    Ok(dofs(held(model).filter(|(n, _)| *n == node).map(|(_, dof)| dof)))
}

/// Nodes that follow others, or those that lead; of all constraints, or of those with one node on the other side.
fn joined(interp: &mut Tcl, call: &Call<'_>, following: bool) -> Outcome {
    let mut a = Args::new(call, "getConstrainedNodes <$node>");
    let other = if a.left() > 0 { Some(node_of(interp, &mut a, "tag of the node on the other side")?) } else { None };
    finish(interp, &a)?;
    let model = interp.host.engine.model();
    let pairs = model
        .multi_points
        .iter()
        .map(|m| if following { (m.constrained, m.retained) } else { (m.retained, m.constrained) });
    Ok(nodes(model, pairs.filter(|(_, o)| other.is_none_or(|other| *o == other)).map(|(own, _)| own)))
}

/// Degrees of freedom of a node that follow others, or that lead.
fn joined_dofs(interp: &mut Tcl, call: &Call<'_>, following: bool) -> Outcome {
    let mut a = Args::new(call, "getConstrainedDOFs $node <$other> <$dof>");
    let node = node_of(interp, &mut a, NODE.meaning)?;
    let other = if a.left() > 0 { Some(node_of(interp, &mut a, "tag of the node on the other side")?) } else { None };
    let at_other = match other {
        Some(other) if a.left() > 0 => {
            Some(a.dof("degree of freedom on the other side", interp.host.engine.model().nodes[other.0].ndf)?)
        }
        _ => None,
    };
    finish(interp, &a)?;
    let found = interp.host.engine.model().multi_points.iter().flat_map(|m| {
        let (own, across, dofs, others) = if following {
            (m.constrained, m.retained, &m.constrained_dofs, &m.retained_dofs)
        } else {
            (m.retained, m.constrained, &m.retained_dofs, &m.constrained_dofs)
        };
        // Pair by pair, as the constraint names them.
        let joined = own == node && other.is_none_or(|other| across == other);
        let pairs =
            dofs.iter().zip(others).filter(move |(_, other)| joined && at_other.is_none_or(|dof| dof == **other));
        pairs.map(|(dof, _)| *dof)
    });
    Ok(dofs(found))
}

fn node_response(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, RESPONSE);
    let node = node_of(interp, &mut a, NODE.meaning)?;
    let ndf = interp.host.engine.model().nodes[node.0].ndf;
    let dof = a.dof(DOF.meaning, ndf)?;
    let kind = a.int(NODE_RESPONSE_RESPONSE.meaning)?;
    let engine = &interp.host.engine;
    let field = match kind {
        1 => &engine.state().disp,
        2 => &engine.state().vel,
        3 => &engine.state().accel,
        _ => return Err(a.refuse(format!("there is no response {kind} of a node"), "expected 1, 2 or 3")),
    };
    let at = engine.model().nodes[node.0].dofs().nth(dof).unwrap_or_default();
    Ok(Value::from(field[at]))
}

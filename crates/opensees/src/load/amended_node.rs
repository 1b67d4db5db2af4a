//! `amend node`.

use super::late_support;
use crate::args::Args;
use crate::model::nodes::node_of;
use crate::{Outcome, Tcl, finish};
use hysteron_engine::model::NodeId;
use hysteron_tcl::Value;

/// An amendment of a node: its name, and the function that reads what follows.
type Amendment = (&'static str, fn(&mut Tcl, &mut Args<'_>, NodeId) -> Outcome);

const AMENDMENTS: [Amendment; 2] = [("dampedAs", damped_as), ("late", late_support::late)];

/// `amend node $tag $kind ...`, behind the first two words.
pub(crate) fn amend_node(interp: &mut Tcl, a: &mut Args<'_>) -> Outcome {
    let node = node_of(interp, a, "tag of the node")?;
    let name = a.word("kind of amendment")?;
    match AMENDMENTS.iter().find(|(known, _)| *known == name) {
        Some((_, amend)) => amend(interp, a, node),
        None => Err(a.unknown_name("amendment of a node", AMENDMENTS.map(|(known, _)| known))),
    }
}

/// `dampedAs $other`: a node takes over the mass-proportional damping of another one.
///
/// A node that takes over a mass needs it, since `rayleigh` reaches only the nodes that exist.
fn damped_as(interp: &mut Tcl, a: &mut Args<'_>, node: NodeId) -> Outcome {
    let other = node_of(interp, a, "tag of the node whose damping it takes over")?;
    finish(interp, a)?;
    interp.host.engine.change_model(|m| m.nodes[node.0].alpha_m = m.nodes[other.0].alpha_m);
    Ok(Value::EMPTY)
}

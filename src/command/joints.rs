//! What `amend` changes of how nodes and elements hang together.

use super::args::Args;
use super::model::node_of;
use super::{Outcome, Tcl, finish};
use crate::element::amendment::Hinged;
use crate::model::ElementId;
use crate::script::Value;
use std::sync::Arc;

/// `amend node $tag dampedAs $other`: a node that takes over the mass of another one takes over its mass-proportional damping as well, for
/// `rayleigh` reaches only the nodes that there are.
pub(super) fn damped_as(interp: &mut Tcl, a: &mut Args<'_>) -> Outcome {
    let node = node_of(interp, a, "tag of the node")?;
    if a.word("kind of amendment")? != "dampedAs" {
        return Err(a.unknown_name("amendment of a node", ["dampedAs"]));
    }
    let other = node_of(interp, a, "tag of the node whose damping it takes over")?;
    finish(interp, a)?;
    interp.host.engine.change_model(|m| m.nodes[node.0].alpha_m = m.nodes[other.0].alpha_m);
    Ok(Value::EMPTY)
}

/// `amend element $tag hinges`: ends of beams that yield.
pub(super) fn hinge(interp: &mut Tcl, a: &mut Args<'_>, elements: &[ElementId]) -> Outcome {
    let (mut material, mut ends) = (None, &[0, 1][..]);
    while let Some(word) = a.option() {
        match word.as_ref() {
            "-mat" => material = Some(a.of(&interp.host.definitions.materials)?.0),
            "-end" => {
                ends = match a.word("end with a hinge")?.as_ref() {
                    "i" => &[0],
                    "j" => &[1],
                    _ => return Err(a.unknown_name("end", ["i", "j"])),
                }
            }
            _ => return Err(a.unknown_name("option", ["-mat", "-end"])),
        }
    }
    let material = material.ok_or_else(|| {
        let expected = "expected the tag of a uniaxialMaterial, moment over rotation, as well";
        a.refuse("amend hinges: -mat $mat is missing", expected)
    })?;
    finish(interp, a)?;
    for id in elements {
        let model = interp.host.engine.model();
        let entry = &model.elements[id.0];
        let [i, j] = entry.nodes[..] else {
            return Err(a.refuse(format!("element {} has not two nodes", entry.tag), "expected a beam"));
        };
        let chord = model.nodes[j.0].place() - model.nodes[i.0].place();
        let hinged = Hinged::new(entry.element.clone(), chord, ends, material.clone())
            .map_err(|e| a.refuse(e.0, "expected a beam and a material"))?;
        interp.host.engine.replace_element(*id, Arc::new(hinged));
    }
    Ok(Value::EMPTY)
}

/// `amend element $tag node $old $new`: an end of elements joined to another node at the same place, so that a hinge
/// or a spring can be put between.
pub(super) fn rejoin(interp: &mut Tcl, a: &mut Args<'_>, elements: &[ElementId]) -> Outcome {
    let old = node_of(interp, a, "tag of the node that it is joined to")?;
    let new = node_of(interp, a, "tag of the node that it shall be joined to")?;
    let model = interp.host.engine.model();
    let (from, to) = (&model.nodes[old.0], &model.nodes[new.0]);
    if from.ndf != to.ndf || from.place() != to.place() {
        let message =
            format!("node {} is not at the place of node {}, or has other degrees of freedom", to.tag, from.tag);
        return Err(a.refuse(message, "expected a node that can stand for it"));
    }
    for id in elements {
        let entry = &interp.host.engine.model().elements[id.0];
        let Some(end) = entry.nodes.iter().position(|n| *n == old) else {
            let message =
                format!("element {} is not joined to node {}", entry.tag, interp.host.engine.model().nodes[old.0].tag);
            return Err(a.refuse(message, "expected a node of the element"));
        };
        interp.host.engine.change_model(|m| m.rejoin_element(*id, end, new));
    }
    finish(interp, a)?;
    Ok(Value::EMPTY)
}

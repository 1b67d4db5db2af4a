//! Amendments of the joints between nodes and elements.

use crate::args::Args;
use crate::model::nodes::node_of;
use crate::{Outcome, Tcl, finish};
use hysteron_engine::element::amendment::Hinged;
use hysteron_engine::model::ElementId;
use hysteron_engine::shared::Shared;
use hysteron_tcl::Value;

/// `amend element $tag hinges`: ends of beams that yield.
pub(crate) fn hinge(interp: &mut Tcl, a: &mut Args<'_>, elements: &[ElementId]) -> Outcome {
    let (mut material, mut ends) = (None, &[0, 1][..]);
    while let Some(word) = a.option() {
        match word.as_ref() {
            "-mat" => material = Some(a.of(&interp.host.builder.definitions.materials)?.0),
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
        // A truss in space has as many degrees of freedom as a beam in the plane. The dimensions of the nodes differ.
        let ends_of = match entry.nodes[..] {
            [i, j] => {
                Some([&model.nodes[i.0], &model.nodes[j.0]]).filter(|n| n.iter().all(|n| n.ndf == 3 * (n.ndm() - 1)))
            }
            _ => None,
        };
        let Some([i, j]) = ends_of.filter(|[i, j]| i.place() != j.place()) else {
            let message =
                format!("element {} does not stand between two nodes with rotations, apart from each other", entry.tag);
            return Err(a.refuse(message, "expected a beam"));
        };
        let chord = j.place() - i.place();
        let hinged = Hinged::new(entry.element.clone(), chord, ends, material.clone())
            .map_err(|e| a.refuse(e.0, "expected a beam and a material"))?;
        interp.host.engine.replace_elements([(*id, hinged.shared())]);
    }
    Ok(Value::EMPTY)
}

/// `amend element $tag ends -from $old -to $new`: elements at one node hang at another one in the same place.
pub(crate) fn move_ends(interp: &mut Tcl, a: &mut Args<'_>, elements: &[ElementId]) -> Outcome {
    const OPTIONS: [&str; 2] = ["-from", "-to"];
    let mut nodes = [None; 2];
    while let Some(word) = a.option() {
        let Some(i) = OPTIONS.iter().position(|o| *o == word) else { return Err(a.unknown_name("option", OPTIONS)) };
        nodes[i] = Some(node_of(interp, a, ["node of the ends", "node that takes the ends over"][i])?);
    }
    let [Some(from), Some(to)] = nodes else {
        return Err(a.refuse("amend ends: two nodes are needed", "expected -from $old -to $new"));
    };
    finish(interp, a)?;
    let model = interp.host.engine.model();
    let [old, new] = [&model.nodes[from.0], &model.nodes[to.0]];
    if old.place() != new.place() || old.ndf != new.ndf {
        let message =
            format!("node {} is not at the place of node {} with as many degrees of freedom", new.tag, old.tag);
        return Err(a.refuse(message, "expected a node with the same coordinates"));
    }
    if let Some(other) = elements.iter().map(|id| &model.elements[id.0]).find(|e| !e.nodes.contains(&from)) {
        let message = format!("element {} has no end at node {}", other.tag, old.tag);
        return Err(a.refuse(message, "expected elements at that node"));
    }
    interp.host.engine.change_model(|m| elements.iter().for_each(|id| m.move_element_ends(*id, from, to)));
    Ok(Value::EMPTY)
}

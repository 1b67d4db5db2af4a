//! `element ShellMITC4`, `ShellDKGQ`, `ShellDKGT`, `ShellNLDKGQ`.

use super::{Kind, Make, refused};
use crate::Tcl;
use crate::args::Args;
use crate::model::nodes::node_of;
use hysteron_engine::element::Element;
use hysteron_engine::element::shell::{Formulation, Shell, UpdatedShell};
use hysteron_engine::model::NodeId;
use hysteron_tcl::Exception;
use nalgebra::Vector3;
use std::sync::Arc;

pub(super) const MITC4: Kind = Kind {
    names: &["ShellMITC4", "shellMITC4", "Shell", "shell"],
    usage: "element ShellMITC4 $tag $i $j $k $l $section",
    make: Make::AnyNodes(|interp, a| make(interp, a, Formulation::Mitc4)),
};

pub(super) const DKGQ: Kind = Kind {
    names: &["ShellDKGQ", "shellDKGQ"],
    usage: "element ShellDKGQ $tag $i $j $k $l $section",
    make: Make::AnyNodes(|interp, a| make(interp, a, Formulation::KirchhoffQuadrilateral)),
};

pub(super) const DKGT: Kind = Kind {
    names: &["ShellDKGT", "shellDKGT"],
    usage: "element ShellDKGT $tag $i $j $k $section",
    make: Make::AnyNodes(|interp, a| make(interp, a, Formulation::KirchhoffTriangle)),
};

pub(super) const UPDATED: Kind = Kind {
    names: &["ShellNLDKGQ", "shellNLDKGQ"],
    usage: "element ShellNLDKGQ $tag $i $j $k $l $section",
    make: Make::AnyNodes(make_updated),
};

/// Nodes of the corners, their places, and their displacements.
type Corners = (Vec<NodeId>, Vec<Vector3<f64>>, Vec<f64>);

fn corners(interp: &Tcl, a: &mut Args<'_>, count: usize) -> Result<Corners, Exception> {
    let (mut nodes, mut places, mut disp) = (vec![], vec![], vec![]);
    for _ in 0..count {
        let id = node_of(interp, a, "tag of a corner's node")?;
        let engine = &interp.host.engine;
        let node = &engine.model().nodes[id.0];
        if (node.ndm(), node.ndf) != (3, 6) {
            let message = format!("node {} has {} degrees of freedom in {} dimensions", node.tag, node.ndf, node.ndm());
            return Err(a.refuse(message, "expected 6 degrees of freedom in 3 dimensions"));
        }
        places.push(node.place());
        disp.extend(node.dofs().map(|d| engine.state().disp[d]));
        nodes.push(id);
    }
    Ok((nodes, places, disp))
}

fn make(
    interp: &mut Tcl,
    a: &mut Args<'_>,
    formulation: Formulation,
) -> Result<(Vec<NodeId>, Arc<dyn Element>), Exception> {
    let (nodes, places, mut disp) = corners(interp, a, formulation.nodes())?;
    if formulation != Formulation::Mitc4 {
        disp.clear();
    }
    let place = a.last_span();
    let (section, _) = a.of(&interp.host.builder.definitions.plates)?;
    let made = Shell::new(formulation, &places, section, &disp).map_err(|e| refused(a, place, e))?;
    Ok((nodes, Arc::new(made)))
}

fn make_updated(interp: &mut Tcl, a: &mut Args<'_>) -> Result<(Vec<NodeId>, Arc<dyn Element>), Exception> {
    let (nodes, places, _) = corners(interp, a, 4)?;
    let place = a.last_span();
    let (section, _) = a.of(&interp.host.builder.definitions.plates)?;
    let places = std::array::from_fn(|i| places[i]);
    let made = UpdatedShell::new(places, section).map_err(|e| refused(a, place, e))?;
    Ok((nodes, Arc::new(made)))
}

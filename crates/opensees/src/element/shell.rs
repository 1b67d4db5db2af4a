//! `element ShellMITC4`, `ShellDKGQ`, `ShellDKGT`.

use super::{Kind, Make, refused};
use crate::Tcl;
use crate::args::Args;
use crate::model::nodes::node_of;
use hysteron_engine::element::Element;
use hysteron_engine::element::shell::{Formulation, Shell};
use hysteron_engine::model::NodeId;
use hysteron_tcl::Exception;
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

fn make(
    interp: &mut Tcl,
    a: &mut Args<'_>,
    formulation: Formulation,
) -> Result<(Vec<NodeId>, Arc<dyn Element>), Exception> {
    let (mut nodes, mut places, mut disp) = (vec![], vec![], vec![]);
    for _ in 0..formulation.nodes() {
        let id = node_of(interp, a, "tag of a corner's node")?;
        let engine = &interp.host.engine;
        let node = &engine.model().nodes[id.0];
        if (node.ndm(), node.ndf) != (3, 6) {
            let message = format!("node {} has {} degrees of freedom in {} dimensions", node.tag, node.ndf, node.ndm());
            return Err(a.refuse(message, "expected 6 degrees of freedom in 3 dimensions"));
        }
        places.push(node.place());
        if formulation == Formulation::Mitc4 {
            disp.extend(node.dofs().map(|d| engine.state().disp[d]));
        }
        nodes.push(id);
    }
    let place = a.last_span();
    let (section, _) = a.of(&interp.host.builder.definitions.plates)?;
    let made = Shell::new(formulation, &places, section, &disp).map_err(|e| refused(a, place, e))?;
    Ok((nodes, Arc::new(made)))
}

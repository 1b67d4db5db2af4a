//! Nodes at the corners of elements.

use crate::Tcl;
use crate::args::Args;
use crate::model::nodes::node_of;
use crate::text::Arg;
use hysteron_engine::model::NodeId;
use hysteron_tcl::Exception;
use nalgebra::Vector3;

/// Corners of a quadrilateral.
pub(super) const CORNERS: [Arg; 4] = [
    Arg::whole("i", "tag of a corner's node"),
    Arg::whole("j", "tag of a corner's node"),
    Arg::whole("k", "tag of a corner's node"),
    Arg::whole("l", "tag of a corner's node"),
];

/// Corners of a triangle.
pub(super) const TRIANGLE_CORNERS: [Arg; 3] = [CORNERS[0], CORNERS[1], CORNERS[2]];

/// A node that has so many dimensions and degrees of freedom, and its place.
pub(super) fn placed_node(
    interp: &Tcl,
    a: &mut Args<'_>,
    arg: &Arg,
    (ndm, ndf): (usize, usize),
) -> Result<(NodeId, Vector3<f64>), Exception> {
    let id = node_of(interp, a, arg.meaning)?;
    let node = &interp.host.engine.model().nodes[id.0];
    if (node.ndm(), node.ndf) != (ndm, ndf) {
        let message = format!("node {} has {} degrees of freedom in {} dimensions", node.tag, node.ndf, node.ndm());
        return Err(a.refuse(message, format!("expected {ndf} degrees of freedom in {ndm} dimensions")));
    }
    Ok((id, node.place()))
}

/// N such nodes.
pub(super) fn placed_nodes<const N: usize>(
    interp: &Tcl,
    a: &mut Args<'_>,
    arg: &Arg,
    size: (usize, usize),
) -> Result<(Vec<NodeId>, [Vector3<f64>; N]), Exception> {
    let (mut nodes, mut places) = (vec![], [Vector3::zeros(); N]);
    for place in &mut places {
        let (id, found) = placed_node(interp, a, arg, size)?;
        *place = found;
        nodes.push(id);
    }
    Ok((nodes, places))
}

//! `element beamColumnJoint`.

use super::{Kind, Make};
use crate::args::Args;
use crate::checks;
use crate::model::nodes::node_of;
use crate::text::{Arg, Domain, Text};
use crate::{Tcl, warn};
use hysteron_engine::element::{BeamColumnJoint, Element, JOINT_SPRINGS, JointGeometry};
use hysteron_engine::model::NodeId;
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::Diagnostic;
use nalgebra::Vector3;
use std::sync::Arc;

const HEIGHT: Arg = Arg::positive("heightFactor", "distance of the bars of the beams over the height");
const WIDTH: Arg = Arg::positive("widthFactor", "distance of the bars of the columns over the width");

pub(super) const BEAM_COLUMN_JOINT: Kind = Kind {
    names: &["beamColumnJoint"],
    usage: "element beamColumnJoint $tag $below $right $above $left $mat1 ... $mat13 <$heightFactor $widthFactor>",
    text: Text::new("Joint of beams and columns: bar slip, interface shear and a shear panel.")
        .example("element beamColumnJoint 77 1 3 2 4 9 9 9 9 9 9 9 9 9 9 9 9 9")
        .arguments(&[
            Arg::whole("below", "node at the lower edge of the panel"),
            Arg::whole("right", "node at the right edge"),
            Arg::whole("above", "node at the upper edge"),
            Arg::whole("left", "node at the left edge"),
            Arg::new(
                "mat1",
                "laws of bar slip at the left, bar slip at the right (for beams: below and above) and \
                 interface shear, of each node from below against the clock",
            )
            .within(Domain::Whole),
            Arg::whole("mat13", "law of the shear panel, moment over shear angle"),
            HEIGHT,
            WIDTH,
        ]),
    make: Make::AnyNodes(make),
};

/// Share of the length of an axis by which that of a joint in the plane may be inclined.
const MAX_INCLINATION: f64 = 1e-6;

fn make(interp: &mut Tcl, a: &mut Args<'_>) -> Result<(Vec<NodeId>, Arc<dyn Element>), Exception> {
    let (mut nodes, mut places, mut ndm) = (vec![], [Vector3::zeros(); 4], 2);
    for place in &mut places {
        let id = node_of(interp, a, "tag of a node of the joint")?;
        let node = &interp.host.engine.model().nodes[id.0];
        if !matches!((node.ndm(), node.ndf), (2, 3) | (3, 6)) {
            let message = format!("node {} has {} degrees of freedom in {} dimensions", node.tag, node.ndf, node.ndm());
            return Err(a.refuse(message, "expected 3 degrees of freedom in 2 dimensions or 6 in 3"));
        }
        if nodes.contains(&id) {
            return Err(a.refuse(format!("node {} is there twice", node.tag), "expected another node"));
        }
        (*place, ndm) = (node.place(), node.ndm());
        nodes.push(id);
    }
    let last = a.last_span();
    let (up, right) = (places[2] - places[0], places[1] - places[3]);
    let (height, width) = (up.norm(), right.norm());
    if height <= f64::EPSILON || width <= f64::EPSILON {
        let label = "expected the nodes below, right, above and left of the joint";
        return Err(a.refuse_at(last, "beamColumnJoint: nodes that face each other are at one place", label));
    }
    let materials: Vec<_> =
        (0..JOINT_SPRINGS).map(|_| a.of(&interp.host.builder.definitions.materials)).collect::<Result<_, _>>()?;
    let Ok(materials) = materials.try_into() else { return Err(a.refuse("beamColumnJoint: materials", "")) };
    let mut factors = [1.0; 2];
    if a.left() > 0 {
        factors = [a.number(&HEIGHT)?, a.number(&WIDTH)?];
        if ndm == 3 && factors != [1.0; 2] {
            let warning = Diagnostic::warning(
                &checks::words::UNUSED_WORD,
                "beamColumnJoint: the factors of a joint in space are not used, as in OpenSees",
            );
            warn(interp, warning.at(a.last_span(), "expected 1"))?;
            factors = [1.0; 2];
        }
    }
    if ndm == 2 && (up.x.abs() > MAX_INCLINATION * height || right.y.abs() > MAX_INCLINATION * width) {
        let message = "beamColumnJoint: the joint is inclined, but its springs act along the global axes";
        warn(
            interp,
            Diagnostic::warning(&checks::elements::INCLINED_JOINT, message)
                .at(last, "expected nodes below, right, above and left of its centre"),
        )?;
    }
    let unit = |v: Vector3<f64>| -> [f64; 3] { (v / v.norm()).into() };
    let geometry = JointGeometry {
        height,
        width,
        height_factor: factors[0],
        width_factor: factors[1],
        axes: (ndm == 3).then(|| [unit(right), unit(up)]),
    };
    Ok((nodes, BeamColumnJoint::new(materials, &geometry).shared()))
}

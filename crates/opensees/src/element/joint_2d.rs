//! `element Joint2D`.

use super::corners::placed_nodes;
use super::{Kind, Make};
use crate::Tcl;
use crate::args::Args;
use crate::model::constraint;
use crate::text::{Arg, Domain, Text};
use crate::things;
use hysteron_engine::element::{Element, Joint};
use hysteron_engine::material::Material;
use hysteron_engine::model::NodeId;
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use nalgebra::Vector3;
use std::sync::Arc;

const N2: Arg = Arg::whole("n2", "tag of a node of the joint");
const N3: Arg = Arg::whole("n3", "tag of a node of the joint");
const N4: Arg = Arg::whole("n4", "tag of a node of the joint");

pub(super) const JOINT_2D: Kind = Kind {
    names: &["Joint2D", "Joint2d"],
    usage: "element Joint2D $tag $n1 $n2 $n3 $n4 $centre <$mat1 $mat2 $mat3 $mat4> $panel <$largeDisp>",
    text: Text::new("Joint of beams and columns in the plane: a shear panel with rotational springs at its edges.")
        .example("element Joint2D 77 1 2 4 3 99 9 0")
        .arguments(&[
            Arg::new("n1", "nodes at the middles of the edges of a parallelogram, one after the other")
                .within(Domain::Whole),
            N2,
            N3,
            N4,
            Arg::new("centre", "new tag of the node in the middle, with two displacements and two rotations"),
            Arg::new("mat1", "law of the rotational spring at node 1; 0 stands for a rigid one"),
            Arg::new("mat2", "law of the rotational spring at node 2; 0 stands for a rigid one"),
            Arg::new("mat3", "law of the rotational spring at node 3; 0 stands for a rigid one"),
            Arg::new("mat4", "law of the rotational spring at node 4; 0 stands for a rigid one"),
            Arg::new("panel", "law of the moment and the shear angle of the panel"),
            Arg::new("largeDisp", "0; large displacements are not supported"),
        ]),
    make: Make::AnyNodes(make),
};

/// Distance of the middles of 1-3 and 2-4 that OpenSees lets pass.
const MIDDLE_TOLERANCE: f64 = 1e-6;
/// Rotations of the centre, from 0: that of the edges of nodes 1 and 3, and that of nodes 2 and 4.
const ROTATIONS: [usize; 2] = [2, 3];

fn make(interp: &mut Tcl, a: &mut Args<'_>) -> Result<(Vec<NodeId>, Arc<dyn Element>), Exception> {
    let (mut nodes, places) = placed_nodes::<4>(interp, a, &N2, (2, 3))?;
    let last = a.last_span();
    let (first, second) = (0.5 * (places[0] + places[2]), 0.5 * (places[1] + places[3]));
    if (first - second).norm() > MIDDLE_TOLERANCE
        || (places[0] - first).norm() < 1e-12
        || (places[1] - first).norm() < 1e-12
    {
        let label = "expected nodes at the middles of the edges of a parallelogram, one after the other";
        return Err(a.refuse_at(last, "Joint2D: the nodes make no parallelogram", label));
    }
    let centre = a.int("new tag of the central node")?;
    if interp.host.engine.model().node(centre).is_some() {
        return Err(a.exists(things::NODE, centre));
    }
    let springs = springs(interp, a)?;
    if a.optional_int("flag of large displacements")?.is_some_and(|flag| flag != 0) {
        return Err(a.refuse("Joint2D: large displacements are not supported", "expected 0"));
    }
    if matches!(a.peek().as_deref(), Some("-damage" | "-Damage")) {
        a.option();
        return Err(a.refuse("Joint2D: indices of damage are not supported", "expected nothing more"));
    }
    let rigid: Vec<bool> = springs.iter().map(Option::is_none).collect();
    let vector = |from: usize, to: usize| [places[to].x - places[from].x, places[to].y - places[from].y];
    let made = Joint::new(springs, [vector(0, 2), vector(1, 3)]);
    let middle = interp.host.engine.add_node(centre, &[first.x, first.y], 4);
    for (k, (node, place)) in nodes.iter().zip(places).enumerate() {
        tie(interp, (middle, *node), place - first, ROTATIONS[k % 2], rigid[k]);
    }
    nodes.push(middle);
    Ok((nodes, made.shared()))
}

/// Springs of the four nodes, if there are any, and of the panel.
fn springs(interp: &Tcl, a: &mut Args<'_>) -> Result<[Option<(Material, i32)>; 5], Exception> {
    let mut springs = [None, None, None, None, None];
    if a.ahead().take_while(|w| w.as_f64().is_some()).count() > 2 {
        for spring in &mut springs[..4] {
            // 0 stands for a rigid node.
            if a.peek().is_some_and(|w| w.as_ref() == "0") {
                a.int("tag of a material or 0")?;
            } else {
                *spring = Some(a.of(&interp.host.builder.definitions.materials)?);
            }
        }
    }
    springs[4] = Some(a.of(&interp.host.builder.definitions.materials)?);
    Ok(springs)
}

/// Node of an edge that moves as a rigid arm with the centre, turned by the rotation `main`. A rigid node turns with the
/// other rotation.
fn tie(interp: &mut Tcl, (centre, node): (NodeId, NodeId), arm: Vector3<f64>, main: usize, rigid: bool) {
    if rigid {
        let mut matrix = vec![0.0; 12];
        (matrix[0], matrix[main]) = (1.0, -arm.y);
        (matrix[5], matrix[4 + main]) = (1.0, arm.x);
        matrix[8 + ROTATIONS[usize::from(main == ROTATIONS[0])]] = 1.0;
        return constraint::add(interp, centre, node, (vec![0, 1, 2], vec![0, 1, 2, 3]), matrix);
    }
    let matrix = vec![1.0, 0.0, -arm.y, 0.0, 1.0, arm.x];
    constraint::add(interp, centre, node, (vec![0, 1], vec![0, 1, main]), matrix);
}

//! Closing gaps: pounding, a moat wall, a stopper.

use super::declaration::{Dimension, Measurement, Quantity};
use super::{AddedParameter, Hypothesis, MovingGroup, Proposal, ProposalContext, element_names, element_tags};
use crate::inspect::adjacent_structures::AdjacentNodes;
use crate::inspect::device_axes::device_axes;
use crate::inspect::inventory::{Device, TagPurpose};
use crate::inspect::response::ResponseRange;
use crate::memory::family::Family;

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "gap_impact",
    statement: "a gap closes: pounding, a moat wall, a stopper",
    refuted_by: "the deformation passes the gap without a peak of force or acceleration",
    look_alikes: &["strain_stiffening"],
    shows: "peaks of force or acceleration at one deformation; a displacement that is cut off on one side",
    parted_by: "below that deformation the model is right",
    place: "nonlinear groups, and linear ones on the ground; each device of a group of 2 to 6; at most 8 pairs of neighbours",
    forms: "`gap` on both sides or one, linear or Hertzian, across one axis; a joint between neighbours",
    needs_clock: false,
    is_missing_part: false,
    memory: &[Family::Shape, Family::Side],
    materials: &[],
    measurement: Measurement::new(
        "measure the clearance at {place}, and put an accelerometer beside it: contact shows as short peaks",
        "measure the clearance at {place}, and drive slowly to it: the force must rise there",
    ),
    quantities: &[
        Quantity::new("gap", "gap", Dimension::Length),
        Quantity::new("wall", "stiffness of the wall", Dimension::Stiffness),
        Quantity::new("damping", "damping of the contact", Dimension::Unnamed),
    ],
    propose,
};

/// Largest number of devices in a group that get walls one at a time.
const MAX_SINGLE_DEVICES: usize = 6;

/// Least gap over the largest deformation; a closer wall is no gap. A choice.
const MIN_GAP: f64 = 0.05;

fn propose(s: &ProposalContext<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for m in s.moving_or_supported_groups() {
        let sides = [("walls on both sides", 0), ("wall on the positive side", 1), ("wall on the negative side", -1)];
        let all = BlockedDirections { directions: &m.directions, across: "" };
        for (form, side) in sides {
            for (law, power) in [("", 1.0), (", Hertz contact", 1.5)] {
                out.extend(wall(s, &m, &m.devices, &all, &format!("{form}{law}"), (side, power)));
            }
            // Of devices that move in the plane, a wall across one axis.
            if let [first, second] = &m.directions[..] {
                for (direction, across) in [(first, " across the first axis"), (second, " across the second axis")] {
                    let blocked = BlockedDirections { directions: std::slice::from_ref(direction), across };
                    out.extend(wall(s, &m, &m.devices, &blocked, form, (side, 1.0)));
                }
            }
        }
        // An abutment or an adjacent building is at one device.
        for device in m.devices.iter().filter(|_| (2..=MAX_SINGLE_DEVICES).contains(&m.devices.len())) {
            for (form, side) in sides {
                out.extend(wall(s, &m, &[device], &all, form, (side, 1.0)));
            }
        }
    }
    for (n, pair) in s.inventory.adjacent.iter().enumerate() {
        out.extend(joint_contact(s, n, pair));
    }
    out
}

/// Directions that a wall blocks.
struct BlockedDirections<'a> {
    directions: &'a [usize],
    across: &'static str,
}

/// Starts of the gap over the largest deformation towards the wall. A wall touched at a few peaks leaves the motion
/// between them unchanged, and its minimum is narrow. A choice.
const GAP_STARTS: [f64; 4] = [0.97, 0.9, 0.8, 0.5];

/// Walls beside devices of a group; none if no device moves towards them. The contact law is force ∝ penetration^power.
fn wall(
    s: &ProposalContext<'_>,
    m: &MovingGroup<'_>,
    devices: &[&Device],
    blocked: &BlockedDirections<'_>,
    form: &str,
    (side, power): (i32, f64),
) -> Option<Proposal> {
    let line = format!(
        "amend element {} gap -at $hy_gap -stiffness $hy_wall -power {power} -damping $hy_damping -side {side} -dir {}",
        element_tags(devices),
        blocked.directions.iter().map(usize::to_string).collect::<Vec<_>>().join(" ")
    );
    let towards = |x: ResponseRange| match side {
        0 => x.deformation,
        1 => x.deformation_bounds[1],
        _ => -x.deformation_bounds[0],
    };
    let reach = blocked.directions.iter().filter_map(|d| s.responses.of(devices, *d)).map(towards).fold(0.0, f64::max);
    if reach <= MIN_GAP * m.deformation {
        return None;
    }
    // Equal contact force at a penetration of a fifth of the deformation.
    let k = m.stiffness() * (0.2 * m.deformation).powf(1.0 - power);
    let gap = AddedParameter::linear("gap", MIN_GAP * m.deformation, 1.1 * m.deformation, 0.7 * reach);
    let gap = AddedParameter { further_starts: GAP_STARTS.map(|part| part * reach).into(), ..gap };
    let added = [vec![gap], contact(k, 30.0 * k, m.speed)].concat();
    Some(Proposal::script_edit(
        "gap_impact",
        &format!("{form}{}", blocked.across),
        element_names(devices),
        vec![line],
        added,
    ))
}

/// Parameters of a contact: its stiffness on the scale k with the start of its search, and its damping on the scale of 1/speed.
fn contact(k: f64, start: f64, speed: f64) -> Vec<AddedParameter> {
    let nonzero_speed = speed.max(1e-12);
    vec![
        AddedParameter::log("wall", 0.5 * k, 1e4 * k, start),
        AddedParameter::log("damping", 1e-3 / nonzero_speed, 3.0 / nonzero_speed, 0.1 / nonzero_speed),
    ]
}

/// Width of a joint between adjacent structures over the sum of all deformations, largest and least. A choice.
const MAX_JOINT_WIDTH: f64 = 2.0;
const MIN_JOINT_WIDTH: f64 = 0.01;
/// Starts of the width over that sum. A choice.
const JOINT_STARTS: [f64; 4] = [0.05, 0.1, 0.4, 0.8];

/// A joint between adjacent structures that closes. Nodes at one place give a proposal for either order of the structures.
fn joint_contact(s: &ProposalContext<'_>, number: usize, pair: &AdjacentNodes) -> Vec<Proposal> {
    let of = |d: &Device| {
        let lateral = device_axes(&[d], s.inventory, s.responses).lateral;
        lateral.into_iter().filter_map(|n| s.responses.of(&[d], n)).collect::<Vec<_>>()
    };
    let extents: Vec<ResponseRange> = s.inventory.devices.iter().flat_map(of).collect();
    let reach: f64 = extents.iter().map(|x| x.deformation).sum();
    let Some(most) = extents
        .into_iter()
        .reduce(ResponseRange::envelope)
        .filter(|x| s.inventory.base_excited && x.deformation > 0.0 && x.force > 0.0)
    else {
        return vec![];
    };
    let k = most.force / most.deformation;
    let tag = s.inventory.first_tag(TagPurpose::Joints) + number as i32;
    let [i, j] = pair.nodes;
    // The link between separated nodes has the direction in which they approach.
    let (element, sides): (_, &[i32]) = if pair.separated { ("twoNodeLink", &[-1]) } else { ("zeroLength", &[-1, 1]) };
    let one = |side: &i32| {
        // The amendment is the wall; the spring only carries it.
        let block = vec![
            format!("uniaxialMaterial Elastic {tag} {:e}", 1e-9 * k),
            format!("element {element} {tag} {i} {j} -mat {tag} -dir 1"),
            format!("amend element {tag} gap -at $hy_gap -stiffness $hy_wall -damping $hy_damping -side {side} -dir 1"),
        ];
        let gap = AddedParameter::log("gap", MIN_JOINT_WIDTH * reach, MAX_JOINT_WIDTH * reach, 0.2 * reach);
        let gap = AddedParameter { further_starts: JOINT_STARTS.map(|part| part * reach).into(), ..gap };
        let added = [vec![gap], contact(k, 10.0 * k, most.speed)].concat();
        let form = if *side < 0 { "neighbours touch" } else { "neighbours touch, the second on the other side" };
        Proposal::script_edit("gap_impact", form, format!("nodes {i} {j}"), block, added)
    };
    sides.iter().map(one).collect()
}

//! Gaps that close or open: pounding, a moat wall, a stopper, uplift.

use super::cavitation::{PulledDevices, pulled_devices};
use super::declaration::{Dimension, Measurement, Quantity};
use super::free_masses::{FreeMass, MovingDirection, free_masses};
use super::{AddedParameter, Hypothesis, MovingGroup, Proposal, ProposalContext, element_names, element_tags};
use crate::inspect::adjacent_structures::AdjacentNodes;
use crate::inspect::device_axes::device_axes;
use crate::inspect::inventory::{Device, TagPurpose};
use crate::inspect::response::ResponseRange;
use crate::memory::family::Family;

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "gap_impact",
    statement: "a gap closes or opens: pounding, a moat wall, a stopper, uplift",
    refuted_by: "the deformation passes the gap without a peak of force or acceleration",
    look_alikes: &["strain_stiffening", "cavitation"],
    shows: "peaks of force or acceleration at one deformation; a displacement that is cut off on one side; no force of a bearing that lifts off",
    parted_by: "below that deformation the model is right; `cavitation` holds a tension",
    place: "nonlinear groups, and linear ones on the ground; each device of a group of 2 to 6; at most 8 pairs of neighbours; each of 6 masses that are not on a device on the ground; devices that are pulled in their axis",
    forms: "`gap` on both sides or one, linear or Hertzian, across one axis; a joint between neighbours; a wall on the ground on either side of a mass, or a neighbour there that is one mass on a spring; `cavitation` at no force",
    needs_clock: false,
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
        Quantity::new("neighbour", "mass of the neighbour", Dimension::Unnamed),
        Quantity::new("period", "period of the neighbour", Dimension::Time),
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
    if s.inventory.base_excited {
        out.extend(free_masses(s).iter().flat_map(|m| contacts_beside_mass(s, m)));
    }
    out.extend(pulled_devices(s).iter().map(uplift));
    for (n, pair) in s.inventory.adjacent.iter().enumerate() {
        out.extend(joint_contact(s, n, pair));
    }
    out
}

/// Tension that lifts a bearing off, over that of its stiffness: as good as none.
const NO_TENSION: f64 = 1e-4;

/// A bearing that is not held down loses the stiffness of its contact in tension.
fn uplift(pulled: &PulledDevices<'_>) -> Proposal {
    let &PulledDevices { ref devices, direction, sign, stiffness: k, extension } = pulled;
    let line = format!(
        "amend element {} cavitation -strength {:.6e} -extension {:.6e} -damage 0.0 -share $hy_k 0 -sign {sign} -dir {direction}",
        element_tags(devices),
        NO_TENSION * k * extension,
        NO_TENSION * extension,
    );
    let added = vec![AddedParameter::linear("k", 0.3 * k, 2.0 * k, k)];
    Proposal::script_edit("gap_impact", "uplift", element_names(devices), vec![line], added)
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
    let added = [vec![gap(m.deformation, reach)], contact(k, 30.0 * k, m.speed)].concat();
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

/// Contacts on either side of a mass, in each direction in which it moves.
fn contacts_beside_mass(s: &ProposalContext<'_>, m: &FreeMass<'_>) -> Vec<Proposal> {
    let sides = |d| [(d, 1, "positive"), (d, -1, "negative")];
    m.directions.iter().flat_map(sides).flat_map(|at| contact_beside_mass(s, m, at)).collect()
}

/// A wall on the ground that the mass meets when it moves to a side, and a neighbour there; none if the mass does not move
/// towards it.
fn contact_beside_mass(
    s: &ProposalContext<'_>,
    m: &FreeMass<'_>,
    (direction, side, side_name): (&MovingDirection, i32, &str),
) -> Vec<Proposal> {
    let &MovingDirection { dof, motion, inertia } = direction;
    let [low, high] = motion.displacement_bounds;
    let (most, reach) = (motion.displacement(), if side > 0 { high } else { -low });
    if reach <= MIN_GAP * most {
        return vec![];
    }
    let k = inertia / most;
    let tag = s.inventory.first_tag(TagPurpose::MassContacts);
    let ground = m.ground_node(tag, s.inventory.ndm);
    let axis = if m.directions.len() > 1 { format!(" along axis {dof}") } else { String::new() };
    let form = |form: &str, block: Vec<String>, of_gap: AddedParameter, more: Vec<AddedParameter>| {
        let added = [more, vec![of_gap], contact(k, 30.0 * k, motion.velocity)].concat();
        let form = format!("{form} a mass on the {side_name} side{axis}");
        Proposal::script_edit("gap_impact", &form, m.location(), block, added)
    };
    let wall = carried_gap(k, tag, ("zeroLength", [tag, m.mass.node]), side, dof);
    let touched = carried_gap(k, tag + 1, ("zeroLength", [tag + 1, m.mass.node]), side, dof);
    let neighbour = [&ground[..], &m.neighbour(s, (tag, tag + 1), dof), &touched].concat();
    let (own, length) = (m.mass.mass[dof - 1], s.longest_run());
    let more = vec![
        AddedParameter { further_starts: NEIGHBOUR_STARTS.into(), ..neighbour_period(length) },
        AddedParameter::log("neighbour", 0.1 * own, 10.0 * own, own),
    ];
    // A neighbour comes to meet the mass.
    let joint = AddedParameter::linear("gap", MIN_GAP * most, MAX_JOINT_WIDTH * most, 0.7 * reach);
    let joint = AddedParameter { further_starts: GAP_STARTS.map(|part| part * reach).into(), ..joint };
    vec![
        form("wall beside", [&ground[..], &wall].concat(), gap(most, reach), vec![]),
        Proposal { is_missing_part: true, ..form("neighbour of one mass beside", neighbour, joint, more) },
    ]
}

/// Periods of a neighbour, s: range, start and further starts. Buildings of one to ten storeys have 0.1 to 1 s
/// (ASCE/SEI 7-16, 12.8.2.1); taller ones and those on bearings have more.
const NEIGHBOUR_PERIODS: [f64; 3] = [0.05, 4.0, 0.5];
const NEIGHBOUR_STARTS: [f64; 3] = [0.2, 1.0, 2.0];

/// The period of a neighbour, no longer than a run.
fn neighbour_period(length: f64) -> AddedParameter {
    let [shortest, longest, start] = NEIGHBOUR_PERIODS;
    AddedParameter::log("period", shortest, longest.min(length.max(2.0 * start)), start)
}

/// Width of a gap, with the largest deformation in any direction and the largest towards the wall.
fn gap(most: f64, reach: f64) -> AddedParameter {
    let gap = AddedParameter::linear("gap", MIN_GAP * most, 1.1 * most, 0.7 * reach);
    AddedParameter { further_starts: GAP_STARTS.map(|part| part * reach).into(), ..gap }
}

/// Commands for a contact between two nodes, on an element that only carries it; k is a stiffness of the model.
fn carried_gap(k: f64, tag: i32, (element, [i, j]): (&str, [i32; 2]), side: i32, dof: usize) -> [String; 3] {
    [
        format!("uniaxialMaterial Elastic {tag} {:e}", 1e-9 * k),
        format!("element {element} {tag} {i} {j} -mat {tag} -dir {dof}"),
        format!("amend element {tag} gap -at $hy_gap -stiffness $hy_wall -damping $hy_damping -side {side} -dir {dof}"),
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
        let block = carried_gap(k, tag, (element, [i, j]), *side, 1).to_vec();
        let gap = AddedParameter::log("gap", MIN_JOINT_WIDTH * reach, MAX_JOINT_WIDTH * reach, 0.2 * reach);
        let gap = AddedParameter { further_starts: JOINT_STARTS.map(|part| part * reach).into(), ..gap };
        let added = [vec![gap], contact(k, 10.0 * k, most.speed)].concat();
        let form = if *side < 0 { "neighbours touch" } else { "neighbours touch, the second on the other side" };
        Proposal::script_edit("gap_impact", form, format!("nodes {i} {j}"), block, added)
    };
    sides.iter().map(one).collect()
}

#[cfg(test)]
mod tests {
    use super::propose;
    use crate::inspect::response::{NodeMotion, ResponseRanges};
    use crate::test_support::{pad_study, proposal_context, shaken_inventory};

    /// A wall or a neighbour stands beside a mass that moves towards it. The mass on a device on the ground has the wall of the device.
    #[test]
    fn walls_stand_where_a_mass_moves_to() {
        let text = "model basic -ndm 1 -ndf 1
            foreach n {1 2 3} {node $n 0.}
            fix 1 1
            foreach n {2 3} {mass $n 1.}
            uniaxialMaterial Elastic 1 100.
            element zeroLength 1 1 2 -mat 1 -dir 1
            element zeroLength 2 2 3 -mat 1 -dir 1";
        let (inventory, study) = (shaken_inventory(text), pad_study());
        let walls = |displacement_bounds: [f64; 2]| -> Vec<(String, String)> {
            let motion = NodeMotion { velocity: 1.0, acceleration: 10.0, displacement_bounds };
            let node_motions = [((2, 1), motion), ((3, 1), motion)].into();
            let responses = ResponseRanges { node_motions, ..ResponseRanges::default() };
            let proposals = propose(&proposal_context(&inventory, &study, &responses));
            proposals.into_iter().map(|p| (p.location, p.form)).collect()
        };
        let contact =
            |what: &str, side: &str| ("node 3".to_owned(), format!("{what} beside a mass on the {side} side"));
        let beside = |side: &str| [contact("wall", side), contact("neighbour of one mass", side)];
        assert_eq!(walls([-0.1, 0.1]), [beside("positive"), beside("negative")].concat());
        assert_eq!(walls([-0.1, 0.001]), beside("negative"));
    }
}

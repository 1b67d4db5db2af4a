//! Torsion of a plan with an eccentric mass.

use super::declaration::{Dimension, Measurement, Quantity, Recordable};
use super::{AddedParameter, Hypothesis, Proposal, ProposalContext};
use crate::inspect::inventory::TagPurpose;

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "torsion",
    statement: "the mass or the stiffness is eccentric and turns the plan",
    refuted_by: "opposite edges move alike",
    look_alikes: &["bidirectional_coupling", "sensor_gain"],
    shows: "opposite edges of a floor that move differently; a second frequency in the beat of the corners",
    parted_by: "the mean of both edges is right",
    place: "masses with a rotational part in plan, of a shaken model",
    forms: "eccentric mass, in both directions or along one",
    needs_clock: false,
    memory: &[],
    materials: &[],
    measurement: Measurement::new(
        "put two accelerometers of one direction on opposite edges of the floor of {place}: they must differ",
        "record opposite edges of the floor of {place}: they must differ",
    )
    .unless(Recordable::EdgesOfFloor, None),
    quantities: &[
        Quantity::new("ex", "eccentricity along X", Dimension::Length),
        Quantity::new("ey", "eccentricity along Y", Dimension::Length),
    ],
    propose,
};

/// Least radius of gyration of a floor over the extent of the model; a floor has about a third. Frames in elevation have
/// negligible rotational inertia. A choice.
const MIN_GYRATION_RADIUS: f64 = 0.01;

fn propose(s: &ProposalContext<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    if !s.inventory.base_excited {
        return out;
    }
    let ndm = s.inventory.ndm;
    for (n, node) in s.inventory.masses.iter().enumerate() {
        // A floor has two translations and the rotation about the vertical axis.
        let plan = if ndm == 2 { node.mass.len() == 3 } else { node.mass.len() == 6 };
        let turn = if ndm == 2 { 2 } else { 5 };
        if !plan || node.mass[turn] <= 0.0 || node.mass[0] <= 0.0 {
            continue;
        }
        let tag = s.inventory.first_tag(TagPurpose::Masses) + n as i32;
        let radius = (node.mass[turn] / node.mass[0]).sqrt();
        if radius < MIN_GYRATION_RADIUS * s.inventory.extent {
            continue;
        }
        let third = if ndm == 3 { format!(" [nodeCoord {} 3]", node.node) } else { String::new() };
        let masses = |keep: &dyn Fn(usize) -> bool| {
            let words =
                node.mass.iter().enumerate().map(|(i, m)| if keep(i) { format!("{m:e}") } else { "0.0".into() });
            words.collect::<Vec<_>>().join(" ")
        };
        let mut form = |form: &str, ex: &str, ey: &str| {
            let mut block = vec![
                format!(
                    "node {tag} [expr {{[nodeCoord {0} 1]+{ex}}}] [expr {{[nodeCoord {0} 2]+{ey}}}]{third}",
                    node.node
                ),
                format!("mass {tag} {}", masses(&|i| i < 2)),
                format!("mass {} {}", node.node, masses(&|i| i >= 2)),
                format!("rigidLink beam {} {tag}", node.node),
            ];
            if node.damped {
                block.push(format!("amend node {tag} dampedAs {}", node.node));
            }
            let names = [(ex, "ex"), (ey, "ey")];
            let own = names.iter().filter(|(word, _)| word.starts_with('$'));
            let added = own.map(|(_, name)| AddedParameter::linear(name, -radius, radius, 0.05 * radius)).collect();
            out.push(Proposal::script_edit("torsion", form, format!("node {}", node.node), block, added));
        };
        form("eccentric mass", "$hy_ex", "$hy_ey");
        // An eccentricity along the excited axis adds little but inertia, and misleads a search for both.
        form("mass eccentric along x", "$hy_ex", "0.0");
        form("mass eccentric along y", "0.0", "$hy_ey");
    }
    out
}

#[cfg(test)]
mod tests {
    use super::propose;
    use crate::inspect::inventory::{Mass, ModelInventory};
    use crate::inspect::response::ResponseRanges;
    use crate::test_support::{pad_study, proposal_context};

    #[test]
    fn a_negligible_rotational_inertia_makes_no_floor() {
        let (study, responses) = (pad_study(), ResponseRanges::default());
        let proposed = |turn: f64, extent: f64| {
            let masses = vec![Mass { node: 1, mass: vec![18.0, 18.0, turn], damped: false }];
            let mut inventory = ModelInventory::default();
            (inventory.ndm, inventory.base_excited, inventory.extent, inventory.masses) = (2, true, extent, masses);
            propose(&proposal_context(&inventory, &study, &responses)).len()
        };
        assert_eq!(proposed(18.0 * 3.0 * 3.0, 14.0), 3);
        assert_eq!(proposed(1e-6, 14.0), 0);
        // A floor on one spring gives the model no extent.
        assert_eq!(proposed(18.0 * 3.0 * 3.0, 0.0), 3);
    }
}

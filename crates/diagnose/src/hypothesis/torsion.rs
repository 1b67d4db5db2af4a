//! An eccentric plan turns.

use super::{Added, Hypothesis, Proposal, Sight};
use crate::inspect::inventory::Numbers;

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "torsion",
    says: "the mass or the stiffness is eccentric and turns the plan",
    refuted_by: "opposite edges move alike",
    like: &["bidirectional_coupling", "sensor_gain"],
    needs_clock: false,
    propose,
};

/// A mass whose radius of gyration is less than this part of the model's extent has no plan: its rotational part is a token, as frames
/// in elevation have it (a choice; a floor has about a third).
const TOKEN: f64 = 0.01;

fn propose(s: &Sight<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    if !s.anatomy.shaken {
        return out;
    }
    let ndm = s.anatomy.ndm;
    for (n, node) in s.anatomy.masses.iter().enumerate() {
        // In plan: two translations and the rotation about the vertical.
        let plan = if ndm == 2 { node.mass.len() == 3 } else { node.mass.len() == 6 };
        let turn = if ndm == 2 { 2 } else { 5 };
        if !plan || node.mass[turn] <= 0.0 || node.mass[0] <= 0.0 {
            continue;
        }
        let tag = s.anatomy.free(Numbers::Masses) + n as i32;
        let radius = (node.mass[turn] / node.mass[0]).sqrt();
        if radius < TOKEN * s.anatomy.extent {
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
            let added = own.map(|(_, name)| Added::linear(name, -radius, radius, 0.05 * radius)).collect();
            out.push(Proposal::edit("torsion", form, format!("node {}", node.node), block, added));
        };
        form("eccentric mass", "$hy_ex", "$hy_ey");
        // Along the axis that is shaken an eccentricity does little but add inertia, and leads a search for both astray.
        form("mass eccentric along x", "$hy_ex", "0.0");
        form("mass eccentric along y", "0.0", "$hy_ey");
    }
    out
}

#[cfg(test)]
mod tests {
    use super::propose;
    use crate::fit::two_effect_search::tests::baseline;
    use crate::hypothesis::Sight;
    use crate::inspect::inventory::{Anatomy, Mass};
    use crate::inspect::response::Scales;

    #[test]
    fn a_token_of_inertia_makes_no_plan() {
        let (study, scales) = (baseline().variant.study.clone(), Scales::default());
        let proposed = |turn: f64, extent: f64| {
            let masses = vec![Mass { node: 1, mass: vec![18.0, 18.0, turn], damped: false }];
            let mut anatomy = Anatomy::default();
            (anatomy.ndm, anatomy.shaken, anatomy.extent, anatomy.masses) = (2, true, extent, masses);
            propose(&Sight { anatomy: &anatomy, study: &study, scales: &scales, fits: &[], clock: true }).len()
        };
        assert_eq!(proposed(18.0 * 3.0 * 3.0, 14.0), 3);
        assert_eq!(proposed(1e-6, 14.0), 0);
        // A floor that stands on one spring has no extent but its own.
        assert_eq!(proposed(18.0 * 3.0 * 3.0, 0.0), 3);
    }
}

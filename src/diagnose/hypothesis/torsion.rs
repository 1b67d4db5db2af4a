//! An eccentric plan turns.

use super::{Added, Hypothesis, Proposal, Sight};
use crate::diagnose::anatomy::Numbers;

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "torsion",
    says: "the mass or the stiffness is eccentric and turns the plan",
    refuted_by: "opposite edges move alike",
    like: &["bidirectional_coupling", "sensor_gain"],
    needs_clock: false,
    propose,
};

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

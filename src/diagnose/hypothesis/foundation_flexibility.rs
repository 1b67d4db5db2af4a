//! The support gives way.

use super::{Added, Hypothesis, Proposal, Sight};

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "foundation_flexibility",
    says: "the soil or the support below the fixed base of the model gives way",
    refuted_by: "the base of the structure does not move against the free field",
    like: &["superstructure_yielding", "damping"],
    propose,
};

fn propose(s: &Sight<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    if !s.anatomy.shaken {
        return out;
    }
    let scale = s.stiffness();
    for (n, support) in s.anatomy.supports.iter().enumerate() {
        if support.elements.is_empty() || support.fixed.len() < s.anatomy.ndm {
            continue;
        }
        let mut form = |form: &str, dof: usize, scale: f64| {
            let tag = s.anatomy.free_tag + 10 * n as i32;
            let direction = if s.anatomy.ndm == 2 && dof == 3 { 6 } else { dof };
            let block = vec![
                format!("node {tag} {}", coordinates(support.node, s.anatomy.ndm)),
                format!("fix {tag} {}", vec!["1"; support.ndf].join(" ")),
                format!("remove sp {} {dof}", support.node),
                format!("uniaxialMaterial Elastic {tag} $hy_spring"),
                format!("uniaxialMaterial Viscous {} $hy_dashpot 1.0", tag + 1),
                format!(
                    "element zeroLength {tag} {tag} {} -mat {tag} {} -dir {direction} {direction}",
                    support.node,
                    tag + 1
                ),
            ];
            let added = vec![
                Added::log("spring", 0.05 * scale, 1e3 * scale, 5.0 * scale),
                Added::log("dashpot", 1e-5 * scale, 0.3 * scale, 1e-3 * scale),
            ];
            out.push(Proposal::edit("foundation_flexibility", form, format!("node {}", support.node), block, added));
        };
        form("horizontal spring", 1, scale);
        let rotation = if s.anatomy.ndm == 2 { 3 } else { 5 };
        if support.fixed.contains(&rotation) && support.ndf >= rotation {
            let height = s.height();
            form("rocking spring", rotation, scale * height * height);
        }
    }
    out
}

/// Tcl that gives the coordinates of a node.
fn coordinates(node: i32, ndm: usize) -> String {
    (1..=ndm).map(|i| format!("[nodeCoord {node} {i}]")).collect::<Vec<_>>().join(" ")
}

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
    let (ndm, total) = (s.anatomy.ndm, s.anatomy.masses.iter().map(|m| m.mass[0]).sum::<f64>());
    for (n, support) in s.anatomy.supports.iter().enumerate() {
        if support.elements.is_empty() || support.fixed.len() < ndm {
            continue;
        }
        let rotation = if ndm == 2 { 3 } else { 5 };
        let rocks =
            support.fixed.contains(&rotation) && support.ndf >= rotation && support.stiffness[rotation - 1] > 0.0;
        let mut form = |form: &str, dofs: &[(&str, usize)], footing: bool| {
            let tag = s.anatomy.free_tag + 10 * n as i32;
            let mut block = vec![
                format!("node {tag} {}", super::coordinates(support.node, ndm)),
                format!("fix {tag} {}", vec!["1"; support.ndf].join(" ")),
            ];
            let mut added = vec![];
            for (k, (name, dof)) in dofs.iter().enumerate() {
                let direction = if ndm == 2 && *dof == 3 { 6 } else { *dof };
                let (spring, dashpot) = (tag + 2 * k as i32, tag + 2 * k as i32 + 1);
                block.extend([
                    format!("remove sp {} {dof}", support.node),
                    format!("uniaxialMaterial Elastic {spring} $hy_{name}"),
                    format!("uniaxialMaterial Viscous {dashpot} $hy_{name}_dashpot 1.0"),
                    format!(
                        "element zeroLength {spring} {tag} {} -mat {spring} {dashpot} -dir {direction} {direction}",
                        support.node
                    ),
                ]);
                // Against the stiffness of what stands on it: what is much stiffer is a fixed base.
                let scale = support.stiffness[dof - 1];
                added.push(Added::log(name, 3e-3 * scale, 100.0 * scale, scale));
                added.push(Added::log(&format!("{name}_dashpot"), 1e-5 * scale, 0.3 * scale, 3e-3 * scale));
            }
            if footing {
                let own = s.anatomy.masses.iter().find(|m| m.node == support.node).map_or(&[][..], |m| &m.mass);
                let mass = |i: usize| own.get(i).copied().unwrap_or(0.0);
                let words = (0..support.ndf).map(|i| match i {
                    0 => format!("[expr {{{:e}+$hy_footing}}]", mass(0)),
                    _ => format!("{:e}", mass(i)),
                });
                block.push(format!("mass {} {}", support.node, words.collect::<Vec<_>>().join(" ")));
                added.push(Added::log("footing", 1e-3 * total, total, 0.05 * total));
            }
            out.push(Proposal::edit("foundation_flexibility", form, format!("node {}", support.node), block, added));
        };
        if support.stiffness[0] > 0.0 {
            form("horizontal spring", &[("sway", 1)], false);
            if total > 0.0 {
                form("horizontal spring and a footing with mass", &[("sway", 1)], true);
            }
        }
        if rocks {
            form("rocking spring", &[("rocking", rotation)], false);
            form("horizontal and rocking spring", &[("sway", 1), ("rocking", rotation)], false);
        }
    }
    out
}

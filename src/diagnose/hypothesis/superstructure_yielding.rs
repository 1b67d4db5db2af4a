//! The structure above yields.

use super::{Added, Hypothesis, Proposal, Sight};

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "superstructure_yielding",
    says: "the structure above, taken as elastic, yields",
    refuted_by: "the structure comes back to where it stood, and its stiffness does not fall with the amplitude",
    like: &["foundation_flexibility", "damping"],
    propose,
};

fn propose(s: &Sight<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for m in s.moved(true) {
        // Each alone, and all together.
        let mut sets: Vec<Vec<&crate::diagnose::anatomy::Device>> = m.group.iter().map(|d| vec![*d]).collect();
        if m.group.len() > 1 {
            sets.push(m.group.clone());
        }
        for set in sets {
            let q = m.directions.iter().filter_map(|d| s.scales.of(&set, *d)).map(|x| x.q).fold(0.0, f64::max);
            let line = format!(
                "amend element {} yielding -force $hy_yield -hardening $hy_hardening {}",
                super::tags(&set),
                m.dir
            );
            let added =
                vec![Added::log("yield", 0.05 * q, 1.5 * q, 0.6 * q), Added::linear("hardening", 0.0, 0.6, 0.1)];
            let at = super::named(&set);
            out.push(Proposal::edit("superstructure_yielding", "bilinear spring", at, vec![line], added));
        }
    }
    // A hinge at the foot of each column that stands on a fixed node.
    for support in &s.anatomy.supports {
        let feet: Vec<_> = s.anatomy.beams.iter().filter(|b| b.nodes.contains(&support.node)).collect();
        let [foot] = feet[..] else { continue };
        let (tag, ndm) = (s.anatomy.free_tag + 5, s.anatomy.ndm);
        if ndm != 2 {
            continue;
        }
        let block = vec![
            format!("node {tag} [nodeCoord {0} 1] [nodeCoord {0} 2]", support.node),
            format!("amend element {} node {} {tag}", foot.tag, support.node),
            format!("equalDOF {} {tag} 1 2", support.node),
            format!("uniaxialMaterial Steel02 {tag} $hy_moment $hy_rotational $hy_hardening 18.0 0.925 0.15"),
            format!("element zeroLength {tag} {} {tag} -mat {tag} -dir 6", support.node),
        ];
        let moment = s.stiffness() * s.height() * 0.01;
        let added = vec![
            Added::log("moment", 1e-2 * moment, 1e2 * moment, moment),
            Added::log("rotational", 10.0 * moment, 1e5 * moment, 1e3 * moment),
            Added::linear("hardening", 0.0, 0.4, 0.03),
        ];
        let at = format!("foot of element {}", foot.tag);
        out.push(Proposal::edit("superstructure_yielding", "plastic hinge", at, block, added));
    }
    out
}

//! The two directions share one yield surface.

use super::{Added, Hypothesis, Proposal, Sight};

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "bidirectional_coupling",
    says: "the two horizontal directions share one yield surface",
    refuted_by: "a motion along one direction changes nothing in the other when both move",
    like: &["friction", "axial_shear_interaction"],
    needs_clock: false,
    propose,
};

fn propose(s: &Sight<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for m in s.moved(false).into_iter().filter(|m| m.directions.len() == 2) {
        let k = m.stiffness();
        let line = format!(
            "{} -stiffness $hy_stiffness -strength $hy_strength -alpha $hy_alpha -eta $hy_eta {}",
            m.amend("coupling"),
            m.dir
        );
        let added = vec![
            Added::log("stiffness", k, 100.0 * k, 6.0 * k),
            Added::log("strength", 0.02 * m.q, m.q, 0.4 * m.q),
            Added::linear("alpha", 0.005, 0.6, 0.12),
            Added::linear("eta", 1.0, 4.0, 2.0),
        ];
        out.push(Proposal::edit("bidirectional_coupling", "coupled Bouc-Wen law", m.at(), vec![line], added));
    }
    out
}

//! Coulomb friction in parallel.

use super::{Added, Hypothesis, Proposal, Sight};

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "friction",
    says: "a Coulomb friction force acts in parallel (a slider, a guide, the rig)",
    refuted_by: "the loop of a tiny cycle is as thin as the material alone would have it",
    like: &["rate_dependence", "damping", "sensor_gain"],
    needs_clock: false,
    propose,
};

fn propose(s: &Sight<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for m in s.moved(false) {
        let k = m.stiffness();
        let line = format!("{} -force $hy_force -stiffness $hy_grip {}", m.amend("friction"), m.dir);
        let added =
            vec![Added::log("force", 1e-3 * m.q, 0.9 * m.q, 0.05 * m.q), Added::log("grip", k, 1e4 * k, 50.0 * k)];
        out.push(Proposal::edit("friction", "constant friction force", m.at(), vec![line], added));
    }
    out
}

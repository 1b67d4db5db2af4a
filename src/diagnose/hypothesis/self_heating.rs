//! Dissipated work warms the device.

use super::{Added, Hypothesis, Proposal, Sight};

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "self_heating",
    says: "dissipated work warms the device and softens it",
    refuted_by: "after a pause long enough to cool the first cycle is as soft as the last",
    like: &["cyclic_degradation", "mullins_softening"],
    needs_clock: true,
    propose,
};

/// Softening per degree: only the ratio to the heat capacity can be found without a thermometer.
const SOFTENING: f64 = 0.01;

fn propose(s: &Sight<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for m in s.moved(false) {
        // A rise by ten degrees over the longest run to start from.
        let c = m.work / 10.0;
        for (which, share, more) in Sight::shares(&m) {
            let line = format!(
                "{} -softening {SOFTENING} -capacity $hy_capacity -cooling $hy_cooling {}{share}",
                m.amend("heating"),
                m.dir
            );
            let mut added = vec![Added::log("capacity", 0.02 * c, 30.0 * c, c), Added::log("cooling", 1.0, 1e5, 100.0)];
            added.extend(more);
            out.push(Proposal::edit("self_heating", &format!("softening {which}"), m.at(), vec![line], added));
        }
    }
    out
}

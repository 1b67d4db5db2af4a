//! Strength is lost with accumulated damage.

use super::{Added, Hypothesis, Proposal, Sight, of_strength};

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "cyclic_degradation",
    says: "strength or stiffness is lost with accumulated damage",
    refuted_by: "after a rest, or at a small amplitude after a large one, the strength is back",
    like: &["self_heating", "mullins_softening"],
    needs_clock: false,
    propose,
};

fn propose(s: &Sight<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for m in s.moved(false) {
        for (which, share, more) in Sight::shares(&m).into_iter().chain([of_strength(&m)]) {
            let line = format!("{} -loss $hy_loss -energy $hy_energy {}{share}", m.amend("degradation"), m.dir);
            let mut added = vec![
                Added::linear("loss", -0.5, 0.95, 0.2),
                Added::log("energy", 0.01 * m.work, 10.0 * m.work, 0.4 * m.work),
            ];
            added.extend(more);
            out.push(Proposal::edit("cyclic_degradation", &format!("loss {which}"), m.at(), vec![line], added));
        }
    }
    out
}

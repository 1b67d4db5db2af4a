//! Virgin rubber is stiffer than scragged rubber.

use super::{Added, Hypothesis, Proposal, Sight};

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "mullins_softening",
    says: "virgin or recovered rubber is stiffer on its first way to a strain than on the next (Mullins, scragging)",
    refuted_by: "the second cycle at an amplitude that was never reached before is as stiff as the first",
    like: &["cyclic_degradation", "self_heating", "strain_stiffening"],
    propose,
};

fn propose(s: &Sight<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for m in s.moved(false) {
        for (which, share, more) in Sight::shares(&m) {
            let line =
                format!("{} -virgin $hy_virgin -power $hy_power -onset $hy_onset {}{share}", m.amend("mullins"), m.dir);
            let mut added = vec![
                Added::linear("virgin", -0.3, 1.5, 0.2),
                Added::linear("power", 0.2, 8.0, 2.0),
                Added::log("onset", 1e-3 * m.e, 3.0 * m.e, 0.1 * m.e),
            ];
            added.extend(more);
            out.push(Proposal::edit("mullins_softening", &format!("excess {which}"), m.at(), vec![line], added));
        }
    }
    out
}

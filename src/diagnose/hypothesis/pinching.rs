//! Slip thins the loops near zero.

use super::{Added, Hypothesis, Proposal, Sight};

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "pinching",
    says: "slip or crack closing thins the loops near zero",
    refuted_by: "the force at zero deformation is as large as that of a fresh device",
    like: &["cyclic_degradation", "mullins_softening"],
    propose,
};

fn propose(s: &Sight<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for m in s.moved(false) {
        for (which, share, more) in Sight::shares(&m) {
            let line =
                format!("{} -depth $hy_depth -width $hy_width -onset $hy_onset {}{share}", m.amend("pinching"), m.dir);
            let mut added = vec![
                Added::linear("depth", 0.0, 1.0, 0.3),
                Added::log("width", 0.05, 1.5, 0.3),
                Added::linear("onset", 0.0, 0.6 * m.e, 0.05 * m.e),
            ];
            added.extend(more);
            out.push(Proposal::edit("pinching", &format!("slack {which}"), m.at(), vec![line], added));
        }
    }
    out
}

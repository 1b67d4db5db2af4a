//! Slip thins the loops near zero.

use super::{Added, Hypothesis, Proposal, Sight};

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "pinching",
    says: "slip or crack closing thins the loops near zero",
    refuted_by: "the force at zero deformation is as large as that of a fresh device",
    like: &["cyclic_degradation", "mullins_softening"],
    needs_clock: false,
    propose,
};

fn propose(s: &Sight<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for m in s.moved(false) {
        let k = m.stiffness();
        for (form, option, most) in [
            ("slip where the hysteretic force passes zero", "size", m.e),
            ("slip that grows with the deformation", "growth", 1.0),
        ] {
            let size = if option == "size" { "-size $hy_size" } else { "-size 0.0 -growth $hy_growth" };
            let line = format!("{} {size} -width $hy_width -share $hy_k 0 {}", m.amend("slip"), m.dir);
            let added = vec![
                Added::linear(option, 0.0, 1.5 * most, 0.3 * most),
                Added::log("width", 0.02 * m.q, m.q, 0.2 * m.q),
                Added::linear("k", 0.0, 1.2 * k, 0.6 * k),
            ];
            out.push(Proposal::edit("pinching", form, m.at(), vec![line], added));
        }
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

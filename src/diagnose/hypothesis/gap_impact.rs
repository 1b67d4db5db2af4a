//! A gap closes.

use super::{Added, Hypothesis, Proposal, Sight};

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "gap_impact",
    says: "a gap closes: pounding, a moat wall, a stopper",
    refuted_by: "the deformation passes the gap without a peak of force or acceleration",
    like: &["strain_stiffening"],
    needs_clock: false,
    propose,
};

fn propose(s: &Sight<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for m in s.moved(false) {
        let k = m.stiffness();
        for (form, side) in
            [("walls on both sides", 0), ("wall on the positive side", 1), ("wall on the negative side", -1)]
        {
            for (law, power) in [("", 1.0), (", Hertz contact", 1.5)] {
                let line = format!(
                    "{} -at $hy_gap -stiffness $hy_wall -power {power} -damping $hy_damping -side {side} {}",
                    m.amend("gap"),
                    m.dir
                );
                // As stiff at a fifth of the deformation.
                let k = k * (0.2 * m.e).powf(1.0 - power);
                let added = vec![
                    Added::linear("gap", 0.05 * m.e, 1.1 * m.e, 0.7 * m.e),
                    Added::log("wall", 0.5 * k, 1e4 * k, 30.0 * k),
                    Added::log("damping", 1e-3 / m.v.max(1e-12), 3.0 / m.v.max(1e-12), 0.1 / m.v.max(1e-12)),
                ];
                let form = format!("{form}{law}");
                out.push(Proposal::edit("gap_impact", &form, m.at(), vec![line], added));
            }
        }
    }
    out
}

//! The backbone hardens at large strain.

use super::{Added, Hypothesis, Proposal, Sight};

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "strain_stiffening",
    says: "the backbone hardens at large strain",
    refuted_by: "the secant stiffness goes on falling beyond the largest strain tested",
    like: &["axial_shear_interaction", "gap_impact"],
    needs_clock: false,
    propose,
};

fn propose(s: &Sight<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    // Under ground motion a model without stiffening goes much further than what stiffens.
    let most = if s.anatomy.shaken { 20.0 } else { 3.0 };
    for m in s.moved_or_grounded() {
        let form = |form: &str, power: f64, from: &str, added: Vec<Added>| {
            let line = format!("{} -factor $hy_factor -power {power} -from {from} {}", m.amend("stiffening"), m.dir);
            Proposal::edit("strain_stiffening", form, m.at(), vec![line], added)
        };
        let at = |power: f64, size: f64| size * m.q / m.e.powf(power);
        out.push(form("cubic", 3.0, "0.0", vec![Added::linear("factor", at(3.0, -1.0), at(3.0, most), at(3.0, 0.1))]));
        let from = Added::linear("from", 0.0, 0.95 * m.e, 0.4 * m.e);
        let factor = Added::linear("factor", at(2.0, -1.0), at(2.0, 10.0 * most), at(2.0, 0.3));
        out.push(form("quadratic from an onset", 2.0, "$hy_from", vec![factor, from]));
    }
    out
}

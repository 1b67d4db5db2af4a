//! The axial load changes the lateral response.

use super::{Added, Hypothesis, Proposal, Sight};
use crate::inspect::conditions::axial_loads;

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "axial_shear_interaction",
    says: "the axial load takes lateral stiffness away (P-Delta, buckling)",
    refuted_by: "the lateral stiffness is the same at another axial load",
    like: &["strain_stiffening", "mullins_softening"],
    needs_clock: false,
    propose,
};

/// Compression of a group at rest, from the runs' own `axial` or from the model.
pub(super) fn load(s: &Sight<'_>, m: &super::Moved<'_>) -> Option<(f64, String)> {
    let carried = m.axial.and_then(|axial| s.scales.of(&m.group, axial)).map_or(0.0, |x| x.q);
    if carried > 0.0 {
        return Some((carried, m.axial_word()));
    }
    let most = axial_loads(s.study)?.into_iter().fold(0.0, f64::max);
    (most > 0.0).then(|| (most, " -load [expr {abs($axial)}]".into()))
}

fn propose(s: &Sight<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for m in s.moved(false) {
        let Some((p, option)) = load(s, &m) else { continue };
        for (which, share, more) in Sight::shares(&m) {
            let critical = || Added::log("critical", 0.5 * p, 20.0 * p, 2.0 * p);
            let line = format!("{} -critical $hy_critical{option} {}{share}", m.amend("axial"), m.dir);
            let mut added = vec![critical()];
            added.extend(more.clone());
            let form = format!("critical load, loss {which}");
            out.push(Proposal::edit("axial_shear_interaction", &form, m.at(), vec![line], added));
            let line = format!("{} -critical $hy_critical -width $hy_width{option} {}{share}", m.amend("axial"), m.dir);
            let mut added = vec![critical(), Added::log("width", 1.1 * m.e, 20.0 * m.e, 3.0 * m.e)];
            added.extend(more);
            let form = format!("critical load falling with the overlap, loss {which}");
            out.push(Proposal::edit("axial_shear_interaction", &form, m.at(), vec![line], added));
        }
    }
    out
}

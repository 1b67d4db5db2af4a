//! The axial load changes the lateral response.

use super::{Added, Hypothesis, Proposal, Sight};
use crate::diagnose::conditions::{axial_loads, axial_loads_differ};

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "axial_shear_interaction",
    says: "the axial load takes lateral stiffness away (P-Delta, buckling)",
    refuted_by: "the lateral stiffness is the same at another axial load",
    like: &["strain_stiffening", "mullins_softening"],
    needs_clock: false,
    propose,
};

pub(super) const VARYING: Hypothesis = Hypothesis {
    cause: "varying_axial_load",
    says: "the axial force changes during the run and changes the lateral response",
    refuted_by: "the lateral strength does not follow the axial force",
    like: &["axial_shear_interaction", "friction"],
    needs_clock: false,
    propose: propose_varying,
};

/// Compression of a group at rest, from the runs' own `axial` or from the model.
fn load(s: &Sight<'_>, m: &super::Moved<'_>) -> Option<(f64, String)> {
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

/// Part of itself that the axial force of the model has to vary by to be followed.
const VARIES: f64 = 0.05;

fn propose_varying(s: &Sight<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for m in s.moved(false) {
        let k = m.stiffness();
        let elastic = Added::linear("k", 0.0, 1.2 * k, 0.5 * k);
        let x = m.axial.and_then(|axial| s.scales.of(&m.group, axial)).filter(|x| x.q > 0.0);
        if let Some(x) = x.filter(|x| x.forces[1] - x.forces[0] > VARIES * x.q) {
            let line = format!(
                "{} -reference $hy_reference -power $hy_power -share $hy_k 0 {}{}",
                m.amend("pressure"),
                m.dir,
                m.axial_word()
            );
            let added = vec![
                Added::log("reference", 0.05 * x.q, 2.0 * x.q, 0.6 * x.q),
                Added::linear("power", 0.1, 2.0, 1.0),
                elastic,
            ];
            let form = "strength follows the axial force";
            out.push(Proposal::edit("varying_axial_load", form, m.at(), vec![line], added));
        } else if let (Some((p, option)), [_]) = (load(s, &m), &m.directions[..])
            && (x.is_some() || !axial_loads_differ(s.study))
        {
            // The model holds it constant in all runs, or does not have it: what comes of the lateral motion itself.
            let line =
                format!("{} -reference {p:.6e} -lever $hy_lever{option} -share $hy_k 0 {}", m.amend("pressure"), m.dir);
            let most = 1.5 * p / m.e;
            let recorded = m.axial_over(s).map(|slope| (slope * p).clamp(-most, most));
            let added = vec![Added::linear("lever", -most, most, recorded.unwrap_or(0.2 * most)), elastic];
            let form = "strength follows an axial force that overturning changes";
            let form = Proposal::edit("varying_axial_load", form, m.at(), vec![line], added);
            out.push(Proposal { exact: true, ..form });
        }
    }
    out
}

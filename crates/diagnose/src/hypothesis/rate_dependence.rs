//! The force depends on the rate of strain.

use super::{Added, Hypothesis, Proposal, Sight};

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "rate_dependence",
    says: "the force depends on how fast the device is strained: a viscous overstress",
    refuted_by: "the same motion at a tenth of the speed gives the same force",
    like: &["friction", "damping", "mullins_softening"],
    needs_clock: true,
    propose,
};

fn propose(s: &Sight<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    // A dashpot beside what was taken as elastic is damping of the structure.
    let of_elastic = s.anatomy.shaken && s.moved(false).is_empty();
    for m in s.moved_or_grounded() {
        let (at, dir, k) = (m.at(), &m.dir, m.stiffness());
        let over = |form: &str, power: &str, more: Vec<Added>| {
            let line = format!(
                "{} overstress -force $hy_force -speed {:.6e} -power {power} -stiffness $hy_spring {dir}",
                m.amend(""),
                m.v
            );
            let mut added = vec![
                Added::log("force", 1e-3 * m.q, 3.0 * m.q, 0.1 * m.q),
                Added::log("spring", 0.05 * k, 100.0 * k, 3.0 * k),
            ];
            added.extend(more);
            Proposal::edit("rate_dependence", form, at.clone(), vec![line], added)
        };
        out.push(over("linear overstress (Maxwell)", "1.0", vec![]));
        out.push(over("power-law overstress", "$hy_power", vec![Added::linear("power", 0.08, 1.0, 0.3)]));
        let relaxing = |form: &str, more: &str| {
            let line = format!("{} -strength $hy_strength -time $hy_time{more} {dir}", m.amend("relaxation"));
            // From what relaxes between two samples to what hardly does during the longest run.
            let (step, longest) = (s.sampling(), s.longest());
            let added = vec![
                Added::log("strength", 0.01, 20.0, 0.3),
                Added::log("time", step, longest, (step * longest).sqrt()),
            ];
            Proposal::edit("rate_dependence", form, at.clone(), vec![line], added)
        };
        out.push(relaxing("quasi-linear overstress, one relaxation time", ""));
        out.push(relaxing("quasi-linear overstress, relaxation times over three decades", " -decades 3"));
        if !of_elastic {
            let (line, force) = m.dashpot(&m.amend("damping"), "$hy_power");
            let added = vec![force, Added::linear("power", 0.1, 1.2, 1.0)];
            out.push(Proposal::edit("rate_dependence", "dashpot", at.clone(), vec![line], added));
        }
    }
    out
}

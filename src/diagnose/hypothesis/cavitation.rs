//! Tension beyond the cavitation strength.

use super::{Added, Hypothesis, Proposal, Sight};

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "cavitation",
    says: "the rubber cavitates in tension and is damaged by it",
    refuted_by: "the second pull is as strong as the first",
    like: &[],
    propose,
};

fn propose(s: &Sight<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for group in s.anatomy.devices.iter().map(|d| vec![d]) {
        let Some(x) = s.scales.of(&group, 1) else { continue };
        let axial = group[0].directions.iter().find(|d| d.number == 1);
        // There must be tension, in a direction that carries compression as well.
        let (Some(axial), true) = (axial, x.range[1] > 0.0 && group[0].directions.len() > 1 || x.range[1] > 0.2 * x.e)
        else {
            continue;
        };
        let pull = axial.stiffness * x.range[1];
        let line = format!(
            "amend element {} cavitation -strength $hy_strength -extension [expr {{$hy_strength/{:.6e}}}] -damage $hy_damage -dir 1",
            group[0].tag, axial.stiffness
        );
        let added =
            vec![Added::log("strength", 0.02 * pull, 1.0 * pull, 0.4 * pull), Added::linear("damage", 0.0, 0.95, 0.5)];
        out.push(Proposal::edit("cavitation", "limit of tension", super::named(&group), vec![line], added));
    }
    out
}

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
        // The axis of a bearing; of a spring with one direction nobody knows what it stands for, nor which way it pulls.
        let alone = group[0].directions.len() == 1;
        let Some(axis) = group[0].directions.iter().find(|d| alone || d.number == 1) else { continue };
        let Some(x) = s.scales.of(&group, axis.number) else { continue };
        for sign in if alone { &[1.0, -1.0][..] } else { &[1.0][..] } {
            let extension = if *sign > 0.0 { x.range[1] } else { -x.range[0] };
            if extension <= 0.05 * x.e {
                continue;
            }
            let pull = axis.stiffness * extension;
            let mut form = |form: &str, rise: &str, more: Vec<Added>| {
                let line = format!(
                    "amend element {} cavitation -strength $hy_strength -extension [expr {{$hy_strength/{:.6e}}}] \
                     -damage $hy_damage{rise} -sign {sign} -dir {}",
                    group[0].tag, axis.stiffness, axis.number
                );
                let mut added = vec![
                    Added::log("strength", 0.02 * pull, pull, 0.4 * pull),
                    Added::linear("damage", 0.0, 0.99, 0.5),
                ];
                added.extend(more);
                let at = super::named(&group);
                out.push(Proposal::edit("cavitation", form, at, vec![line], added));
            };
            form("limit of tension", "", vec![]);
            let reach = Added::log("reach", 0.02 * extension, 5.0 * extension, 0.5 * extension);
            let more = vec![Added::linear("rise", 0.0, 3.0, 0.3), reach];
            form("limit of tension that rises", " -rise $hy_rise -reach $hy_reach", more);
        }
    }
    out
}

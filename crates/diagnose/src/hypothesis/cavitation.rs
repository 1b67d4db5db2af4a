//! Tension beyond the cavitation strength.

use super::{Added, Hypothesis, Proposal, Sight};

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "cavitation",
    says: "the rubber cavitates in tension and is damaged by it",
    refuted_by: "the second pull is as strong as the first",
    like: &[],
    needs_clock: false,
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
            let k = axis.stiffness;
            let mut form = |form: &str, k_of: &str, rise: &str, more: &[Added]| {
                let line = format!(
                    "amend element {} cavitation -strength $hy_strength -extension [expr {{$hy_strength/{k_of}}}] \
                     -damage $hy_damage{rise} -sign {sign} -dir {}",
                    group[0].tag, axis.number
                );
                let mut added = vec![
                    Added::log("strength", 0.02 * pull, pull, 0.4 * pull),
                    Added::linear("damage", 0.0, 0.99, 0.5),
                ];
                added.extend_from_slice(more);
                let at = super::named(&group);
                out.push(Proposal::edit("cavitation", form, at, vec![line], added));
            };
            let own = format!("{k:.6e}");
            form("limit of tension", &own, "", &[]);
            let rise = || Added::linear("rise", 0.0, 3.0, 0.3);
            let reach = || Added::log("reach", 0.02 * extension, 5.0 * extension, 0.5 * extension);
            form("limit of tension that rises", &own, " -rise $hy_rise -reach $hy_reach", &[rise(), reach()]);
            // A dashpot beside the rubber goes on in tension.
            let part = Added::linear("k", 0.5 * k, 1.5 * k, k);
            let line = " -rise $hy_rise -reach $hy_reach -share $hy_k 0";
            form("limit of the elastic tension", "$hy_k", line, &[rise(), reach(), part]);
        }
    }
    out
}

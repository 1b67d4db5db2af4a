//! Cavitation of rubber in tension.

use super::{AddedParameter, Hypothesis, Proposal, ProposalContext};

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "cavitation",
    statement: "the rubber cavitates in tension and is damaged by it",
    refuted_by: "the second pull is as strong as the first",
    look_alikes: &[],
    needs_clock: false,
    propose,
};

fn propose(s: &ProposalContext<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for group in s.inventory.devices.iter().map(|d| vec![d]) {
        // The axis of a bearing, or the single direction of a spring, whose sense of tension is not known.
        let single = group[0].directions.len() == 1;
        let Some(axis) = group[0].directions.iter().find(|d| single || d.number == 1) else { continue };
        let Some(x) = s.responses.of(&group, axis.number) else { continue };
        for sign in if single { &[1.0, -1.0][..] } else { &[1.0][..] } {
            let extension = if *sign > 0.0 { x.deformation_bounds[1] } else { -x.deformation_bounds[0] };
            if extension <= 0.05 * x.deformation {
                continue;
            }
            let force = axis.stiffness * extension;
            let k = axis.stiffness;
            let mut form = |form: &str, tension_stiffness: &str, rise: &str, more: &[AddedParameter]| {
                let line = format!(
                    "amend element {} cavitation -strength $hy_strength -extension [expr {{$hy_strength/{tension_stiffness}}}] \
                     -damage $hy_damage{rise} -sign {sign} -dir {}",
                    group[0].tag, axis.number
                );
                let mut added = vec![
                    AddedParameter::log("strength", 0.02 * force, force, 0.4 * force),
                    AddedParameter::linear("damage", 0.0, 0.99, 0.5),
                ];
                added.extend_from_slice(more);
                let at = super::element_names(&group);
                out.push(Proposal::script_edit("cavitation", form, at, vec![line], added));
            };
            let own = format!("{k:.6e}");
            form("limit of tension", &own, "", &[]);
            let rise = || AddedParameter::linear("rise", 0.0, 3.0, 0.3);
            let reach = || AddedParameter::log("reach", 0.02 * extension, 5.0 * extension, 0.5 * extension);
            form("limit of tension that rises", &own, " -rise $hy_rise -reach $hy_reach", &[rise(), reach()]);
            // A dashpot beside the rubber keeps its force in tension.
            let part = AddedParameter::linear("k", 0.5 * k, 1.5 * k, k);
            let line = " -rise $hy_rise -reach $hy_reach -share $hy_k 0";
            form("limit of the elastic tension", "$hy_k", line, &[rise(), reach(), part]);
        }
    }
    out
}

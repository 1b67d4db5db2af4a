//! Loss of strength or stiffness with accumulated damage.

use super::context::{force_parts, strength_part};
use super::{AddedParameter, Hypothesis, Proposal, ProposalContext};
use crate::memory::family::Family;

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "cyclic_degradation",
    statement: "strength or stiffness is lost with accumulated damage",
    refuted_by: "after a rest, or at a small amplitude after a large one, the strength is back",
    look_alikes: &["self_heating", "mullins_softening"],
    needs_clock: false,
    is_missing_part: false,
    memory: &[Family::Work],
    propose,
};

fn propose(s: &ProposalContext<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for m in s.moving_groups(false) {
        for (part_name, share, further) in force_parts(&m).into_iter().chain([strength_part(&m)]) {
            let line = format!("{} -loss $hy_loss -energy $hy_energy {}{share}", m.amend("degradation"), m.dir_option);
            let mut added = vec![
                AddedParameter::linear("loss", -0.5, 0.95, 0.2),
                AddedParameter::log("energy", 0.01 * m.work, 10.0 * m.work, 0.4 * m.work),
            ];
            added.extend(further);
            out.push(Proposal::script_edit(
                "cyclic_degradation",
                &format!("loss {part_name}"),
                m.location(),
                vec![line],
                added,
            ));
        }
    }
    out
}

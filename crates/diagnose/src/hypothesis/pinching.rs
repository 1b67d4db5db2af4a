//! Pinching: slip thins the loops near zero.

use super::context::force_parts;
use super::{AddedParameter, Hypothesis, Proposal, ProposalContext};
use crate::memory::family::Family;

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "pinching",
    statement: "slip or crack closing thins the loops near zero",
    refuted_by: "the force at zero deformation is as large as that of a fresh device",
    look_alikes: &["cyclic_degradation", "mullins_softening"],
    needs_clock: false,
    is_missing_part: false,
    memory: &[Family::Pinching, Family::Largest],
    propose,
};

fn propose(s: &ProposalContext<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for m in s.moving_groups(false) {
        let k = m.stiffness();
        for (form, option, most) in [
            ("slip where the hysteretic force passes zero", "size", m.deformation),
            ("slip that grows with the deformation", "growth", 1.0),
        ] {
            let size = if option == "size" { "-size $hy_size" } else { "-size 0.0 -growth $hy_growth" };
            let line = format!("{} {size} -width $hy_width -share $hy_k 0 {}", m.amend("slip"), m.dir_option);
            let added = vec![
                AddedParameter::linear(option, 0.0, 1.5 * most, 0.3 * most),
                AddedParameter::log("width", 0.02 * m.force, m.force, 0.2 * m.force),
                AddedParameter::linear("k", 0.0, 1.2 * k, 0.6 * k),
            ];
            out.push(Proposal::script_edit("pinching", form, m.location(), vec![line], added));
        }
        for (part_name, share, further) in force_parts(&m) {
            let line = format!(
                "{} -depth $hy_depth -width $hy_width -onset $hy_onset {}{share}",
                m.amend("pinching"),
                m.dir_option
            );
            let mut added = vec![
                AddedParameter::linear("depth", 0.0, 1.0, 0.3),
                AddedParameter::log("width", 0.05, 1.5, 0.3),
                AddedParameter::linear("onset", 0.0, 0.6 * m.deformation, 0.05 * m.deformation),
            ];
            added.extend(further);
            out.push(Proposal::script_edit("pinching", &format!("slack {part_name}"), m.location(), vec![line], added));
        }
    }
    out
}

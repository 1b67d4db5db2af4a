//! Loss of strength or stiffness with accumulated damage.

use super::context::{force_parts, strength_part};
use super::declaration::{Dimension, Measurement, Quantity};
use super::{AddedParameter, Hypothesis, Proposal, ProposalContext};
use crate::memory::family::Family;

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "cyclic_degradation",
    statement: "strength or stiffness is lost with accumulated damage",
    refuted_by: "after a rest, or at a small amplitude after a large one, the strength is back",
    look_alikes: &["self_heating", "mullins_softening"],
    shows: "peaks that fall with the number and size of the cycles, and stay low",
    parted_by: "after a rest the strength is still missing",
    place: "nonlinear groups",
    forms: "`degradation`, as a factor or of the strength",
    needs_clock: false,
    memory: &[Family::Work],
    materials: &[],
    measurement: Measurement::new(
        "inspect {place} for damage, and compare a small earthquake before the strong one with one after it",
        "drive small cycles before and after the strong ones: {place} must stay weaker after them",
    ),
    quantities: &[
        Quantity::new("loss", "largest loss", Dimension::Ratio),
        Quantity::new("damageDuctility", "damage by ductility", Dimension::Ratio),
        Quantity::new("damageEnergy", "damage by energy", Dimension::Ratio),
        Quantity::new("energy", "work that causes it", Dimension::Energy),
        Quantity::new("deltaA", "loss of the hysteretic force per energy", Dimension::Unnamed),
        Quantity::new("deltaNu", "loss of strength per energy", Dimension::Unnamed),
        Quantity::new("deltaEta", "loss of stiffness per energy", Dimension::Unnamed),
    ],
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

//! One yield surface for both horizontal directions.

use super::declaration::{Dimension, Measurement, Quantity, Recordable};
use super::{AddedParameter, Hypothesis, Proposal, ProposalContext};

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "bidirectional_coupling",
    statement: "the two horizontal directions share one yield surface",
    refuted_by: "a motion along one direction changes nothing in the other when both move",
    look_alikes: &["friction", "axial_shear_interaction"],
    shows: "less force in a direction while the other one moves; rounded corners of loops in orbits",
    parted_by: "motions along one direction show nothing",
    place: "nonlinear groups that move in two directions",
    forms: "`coupling`",
    needs_clock: false,
    memory: &[],
    materials: &[],
    measurement: Measurement::new(
        "record both horizontal displacements across {place}",
        "drive one direction alone: its loops must be larger than in a motion of both",
    )
    .unless_at_building(Recordable::BothHorizontal),
    quantities: &[
        Quantity::new("stiffness", "initial stiffness", Dimension::Stiffness),
        Quantity::new("strength", "strength", Dimension::Force),
        Quantity::new("alpha", "hardening ratio", Dimension::Ratio),
        Quantity::new("eta", "exponent of the transition", Dimension::Ratio),
    ],
    propose,
};

fn propose(s: &ProposalContext<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for m in s.moving_groups(false).into_iter().filter(|m| m.directions.len() == 2) {
        let k = m.stiffness();
        let line = format!(
            "{} -stiffness $hy_stiffness -strength $hy_strength -alpha $hy_alpha -eta $hy_eta {}",
            m.amend("coupling"),
            m.dir_option
        );
        let added = vec![
            AddedParameter::log("stiffness", k, 100.0 * k, 6.0 * k),
            AddedParameter::log("strength", 0.02 * m.force, m.force, 0.4 * m.force),
            AddedParameter::linear("alpha", 0.005, 0.6, 0.12),
            AddedParameter::linear("eta", 1.0, 4.0, 2.0),
        ];
        out.push(Proposal::script_edit(
            "bidirectional_coupling",
            "coupled Bouc-Wen law",
            m.location(),
            vec![line],
            added,
        ));
    }
    out
}

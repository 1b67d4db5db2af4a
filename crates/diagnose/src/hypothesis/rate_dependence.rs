//! Dependence of the force on the rate of strain.

use super::declaration::{Dimension, Measurement, Quantity};
use super::{AddedParameter, Hypothesis, Proposal, ProposalContext};
use crate::memory::family::Family;

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "rate_dependence",
    statement: "the force depends on how fast the device is strained: a viscous overstress",
    refuted_by: "the same motion at a tenth of the speed gives the same force",
    look_alikes: &["friction", "damping", "mullins_softening"],
    shows: "more force in fast parts than in slow ones; a drop at rest; creep under a held force",
    parted_by: "`friction` does not grow with speed, and `mullins_softening` does not come back in the next fast cycle",
    place: "nonlinear groups, and linear ones on the ground; needs a clock",
    forms: "`overstress`, linear and of a power; `relaxation` with one time; `relaxation` and `creep` over three decades; `damping` of a power",
    needs_clock: true,
    memory: &[Family::Rate],
    materials: &[],
    measurement: Measurement::new(
        "test a device like {place} in a rig at two speeds: the faster loop must be the larger one",
        "repeat a run at a tenth of its speed: the force must fall",
    ),
    quantities: &[
        Quantity::new("force", "viscous force at the largest speed", Dimension::Force),
        Quantity::new("spring", "stiffness in series", Dimension::Stiffness),
        Quantity::new("strength", "strength of the relaxation", Dimension::Ratio),
        Quantity::new("time", "relaxation time", Dimension::Time),
        Quantity::new("creep", "deformation that creep adds under the largest force", Dimension::Length),
        Quantity::new("friction", "factor on the friction of the compound", Dimension::Ratio),
        Quantity::new("overstress", "factor on the overstress of the compound", Dimension::Ratio),
        Quantity::new("stiffening", "factor on the stiffening of the compound", Dimension::Ratio),
        Quantity::new("slow", "friction at rest over that at speed", Dimension::Ratio),
        Quantity::new("rate", "rate of the friction", Dimension::Unnamed),
    ],
    propose,
};

fn propose(s: &ProposalContext<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    // A dashpot beside an elastic device is damping of the structure.
    let of_elastic = s.inventory.base_excited && s.moving_groups(false).is_empty();
    for m in s.moving_or_supported_groups() {
        let (location, dir, k) = (m.location(), &m.dir_option, m.stiffness());
        let overstress = |form: &str, power: &str, more: Vec<AddedParameter>| {
            let line = format!(
                "{} overstress -force $hy_force -speed {:.6e} -power {power} -stiffness $hy_spring {dir}",
                m.amend(""),
                m.speed
            );
            let mut added = vec![
                AddedParameter::log("force", 1e-3 * m.force, 3.0 * m.force, 0.1 * m.force),
                AddedParameter::log("spring", 0.05 * k, 100.0 * k, 3.0 * k),
            ];
            added.extend(more);
            Proposal::script_edit("rate_dependence", form, location.clone(), vec![line], added)
        };
        out.push(overstress("linear overstress (Maxwell)", "1.0", vec![]));
        out.push(overstress(
            "power-law overstress",
            "$hy_power",
            vec![AddedParameter::linear("power", 0.08, 1.0, 0.3)],
        ));
        // Times from a sampling interval to the longest run.
        let (step, longest) = (s.sampling_interval(), s.longest_run());
        let time = AddedParameter::log("time", step, longest, (step * longest).sqrt());
        let relaxation = |form: &str, more: &str| {
            let line = format!("{} -strength $hy_strength -time $hy_time{more} {dir}", m.amend("relaxation"));
            let added = vec![AddedParameter::log("strength", 0.01, 20.0, 0.3), time.clone()];
            Proposal::script_edit("rate_dependence", form, location.clone(), vec![line], added)
        };
        out.push(relaxation("quasi-linear overstress, one relaxation time", ""));
        out.push(relaxation("quasi-linear overstress, relaxation times over three decades", " -decades 3"));
        if !of_elastic {
            // Beside an elastic device creep is an overstress of another stiffness.
            let compliance = format!("[expr {{$hy_creep/{:.6e}}}]", m.force);
            let line = format!("{} -compliance {compliance} -time $hy_time -decades 3 {dir}", m.amend("creep"));
            let added = vec![
                AddedParameter::log("creep", 1e-3 * m.deformation, 3.0 * m.deformation, 0.1 * m.deformation),
                time,
            ];
            let form = "creep in series, retardation times over three decades";
            out.push(Proposal::script_edit("rate_dependence", form, location.clone(), vec![line], added));
            let (line, force) = m.dashpot(&m.amend("damping"), "$hy_power");
            let added = vec![force, AddedParameter::linear("power", 0.1, 1.2, 1.0)];
            out.push(Proposal::script_edit("rate_dependence", "dashpot", location.clone(), vec![line], added));
        }
    }
    out
}

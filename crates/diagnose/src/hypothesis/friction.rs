//! Coulomb friction in parallel with a device.

use super::declaration::{Dimension, Measurement, Quantity, Recordable};
use super::{AddedParameter, Hypothesis, MovingGroup, Proposal, ProposalContext};
use crate::memory::family::Family;

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "friction",
    statement: "a Coulomb friction force acts in parallel (a slider, a guide, the rig)",
    refuted_by: "the loop of a tiny cycle is as thin as the material alone would have it",
    look_alikes: &["rate_dependence", "damping", "sensor_gain"],
    shows: "a force that jumps when the velocity changes its sign, in small cycles as in large ones; of a face that sticks a peak at each start",
    parted_by: "`rate_dependence` fades in slow cycles, `sensor_gain` scales the whole loop",
    place: "nonlinear groups, and linear ones on the ground",
    forms: "`friction`; `bristles`; with a clock also `bristles` that fall with speed, such that stick after rest, and `sliding`",
    needs_clock: false,
    memory: &[Family::Shape, Family::Rate],
    materials: &[],
    measurement: Measurement::new(
        "record the displacement across {place} in small earthquakes: it must stick at each reversal",
        "drive a tiny, slow cycle: the loop must be as high as twice the friction force",
    )
    .unless_at_building(Recordable::Deformation),
    quantities: &[
        Quantity::new("force", "friction force", Dimension::Force),
        Quantity::new("way", "elastic slip", Dimension::Length),
        Quantity::new("breakaway", "breakaway force", Dimension::Force),
        Quantity::new("speed", "speed of the transition", Dimension::Speed),
        Quantity::new("slip", "slip that ends the breakaway", Dimension::Length),
        Quantity::new("rest", "time at rest that brings it back", Dimension::Time),
    ],
    propose,
};

/// Deformation of the bristles over the slip that ends the breakaway. A choice: little, so that the face sticks.
const SLIP_WHERE_BENT: f64 = 0.1;

/// Parameters of a breakaway force that comes back at rest. Rests are from a sampling interval to the longest run.
fn sticking(s: &ProposalContext<'_>, m: &MovingGroup<'_>) -> Vec<AddedParameter> {
    let (step, longest) = (s.sampling_interval(), s.longest_run());
    vec![
        AddedParameter::log("breakaway", 0.01 * m.force, 2.0 * m.force, 0.3 * m.force),
        AddedParameter::log("slip", 1e-3 * m.deformation, m.deformation, 0.1 * m.deformation),
        AddedParameter::log("rest", step, longest, (step * longest).sqrt()),
    ]
}

fn propose(s: &ProposalContext<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for m in s.moving_or_supported_groups() {
        let force = || AddedParameter::log("force", 1e-3 * m.force, 0.9 * m.force, 0.05 * m.force);
        // A larger deformation before slip is that of a hysteretic spring.
        let elastic_slip =
            || AddedParameter::log("way", 1e-4 * m.deformation, 0.05 * m.deformation, 0.01 * m.deformation);
        let mut form = |form: &str, law: &str, added: Vec<AddedParameter>| {
            out.push(Proposal::script_edit(
                "friction",
                form,
                m.location(),
                vec![format!("{law} {}", m.dir_option)],
                added,
            ));
        };
        let slips = |kind: &str| format!("{} -force $hy_force -stiffness [expr $hy_force/$hy_way]", m.amend(kind));
        form("constant friction force", &slips("friction"), vec![force(), elastic_slip()]);
        form("friction force of bristles", &slips("bristles"), vec![force(), elastic_slip()]);
        if s.has_clock {
            let breakaway = || AddedParameter::log("breakaway", 1e-3 * m.force, 0.9 * m.force, 0.05 * m.force);
            let speed = AddedParameter::log("speed", 1e-3 * m.speed, m.speed, 0.1 * m.speed);
            let law = format!("{} -breakaway $hy_breakaway -speed $hy_speed", slips("bristles"));
            form("friction force that falls with speed", &law, vec![force(), elastic_slip(), breakaway(), speed]);
            let law = format!("{} -force $hy_force -speed $hy_speed", m.amend("sliding"));
            let speed = AddedParameter::log("speed", 1e-4 * m.speed, 0.1 * m.speed, 0.01 * m.speed);
            form("friction force smoothed over speed", &law, vec![force(), speed]);
            for (what, constant, more) in [
                ("breakaway force after rest", "0.0", vec![]),
                ("friction force that grows at rest", "$hy_force", vec![force()]),
            ] {
                let law = format!(
                    "{} -force {constant} -stiffness [expr {{({constant}+$hy_breakaway)/({SLIP_WHERE_BENT}*$hy_slip)}}] \
                     -breakaway $hy_breakaway -slip $hy_slip -rest $hy_rest",
                    m.amend("bristles")
                );
                form(what, &law, [sticking(s, &m), more].concat());
            }
        }
    }
    out
}

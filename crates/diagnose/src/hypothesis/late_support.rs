//! Supports that the motion of the ground reaches later or earlier than the others.

use super::declaration::{Dimension, Measurement, Quantity, Recordable};
use super::support_springs::{MAX_JOINT_SUPPORTS, MAX_SINGLE_SUPPORTS, carrying_supports, horizontal_dofs};
use super::{AddedParameter, Hypothesis, Proposal, ProposalContext};
use crate::inspect::inventory::Support;

/// Name of the cause.
const CAUSE: &str = "late_support";

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: CAUSE,
    statement: "the ground motion reaches a support later or earlier than the others",
    refuted_by: "instruments on the ground at all supports show one motion at one time",
    look_alikes: &["foundation_flexibility", "sensor_lag"],
    shows: "forces between supports while the structure as a whole hardly moves, most in rapid parts of the motion",
    parted_by: "a channel that is late keeps its form; soil below a support makes the period longer",
    place: "supports of a shaken model that stand apart and carry elements: 6 alone, and all in the order of their places",
    forms: "a delay of one support; a delay in proportion to the distance along an axis, as of a wave that passes",
    needs_clock: false,
    memory: &[],
    materials: &[],
    measurement: Measurement::new(
        "put an accelerometer on the ground at {place}, with the clock of the others",
        "record the motion of the table below {place}",
    )
    .unless_at_building(Recordable::Acceleration)
    .unless_in_rig(Recordable::Acceleration),
    quantities: &[
        Quantity::new("delay", "delay of the ground motion", Dimension::Time),
        Quantity::new("slowness", "delay per length along the axis", Dimension::Unnamed),
    ],
    propose,
};

/// Largest delay, s, and starts. Apparent velocities of waves are 0.3 to 5 km/s (Der Kiureghian 1996, A coherency model for
/// spatially varying ground motions), and bridges some hundred metres long.
const MAX_DELAY: f64 = 0.5;
const DELAY_STARTS: [f64; 7] = [-0.2, -0.1, -0.04, 0.02, 0.08, 0.15, 0.3];
/// Distance of supports that stand apart, in parts of the extent of the model. A choice.
const APART: f64 = 0.1;

fn propose(s: &ProposalContext<'_>) -> Vec<Proposal> {
    if !s.inventory.uniformly_excited || s.inventory.ndm < 2 {
        return vec![];
    }
    let supports: Vec<&Support> =
        carrying_supports(s).into_iter().filter(|p| !horizontal_dofs(&[p], s.inventory.ndm).is_empty()).collect();
    let along = |p: &Support, axis: usize| s.inventory.coordinates.get(&p.node).map_or(0.0, |x| x[axis]);
    // Heights do not part supports. In a plan without heights both axes do.
    let vertical = s.inventory.vertical_axis();
    let spread = |axis: usize| {
        let at = supports.iter().map(|p| along(p, axis));
        let [low, high] = at.fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], x| [l.min(x), h.max(x)]);
        (low, high - low)
    };
    let apart = |axis: &usize| Some(*axis) != vertical && spread(*axis).1 > APART * s.inventory.extent;
    let axes: Vec<usize> = (0..s.inventory.ndm).filter(apart).collect();
    if axes.is_empty() || supports.len() > MAX_JOINT_SUPPORTS {
        return vec![];
    }
    let mut out: Vec<Proposal> = supports.iter().take(MAX_SINGLE_SUPPORTS).map(|p| delayed(p)).collect();
    if supports.len() > 2 {
        out.extend(axes.iter().map(|axis| passing_wave(&supports, *axis, spread(*axis), &along)));
    }
    out
}

/// A support with a delay.
fn delayed(support: &Support) -> Proposal {
    let block = vec![format!("amend node {} late -by $hy_delay", support.node)];
    let delay = AddedParameter::linear("delay", -MAX_DELAY, MAX_DELAY, DELAY_STARTS[3] * 2.0);
    let added = vec![AddedParameter { further_starts: DELAY_STARTS.into(), ..delay }];
    Proposal::script_edit(CAUSE, "delay of a support", format!("node {}", support.node), block, added)
}

/// Supports with delays in proportion to their distance from the first along an axis.
fn passing_wave(
    supports: &[&Support],
    axis: usize,
    (first, length): (f64, f64),
    along: &impl Fn(&Support, usize) -> f64,
) -> Proposal {
    let late = |p: &&&Support| along(p, axis) > first;
    let command = |p: &&Support| {
        let distance = along(p, axis) - first;
        format!("amend node {} late -by [expr {{$hy_slowness*{distance:e}}}]", p.node)
    };
    let block = supports.iter().filter(late).map(command).collect();
    let most = MAX_DELAY / length;
    let slowness = AddedParameter::linear("slowness", -most, most, 0.1 * most);
    let starts = DELAY_STARTS.map(|delay| delay / length).into();
    let nodes: Vec<String> = supports.iter().map(|p| p.node.to_string()).collect();
    Proposal::script_edit(
        CAUSE,
        &format!("wave that passes along axis {}", axis + 1),
        format!("node {}", nodes.join(" ")),
        block,
        vec![AddedParameter { further_starts: starts, ..slowness }],
    )
}

#[cfg(test)]
mod tests {
    use super::propose;
    use crate::inspect::response::ResponseRanges;
    use crate::test_support::{inventory_under, pad_study, proposal_context};

    /// Piers that stand apart are late alone or one after the other; a structure on one support is not.
    #[test]
    fn supports_that_stand_apart_are_late() {
        let places = |piers: &str, pattern: &str| -> Vec<(String, String)> {
            let text = format!(
                "model basic -ndm 2 -ndf 3
                geomTransf Linear 1
                set before 0
                foreach n {{{piers}}} {{
                    node $n [expr {{10.*$n}}] 0.; fix $n 1 1 1
                    node 1$n [expr {{10.*$n}}] 5. -mass 1. 1. 0.
                    element elasticBeamColumn $n $n 1$n 1. 1e3 1. 1
                    if {{$before}} {{element elasticBeamColumn 2$n $before 1$n 1. 1e3 1. 1}}
                    set before 1$n
                }}"
            );
            let (inventory, study, responses) =
                (inventory_under(&text, pattern), pad_study(), ResponseRanges::default());
            let proposals = propose(&proposal_context(&inventory, &study, &responses));
            proposals.into_iter().map(|p| (p.location, p.commands.join("; "))).collect()
        };
        let shaken = "UniformExcitation 2 1 -accel 2";
        let late = |n: u32| (format!("node {n}"), format!("amend node {n} late -by $hy_delay"));
        let wave = "amend node 2 late -by [expr {$hy_slowness*1e1}]; amend node 3 late -by [expr {$hy_slowness*2e1}]";
        assert_eq!(places("1 2 3", shaken), [late(1), late(2), late(3), ("node 1 2 3".to_owned(), wave.to_owned())]);
        assert_eq!(places("1 2", shaken), [late(1), late(2)]);
        assert!(places("1", shaken).is_empty());
        assert!(places("1 2 3", "Plain 2 2 {load 11 1. 0. 0.}").is_empty());
    }
}

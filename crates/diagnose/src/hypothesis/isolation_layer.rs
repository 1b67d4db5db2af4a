//! An isolation layer that the model leaves out: friction pendulums or rubber bearings below a structure on a fixed base.

use super::declaration::{Dimension, Measurement, Quantity, Recordable};
use super::support_springs::{FreedSupports, MAX_JOINT_SUPPORTS, SupportSpring, carrying_supports, horizontal_dofs};
use super::{AddedParameter, Hypothesis, Proposal, ProposalContext};
use crate::inspect::dominant_period::dominant_period;
use crate::inspect::inventory::{Support, TagPurpose, grouped};
use std::f64::consts::TAU;

/// Name of the cause.
pub(crate) const CAUSE: &str = "isolation_layer";

/// End of the range of a parameter at which a layer isolates nothing.
pub(crate) struct LayerLimit {
    /// Name without its prefix.
    pub(crate) parameter: &'static str,
    /// True for the upper end.
    pub(crate) is_upper: bool,
    /// The finding, in words.
    pub(crate) finding: &'static str,
}

/// All of them.
pub(crate) const LIMITS: &[LayerLimit] = &[
    LayerLimit {
        parameter: "period",
        is_upper: false,
        finding: "the layer has hardly twice the period of the structure above",
    },
    LayerLimit { parameter: "yield", is_upper: true, finding: "the layer hardly yields" },
];

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: CAUSE,
    statement: "the structure stands on an isolation layer that the model leaves out: sliding or rubber bearings and the mass of their slab",
    refuted_by: "the base of the structure moves with the ground, and its period does not grow with the amplitude",
    look_alikes: &["foundation_flexibility", "superstructure_yielding"],
    shows: "drifts that hardly grow with the strength of the motion, and swing at a period of seconds that the model lacks",
    parted_by: "`foundation_flexibility` has one period at all amplitudes; `superstructure_yielding` has one storey with the largest drift",
    place: "supports of a shaken model that carry linear devices or beams: all with the same fixities together, up to 20",
    forms: "a bilinear spring with the mass of a slab below each support: yield force, period of all mass above on the stiffness after yielding, stiffness before it",
    needs_clock: false,
    memory: &[],
    materials: &[],
    measurement: Measurement::new(
        "look for bearings below {place}, and record the displacement across them",
        "look for bearings below {place}, and record the displacement across them",
    ).unless_at_building(Recordable::Deformation).unless_in_rig(Recordable::Deformation),
    quantities: &[
        Quantity::new("yield", "yield force of the layer", Dimension::Force),
        Quantity::new("period", "period after yielding", Dimension::Time)
            .within("the period after yielding, s", [1.0, 5.0], "isolated structures swing at up to 5 s (ASCE/SEI 7-16, 17.4.1), rarely below 2 s, and models of quarter scale at half of that"),
        Quantity::new("slab", "mass of the slab", Dimension::Unnamed),
        Quantity::new("initial", "stiffness before yielding", Dimension::Stiffness),
    ],
    propose,
};

/// Period of the layer over that of the structure as one mass on the stiffness above its supports: range and further starts.
/// Isolated structures have more than three times their fixed-base period (ASCE/SEI 7-10, 17.4.1); a layer with less than twice
/// isolates little.
const PERIOD_RATIOS: [f64; 2] = [2.0, 20.0];
const PERIOD_STARTS: [f64; 3] = [3.0, 5.0, 9.0];
/// Yield force of the layer over the largest force in the fitted fixed-base model: range, start and further starts. A choice:
/// a layer that stays below its yield force isolates nothing.
const YIELD_RATIOS: [f64; 2] = [0.01, 1.0];
const YIELD_START: f64 = 0.4;
const YIELD_STARTS: [f64; 2] = [0.8, 0.15];
/// Stiffness before yielding over that of the elements above: range and start. A slider that sticks is nearly rigid.
const STIFFNESS_RATIOS: [f64; 3] = [0.5, 100.0, 5.0];
/// Mass of the slab over the mass of the structure above: range. It starts at the mass of one level.
const MASS_RATIOS: [f64; 2] = [0.01, 1.0];

fn propose(s: &ProposalContext<'_>) -> Vec<Proposal> {
    if !s.inventory.base_excited {
        return vec![];
    }
    // A structure on devices that yield has its layer already.
    let stands_on_device = |p: &&Support| {
        let yields = |tag: &i32| s.inventory.devices.iter().any(|d| d.tag == *tag && !d.linear);
        p.elements.iter().any(yields)
    };
    let supports = carrying_supports(s);
    if supports.iter().any(stands_on_device) {
        return vec![];
    }
    let groups = grouped(supports, |a, b| a.fixed == b.fixed);
    groups.iter().filter(|g| g.len() <= MAX_JOINT_SUPPORTS).filter_map(|g| layer(s, g)).collect()
}

/// A layer of equal bearings below some supports; none where the model has no mass, force or stiffness.
fn layer(s: &ProposalContext<'_>, supports: &[&Support]) -> Option<Proposal> {
    let horizontal = horizontal_dofs(supports, s.inventory.ndm);
    let first = *horizontal.first()?;
    let count = supports.len() as f64;
    let stiffness = supports.iter().map(|p| p.stiffness[first - 1]).sum::<f64>() / count;
    let (total, force) = (s.inventory.total_mass(), s.responses.largest_force());
    if stiffness <= 0.0 || total <= 0.0 || force <= 0.0 {
        return None;
    }
    let shared = total / count;
    let reference = TAU * (shared / stiffness).sqrt();
    let [shortest, longest] = PERIOD_RATIOS.map(|ratio| ratio * reference);
    // The residual swings in the period that the fixed base lacks.
    let period = dominant_period(s.study, s.fits).unwrap_or(PERIOD_STARTS[0] * reference).clamp(shortest, longest);
    let with_starts = |a: AddedParameter, starts: &[f64], scale: f64| AddedParameter {
        further_starts: starts.iter().map(|ratio| ratio * scale).collect(),
        ..a
    };
    let [lower, upper] = YIELD_RATIOS.map(|ratio| ratio * force);
    let strength = AddedParameter::log("yield", lower, upper, YIELD_START * force);
    let [softest, stiffest, stiffness_start] = STIFFNESS_RATIOS.map(|ratio| ratio * stiffness);
    let [lightest, heaviest] = MASS_RATIOS.map(|ratio| ratio * shared);
    let level = shared / s.inventory.masses.len() as f64;
    let added = vec![
        with_starts(strength, &YIELD_STARTS, force),
        with_starts(AddedParameter::log("period", shortest, longest, period), &PERIOD_STARTS, reference),
        AddedParameter::log("slab", lightest, heaviest, level.clamp(lightest, heaviest)),
        AddedParameter::log("initial", softest, stiffest, stiffness_start),
    ];
    // The stiffness after yielding is that of a pendulum of the period with all mass above.
    let law = format!("$hy_yield $hy_initial [expr {{pow({TAU:.10}/$hy_period,2)*({shared:e}+$hy_slab)/$hy_initial}}]");
    let spring = SupportSpring { materials: vec![("Steel01", law)], dofs: &horizontal };
    let freed = FreedSupports { inventory: s.inventory, supports, purpose: TagPurpose::IsolationLayer };
    let block = freed.commands(&[spring], Some("slab"));
    let named: Vec<String> = supports.iter().map(|p| p.node.to_string()).collect();
    let at = format!("node {}", named.join(" "));
    let proposal = Proposal::script_edit(CAUSE, "yielding spring with the mass of a slab", at, block, added);
    Some(Proposal { is_missing_part: true, ..proposal })
}

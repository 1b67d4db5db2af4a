//! An isolation layer that the model leaves out: friction pendulums or rubber bearings below a structure on a fixed base, or
//! between two of its storeys.

use super::context::node_coordinates;
use super::declaration::{Dimension, Measurement, Quantity, Recordable};
use super::support_springs::{FreedSupports, MAX_JOINT_SUPPORTS, SupportSpring, carrying_supports, horizontal_dofs};
use super::{AddedParameter, Hypothesis, Proposal, ProposalContext};
use crate::inspect::dominant_period::dominant_period;
use crate::inspect::inventory::{Mass, Support, TagPurpose, grouped};
use crate::inspect::levels::Level;
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
    statement: "the structure or its upper part stands on an isolation layer that the model leaves out: sliding or rubber bearings and the mass of their slab",
    refuted_by: "what stands there moves with what is below, and its period does not grow with the amplitude",
    look_alikes: &["foundation_flexibility", "superstructure_yielding"],
    shows: "drifts that hardly grow with the strength of the motion, and swing at a period of seconds that the model lacks",
    parted_by: "`foundation_flexibility` has one period at all amplitudes; `superstructure_yielding` has one storey with the largest drift",
    place: "supports of a shaken model that carry linear devices or beams: all with the same fixities together, up to 20; up to 4 levels between its storeys",
    forms: "a bilinear spring with the mass of a slab below each support, or below what stands on a level: yield force, period of all mass above on the stiffness after yielding, stiffness before it",
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

/// Levels within the structure that get a layer, the lowest first, at most.
const MAX_LEVELS: usize = 4;

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
    let groups: Vec<&Vec<&Support>> = groups.iter().filter(|g| g.len() <= MAX_JOINT_SUPPORTS).collect();
    let mut out: Vec<Proposal> = groups.iter().filter_map(|g| below_supports(s, g)).collect();
    if let [one] = groups[..] {
        let levels = s.inventory.levels();
        let fits = |l: &&Level| l.carriers.len() <= MAX_JOINT_SUPPORTS;
        out.extend(levels.iter().filter(fits).take(MAX_LEVELS).filter_map(|level| on_level(s, one, level)));
    }
    out
}

/// A layer of equal bearings: its parameters and the words of its law behind the tag.
struct Layer {
    added: Vec<AddedParameter>,
    law: String,
    /// Horizontal directions in which it slides.
    horizontal: Vec<usize>,
}

impl Layer {
    /// A layer of `count` bearings below a mass. Structures on `supports` give the scales; none without mass, force or stiffness.
    fn new(s: &ProposalContext<'_>, supports: &[&Support], mass: f64, count: usize) -> Option<Self> {
        let horizontal = horizontal_dofs(supports, s.inventory.ndm);
        let first = *horizontal.first()?;
        let count = count as f64;
        let stiffness = supports.iter().map(|p| p.stiffness[first - 1]).sum::<f64>() / count;
        let force = match s.responses.largest_force() {
            0.0 => inertia(s, first) / count,
            of_devices => of_devices,
        };
        if stiffness <= 0.0 || mass <= 0.0 || force <= 0.0 {
            return None;
        }
        let shared = mass / count;
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
        let law =
            format!("$hy_yield $hy_initial [expr {{pow({TAU:.10}/$hy_period,2)*({shared:e}+$hy_slab)/$hy_initial}}]");
        Some(Self { added, law, horizontal })
    }

    fn proposal(self, form: &str, nodes: impl Iterator<Item = i32>, block: Vec<String>) -> Proposal {
        let named: Vec<String> = nodes.map(|node| node.to_string()).collect();
        let proposal = Proposal::script_edit(CAUSE, form, format!("node {}", named.join(" ")), block, self.added);
        Proposal { is_missing_part: true, ..proposal }
    }
}

/// Largest inertia of the masses of the fitted baseline in a direction, as if all were largest at one time: a scale of forces in
/// frames without devices.
fn inertia(s: &ProposalContext<'_>, dof: usize) -> f64 {
    let of = |m: &Mass| Some(m.mass.get(dof - 1)? * s.responses.node_motions.get(&(m.node, dof))?.acceleration);
    s.inventory.masses.iter().filter_map(of).sum()
}

/// A layer below some supports.
fn below_supports(s: &ProposalContext<'_>, supports: &[&Support]) -> Option<Proposal> {
    let layer = Layer::new(s, supports, s.inventory.total_mass(), supports.len())?;
    let spring = SupportSpring { materials: vec![("Steel01", layer.law.clone())], part: None, dofs: &layer.horizontal };
    let freed = FreedSupports { inventory: s.inventory, supports, purpose: TagPurpose::IsolationLayer };
    let block = freed.commands(&[spring], Some("slab"));
    Some(layer.proposal("yielding spring with the mass of a slab", supports.iter().map(|p| p.node), block))
}

/// A layer on a level: each node gets another one above it, at which the elements above hang. Their slab is rigid.
fn on_level(s: &ProposalContext<'_>, supports: &[&Support], level: &Level) -> Option<Proposal> {
    let layer = Layer::new(s, supports, level.mass_above, level.carriers.len())?;
    let (ndm, ndf) = (s.inventory.ndm, supports[0].ndf);
    let first = s.inventory.first_tag(TagPurpose::MiddleLayer);
    let words = |word: &dyn Fn(usize) -> String| (1..=ndf).map(word).collect::<Vec<_>>().join(" ");
    let slides = |dof: &usize| layer.horizontal.contains(dof);
    let named = |dofs: &[usize]| dofs.iter().map(usize::to_string).collect::<Vec<_>>().join(" ");
    let others: Vec<usize> = (1..=ndf).filter(|dof| !slides(dof)).collect();
    let sliding = named(&layer.horizontal);
    let mut block = vec![format!("uniaxialMaterial Steel01 {first} {}", layer.law)];
    for ((node, above), tag) in level.carriers.iter().zip(first..) {
        block.push(format!("node {tag} {}", node_coordinates(*node, ndm)));
        let mass = words(&|dof| if slides(&dof) { "$hy_slab" } else { "0.0" }.to_owned());
        block.push(format!("mass {tag} {mass}"));
        let materials = vec![first.to_string(); layer.horizontal.len()].join(" ");
        block.push(format!("element zeroLength {tag} {node} {tag} -mat {materials} -dir {sliding}"));
        if !others.is_empty() {
            block.push(format!("equalDOF {node} {tag} {}", named(&others)));
        }
        if tag > first {
            block.push(format!("equalDOF {first} {tag} {sliding}"));
        }
        let tags = above.iter().map(i32::to_string).collect::<Vec<_>>().join(" ");
        block.push(format!("amend element {tags} ends -from {node} -to {tag}"));
    }
    let nodes = level.carriers.iter().map(|(node, _)| *node);
    Some(layer.proposal("yielding spring with the mass of a slab on a level", nodes, block))
}

#[cfg(test)]
mod tests {
    use super::propose;
    use crate::inspect::response::{NodeMotion, ResponseRanges};
    use crate::test_support::{pad_study, proposal_context, shaken_inventory};

    /// A chain of two storeys gets a layer at its foot, and one between the storeys that carries the upper one alone.
    #[test]
    fn a_layer_lies_on_the_ground_or_on_a_level() {
        let inventory = shaken_inventory(
            "model basic -ndm 1 -ndf 1
            node 1 0.; foreach n {2 3} {node $n 0. -mass 1.}
            fix 1 1; uniaxialMaterial Elastic 1 100.
            foreach {e i j} {1 1 2 2 2 3} {element zeroLength $e $i $j -mat 1 -dir 1}",
        );
        let moves = NodeMotion { acceleration: 5.0, ..NodeMotion::default() };
        let responses = ResponseRanges { node_motions: [((2, 1), moves)].into(), ..ResponseRanges::default() };
        let study = pad_study();
        let proposals = propose(&proposal_context(&inventory, &study, &responses));
        let places: Vec<&str> = proposals.iter().map(|p| p.location.as_str()).collect();
        assert_eq!(places, ["node 1", "node 2"]);
        let moved = |n: usize| proposals[n].commands.iter().any(|c| c.starts_with("amend element 2 ends -from 2 -to "));
        assert!(!moved(0) && moved(1), "{:?}", proposals[1].commands);
    }
}

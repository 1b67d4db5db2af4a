//! Flexible soil or supports below a fixed base.

use super::declaration::{Dimension, Measurement, Quantity, Recordable};
use super::support_springs::{FreedSupports, SupportSpring, carrying_supports, horizontal_dofs, largest_stiffness};
use super::{AddedParameter, Hypothesis, Proposal, ProposalContext};
use crate::inspect::conditions::amplitudes_differ;
use crate::inspect::inventory::{Support, TagPurpose, grouped};

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "foundation_flexibility",
    statement: "the soil or the support below the fixed base of the model gives way",
    refuted_by: "the base of the structure does not move against the free field",
    look_alikes: &["superstructure_yielding", "isolation_layer", "damping"],
    shows: "a longer period than the model's; a base that moves or rocks against the free field",
    parted_by: "the period is longer at small amplitudes too, which yielding does not explain",
    place: "supports of a shaken model: 6 alone, and groups of 2 to 20",
    forms: "horizontal spring, rocking spring, or both, each with a dashpot; a spring that yields; a footing with mass",
    needs_clock: false,
    is_missing_part: false,
    memory: &[],
    materials: &[],
    measurement: Measurement::new(
        "put one accelerometer on the foundation at {place} and one on free ground: they must differ",
        "record the displacement of the support at {place}",
    )
    .unless_at_building(Recordable::Acceleration)
    .unless_in_rig(Recordable::Deformation),
    quantities: &[
        Quantity::new("sway", "horizontal stiffness", Dimension::Stiffness),
        Quantity::new("sway_dashpot", "horizontal damping", Dimension::Dashpot),
        Quantity::new("rocking", "rocking stiffness", Dimension::RotationalStiffness),
        Quantity::new("rocking_dashpot", "rocking damping", Dimension::RotationalDashpot),
        Quantity::new("sway_yield", "yield force", Dimension::Force),
        Quantity::new("sway_hardening", "hardening ratio", Dimension::Ratio),
        Quantity::new("footing", "mass of the footing", Dimension::Unnamed),
    ],
    propose,
};

/// Supports that are freed one at a time, at most.
const MAX_SINGLE_SUPPORTS: usize = 6;
/// Supports that are freed together, at most.
const MAX_JOINT_SUPPORTS: usize = 20;
/// Difference of stiffnesses that count as similar, in parts of the larger one. A choice.
const SIMILAR_STIFFNESS: f64 = 0.5;

fn propose(s: &ProposalContext<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    if !s.inventory.base_excited {
        return out;
    }
    let supports = carrying_supports(s);
    for support in supports.iter().take(MAX_SINGLE_SUPPORTS) {
        add_forms(s, &[support], &mut out);
    }
    // Supports with equal fixities together: ends of a bridge, columns of a frame. Among them those with similar stiffness:
    // piers without abutments.
    let all = || supports.iter().copied();
    let equally_fixed = grouped(all(), |a, b| a.fixed == b.fixed);
    let similar = grouped(all(), |a, b| a.fixed == b.fixed && similar_stiffness(a, b));
    let further = similar.into_iter().filter(|g| !equally_fixed.contains(g)).collect::<Vec<_>>();
    for group in equally_fixed.iter().chain(&further).filter(|g| (2..=MAX_JOINT_SUPPORTS).contains(&g.len())) {
        add_forms(s, group, &mut out);
    }
    out
}

/// Returns true if the elements on two supports have similar stiffnesses.
fn similar_stiffness(a: &Support, b: &Support) -> bool {
    let near = |(a, b): (&f64, &f64)| (a - b).abs() <= SIMILAR_STIFFNESS * a.abs().max(b.abs());
    a.stiffness.iter().zip(&b.stiffness).all(near)
}

/// Addition to the springs and dashpots of a support.
#[derive(Clone, Copy, PartialEq)]
enum Addition {
    None,
    /// Yielding of the springs, with a scale of the yield force.
    Yielding {
        force: f64,
    },
    /// A footing with mass.
    Footing,
}

/// Adds all forms of equal springs and dashpots below some supports.
fn add_forms(s: &ProposalContext<'_>, supports: &[&Support], out: &mut Vec<Proposal>) {
    let ndm = s.inventory.ndm;
    let total = s.inventory.total_mass();
    let (first, stiffest) = (supports[0], |dof: usize| largest_stiffness(supports, dof));
    let horizontal = horizontal_dofs(supports, ndm);
    let rotations: &[usize] = if ndm == 2 { &[3] } else { &[4, 5] };
    let rocking: Vec<usize> = rotations
        .iter()
        .copied()
        .filter(|d| first.fixed.contains(d) && first.ndf >= *d && stiffest(*d) > 0.0)
        .collect();
    let named: Vec<String> = supports.iter().map(|p| p.node.to_string()).collect();
    let at = format!("node {}", named.join(" "));
    let freed = FreedSupports { inventory: s.inventory, supports, purpose: TagPurpose::Foundation };
    let mut form = |form: &str, springs: &[(&str, &[usize])], addition: Addition| {
        let mut added = vec![];
        let mut spring = |name: &str, dofs| {
            let law = match addition {
                Addition::Yielding { .. } => ("Steel01", format!("$hy_{name}_yield $hy_{name} $hy_{name}_hardening")),
                _ => ("Elastic", format!("$hy_{name}")),
            };
            added.extend(spring_parameters(name, scale_of(dofs, stiffest), addition));
            SupportSpring { materials: vec![law, ("Viscous", format!("$hy_{name}_dashpot 1.0"))], dofs }
        };
        let springs: Vec<_> = springs.iter().map(|(name, dofs)| spring(name, dofs)).collect();
        let is_footing = addition == Addition::Footing;
        if is_footing {
            added.push(AddedParameter::log("footing", 1e-3 * total, total, 0.05 * total));
        }
        let block = freed.commands(&springs, is_footing.then_some("footing"));
        out.push(Proposal::script_edit("foundation_flexibility", form, at.clone(), block, added));
    };
    if !horizontal.is_empty() {
        form("horizontal spring", &[("sway", &horizontal)], Addition::None);
        // Yielding shows where amplitudes differ, below elements that do not yield themselves.
        let force = s.responses.largest_force();
        let softens = |tag: &i32| s.inventory.devices.iter().any(|d| d.tag == *tag && !d.linear);
        let below = supports.iter().any(|p| p.elements.iter().any(softens));
        if force > 0.0 && !below && amplitudes_differ(s.study) {
            form("horizontal spring that yields", &[("sway", &horizontal)], Addition::Yielding { force });
        }
        if total > 0.0 {
            form("horizontal spring and a footing with mass", &[("sway", &horizontal)], Addition::Footing);
        }
    }
    if !rocking.is_empty() {
        form("rocking spring", &[("rocking", &rocking)], Addition::None);
    }
    if !horizontal.is_empty() && !rocking.is_empty() {
        form("horizontal and rocking spring", &[("sway", &horizontal), ("rocking", &rocking)], Addition::None);
    }
}

/// Scale of the stiffness of a spring: that of the elements above. A much stiffer spring is a fixed base.
fn scale_of(dofs: &[usize], stiffest: impl Fn(usize) -> f64) -> f64 {
    dofs.iter().map(|d| stiffest(*d)).fold(0.0, f64::max)
}

/// Parameters of a spring on the scale of its stiffness.
fn spring_parameters(name: &str, scale: f64, addition: Addition) -> Vec<AddedParameter> {
    let mut added = vec![
        AddedParameter::log(name, 3e-3 * scale, 100.0 * scale, scale),
        AddedParameter::log(&format!("{name}_dashpot"), 1e-5 * scale, 0.3 * scale, 3e-3 * scale),
    ];
    if let Addition::Yielding { force } = addition {
        added.push(AddedParameter::log(&format!("{name}_yield"), 3e-3 * force, 10.0 * force, 0.1 * force));
        added.push(AddedParameter::linear(&format!("{name}_hardening"), 0.0, 0.9, 0.1));
    }
    added
}

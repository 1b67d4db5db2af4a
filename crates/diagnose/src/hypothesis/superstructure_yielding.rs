//! Yielding of the structure above the base.

use super::declaration::{Dimension, Measurement, Quantity, Recordable};
use super::yielding_joint::{STRENGTH_STARTS, YieldingJoint};
use super::{AddedParameter, Hypothesis, Proposal, ProposalContext, foundation_flexibility};
use crate::inspect::frame_members::FrameMember;
use crate::inspect::inventory::{Device, TagPurpose};

/// Ground columns that yield one at a time, storeys and floors, at most.
const MAX_LEVELS: usize = 6;
/// Largest number of springs of one kind that yield one at a time.
const MAX_SINGLE_SPRINGS: usize = 12;

/// Name of the cause.
pub(super) const CAUSE: &str = "superstructure_yielding";

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: CAUSE,
    statement: "the structure above, taken as elastic, yields",
    refuted_by: "the structure comes back to where it stood, and its stiffness does not fall with the amplitude",
    look_alikes: &["foundation_flexibility", "isolation_layer", "damping"],
    shows: "drifts that grow faster than the force in strong parts, and a residual drift",
    parted_by: "in weak parts the model is right",
    place: "linear devices, alone where they are 12 or fewer, and all together; columns of up to 6 levels; girders",
    forms: "`yielding`; `peakOriented`; `hinges` at the feet of columns, or at both ends of columns and girders",
    needs_clock: false,
    memory: &[],
    materials: &[],
    measurement: Measurement::new(
        "inspect {place} for cracks and a permanent drift, and record the drift there",
        "record the deformation at {place}: it must keep a permanent part",
    )
    .unless_in_rig(Recordable::Deformation),
    quantities: &[
        Quantity::new("yield", "yield force", Dimension::Force),
        Quantity::new("moment", "yield moment", Dimension::Moment),
        Quantity::new("plastic", "stiffness after yielding", Dimension::RotationalStiffness),
        Quantity::new("rotational", "initial stiffness of the hinge", Dimension::RotationalStiffness),
        Quantity::new("unloading", "exponent of unloading", Dimension::Ratio),
    ],
    propose,
};

fn propose(s: &ProposalContext<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for m in s.moving_groups(true) {
        // Each spring alone if there are few, and all together.
        let mut sets: Vec<Vec<&Device>> =
            if m.devices.len() <= MAX_SINGLE_SPRINGS { m.devices.iter().map(|d| vec![*d]).collect() } else { vec![] };
        if m.devices.len() > 1 {
            sets.push(m.devices.clone());
        }
        for set in sets {
            let q = m.directions.iter().filter_map(|d| s.responses.of(&set, *d)).map(|x| x.force).fold(0.0, f64::max);
            let tags = super::element_tags(&set);
            let mut form = |form: &str, law: &str, more: Vec<AddedParameter>| {
                let line =
                    format!("amend element {tags} {law} -force $hy_yield -hardening $hy_hardening {}", m.dir_option);
                let force = AddedParameter::linear("yield", 0.03 * q, 1.2 * q, 0.9 * q);
                let mut added = vec![
                    AddedParameter { further_starts: STRENGTH_STARTS.map(|part| part * q).into(), ..force },
                    AddedParameter::linear("hardening", 0.0, 0.6, 0.1),
                ];
                added.extend(more);
                let at = super::element_names(&set);
                out.push(Proposal::script_edit(CAUSE, form, at, vec![line], added));
            };
            form("bilinear spring", "yielding", vec![]);
            // Concrete loses stiffness in unloading.
            let unloading = vec![AddedParameter::linear("unloading", 0.0, 0.6, 0.2)];
            form(
                "spring that reloads towards its largest deformation",
                "peakOriented -unloading $hy_unloading",
                unloading,
            );
        }
    }
    // Hinges at the feet of the columns of each storey, on the ground also one column at a time. Columns below a girder yield at
    // the head as well, and girders at both ends.
    let levels = s.inventory.storeys(&s.inventory.columns);
    for (n, level) in levels.iter().take(MAX_LEVELS).enumerate() {
        if n == 0 && level.len() > 1 {
            out.extend(level.iter().take(MAX_LEVELS).filter_map(|column| hinges(s, &[*column], Ends::Foot)));
        }
        out.extend(hinges(s, level, Ends::Foot));
        let below_girder = |c: &&FrameMember| s.inventory.girders.iter().any(|g| [g.foot, g.head].contains(&c.head));
        if level.iter().all(below_girder) {
            out.extend(hinges(s, level, Ends::Both));
        }
    }
    // Girders of all floors together, and of each floor.
    let girders: Vec<&FrameMember> = s.inventory.girders.iter().collect();
    out.extend(hinges(s, &girders, Ends::Both));
    let floors = s.inventory.storeys(&s.inventory.girders);
    if floors.len() > 1 {
        out.extend(floors.iter().take(MAX_LEVELS).filter_map(|floor| hinges(s, floor, Ends::Both)));
    }
    out
}

/// Ends of beams with hinges.
#[derive(Clone, Copy, PartialEq)]
enum Ends {
    Foot,
    Both,
}

/// Equal hinges at the ends of beams, about every axis of bending; none without stiffness or moment.
fn hinges(s: &ProposalContext<'_>, columns: &[&FrameMember], ends: Ends) -> Option<Proposal> {
    let stiffness = columns.iter().fold(0.0, |a: f64, c| a.max(c.rotational_stiffness));
    let moment = columns.iter().filter_map(|c| s.responses.end_moments.get(&c.tag)).fold(0.0, |a: f64, m| a.max(*m));
    if stiffness <= 0.0 || moment <= 0.0 {
        return None;
    }
    let material = s.inventory.first_tag(TagPurpose::Hinges);
    let joint = YieldingJoint { strength: "moment", plastic: "plastic", initial: "rotational" };
    let (kind, words) = joint.law();
    let mut block = vec![format!("uniaxialMaterial {kind} {material} {words}")];
    // A column may be defined from its head.
    let (from_foot, from_head): (Vec<&FrameMember>, Vec<&FrameMember>) =
        columns.iter().copied().partition(|c| c.foot_end == 0 || ends == Ends::Both);
    for (members, end) in [(from_foot, " -end i"), (from_head, " -end j")] {
        let end = if ends == Ends::Both { "" } else { end };
        if !members.is_empty() {
            block.push(format!("amend element {} hinges -mat {material}{end}", member_tags(&members)));
        }
    }
    let added = joint.parameters(moment, stiffness);
    let at = format!("{} of element {}", if ends == Ends::Both { "both ends" } else { "foot" }, member_tags(columns));
    let proposal = Proposal::script_edit(CAUSE, "plastic hinge", at, block, added);
    // Below a hinge on the ground there is nothing that soil would turn.
    let supports = &s.inventory.supports;
    let on_ground = |c: &&FrameMember| supports.iter().any(|p| p.node == c.foot && s.inventory.carries_one_column(p));
    let is_ground = ends == Ends::Foot && columns.iter().all(on_ground);
    Some(Proposal { same_model: is_ground.then_some(foundation_flexibility::CAUSE), ..proposal })
}

fn member_tags(columns: &[&FrameMember]) -> String {
    columns.iter().map(|c| c.tag.to_string()).collect::<Vec<_>>().join(" ")
}

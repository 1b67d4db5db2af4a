//! Energy loss of the structure beyond its damping model.

use super::declaration::{Dimension, Measurement, Quantity};
use super::{AddedParameter, Hypothesis, Proposal, ProposalContext};
use crate::inspect::frame_members::FrameMember;
use crate::inspect::inventory::{Device, Mass, TAGS_PER_PURPOSE, TagPurpose};
use crate::memory::family::Family;

/// Masses that get a dashpot one at a time, at most.
const MAX_SINGLE_MASSES: usize = 6;

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "damping",
    statement: "the structure loses energy that its damping model misses",
    refuted_by: "free vibration decays as the model says",
    look_alikes: &["rate_dependence", "friction"],
    shows: "a free vibration that decays faster or slower than the model's",
    parted_by: "the period is right, and so is the force at peaks of displacement",
    place: "linear groups of a shaken model; frames; all masses; each of 6 masses that are not on a device on the ground",
    forms: "`damping`, linear or of a power; dashpots in proportion to stiffness; dashpots beside columns; mass-proportional damping; a dashpot of a power from 1 to 2 between a mass and the ground",
    needs_clock: false,
    is_missing_part: false,
    memory: &[Family::Rate],
    materials: &[],
    measurement: Measurement::new(
        "record small vibrations after a shock or in wind, and compare their decay with that of the model",
        "record a free vibration, and compare its decay with that of the model",
    ),
    quantities: &[
        Quantity::new("force", "damping force at the largest speed", Dimension::Force),
        Quantity::new("beta", "damping per stiffness", Dimension::Time),
        Quantity::new("alphaM", "damping per mass", Dimension::Rate),
        Quantity::new("c", "dashpot", Dimension::Dashpot),
    ],
    propose,
};

fn propose(s: &ProposalContext<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    if !s.inventory.base_excited {
        return out;
    }
    for m in s.moving_groups(true) {
        let dashpots = |amend: &str, at: &str, forms: [&str; 2]| {
            // From nearly dry friction (0.2) to an orifice (2).
            let power = AddedParameter::linear("power", 0.2, 2.0, 0.6);
            let (linear, force) = m.dashpot(amend, "1.0");
            let (curved, _) = m.dashpot(amend, "$hy_power");
            [
                Proposal::script_edit("damping", forms[0], at.into(), vec![linear], vec![force.clone()]),
                Proposal::script_edit("damping", forms[1], at.into(), vec![curved], vec![force, power]),
            ]
        };
        let all = ["dashpots in the structure", "dashpots of a power of speed"];
        out.extend(dashpots(&m.amend("damping"), &m.location(), all));
        // Dashpots in proportion to stiffness, and a dashpot beside each device alone.
        if m.devices.len() > 1 {
            let alike = |d: &Device| {
                let k = d.directions.iter().find(|x| m.directions.contains(&x.number)).map_or(0.0, |x| x.stiffness);
                format!("amend element {} damping -coefficient [expr {{$hy_beta*{k:.6e}}}] {}", d.tag, m.dir_option)
            };
            let block = m.devices.iter().map(|d| alike(d)).collect();
            let beta = m.deformation / m.speed.max(f64::MIN_POSITIVE);
            let added = vec![AddedParameter::log("beta", 1e-4 * beta, 3.0 * beta, 0.05 * beta)];
            out.push(Proposal::script_edit(
                "damping",
                "dashpots in proportion to stiffness",
                m.location(),
                block,
                added,
            ));
            for d in &m.devices {
                let alone = format!("amend element {} damping", d.tag);
                out.extend(dashpots(&alone, &super::element_names(&[d]), ["dashpot", "dashpot of a power of speed"]));
            }
        }
    }
    out.extend(dashpots_beside_columns(s));
    out.extend(s.inventory.masses.iter().filter_map(|m| dashpot_on_ground(s, m)).take(MAX_SINGLE_MASSES));
    if !s.inventory.masses.is_empty() {
        // Dashpots between masses and ground, in addition to the damping of the script.
        let mut block = vec![];
        for (tag, node) in (s.inventory.first_tag(TagPurpose::Regions)..).zip(&s.inventory.masses) {
            block.push(format!("# mass-proportional damping of node {}", node.node));
            block.push(format!("region {tag} -node {} -rayleigh $hy_alphaM 0.0 0.0 0.0", node.node));
        }
        let added = vec![AddedParameter::log("alphaM", 1e-3, 10.0, 0.1)];
        out.push(Proposal::script_edit("damping", "mass-proportional damping", "all masses".into(), block, added));
    }
    out
}

/// A dashpot of a power of speed between a mass and the ground: waves that it radiates, water or air that it moves.
///
/// Beside a device on a support it would be a force of the device. `None` there, and for a mass that does not move.
fn dashpot_on_ground(s: &ProposalContext<'_>, m: &Mass) -> Option<Proposal> {
    // Horizontal directions; a chain along one axis moves along it.
    let horizontal = (1..s.inventory.ndm.max(2)).filter(|dof| m.mass.get(dof - 1).is_some_and(|x| *x > 0.0));
    let moving: Vec<(usize, f64, f64)> = horizontal
        .filter_map(|dof| {
            let motion = s.responses.node_motions.get(&(m.node, dof))?;
            Some((dof, motion.velocity, m.mass[dof - 1] * motion.acceleration))
        })
        .filter(|(_, velocity, force)| *velocity > 0.0 && *force > 0.0)
        .collect();
    let is_ground = |node: &i32| *node != m.node && moving.iter().any(|(dof, ..)| s.inventory.is_held(*node, *dof));
    if s.inventory.devices.iter().any(|d| d.nodes.contains(&m.node) && d.nodes.iter().any(is_ground)) {
        return None;
    }
    let (_, velocity, force) = moving.iter().copied().max_by(|a, b| a.1.total_cmp(&b.1))?;
    let tag = s.inventory.first_tag(TagPurpose::GroundDashpots);
    let ndf = m.mass.len();
    let directions: Vec<String> = moving.iter().map(|(dof, ..)| dof.to_string()).collect();
    let block = vec![
        format!("node {tag} {}", super::context::node_coordinates(m.node, s.inventory.ndm)),
        format!("fix {tag} {}", vec!["1"; ndf].join(" ")),
        format!("uniaxialMaterial Viscous {tag} [expr {{$hy_force/pow({velocity:.6e},$hy_power)}}] $hy_power"),
        format!(
            "element zeroLength {tag} {tag} {} -mat {} -dir {}",
            m.node,
            vec![tag.to_string(); directions.len()].join(" "),
            directions.join(" ")
        ),
    ];
    // From waves (1) to drag (2). Scale: the largest force of inertia.
    let added = vec![
        AddedParameter::log("force", 1e-4 * force, 3.0 * force, 0.05 * force),
        AddedParameter { further_starts: vec![2.0], ..AddedParameter::linear("power", 1.0, 2.0, 1.0) },
    ];
    let at = format!("node {}", m.node);
    Some(Proposal::script_edit("damping", "dashpot of a power of speed on the ground", at, block, added))
}

/// Dashpots beside the columns of a frame, from storey to storey.
fn dashpots_beside_columns(s: &ProposalContext<'_>) -> Option<Proposal> {
    let columns = &s.inventory.columns;
    if s.inventory.girders.is_empty() || columns.is_empty() || columns.len() > TAGS_PER_PURPOSE {
        return None;
    }
    // Scale: the critical damping of a column under its share of the mass.
    let stiffness =
        columns.iter().fold(0.0, |most: f64, c| most.max(3.0 * c.rotational_stiffness / (c.length * c.length)));
    let mass = s.inventory.masses.iter().map(|m| m.mass[0]).sum::<f64>() / columns.len() as f64;
    let critical = 2.0 * (stiffness * mass).sqrt();
    if critical <= 0.0 {
        return None;
    }
    let first = s.inventory.first_tag(TagPurpose::Dashpots);
    let (materials, across) = match s.inventory.ndm {
        2 => (format!("{first}"), "-dir 2"),
        _ => (format!("{first} {first}"), "-dir 2 3 -orient 0 0 1 1 0 0"),
    };
    let mut block = vec![format!("uniaxialMaterial Viscous {first} $hy_c 1.0")];
    let link = |(c, tag): (&FrameMember, i32)| {
        format!("element twoNodeLink {tag} {} {} -mat {materials} {across}", c.foot, c.head)
    };
    block.extend(columns.iter().zip(first..).map(link));
    let added = vec![AddedParameter::log("c", 1e-4 * critical, critical, 0.03 * critical)];
    let tags: Vec<String> = columns.iter().map(|c| c.tag.to_string()).collect();
    Some(Proposal::script_edit(
        "damping",
        "dashpots in the structure",
        format!("beside element {}", tags.join(" ")),
        block,
        added,
    ))
}

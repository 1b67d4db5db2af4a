//! Energy loss of the structure beyond its damping model.

use super::declaration::{Dimension, Measurement, Quantity};
use super::free_masses::{FreeMass, MovingDirection, free_masses};
use super::{AddedParameter, Hypothesis, Proposal, ProposalContext};
use crate::inspect::frame_members::FrameMember;
use crate::inspect::inventory::{Device, TAGS_PER_PURPOSE, TagPurpose};
use crate::memory::family::Family;

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "damping",
    statement: "the structure loses energy that its damping model misses",
    refuted_by: "free vibration decays as the model says",
    look_alikes: &["rate_dependence", "friction"],
    shows: "a free vibration that decays faster or slower than the model's",
    parted_by: "the period is right, and so is the force at peaks of displacement",
    place: "linear groups of a shaken model; frames; all masses; each of 6 masses that are not on a device on the ground",
    forms: "`damping`, linear or of a power; dashpots in proportion to stiffness; dashpots beside columns; mass-proportional damping; one damping ratio of all modes; a dashpot of a power from 1 to 2 between a mass and the ground",
    needs_clock: false,
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
        Quantity::new("ratio", "damping ratio of each mode", Dimension::Ratio).within(
            "the damping ratio of each mode",
            [0.0, 0.2],
            "buildings have 1 to 10 % of critical damping (Chopra, Dynamics of Structures, 11.2), with some margin",
        ),
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
    out.extend(free_masses(s).iter().map(|m| dashpot_on_ground(s, m)));
    if !s.inventory.masses.is_empty() {
        // Dashpots between masses and ground, in addition to the damping of the script.
        let mut block = vec![];
        for (tag, node) in (s.inventory.first_tag(TagPurpose::Regions)..).zip(&s.inventory.masses) {
            block.push(format!("# mass-proportional damping of node {}", node.node));
            block.push(format!("region {tag} -node {} -rayleigh $hy_alphaM 0.0 0.0 0.0", node.node));
        }
        let added = vec![AddedParameter::log("alphaM", 1e-3, 10.0, 0.1)];
        out.push(Proposal::script_edit("damping", "mass-proportional damping", "all masses".into(), block, added));
        out.extend(damping_of_modes(s));
    }
    out
}

/// Modes that are damped at most.
const MAX_MODES: usize = 12;

/// One damping ratio of all modes beside the other damping of the script; none for a single mode, which is damped as its mass.
fn damping_of_modes(s: &ProposalContext<'_>) -> Option<Proposal> {
    let moving = s.inventory.masses.iter().flat_map(|m| &m.mass).filter(|mass| **mass > 0.0).count();
    if moving < 2 {
        return None;
    }
    // Fewer modes than masses: a support holds some of them.
    let modes = s.inventory.masses.len().min(MAX_MODES);
    let block = vec![format!("eigen {modes}"), "modalDamping $hy_ratio".to_owned()];
    let added = vec![AddedParameter::log("ratio", 1e-3, 0.5, 0.03)];
    Some(Proposal::script_edit("damping", "one damping ratio of all modes", "all masses".into(), block, added))
}

/// A dashpot of a power of speed between a mass and the ground: waves that it radiates, water or air that it moves.
fn dashpot_on_ground(s: &ProposalContext<'_>, m: &FreeMass<'_>) -> Proposal {
    let &MovingDirection { motion, inertia: force, .. } = m.fastest();
    let velocity = motion.velocity;
    let tag = s.inventory.first_tag(TagPurpose::GroundDashpots);
    let directions: Vec<String> = m.directions.iter().map(|d| d.dof.to_string()).collect();
    let mut block = m.ground_node(tag, s.inventory.ndm).to_vec();
    block.extend([
        format!("uniaxialMaterial Viscous {tag} [expr {{$hy_force/pow({velocity:.6e},$hy_power)}}] $hy_power"),
        format!(
            "element zeroLength {tag} {tag} {} -mat {} -dir {}",
            m.mass.node,
            vec![tag.to_string(); directions.len()].join(" "),
            directions.join(" ")
        ),
    ]);
    // From waves (1) to drag (2). Scale: the largest force of inertia.
    let added = vec![
        AddedParameter::log("force", 1e-4 * force, 3.0 * force, 0.05 * force),
        AddedParameter { further_starts: vec![2.0], ..AddedParameter::linear("power", 1.0, 2.0, 1.0) },
    ];
    Proposal::script_edit("damping", "dashpot of a power of speed on the ground", m.location(), block, added)
}

/// Dashpots beside the columns of a frame, from storey to storey.
fn dashpots_beside_columns(s: &ProposalContext<'_>) -> Option<Proposal> {
    let columns = &s.inventory.columns;
    if s.inventory.girders.is_empty() || columns.is_empty() || columns.len() > TAGS_PER_PURPOSE {
        return None;
    }
    // Scale: the critical damping of a column under its share of the mass.
    let stiffness = columns.iter().map(FrameMember::sway_stiffness).fold(0.0, f64::max);
    let mass = s.inventory.masses.iter().map(|m| m.mass[0]).sum::<f64>() / columns.len() as f64;
    let critical = 2.0 * (stiffness * mass).sqrt();
    if critical <= 0.0 {
        return None;
    }
    let first = s.inventory.first_tag(TagPurpose::Dashpots);
    let mut block = vec![format!("uniaxialMaterial Viscous {first} $hy_c 1.0")];
    let (materials, across) = match s.inventory.ndm {
        2 => (format!("{first}"), "-dir 2"),
        _ => (format!("{first} {first}"), "-dir 2 3 -orient 0 0 1 1 0 0"),
    };
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

#[cfg(test)]
mod tests {
    use super::propose;
    use crate::inspect::response::ResponseRanges;
    use crate::test_support::{pad_study, proposal_context, shaken_inventory};

    /// Of a single mass one ratio of all modes is the damping of the mass.
    #[test]
    fn several_masses_share_a_damping_ratio() {
        let commands = |mass: &str| -> Vec<String> {
            let text = format!(
                "model basic -ndm 1 -ndf 1
                node 1 0.; node 2 0. -mass {mass}; node 3 0. -mass 1.; fix 1 1
                uniaxialMaterial Elastic 1 100.
                element zeroLength 1 1 2 -mat 1 -dir 1; element zeroLength 2 2 3 -mat 1 -dir 1"
            );
            let (inventory, study, responses) = (shaken_inventory(&text), pad_study(), ResponseRanges::default());
            let all = propose(&proposal_context(&inventory, &study, &responses));
            all.into_iter().filter(|p| p.form.contains("modes")).flat_map(|p| p.commands).collect()
        };
        assert_eq!(commands("1."), ["eigen 2", "modalDamping $hy_ratio"]);
        assert!(commands("0.").is_empty());
    }
}

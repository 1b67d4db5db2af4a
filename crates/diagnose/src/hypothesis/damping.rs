//! Energy loss of the structure that the damping model misses.

use super::{Added, Hypothesis, Proposal, Sight};
use crate::inspect::columns::Column;
use crate::inspect::inventory::{Numbers, ROOM};

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "damping",
    says: "the structure loses energy that its damping model misses",
    refuted_by: "free vibration decays as the model says",
    like: &["rate_dependence", "friction"],
    needs_clock: false,
    propose,
};

fn propose(s: &Sight<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    if !s.anatomy.shaken {
        return out;
    }
    for m in s.moved(true) {
        let dashpots = |amend: &str, at: &str, forms: [&str; 2]| {
            // From nearly friction to an orifice's.
            let power = Added::linear("power", 0.2, 2.0, 0.6);
            let (linear, force) = m.dashpot(amend, "1.0");
            let (curved, _) = m.dashpot(amend, "$hy_power");
            [
                Proposal::edit("damping", forms[0], at.into(), vec![linear], vec![force.clone()]),
                Proposal::edit("damping", forms[1], at.into(), vec![curved], vec![force, power]),
            ]
        };
        let all = ["dashpots in the structure", "dashpots of a power of speed"];
        out.extend(dashpots(&m.amend("damping"), &m.at(), all));
        // Each with a dashpot in proportion to its stiffness, and each alone.
        if m.group.len() > 1 {
            let alike = |d: &super::Device| {
                let k = d.directions.iter().find(|x| m.directions.contains(&x.number)).map_or(0.0, |x| x.stiffness);
                format!("amend element {} damping -coefficient [expr {{$hy_beta*{k:.6e}}}] {}", d.tag, m.dir)
            };
            let block = m.group.iter().map(|d| alike(d)).collect();
            let beta = m.e / m.v.max(f64::MIN_POSITIVE);
            let added = vec![Added::log("beta", 1e-4 * beta, 3.0 * beta, 0.05 * beta)];
            out.push(Proposal::edit("damping", "dashpots in proportion to stiffness", m.at(), block, added));
            for d in &m.group {
                let alone = format!("amend element {} damping", d.tag);
                out.extend(dashpots(&alone, &super::named(&[d]), ["dashpot", "dashpot of a power of speed"]));
            }
        }
    }
    out.extend(beside_columns(s));
    if !s.anatomy.masses.is_empty() {
        // Dashpots between the masses and the ground: mass-proportional damping beside whatever the script has.
        let mut block = vec![];
        for (tag, node) in (s.anatomy.free(Numbers::Regions)..).zip(&s.anatomy.masses) {
            block.push(format!("# mass-proportional damping of node {}", node.node));
            block.push(format!("region {tag} -node {} -rayleigh $hy_alphaM 0.0 0.0 0.0", node.node));
        }
        let added = vec![Added::log("alphaM", 1e-3, 10.0, 0.1)];
        out.push(Proposal::edit("damping", "mass-proportional damping", "all masses".into(), block, added));
    }
    out
}

/// Dashpots from storey to storey of a frame, beside its columns.
fn beside_columns(s: &Sight<'_>) -> Option<Proposal> {
    let columns = &s.anatomy.columns;
    if s.anatomy.girders.is_empty() || columns.is_empty() || columns.len() > ROOM {
        return None;
    }
    // Against the critical damping of a column that carries its part of the mass.
    let stiffness = columns.iter().fold(0.0, |most: f64, c| most.max(3.0 * c.rotational / (c.length * c.length)));
    let mass = s.anatomy.masses.iter().map(|m| m.mass[0]).sum::<f64>() / columns.len() as f64;
    let critical = 2.0 * (stiffness * mass).sqrt();
    if critical <= 0.0 {
        return None;
    }
    let first = s.anatomy.free(Numbers::Dashpots);
    let (materials, across) = match s.anatomy.ndm {
        2 => (format!("{first}"), "-dir 2"),
        _ => (format!("{first} {first}"), "-dir 2 3 -orient 0 0 1 1 0 0"),
    };
    let mut block = vec![format!("uniaxialMaterial Viscous {first} $hy_c 1.0")];
    let link =
        |(c, tag): (&Column, i32)| format!("element twoNodeLink {tag} {} {} -mat {materials} {across}", c.node, c.head);
    block.extend(columns.iter().zip(first..).map(link));
    let added = vec![Added::log("c", 1e-4 * critical, critical, 0.03 * critical)];
    let tags: Vec<String> = columns.iter().map(|c| c.tag.to_string()).collect();
    Some(Proposal::edit(
        "damping",
        "dashpots in the structure",
        format!("beside element {}", tags.join(" ")),
        block,
        added,
    ))
}

//! The support gives way.

use super::{Added, Hypothesis, Proposal, Sight};
use crate::inspect::conditions::amplitudes_differ;
use crate::inspect::inventory::{Numbers, Support, grouped};

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "foundation_flexibility",
    says: "the soil or the support below the fixed base of the model gives way",
    refuted_by: "the base of the structure does not move against the free field",
    like: &["superstructure_yielding", "damping"],
    needs_clock: false,
    propose,
};

/// Supports that are freed alone, at most, and together.
const ALONE: usize = 6;
const TOGETHER: usize = 20;
/// Stiffnesses that differ by no more than this part of the larger one are about the same (a choice).
const SPREAD: f64 = 0.5;

fn propose(s: &Sight<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    if !s.anatomy.shaken {
        return out;
    }
    let stands = |p: &&Support| !p.elements.is_empty() && p.fixed.len() >= s.anatomy.ndm;
    let supports: Vec<&Support> = s.anatomy.supports.iter().filter(stands).collect();
    for support in supports.iter().take(ALONE) {
        forms(s, &[support], &mut out);
    }
    // Those that are held alike, together: the ends of a bridge, the columns of a frame. And of these those that carry alike: the piers
    // of a bridge without its abutments.
    let all = || supports.iter().copied();
    let held = grouped(all(), |a, b| a.fixed == b.fixed);
    let carrying = grouped(all(), |a, b| a.fixed == b.fixed && carry_alike(a, b));
    let further = carrying.into_iter().filter(|g| !held.contains(g)).collect::<Vec<_>>();
    for group in held.iter().chain(&further).filter(|g| (2..=TOGETHER).contains(&g.len())) {
        forms(s, group, &mut out);
    }
    out
}

/// Whether what stands on two supports is about as stiff.
fn carry_alike(a: &Support, b: &Support) -> bool {
    let near = |(a, b): (&f64, &f64)| (a - b).abs() <= SPREAD * a.abs().max(b.abs());
    a.stiffness.iter().zip(&b.stiffness).all(near)
}

/// What a support has beside springs and dashpots.
#[derive(Clone, Copy, PartialEq)]
enum More {
    Nothing,
    /// The springs yield, at about a tenth of the largest force of the model's devices.
    Yielding {
        force: f64,
    },
    /// A mass of its own.
    Footing,
}

/// Springs and dashpots of the same size under some supports.
fn forms(s: &Sight<'_>, supports: &[&Support], out: &mut Vec<Proposal>) {
    let ndm = s.anatomy.ndm;
    let total = s.anatomy.masses.iter().map(|m| m.mass[0]).sum::<f64>();
    let (first, stiffest) =
        (supports[0], |dof: usize| supports.iter().fold(0.0, |a: f64, p| a.max(p.stiffness[dof - 1])));
    // Across the last axis, which is the vertical one; a chain along one axis has its motion there.
    let across: Vec<usize> = (1..ndm.max(2)).filter(|d| first.fixed.contains(d) && stiffest(*d) > 0.0).collect();
    let about: &[usize] = if ndm == 2 { &[3] } else { &[4, 5] };
    let rocks: Vec<usize> =
        about.iter().copied().filter(|d| first.fixed.contains(d) && first.ndf >= *d && stiffest(*d) > 0.0).collect();
    let named: Vec<String> = supports.iter().map(|p| p.node.to_string()).collect();
    let at = format!("node {}", named.join(" "));
    let mut form = |form: &str, springs: &[(&str, &[usize])], more: More| {
        let (mut block, mut added) = (vec![], vec![]);
        let scale = |dofs: &[usize]| dofs.iter().map(|d| stiffest(*d)).fold(0.0, f64::max);
        for (material, (name, dofs)) in (s.anatomy.free(Numbers::Foundation)..).step_by(2).zip(springs) {
            block.push(match more {
                More::Yielding { .. } => {
                    format!("uniaxialMaterial Steel01 {material} $hy_{name}_yield $hy_{name} $hy_{name}_hardening")
                }
                _ => format!("uniaxialMaterial Elastic {material} $hy_{name}"),
            });
            block.push(format!("uniaxialMaterial Viscous {} $hy_{name}_dashpot 1.0", material + 1));
            // Against the stiffness of what stands on it: what is much stiffer is a fixed base.
            let scale = scale(dofs);
            added.push(Added::log(name, 3e-3 * scale, 100.0 * scale, scale));
            added.push(Added::log(&format!("{name}_dashpot"), 1e-5 * scale, 0.3 * scale, 3e-3 * scale));
            if let More::Yielding { force } = more {
                added.push(Added::log(&format!("{name}_yield"), 3e-3 * force, 10.0 * force, 0.1 * force));
                added.push(Added::linear(&format!("{name}_hardening"), 0.0, 0.9, 0.1));
            }
        }
        for (support, tag) in supports.iter().zip(s.anatomy.free(Numbers::Foundation)..) {
            let (mut materials, mut directions) = (vec![], vec![]);
            block.push(format!("node {tag} {}", super::coordinates(support.node, ndm)));
            block.push(format!("fix {tag} {}", vec!["1"; support.ndf].join(" ")));
            for (material, (_, dofs)) in (s.anatomy.free(Numbers::Foundation)..).step_by(2).zip(springs) {
                for dof in *dofs {
                    let direction = if ndm == 2 && *dof == 3 { 6 } else { *dof };
                    block.push(format!("remove sp {} {dof}", support.node));
                    materials.extend([material.to_string(), (material + 1).to_string()]);
                    directions.extend([direction.to_string(), direction.to_string()]);
                }
            }
            block.push(format!(
                "element zeroLength {tag} {tag} {} -mat {} -dir {}",
                support.node,
                materials.join(" "),
                directions.join(" ")
            ));
            if more == More::Footing {
                let own = s.anatomy.masses.iter().find(|m| m.node == support.node).map_or(&[][..], |m| &m.mass);
                let mass = |i: usize| own.get(i).copied().unwrap_or(0.0);
                let words = (0..support.ndf).map(|i| match i {
                    0 => format!("[expr {{{:e}+$hy_footing}}]", mass(0)),
                    _ => format!("{:e}", mass(i)),
                });
                block.push(format!("mass {} {}", support.node, words.collect::<Vec<_>>().join(" ")));
            }
        }
        if more == More::Footing {
            added.push(Added::log("footing", 1e-3 * total, total, 0.05 * total));
        }
        out.push(Proposal::edit("foundation_flexibility", form, at.clone(), block, added));
    };
    if !across.is_empty() {
        form("horizontal spring", &[("sway", &across)], More::Nothing);
        // What softens with amplitude is seen where that differs, and below what does not soften itself.
        let force = s.scales.largest_force();
        let softens = |tag: &i32| s.anatomy.devices.iter().any(|d| d.tag == *tag && !d.linear);
        let below = supports.iter().any(|p| p.elements.iter().any(softens));
        if force > 0.0 && !below && amplitudes_differ(s.study) {
            form("horizontal spring that yields", &[("sway", &across)], More::Yielding { force });
        }
        if total > 0.0 {
            form("horizontal spring and a footing with mass", &[("sway", &across)], More::Footing);
        }
    }
    if !rocks.is_empty() {
        form("rocking spring", &[("rocking", &rocks)], More::Nothing);
    }
    if !across.is_empty() && !rocks.is_empty() {
        form("horizontal and rocking spring", &[("sway", &across), ("rocking", &rocks)], More::Nothing);
    }
}

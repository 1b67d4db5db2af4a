//! The structure above yields.

use super::{Added, Hypothesis, Proposal, Sight};
use crate::diagnose::anatomy::{Device, grouped};
use crate::diagnose::columns::Column;

/// Columns on the ground that are looked at alone, and storeys, at most.
const MOST: usize = 6;

/// Parts of the largest force of the elastic model at which something that has yielded a little may have done so: the valley is narrow,
/// for whatever yields much more or not at all moves as differently as if nothing had been found.
const NEAR_THE_LARGEST: [f64; 5] = [0.99, 0.96, 0.83, 0.75, 0.62];

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "superstructure_yielding",
    says: "the structure above, taken as elastic, yields",
    refuted_by: "the structure comes back to where it stood, and its stiffness does not fall with the amplitude",
    like: &["foundation_flexibility", "damping"],
    needs_clock: false,
    propose,
};

fn propose(s: &Sight<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for m in s.moved(true) {
        // Each alone, and all together.
        let mut sets: Vec<Vec<&Device>> = m.group.iter().map(|d| vec![*d]).collect();
        if m.group.len() > 1 {
            sets.push(m.group.clone());
        }
        for set in sets {
            let q = m.directions.iter().filter_map(|d| s.scales.of(&set, *d)).map(|x| x.q).fold(0.0, f64::max);
            let tags = super::tags(&set);
            let mut form = |form: &str, law: &str, more: Vec<Added>| {
                let line = format!("amend element {tags} {law} -force $hy_yield -hardening $hy_hardening {}", m.dir);
                let force = Added::linear("yield", 0.03 * q, 1.2 * q, 0.9 * q);
                let mut added = vec![
                    Added { also: NEAR_THE_LARGEST.map(|part| part * q).into(), ..force },
                    Added::linear("hardening", 0.0, 0.6, 0.1),
                ];
                added.extend(more);
                let at = super::named(&set);
                out.push(Proposal::edit("superstructure_yielding", form, at, vec![line], added));
            };
            form("bilinear spring", "yielding", vec![]);
            // Concrete loses stiffness, steel does not.
            let unloading = vec![Added::linear("unloading", 0.0, 0.6, 0.2)];
            form(
                "spring that reloads towards its largest deformation",
                "peakOriented -unloading $hy_unloading",
                unloading,
            );
        }
    }
    // The feet of columns: those on the ground each alone as well, of storeys all together. Those that a girder holds yield at the head
    // as well, and girders at both ends.
    let one_level = |a: &Column, b: &Column| (a.level - b.level).abs() <= 1e-6 * b.level.abs().max(1.0);
    let levels = grouped(&s.anatomy.columns, one_level);
    for (n, level) in levels.iter().take(MOST).enumerate() {
        if n == 0 && level.len() > 1 {
            out.extend(level.iter().take(MOST).filter_map(|column| hinges(s, &[*column], Ends::Foot)));
        }
        out.extend(hinges(s, level, Ends::Foot));
        let held = |c: &&Column| s.anatomy.girders.iter().any(|g| [g.node, g.head].contains(&c.head));
        if level.iter().all(held) {
            out.extend(hinges(s, level, Ends::Both));
        }
    }
    let girders: Vec<&Column> = s.anatomy.girders.iter().collect();
    out.extend(hinges(s, &girders, Ends::Both));
    out
}

/// Ends of beams at which there are hinges.
#[derive(Clone, Copy, PartialEq)]
enum Ends {
    Foot,
    Both,
}

/// Hinges at the ends of beams, about every axis of bending, all alike.
fn hinges(s: &Sight<'_>, columns: &[&Column], ends: Ends) -> Option<Proposal> {
    let moment = columns.iter().filter_map(|c| s.scales.moments.get(&c.tag)).fold(0.0, |a: f64, m| a.max(*m));
    if columns.is_empty() || moment <= 0.0 {
        return None;
    }
    let line = |columns: &[&&Column], end: &str| {
        let tags: Vec<String> = columns.iter().map(|c| c.tag.to_string()).collect();
        format!("amend element {} hinges -moment $hy_moment -hardening $hy_hardening{end}", tags.join(" "))
    };
    let block = match ends {
        Ends::Both => vec![line(&columns.iter().collect::<Vec<_>>(), "")],
        // A column may have been drawn from its head.
        Ends::Foot => {
            let (up, down): (Vec<_>, Vec<_>) = columns.iter().partition(|c| c.end == 0);
            let of = |all: Vec<_>, end| (!all.is_empty()).then(|| line(&all, end));
            of(up, " -end i").into_iter().chain(of(down, " -end j")).collect()
        }
    };
    // Against the moment that the elastic beams have.
    let strength = Added::log("moment", 0.03 * moment, 3.0 * moment, 0.9 * moment);
    let added = vec![
        Added { also: NEAR_THE_LARGEST.map(|part| part * moment).into(), ..strength },
        Added::log("hardening", 1e-3, 1.0, 0.05),
    ];
    let tags: Vec<String> = columns.iter().map(|c| c.tag.to_string()).collect();
    Some(Proposal::edit(
        "superstructure_yielding",
        "plastic hinge",
        format!("{} of element {}", if ends == Ends::Both { "both ends" } else { "foot" }, tags.join(" ")),
        block,
        added,
    ))
}

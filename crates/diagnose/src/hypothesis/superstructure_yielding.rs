//! The structure above yields.

use super::{Added, Hypothesis, Proposal, Sight};
use crate::inspect::columns::Column;
use crate::inspect::inventory::{Device, Numbers, grouped};

/// Columns on the ground that are looked at alone, and storeys, at most; springs and braces of a kind that are.
const MOST: usize = 6;
const FEW: usize = 12;

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
        // Each alone where they are few, and all together.
        let mut sets: Vec<Vec<&Device>> =
            if m.group.len() <= FEW { m.group.iter().map(|d| vec![*d]).collect() } else { vec![] };
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
    // Girders of all floors, and of each.
    let girders: Vec<&Column> = s.anatomy.girders.iter().collect();
    out.extend(hinges(s, &girders, Ends::Both));
    let floors = grouped(&s.anatomy.girders, one_level);
    if floors.len() > 1 {
        out.extend(floors.iter().take(MOST).filter_map(|floor| hinges(s, floor, Ends::Both)));
    }
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
    let stiffness = columns.iter().fold(0.0, |a: f64, c| a.max(c.rotational));
    let moment = columns.iter().filter_map(|c| s.scales.moments.get(&c.tag)).fold(0.0, |a: f64, m| a.max(*m));
    if stiffness <= 0.0 || moment <= 0.0 {
        return None;
    }
    let material = s.anatomy.free(Numbers::Hinges);
    let mut block = vec![format!(
        "uniaxialMaterial Steel02 {material} $hy_moment $hy_rotational [expr {{$hy_plastic/$hy_rotational}}] 18.0 0.925 0.15"
    )];
    // A column may have been drawn from its head.
    let (up, down): (Vec<&Column>, Vec<&Column>) =
        columns.iter().copied().partition(|c| c.end == 0 || ends == Ends::Both);
    for (some, end) in [(up, " -end i"), (down, " -end j")] {
        let end = if ends == Ends::Both { "" } else { end };
        if !some.is_empty() {
            block.push(format!("amend element {} hinges -mat {material}{end}", tags(&some)));
        }
    }
    // Against the moment that the elastic beams have, and their stiffness, of which the fitted model has given up some. From stiff
    // hinges on: one as soft as its column is no start for one that yields a little.
    let strength = Added::log("moment", 0.03 * moment, 3.0 * moment, 0.9 * moment);
    let added = vec![
        Added { also: NEAR_THE_LARGEST.map(|part| part * moment).into(), ..strength },
        Added::log("plastic", 1e-3 * stiffness, stiffness, 0.05 * stiffness),
        Added::log("rotational", 0.05 * stiffness, 100.0 * stiffness, 30.0 * stiffness),
    ];
    let at = format!("{} of element {}", if ends == Ends::Both { "both ends" } else { "foot" }, tags(columns));
    Some(Proposal::edit("superstructure_yielding", "plastic hinge", at, block, added))
}

fn tags(columns: &[&Column]) -> String {
    columns.iter().map(|c| c.tag.to_string()).collect::<Vec<_>>().join(" ")
}

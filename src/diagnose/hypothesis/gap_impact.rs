//! A gap closes.

use super::{Added, Device, Hypothesis, Moved, Proposal, Sight, named, tags};

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "gap_impact",
    says: "a gap closes: pounding, a moat wall, a stopper",
    refuted_by: "the deformation passes the gap without a peak of force or acceleration",
    like: &["strain_stiffening"],
    needs_clock: false,
    propose,
};

/// Devices of a group that are looked at each alone, at most.
const ALONE: usize = 6;

fn propose(s: &Sight<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for m in s.moved(false) {
        let sides = [("walls on both sides", 0), ("wall on the positive side", 1), ("wall on the negative side", -1)];
        for (form, side) in sides {
            for (law, power) in [("", 1.0), (", Hertz contact", 1.5)] {
                out.push(wall(&m, &m.group, &format!("{form}{law}"), (side, power)));
            }
        }
        // An abutment or a neighbour is at one place.
        for device in m.group.iter().filter(|_| (2..=ALONE).contains(&m.group.len())) {
            for (form, side) in sides {
                out.push(wall(&m, &[device], form, (side, 1.0)));
            }
        }
    }
    out
}

/// Walls beside some devices of a group that moves.
fn wall(m: &Moved<'_>, devices: &[&Device], form: &str, (side, power): (i32, f64)) -> Proposal {
    let line = format!(
        "amend element {} gap -at $hy_gap -stiffness $hy_wall -power {power} -damping $hy_damping -side {side} {}",
        tags(devices),
        m.dir
    );
    // As stiff at a fifth of the deformation.
    let k = m.stiffness() * (0.2 * m.e).powf(1.0 - power);
    let added = vec![
        Added::linear("gap", 0.05 * m.e, 1.1 * m.e, 0.7 * m.e),
        Added::log("wall", 0.5 * k, 1e4 * k, 30.0 * k),
        Added::log("damping", 1e-3 / m.v.max(1e-12), 3.0 / m.v.max(1e-12), 0.1 / m.v.max(1e-12)),
    ];
    Proposal::edit("gap_impact", form, named(devices), vec![line], added)
}

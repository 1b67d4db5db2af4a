//! A gap closes.

use super::{Added, Device, Hypothesis, Moved, Proposal, Sight, named, tags};
use crate::inspect::inventory::Numbers;
use crate::inspect::neighbours::Neighbours;
use crate::inspect::response::Extent;

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

/// A wall no farther than this part of the largest deformation would never have been called a gap (a choice).
const NEVER: f64 = 0.05;

fn propose(s: &Sight<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for m in s.moved_or_grounded() {
        let sides = [("walls on both sides", 0), ("wall on the positive side", 1), ("wall on the negative side", -1)];
        let all = Way { directions: &m.directions, across: "" };
        for (form, side) in sides {
            for (law, power) in [("", 1.0), (", Hertz contact", 1.5)] {
                out.extend(wall(s, &m, &m.group, &all, &format!("{form}{law}"), (side, power)));
            }
            // Of what moves in the plane, a wall that stands in the way of one direction.
            if let [first, second] = &m.directions[..] {
                for (direction, across) in [(first, " across the first axis"), (second, " across the second axis")] {
                    let way = Way { directions: std::slice::from_ref(direction), across };
                    out.extend(wall(s, &m, &m.group, &way, form, (side, 1.0)));
                }
            }
        }
        // An abutment or a neighbour is at one place.
        for device in m.group.iter().filter(|_| (2..=ALONE).contains(&m.group.len())) {
            for (form, side) in sides {
                out.extend(wall(s, &m, &[device], &all, form, (side, 1.0)));
            }
        }
    }
    for (n, pair) in s.anatomy.neighbours.iter().enumerate() {
        out.extend(joint(s, n, pair));
    }
    out
}

/// Directions of a device that a wall stands in the way of.
struct Way<'a> {
    directions: &'a [usize],
    across: &'static str,
}

/// Parts of the largest deformation towards a wall at which it may stand: what touches it at a few peaks only moves otherwise as if there
/// were none, and the valley is narrow (choices).
const NEAR_THE_LARGEST: [f64; 4] = [0.97, 0.9, 0.8, 0.5];

/// Walls beside some devices of a group that moves; none where nothing moves towards them.
fn wall(
    s: &Sight<'_>,
    m: &Moved<'_>,
    devices: &[&Device],
    way: &Way<'_>,
    form: &str,
    (side, power): (i32, f64),
) -> Option<Proposal> {
    let line = format!(
        "amend element {} gap -at $hy_gap -stiffness $hy_wall -power {power} -damping $hy_damping -side {side} -dir {}",
        tags(devices),
        way.directions.iter().map(usize::to_string).collect::<Vec<_>>().join(" ")
    );
    let towards = |x: Extent| match side {
        0 => x.e,
        1 => x.range[1],
        _ => -x.range[0],
    };
    let reach = way.directions.iter().filter_map(|d| s.scales.of(devices, *d)).map(towards).fold(0.0, f64::max);
    if reach <= NEVER * m.e {
        return None;
    }
    // As stiff at a fifth of the deformation.
    let k = m.stiffness() * (0.2 * m.e).powf(1.0 - power);
    let gap = Added::linear("gap", NEVER * m.e, 1.1 * m.e, 0.7 * reach);
    let gap = Added { also: NEAR_THE_LARGEST.map(|part| part * reach).into(), ..gap };
    let added = [vec![gap], contact(k, 30.0 * k, m.v)].concat();
    Some(Proposal::edit("gap_impact", &format!("{form}{}", way.across), named(devices), vec![line], added))
}

/// Stiffness and damping of a contact beside something of stiffness k that moves with a speed; where the search for the former starts.
fn contact(k: f64, start: f64, speed: f64) -> Vec<Added> {
    let slowest = speed.max(1e-12);
    vec![
        Added::log("wall", 0.5 * k, 1e4 * k, start),
        Added::log("damping", 1e-3 / slowest, 3.0 / slowest, 0.1 / slowest),
    ]
}

/// Parts of all deformations together that the joint between neighbours may be wide (choices).
const WIDE: f64 = 2.0;
const NARROW: f64 = 0.01;

/// A joint between neighbours that is too narrow. Where the model does not say on which side of the first the second stands, either.
fn joint(s: &Sight<'_>, number: usize, pair: &Neighbours) -> Vec<Proposal> {
    let lateral =
        |d: &Device| d.directions.iter().filter(|d| d.number <= 3 && !d.upright).map(|d| d.number).collect::<Vec<_>>();
    let of = |d| lateral(d).into_iter().filter_map(|n| s.scales.of(&[d], n));
    let extents: Vec<Extent> = s.anatomy.devices.iter().flat_map(of).collect();
    let reach: f64 = extents.iter().map(|x| x.e).sum();
    let Some(most) = extents.into_iter().reduce(Extent::or).filter(|x| s.anatomy.shaken && x.e > 0.0 && x.q > 0.0)
    else {
        return vec![];
    };
    let k = most.q / most.e;
    let tag = s.anatomy.free(Numbers::Joints) + number as i32;
    let [i, j] = pair.nodes;
    // Of nodes that stand apart a link knows which way they come nearer.
    let (element, sides): (_, &[i32]) = if pair.apart { ("twoNodeLink", &[-1]) } else { ("zeroLength", &[-1, 1]) };
    let one = |side: &i32| {
        // The wall is that of the amendment; the spring is there to carry it.
        let block = vec![
            format!("uniaxialMaterial Elastic {tag} {:e}", 1e-9 * k),
            format!("element {element} {tag} {i} {j} -mat {tag} -dir 1"),
            format!("amend element {tag} gap -at $hy_gap -stiffness $hy_wall -damping $hy_damping -side {side} -dir 1"),
        ];
        let gap = Added::log("gap", NARROW * reach, WIDE * reach, 0.2 * reach);
        let gap = Added { also: [0.05, 0.1, 0.4, 0.8].map(|part| part * reach).into(), ..gap };
        let added = [vec![gap], contact(k, 10.0 * k, most.v)].concat();
        let form = if *side < 0 { "neighbours touch" } else { "neighbours touch, the second on the other side" };
        Proposal::edit("gap_impact", form, format!("nodes {i} {j}"), block, added)
    };
    sides.iter().map(one).collect()
}

//! Structures that stand side by side on the same ground, or spans on the same pier, and could touch.

use crate::inspect::inventory::Device;
use hysteron_engine::model::{Model, NodeId};
use std::collections::{BTreeMap, BTreeSet};

/// Two nodes with mass of different structures at the same height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Neighbours {
    /// Tags of the nodes.
    pub nodes: [i32; 2],
    /// They stand apart, along the first axis.
    pub apart: bool,
}

/// Pairs at most; nodes that heights do not tell apart make many.
const MOST: usize = 8;
/// Heights within this part of the distance between the lowest and the highest node are the same.
const LEVEL: f64 = 0.01;

/// The pairs of a model, the highest first; none where all that has mass hangs together, but by the ground or by bearings on the same pier.
pub(crate) fn neighbours(model: &Model, devices: &[Device]) -> Vec<Neighbours> {
    let Some(ndm) = model.nodes.first().map(|n| n.ndm()) else { return vec![] };
    let (structures, spans) = (structures(model), spans(model, devices));
    let height = |n: usize| if ndm > 1 { model.nodes[n].place()[ndm - 1] } else { 0.0 };
    let heights = || (0..model.nodes.len()).map(height);
    let whole = heights().fold(f64::NEG_INFINITY, f64::max) - heights().fold(f64::INFINITY, f64::min);
    let heavy: Vec<usize> =
        (0..model.nodes.len()).filter(|n| model.nodes[*n].mass.first().is_some_and(|m| *m > 0.0)).collect();
    let mut out: Vec<(f64, Neighbours)> = vec![];
    for (i, &a) in heavy.iter().enumerate() {
        for &b in &heavy[i + 1..] {
            let [p, q] = [a, b].map(|n| model.nodes[n].place());
            // What stands beside it does so along the axis that it moves in.
            let aside = (1..ndm).any(|d| (p[d] - q[d]).abs() > LEVEL * whole);
            let tags = [a, b].map(|n| model.nodes[n].tag);
            let beside =
                structures[a] != structures[b] || spans.contains(&[tags[0].min(tags[1]), tags[0].max(tags[1])]);
            if !beside || aside {
                continue;
            }
            out.push((height(a), Neighbours { nodes: tags, apart: p[0] != q[0] }));
        }
    }
    out.sort_by(|a, b| b.0.total_cmp(&a.0));
    out.truncate(MOST);
    out.into_iter().map(|(_, pair)| pair).collect()
}

/// Nodes that nothing joins but what each of them rests on by a bearing, the lower tag first: the decks of two spans on a pier.
fn spans(model: &Model, devices: &[Device]) -> BTreeSet<[i32; 2]> {
    let mut on: BTreeMap<i32, Vec<i32>> = BTreeMap::new();
    for d in devices.iter().filter(|d| !d.linear) {
        let [i, j] = d.nodes;
        on.entry(i).or_default().push(j);
        on.entry(j).or_default().push(i);
    }
    let tag = |n: &NodeId| model.nodes[n.0].tag;
    let joined =
        |pair: &[i32; 2]| model.elements.iter().any(|e| pair.iter().all(|n| e.nodes.iter().any(|m| tag(m) == *n)));
    // What a node follows, itself among it.
    let follows = |n: i32| {
        let held = model.multi_points.iter().filter(move |m| tag(&m.constrained) == n);
        held.map(|m| tag(&m.retained)).chain([n])
    };
    let tied = |[a, b]: &[i32; 2]| follows(*a).any(|n| follows(*b).any(|m| m == n));
    let pairs = on.values().flat_map(|all| all.iter().flat_map(|a| all.iter().map(|b| [*a, *b])));
    let pairs: BTreeSet<[i32; 2]> = pairs.filter(|[a, b]| a < b).collect();
    pairs.into_iter().filter(|pair| !joined(pair) && !tied(pair)).collect()
}

/// For each node the first node of the structure that it belongs to: what elements and constraints join, but for nodes that are held
/// in all translations.
fn structures(model: &Model) -> Vec<usize> {
    let ground = |n: &NodeId| {
        let held = |dof: usize| model.fixes.iter().any(|f| f.node == *n && f.dof == dof);
        (0..model.nodes[n.0].ndm()).all(held)
    };
    let mut of: Vec<usize> = (0..model.nodes.len()).collect();
    let joined = model.elements.iter().map(|e| e.nodes.clone());
    let tied = model.multi_points.iter().map(|m| vec![m.retained, m.constrained]);
    for nodes in joined.chain(tied) {
        let mut free = nodes.iter().filter(|n| !ground(n));
        let Some(first) = free.next() else { continue };
        for n in free {
            let (a, b) = (of[first.0], of[n.0]);
            let (one, other) = (a.min(b), a.max(b));
            of.iter_mut().filter(|s| **s == other).for_each(|s| *s = one);
        }
    }
    of
}

#[cfg(test)]
mod tests {
    use super::Neighbours;
    use crate::inspect::probe::tests::anatomy_of;

    #[test]
    fn what_hangs_together_by_the_ground_alone_stands_side_by_side() {
        let seen = |link: &str| {
            let text = format!(
                "model basic -ndm 2 -ndf 3
                foreach {{n x y}} {{1 0. 0. 2 0. 3. 3 0. 6. 4 5. 0. 5 5. 3. 6 5. 7.}} {{node $n $x $y}}
                foreach n {{1 4}} {{fix $n 1 1 1}}
                foreach n {{2 3 5 6}} {{mass $n 1. 1. 0.}}
                geomTransf Linear 1
                foreach {{e i j}} {{1 1 2 2 2 3 3 4 5 4 5 6 {link}}} {{element elasticBeamColumn $e $i $j 1. 1e3 1. 1}}
                timeSeries Constant 2
                pattern UniformExcitation 2 1 -accel 2
                constraints Plain; numberer Plain; system FullGeneral; algorithm Linear
                integrator Newmark 0.5 0.25
                analysis Transient
                analyze 2 0.01\n"
            );
            anatomy_of(&text).neighbours
        };
        assert_eq!(seen(""), [Neighbours { nodes: [2, 5], apart: true }]);
        // A beam between the roofs makes one structure of them.
        assert_eq!(seen("9 3 6"), []);
    }

    #[test]
    fn decks_on_one_pier_stand_side_by_side() {
        let seen = |bearing: &str| {
            let text = format!(
                "model basic -ndm 1 -ndf 1
                foreach n {{1 2 3 4}} {{node $n 0.}}
                fix 1 1
                foreach n {{2 3 4}} {{mass $n 1.}}
                uniaxialMaterial Elastic 1 1e3
                uniaxialMaterial {bearing}
                foreach {{e i j m}} {{1 1 2 1 2 2 3 2 3 2 4 2}} {{element zeroLength $e $i $j -mat $m -dir 1}}
                timeSeries Constant 2
                pattern UniformExcitation 2 1 -accel 2
                constraints Plain; numberer Plain; system FullGeneral; algorithm Linear
                integrator Newmark 0.5 0.25
                analysis Transient
                analyze 2 0.01\n"
            );
            anatomy_of(&text).neighbours
        };
        assert_eq!(seen("ElasticPP 2 1e3 0.01"), [Neighbours { nodes: [3, 4], apart: false }]);
        // Storeys of springs are no spans.
        assert_eq!(seen("Elastic 2 1e3"), []);
    }
}

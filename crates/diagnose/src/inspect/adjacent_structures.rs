//! Structures on the same ground, and spans on the same pier, that could collide.

use crate::inspect::heights::HeightRule;
use crate::inspect::inventory::Device;
use hysteron_engine::model::{Model, NodeId};
use std::collections::{BTreeMap, BTreeSet};

/// Two nodes with mass of different structures at the same height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct AdjacentNodes {
    /// Tags of the nodes.
    pub(crate) nodes: [i32; 2],
    /// True if the nodes have a distance along the first axis.
    pub(crate) separated: bool,
}

/// Largest number of pairs. Models in plan have many, because heights do not separate their nodes.
const MAX_PAIRS: usize = 8;

/// The adjacent nodes of a model, the highest first.
///
/// Empty if all nodes with mass belong to one structure. The ground does not join structures; bearings on a common pier
/// do not join the spans that they carry.
pub(crate) fn adjacent_nodes(model: &Model, devices: &[Device]) -> Vec<AdjacentNodes> {
    let Some(ndm) = model.nodes.first().map(|n| n.ndm()) else { return vec![] };
    let (structures, spans) = (structures(model), spans(model, devices));
    let height = |n: usize| if ndm > 1 { model.nodes[n].place()[ndm - 1] } else { 0.0 };
    let heights = HeightRule::of_model(model);
    let with_mass: Vec<usize> =
        (0..model.nodes.len()).filter(|n| model.nodes[*n].mass.first().is_some_and(|m| *m > 0.0)).collect();
    let mut out: Vec<(f64, AdjacentNodes)> = vec![];
    for (i, &a) in with_mass.iter().enumerate() {
        for &b in &with_mass[i + 1..] {
            let [p, q] = [a, b].map(|n| model.nodes[n].place());
            // Adjacent structures collide along the first axis.
            let offset = (1..ndm).any(|d| !heights.are_equal(p[d], q[d]));
            let tags = [a, b].map(|n| model.nodes[n].tag);
            let beside =
                structures[a] != structures[b] || spans.contains(&[tags[0].min(tags[1]), tags[0].max(tags[1])]);
            if !beside || offset {
                continue;
            }
            out.push((height(a), AdjacentNodes { nodes: tags, separated: p[0] != q[0] }));
        }
    }
    out.sort_by(|a, b| b.0.total_cmp(&a.0));
    out.truncate(MAX_PAIRS);
    out.into_iter().map(|(_, pair)| pair).collect()
}

/// Pairs of nodes that only bearings on a common node join, the lower tag first: decks of two spans on one pier.
fn spans(model: &Model, devices: &[Device]) -> BTreeSet<[i32; 2]> {
    let mut neighbours_of: BTreeMap<i32, Vec<i32>> = BTreeMap::new();
    for d in devices.iter().filter(|d| !d.linear) {
        let [i, j] = d.nodes;
        neighbours_of.entry(i).or_default().push(j);
        neighbours_of.entry(j).or_default().push(i);
    }
    let tag = |n: &NodeId| model.nodes[n.0].tag;
    let joined =
        |pair: &[i32; 2]| model.elements.iter().any(|e| pair.iter().all(|n| e.nodes.iter().any(|m| tag(m) == *n)));
    // The nodes that a node is constrained to, and itself.
    let followed = |n: i32| {
        let held = model.multi_points.iter().filter(move |m| tag(&m.constrained) == n);
        held.map(|m| tag(&m.retained)).chain([n])
    };
    let constrained_together = |[a, b]: &[i32; 2]| followed(*a).any(|n| followed(*b).any(|m| m == n));
    let pairs = neighbours_of.values().flat_map(|all| all.iter().flat_map(|a| all.iter().map(|b| [*a, *b])));
    let pairs: BTreeSet<[i32; 2]> = pairs.filter(|[a, b]| a < b).collect();
    pairs.into_iter().filter(|pair| !joined(pair) && !constrained_together(pair)).collect()
}

/// Index of the first node of the structure to which each node belongs.
///
/// Elements and constraints join nodes to structures. Nodes fixed in all translations join nothing.
fn structures(model: &Model) -> Vec<usize> {
    let ground = |n: &NodeId| {
        let held = |dof: usize| model.fixes.iter().any(|f| f.node == *n && f.dof == dof);
        (0..model.nodes[n.0].ndm()).all(held)
    };
    let mut of: Vec<usize> = (0..model.nodes.len()).collect();
    let joined = model.elements.iter().map(|e| e.nodes.clone());
    let constraints = model.multi_points.iter().map(|m| vec![m.retained, m.constrained]);
    for nodes in joined.chain(constraints) {
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
    use super::AdjacentNodes;
    use crate::inspect::probe::tests::inventory_of;

    #[test]
    fn structures_that_only_the_ground_joins_are_adjacent() {
        let found = |link: &str| {
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
            inventory_of(&text).adjacent
        };
        assert_eq!(found(""), [AdjacentNodes { nodes: [2, 5], separated: true }]);
        // A beam between the roofs joins both structures.
        assert_eq!(found("9 3 6"), []);
    }

    #[test]
    fn decks_on_one_pier_are_adjacent() {
        let found = |bearing: &str| {
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
            inventory_of(&text).adjacent
        };
        assert_eq!(found("ElasticPP 2 1e3 0.01"), [AdjacentNodes { nodes: [3, 4], separated: false }]);
        // Elastic springs are storeys, not bearings.
        assert_eq!(found("Elastic 2 1e3"), []);
    }
}

//! Levels of a structure, and the elements between them.

use super::place::level_of_elements;
use crate::inspect::heights::HeightRule;
use crate::inspect::inventory::{ModelInventory, Support};
use std::collections::{BTreeMap, VecDeque};

/// Level of each node: its height, or its distance from the supports in elements where nothing has a height.
#[derive(Clone, Debug, Default)]
pub(super) struct Levels {
    nodes: BTreeMap<i32, f64>,
    rule: HeightRule,
}

impl Levels {
    /// Levels of a model.
    pub(super) fn of(inventory: &ModelInventory) -> Self {
        let heights = inventory.vertical_axis().map(|axis| -> BTreeMap<i32, f64> {
            inventory.coordinates.iter().filter_map(|(tag, x)| Some((*tag, *x.get(axis)?))).collect()
        });
        let rises = |h: &BTreeMap<i32, f64>| inventory.heights.range.1 > inventory.heights.range.0 && !h.is_empty();
        let nodes = heights.filter(rises).unwrap_or_else(|| distances(inventory));
        let rule = HeightRule::of(nodes.values().copied());
        Self { nodes, rule }
    }

    /// Level of a node; none where no element leads to it.
    pub(super) fn node(&self, tag: i32) -> Option<f64> {
        self.nodes.get(&tag).copied()
    }

    pub(super) fn are_equal(&self, a: f64, b: f64) -> bool {
        self.rule.are_equal(a, b)
    }

    /// True if the second of two nodes is not below the first.
    pub(super) fn rises(&self, [first, second]: [i32; 2]) -> bool {
        self.node(first).zip(self.node(second)).is_none_or(|(a, b)| b >= a)
    }

    /// Elements that reach from below a level to it or above it, by tag.
    pub(super) fn crossing(&self, level: f64, inventory: &ModelInventory) -> Vec<i32> {
        let reaches = |nodes: &[i32]| {
            let levels = || nodes.iter().filter_map(|n| self.node(*n));
            let is_below = |l: f64| l < level && !self.are_equal(l, level);
            levels().any(is_below) && levels().any(|l| !is_below(l))
        };
        inventory.element_nodes.iter().filter(|(_, nodes)| reaches(nodes)).map(|(tag, _)| *tag).collect()
    }

    /// A place with the level of its elements in parentheses, if their nodes tell it.
    pub(super) fn with_level(&self, place: &str, elements: &[i32], inventory: &ModelInventory) -> String {
        let level = level_of_elements(elements, inventory);
        if level.is_empty() { place.to_owned() } else { format!("{place} ({level})") }
    }
}

/// Numbers of elements from the supports to each node.
fn distances(inventory: &ModelInventory) -> BTreeMap<i32, f64> {
    let mut neighbours: BTreeMap<i32, Vec<i32>> = BTreeMap::new();
    for nodes in inventory.element_nodes.values() {
        for n in nodes {
            neighbours.entry(*n).or_default().extend(nodes.iter().filter(|m| *m != n));
        }
    }
    let is_support = |s: &&Support| s.fixed.len() >= inventory.ndm;
    let mut found: BTreeMap<i32, f64> = BTreeMap::new();
    let mut next: VecDeque<(i32, f64)> = inventory.supports.iter().filter(is_support).map(|s| (s.node, 0.0)).collect();
    while let Some((node, distance)) = next.pop_front() {
        if found.contains_key(&node) {
            continue;
        }
        found.insert(node, distance);
        next.extend(neighbours.get(&node).into_iter().flatten().map(|n| (*n, distance + 1.0)));
    }
    found
}

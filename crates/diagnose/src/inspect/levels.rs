//! Levels at which a structure can be parted from what stands on them.

use super::inventory::ModelInventory;
use std::collections::BTreeMap;

/// A level with mass and elements above it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Level {
    /// Nodes that carry elements above, with the tags of these.
    pub(crate) carriers: Vec<(i32, Vec<i32>)>,
    /// Mass of all nodes above in their first degree of freedom.
    pub(crate) mass_above: f64,
}

impl ModelInventory {
    /// Levels between the supports and the top, the lowest first. Heights part them, or the number of elements down to a support
    /// where the model has no heights.
    pub(crate) fn levels(&self) -> Vec<Level> {
        let ranks = self.ranks();
        let is_support = |node: &i32| self.supports.iter().any(|s| s.node == *node && s.fixed.len() >= self.ndm);
        let carried = self.masses.iter().filter(|m| !is_support(&m.node));
        let mut heights: Vec<f64> = carried.filter_map(|m| ranks.get(&m.node)).copied().collect();
        heights.sort_by(f64::total_cmp);
        heights.dedup_by(|a, b| self.is_one_level(*a, *b));
        heights.into_iter().filter_map(|height| self.level(&ranks, height)).collect()
    }

    /// The level of a rank; none with nothing above it, and where an element goes past it.
    fn level(&self, ranks: &BTreeMap<i32, f64>, height: f64) -> Option<Level> {
        let side = |node: &i32| match ranks.get(node) {
            Some(rank) if self.is_one_level(*rank, height) => 0,
            Some(rank) if *rank > height => 1,
            _ => -1,
        };
        let mut carriers: BTreeMap<i32, Vec<i32>> = BTreeMap::new();
        for (tag, nodes) in &self.element_nodes {
            let has = |wanted: i32| nodes.iter().any(|n| side(n) == wanted);
            if has(1) && has(-1) {
                return None;
            }
            if has(1) {
                nodes.iter().filter(|n| side(n) == 0).for_each(|n| carriers.entry(*n).or_default().push(*tag));
            }
        }
        let mass_above = self.masses.iter().filter(|m| side(&m.node) == 1).map(|m| m.mass[0]).sum();
        (!carriers.is_empty()).then(|| Level { carriers: carriers.into_iter().collect(), mass_above })
    }

    fn is_one_level(&self, a: f64, b: f64) -> bool {
        a == b || self.vertical_axis().is_some() && self.heights.are_equal(a, b)
    }

    /// Heights of nodes, or their numbers of elements down to a support.
    fn ranks(&self) -> BTreeMap<i32, f64> {
        if let Some(axis) = self.vertical_axis() {
            return self.coordinates.iter().map(|(tag, x)| (*tag, x[axis])).collect();
        }
        let supports = self.supports.iter().filter(|s| s.fixed.len() >= self.ndm);
        let mut ranks: BTreeMap<i32, f64> = supports.map(|s| (s.node, 0.0)).collect();
        loop {
            let lowest = |nodes: &Vec<i32>| nodes.iter().filter_map(|n| ranks.get(n).copied()).reduce(f64::min);
            let mut next: Vec<(i32, f64)> = vec![];
            for nodes in self.element_nodes.values() {
                let Some(lowest) = lowest(nodes) else { continue };
                next.extend(nodes.iter().filter(|n| !ranks.contains_key(n)).map(|n| (*n, lowest + 1.0)));
            }
            if next.is_empty() {
                return ranks;
            }
            // Of several ways down the shortest counts.
            next.sort_by(|a, b| a.0.cmp(&b.0).then(b.1.total_cmp(&a.1)));
            ranks.extend(next);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Level;
    use crate::test_support::shaken_inventory;

    /// Floors of a frame part it, its roof does not; nor does a floor that a column goes past.
    #[test]
    fn floors_part_a_frame() {
        let levels = |more: &str| -> Vec<Level> {
            shaken_inventory(&format!(
                "model basic -ndm 2 -ndf 3
                foreach {{n x y}} {{1 0. 0. 2 5. 0. 3 0. 3. 4 5. 3. 5 0. 6. 6 5. 6.}} {{node $n $x $y -mass 2. 2. 0.}}
                foreach n {{1 2}} {{fix $n 1 1 1}}
                geomTransf Linear 1
                foreach {{e i j}} {{1 1 3 2 2 4 3 3 5 4 4 6 5 3 4 6 5 6 {more}}} {{
                    element elasticBeamColumn $e $i $j 1. 1e3 1. 1
                }}"
            ))
            .levels()
        };
        let floor = Level { carriers: vec![(3, vec![3]), (4, vec![4])], mass_above: 4.0 };
        assert_eq!(levels(""), [floor]);
        assert!(levels("7 1 6").is_empty());
    }

    /// A chain without heights is parted at each mass but its last.
    #[test]
    fn a_chain_is_parted_by_its_order() {
        let chain = shaken_inventory(
            "model basic -ndm 1 -ndf 1
            node 1 0.; foreach n {2 3 4} {node $n 0. -mass 1.}
            fix 1 1; uniaxialMaterial Elastic 1 100.
            foreach {e i j} {1 1 2 2 3 2 3 3 4} {element zeroLength $e $i $j -mat 1 -dir 1}",
        );
        let at = |node, element, mass_above| Level { carriers: vec![(node, vec![element])], mass_above };
        assert_eq!(chain.levels(), [at(2, 2, 2.0), at(3, 3, 1.0)]);
    }
}

//! Quantities that the runs of a study record, so that no advice asks for them again.

use super::place::Place;
use super::residual_force::{element_of, is_acceleration, node_of};
use crate::hypothesis::declaration::Recordable;
use crate::inspect::conditions::recorded_column;
use crate::inspect::inventory::ModelInventory;
use hysteron_identify::study::unit::{self, Quantity};
use hysteron_identify::study::{ObservedChannel, Run, Study};

/// Channels of a study with the columns of the model that they are compared with.
pub(super) struct RecordedQuantities<'a> {
    pub(super) study: &'a Study,
    pub(super) inventory: &'a ModelInventory,
    /// Names of the observed columns by run: "node 3 dof 1", "element 2 force".
    pub(super) columns: &'a [Vec<String>],
}

/// Distance of places that counts as none, in parts of the extent of the model.
const EQUAL_PLACE: f64 = 0.01;

fn is_of(o: &ObservedChannel, quantity: Quantity) -> bool {
    unit::unit(&o.unit).is_some_and(|u| u.quantity == quantity)
}

impl RecordedQuantities<'_> {
    /// True if every run has a quantity, at a place where it has one.
    pub(super) fn has(&self, what: Recordable, place: &Place) -> bool {
        let in_run = |(number, run): (usize, &Run)| match what {
            Recordable::Temperature => {
                let is_temperature = |u: &str| unit::unit(u).is_some_and(|u| u.quantity == Quantity::Temperature);
                recorded_column(run, "temp").is_some() || run.recording.columns.iter().any(|c| is_temperature(&c.unit))
            }
            Recordable::AxialForce => recorded_column(run, "axial").is_some() || run.number("axial").is_some(),
            Recordable::Deformation => self
                .channels(number)
                .any(|(o, c)| is_of(o, Quantity::Length) && self.is_at(c, place) && self.vertical_of(c) != Some(true)),
            Recordable::VerticalDeformation => self
                .channels(number)
                .any(|(o, c)| is_of(o, Quantity::Length) && self.is_at(c, place) && self.vertical_of(c) == Some(true)),
            Recordable::Acceleration => self.channels(number).any(|(o, c)| is_acceleration(o) && self.is_at(c, place)),
            Recordable::EdgesOfFloor => self.shows_edges(number),
            Recordable::BothHorizontal => self.shows_both_directions(number),
        };
        !self.study.runs.is_empty() && self.study.runs.iter().enumerate().all(in_run)
    }

    /// Channels of a run with their columns.
    fn channels(&self, run: usize) -> impl Iterator<Item = (&ObservedChannel, &str)> {
        let columns = self.columns.get(run).into_iter().flatten().map(String::as_str);
        self.study.runs[run].observe.iter().zip(columns)
    }

    fn is_at(&self, column: &str, place: &Place) -> bool {
        match (node_of(column), element_of(column)) {
            (Some((node, _)), _) => place.nodes.iter().any(|n| n.tag == node),
            (_, Some(element)) => place.elements.contains(&element),
            _ => false,
        }
    }

    /// True if a column is along the vertical axis; none where it is no component of a node.
    fn vertical_of(&self, column: &str) -> Option<bool> {
        let (_, dof) = node_of(column)?;
        Some(self.inventory.ndm > 1 && self.inventory.vertical_axis() == Some(dof - 1))
    }

    fn shows_edges(&self, run: usize) -> bool {
        let places: Vec<(usize, &Vec<f64>)> = self
            .channels(run)
            .filter(|(o, _)| is_acceleration(o))
            .filter_map(|(_, c)| node_of(c))
            .filter_map(|(node, dof)| Some((dof, self.inventory.coordinates.get(&node)?)))
            .collect();
        let axis = self.inventory.vertical_axis();
        let near = |a: f64, b: f64| (a - b).abs() <= EQUAL_PLACE * self.inventory.extent;
        let are_edges = |a: &(usize, &Vec<f64>), b: &(usize, &Vec<f64>)| {
            let same_level = axis.is_none_or(|v| match (a.1.get(v), b.1.get(v)) {
                (Some(a), Some(b)) => self.inventory.heights.are_equal(*a, *b),
                _ => false,
            });
            a.0 == b.0 && same_level && a.1.iter().zip(b.1).any(|(a, b)| !near(*a, *b))
        };
        places.iter().enumerate().any(|(i, a)| places[..i].iter().any(|b| are_edges(a, b)))
    }

    fn shows_both_directions(&self, run: usize) -> bool {
        let horizontal = |dof: &usize| (1..=self.inventory.ndm).contains(dof);
        let mut along: Vec<usize> = self
            .channels(run)
            .filter(|(_, c)| self.vertical_of(c) == Some(false))
            .filter_map(|(_, c)| Some(node_of(c)?.1))
            .filter(horizontal)
            .collect();
        along.sort_unstable();
        along.dedup();
        let forces = |tag: i32| {
            let lateral = self.inventory.devices.iter().find(|d| d.tag == tag).map_or(0, |d| {
                let across = d.directions.iter().filter(|d| d.number <= 3 && !d.along_last_axis);
                across.count()
            });
            let shown = self.channels(run).filter(|(o, c)| o.is_resistance() && element_of(c) == Some(tag)).count();
            lateral > 1 && shown > 1
        };
        along.len() > 1 || self.channels(run).filter_map(|(_, c)| element_of(c)).any(forces)
    }
}

#[cfg(test)]
mod tests {
    use super::{Recordable, RecordedQuantities};
    use crate::inspect::inventory::ModelInventory;
    use crate::test_support::pad_study;
    use crate::verdict::place::{NodePlace, Place};
    use hysteron_identify::study::Study;

    /// A study whose runs have some channels: name and unit.
    fn study(channels: &[(&str, &str)]) -> Study {
        let mut study = pad_study();
        for r in &mut study.runs {
            let first = r.observe[0].clone();
            let one = |(name, unit): &(&str, &str)| {
                let mut o = first.clone();
                (o.channel, o.unit) = ((*name).into(), (*unit).into());
                o
            };
            r.observe = channels.iter().map(one).collect();
        }
        study
    }

    /// A floor of two nodes above two supports.
    fn floor() -> ModelInventory {
        let mut out = ModelInventory::default();
        let at = |x: f64, z: f64| vec![x, 0.0, z];
        out.coordinates = [(1, at(0.0, 0.0)), (2, at(0.0, 3.0)), (3, at(8.0, 3.0))].into();
        (out.ndm, out.extent) = (3, 9.0);
        out
    }

    fn has(what: Recordable, channels: &[(&str, &str)], columns: &[&str], nodes: &[i32]) -> bool {
        let (study, inventory) = (study(channels), floor());
        let of_run: Vec<String> = columns.iter().map(|c| (*c).to_owned()).collect();
        let columns = vec![of_run; study.runs.len()];
        let nodes = nodes.iter().map(|tag| NodePlace { tag: *tag, coordinates: vec![] }).collect();
        let place = Place { nodes, ..Place::default() };
        RecordedQuantities { study: &study, inventory: &inventory, columns: &columns }.has(what, &place)
    }

    #[test]
    fn a_displacement_is_recorded_at_its_node_and_in_its_direction() {
        use Recordable::{Acceleration, Deformation, VerticalDeformation};
        let drift = [("drift", "mm")];
        assert!(has(Deformation, &drift, &["node 2 dof 1"], &[1, 2]));
        assert!(!has(Deformation, &drift, &["node 3 dof 1"], &[1, 2]));
        assert!(!has(Deformation, &drift, &["node 2 dof 3"], &[1, 2]));
        assert!(has(VerticalDeformation, &drift, &["node 2 dof 3"], &[1, 2]));
        assert!(!has(Acceleration, &drift, &["node 2 dof 1"], &[1, 2]));
        assert!(has(Acceleration, &[("acc", "g")], &["node 2 dof 1"], &[1, 2]));
    }

    #[test]
    fn edges_of_a_floor_and_two_directions_need_two_channels() {
        use Recordable::{BothHorizontal, EdgesOfFloor};
        let two = [("a", "m/s2"), ("b", "m/s2")];
        assert!(has(EdgesOfFloor, &two, &["node 2 dof 1", "node 3 dof 1"], &[]));
        assert!(!has(EdgesOfFloor, &two, &["node 2 dof 1", "node 3 dof 2"], &[]));
        assert!(!has(EdgesOfFloor, &two, &["node 1 dof 1", "node 2 dof 1"], &[]));
        assert!(has(BothHorizontal, &two, &["node 2 dof 1", "node 2 dof 2"], &[]));
        assert!(!has(BothHorizontal, &two, &["node 2 dof 1", "node 2 dof 3"], &[]));
        assert!(!has(BothHorizontal, &two[..1], &["node 2 dof 1"], &[]));
    }
}

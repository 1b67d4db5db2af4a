//! Errors drawn on the structure: its elements as lines, and a dot for each sensor by the error there.

use super::place::Place;
use crate::inspect::inventory::ModelInventory;
use hysteron_identify::report::html::line;
use hysteron_opensees::chart::{Curve, Figure, Mark};
use std::collections::BTreeMap;

type Point = (f64, f64);

/// Elements and sensors of a structure on paper.
#[derive(Clone, Debug, Default)]
pub struct StructureDrawing {
    /// Ends of elements by tag: the outline of those with more than two nodes.
    elements: BTreeMap<i32, Vec<Point>>,
    /// Place of each observed channel, by run; none where it is not at a node or an element.
    sensors: Vec<Vec<Option<Point>>>,
}

/// Largest number of elements that are drawn. Of a larger model every n-th is.
const MAX_ELEMENTS: usize = 3000;
/// Classes of the NMSE of a sensor, in the order of the colours of charts: blue, red, green.
const CLASSES: [(&str, f64, f64); 3] =
    [("NMSE below 0.01", 0.0, 0.01), ("over 0.1", 0.1, f64::INFINITY), ("0.01 to 0.1", 0.01, 0.1)];
/// Slopes of the horizontal axes on paper: what runs away from the reader goes up by this much.
const ACROSS: f64 = 0.87;
const AWAY: f64 = 0.3;

/// A point on paper: of a plane as it is, of space from a corner above.
fn on_paper(x: &[f64]) -> Point {
    match *x {
        [x, y, z, ..] => (ACROSS * (x - y), z + AWAY * (x + y)),
        [x, y] => (x, y),
        [x] => (x, 0.0),
        [] => (0.0, 0.0),
    }
}

/// Tag that follows a word at the beginning of the name of a column.
fn tag_after(label: &str, word: &str) -> Option<i32> {
    label.strip_prefix(word)?.split_whitespace().next()?.parse().ok()
}

impl StructureDrawing {
    /// A model, and the columns of its recorders that are observed, by run: "node 3 dof 1", "element 2 force".
    pub(super) fn new(inventory: &ModelInventory, columns: &[Vec<String>]) -> Self {
        let node = |tag: &i32| inventory.coordinates.get(tag).map(|x| on_paper(x));
        let ends = |nodes: &Vec<i32>| {
            let mut points: Vec<Point> = nodes.iter().filter_map(node).collect();
            if points.len() > 2 {
                points.push(points[0]);
            }
            points
        };
        let every = inventory.element_nodes.len().div_ceil(MAX_ELEMENTS).max(1);
        let drawn = inventory.element_nodes.iter().step_by(every);
        let place = |label: &String| {
            if let Some(tag) = tag_after(label, "node ") {
                return node(&tag);
            }
            let nodes = inventory.element_nodes.get(&tag_after(label, "element ")?)?;
            let points: Vec<Point> = nodes.iter().filter_map(node).collect();
            let n = points.len() as f64;
            let sum = points.into_iter().reduce(|a, b| (a.0 + b.0, a.1 + b.1))?;
            Some((sum.0 / n, sum.1 / n))
        };
        Self {
            elements: drawn.map(|(tag, nodes)| (*tag, ends(nodes))).collect(),
            sensors: columns.iter().map(|run| run.iter().map(place).collect()).collect(),
        }
    }

    /// Errors of the channels, `nmse` by run and channel; the largest of those at one place. None for a model in one place.
    pub(super) fn figure(&self, title: &str, places: &[Place], nmse: impl Fn(usize, usize) -> f64) -> Option<Figure> {
        let ends = || self.elements.values().flatten();
        let first = ends().next()?;
        let is_one_place = ends().all(|p| p == first);
        let mut errors: Vec<(Point, f64)> = vec![];
        for (run, sensors) in self.sensors.iter().enumerate() {
            let known = sensors.iter().enumerate().filter_map(|(k, p)| Some(((*p)?, nmse(run, k))));
            for (place, error) in known.filter(|(_, error)| error.is_finite()) {
                match errors.iter_mut().find(|(p, _)| *p == place) {
                    Some((_, largest)) => *largest = largest.max(error),
                    None => errors.push((place, error)),
                }
            }
        }
        if is_one_place || errors.is_empty() {
            return None;
        }
        const GAP: Point = (f64::NAN, f64::NAN);
        let lines = |of: &mut dyn Iterator<Item = &Vec<Point>>| -> Vec<Point> {
            of.flat_map(|points| points.iter().copied().chain([GAP])).collect()
        };
        let mut curves = vec![Curve { mark: Mark::Wide, ..line("", lines(&mut self.elements.values())) }];
        for (name, low, high) in CLASSES {
            let points = errors.iter().filter(|(_, e)| (low..high).contains(e)).map(|(p, _)| *p).collect();
            curves.push(Curve { mark: Mark::Dots, ..line(name, points) });
        }
        let changed = places.iter().flat_map(|p| &p.elements).filter_map(|tag| self.elements.get(tag));
        let changed = lines(&mut changed.filter(|points| points.windows(2).any(|w| w[0] != w[1])));
        if !changed.is_empty() {
            curves.push(line("changed by the repair", changed));
        }
        let (x_label, y_label) = ("length".into(), "height".into());
        Some(Figure { title: title.into(), x_label, y_label, equal: true, curves, ..Figure::default() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frame() -> ModelInventory {
        let coordinates = [(1, vec![0.0, 0.0]), (2, vec![0.0, 3.0]), (3, vec![4.0, 3.0])];
        let element_nodes = [(1, vec![1, 2]), (2, vec![2, 3])];
        let mut out = ModelInventory::default();
        (out.ndm, out.coordinates, out.element_nodes) = (2, coordinates.into(), element_nodes.into());
        out
    }

    #[test]
    fn sensors_have_the_place_of_their_node_or_element_and_the_largest_error_there() {
        let columns =
            [vec!["node 2 dof 1".to_owned(), "element 2 N_1".into(), "node 9 dof 1".into(), "node 2 dof 2".into()]];
        let drawing = StructureDrawing::new(&frame(), &columns);
        let errors = [0.001, 0.05, 7.0, 0.3];
        let place = Place { elements: vec![2], ..Place::default() };
        let figure = drawing.figure("errors", &[place], |_, k| errors[k]).expect("a figure");
        let of = |name: &str| &figure.curves.iter().find(|c| c.name == name).expect(name).points;
        assert_eq!(*of("over 0.1"), [(0.0, 3.0)]);
        assert_eq!(*of("0.01 to 0.1"), [(2.0, 3.0)]);
        assert!(of("NMSE below 0.01").is_empty());
        assert_eq!(of("changed by the repair")[..2], [(0.0, 3.0), (4.0, 3.0)]);
    }

    #[test]
    fn a_bearing_between_two_nodes_at_one_place_has_no_drawing() {
        let mut bearing = frame();
        bearing.coordinates = [(1, vec![0.0, 0.0]), (2, vec![0.0, 0.0])].into();
        bearing.element_nodes = [(1, vec![1, 2])].into();
        let drawing = StructureDrawing::new(&bearing, &[vec!["node 2 dof 1".into()]]);
        assert!(drawing.figure("errors", &[], |_, _| 0.5).is_none());
    }
}

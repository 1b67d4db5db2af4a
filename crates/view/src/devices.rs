//! Deformations and forces of bearings, links and springs at every step.

use crate::history::History;
use crate::scene::{Family, Scene};
use hysteron_engine::analysis::Engine;
use hysteron_engine::element::Snapshot;
use hysteron_engine::model::ElementId;
use hysteron_engine::probe::Probe;

/// Direction of a deformation of a device.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    /// Along its axis.
    Axial,
    /// Across its axis.
    Shear,
    /// A rotation.
    Rotation,
}

/// A device whose loops are kept.
#[derive(Clone, Debug)]
pub(crate) struct Device {
    /// Place of the element.
    pub(crate) element: usize,
    /// Name and role of each direction.
    pub(crate) directions: Vec<(String, Role)>,
    deformation: Probe,
    force: Probe,
    /// Deformations of all directions, then forces.
    pub(crate) history: History,
}

const BASIC: [(&str, Role); 6] = [
    ("axial", Role::Axial),
    ("shear y", Role::Shear),
    ("shear z", Role::Shear),
    ("torsion", Role::Rotation),
    ("rotation y", Role::Rotation),
    ("rotation z", Role::Rotation),
];

impl Device {
    /// Devices of a model, at most `most`: bearings first, then links, then trusses.
    pub(crate) fn all(engine: &Engine, scene: &Scene, most: usize) -> Vec<Self> {
        let of = |family: Family| {
            let places = scene.elements.iter().enumerate().filter(move |(_, e)| e.family == family);
            places.filter_map(|(i, _)| Self::new(engine, scene, i))
        };
        [Family::Bearing, Family::Link, Family::Truss].into_iter().flat_map(of).take(most).collect()
    }

    fn new(engine: &Engine, scene: &Scene, at: usize) -> Option<Self> {
        let element = &engine.model().elements[at].element;
        let force = ["basicForce", "axialForce"].iter().find_map(|w| element.probe(&[w]))?;
        let deformation = ["basicDeformation", "deformation"].iter().find_map(|w| element.probe(&[w]))?;
        if force.len() != deformation.len() || force.is_empty() {
            return None;
        }
        let basic = |indices: &[usize]| indices.iter().map(|i| (BASIC[*i].0.to_owned(), BASIC[*i].1)).collect();
        let directions = match (scene.elements[at].family, force.len()) {
            (Family::Bearing, 3) => basic(&[0, 1, 5]),
            (Family::Bearing, 6) => basic(&[0, 1, 2, 3, 4, 5]),
            (Family::Truss, 1) => basic(&[0]),
            _ => springs(engine, scene, at, force.len()),
        };
        let history = History::new(2 * directions.len());
        Some(Self { element: at, directions, deformation, force, history })
    }

    pub(crate) fn step(&mut self, engine: &Engine, step: usize, buffers: &mut (Vec<f64>, Vec<f64>)) {
        self.read(engine, buffers);
        self.history.push(step, buffers.1.iter().copied());
    }

    /// Deformations of all directions, then forces, in the committed state: in the second buffer.
    pub(crate) fn read(&self, engine: &Engine, buffers: &mut (Vec<f64>, Vec<f64>)) {
        let (disp, row) = buffers;
        let n = self.directions.len();
        row.clear();
        row.resize(2 * n, 0.0);
        let snapshot = engine.snapshot(ElementId(self.element), disp);
        let element = &engine.model().elements[self.element].element;
        element.read(&self.deformation.path, &snapshot, &mut row[..n]);
        element.read(&self.force.path, &snapshot, &mut row[n..]);
    }
}

/// Directions of springs: the vertical one is axial, as that of a bearing made of springs.
fn springs(engine: &Engine, scene: &Scene, at: usize, count: usize) -> Vec<(String, Role)> {
    let element = &engine.model().elements[at].element;
    let mut numbers = vec![0.0; count];
    match element.probe(&["directions"]).filter(|p| p.len() == count) {
        Some(probe) => {
            let none = Snapshot { disp: &[], state: &[], force: &[], load: &[] };
            element.read(&probe.path, &none, &mut numbers);
        }
        None => numbers.iter_mut().enumerate().for_each(|(i, n)| *n = i as f64 + 1.0),
    }
    let vertical = if scene.ndm == 3 { 2 } else { 1 };
    let is_vertical = |direction: usize| {
        let axis = scene.elements[at].axes.and_then(|axes| axes.get(direction).copied());
        axis.is_some_and(|a| a[vertical].abs() > 0.9)
    };
    let moves_across = numbers.iter().filter(|n| **n <= 3.0).count() > 1;
    let name = |number: &f64| {
        let direction = (*number as usize).saturating_sub(1);
        match direction {
            0..3 => {
                let role = if moves_across && is_vertical(direction) { Role::Axial } else { Role::Shear };
                (format!("local {}", ["x", "y", "z"][direction]), role)
            }
            _ => (format!("about {}", ["x", "y", "z"][(direction - 3).min(2)]), Role::Rotation),
        }
    };
    numbers.iter().map(name).collect()
}

//! The model that the script of a study makes, before its first transient analysis.

use super::before_transient::run_to_transient;
use super::shear_test::{BilinearLoop, shear_test};
use super::study::Study;
use crate::mistake::{Mistake, key};
use hysteron_engine::analysis::Engine;
use hysteron_engine::element::Mass;
use hysteron_engine::model::{ElementId, Model};
use hysteron_opensees::run::Run;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Differences of elevation, as a share of the height of the model, within which nodes are of one floor.
const LEVEL: f64 = 1.0e-6;

/// A bearing of the model.
#[derive(Clone, Debug)]
pub(super) struct ScriptBearing {
    /// Tag.
    pub(super) tag: i64,
    /// Index of its type in the study.
    pub(super) kind: usize,
    id: ElementId,
    /// Class of the element, as OpenSees names it.
    pub(super) class: &'static str,
    /// Axial force under gravity, compression positive.
    pub(super) gravity: f64,
    /// Elevation of its upper node.
    elevation: f64,
    /// Elevation of its second node above its first one.
    pub(super) rise: f64,
    /// File and line of the script that made it; empty if they are not known.
    pub(super) line: String,
}

/// The model under gravity.
pub(super) struct ScriptModel {
    run: Run,
    /// Bearings in the order of the study.
    pub(super) bearings: Vec<ScriptBearing>,
    /// Horizontal mass and elevation of each node.
    masses: Vec<[f64; 2]>,
    height: f64,
}

impl ScriptModel {
    /// Run the script at a bound and an eccentricity.
    ///
    /// # Errors
    /// The script fails before its first transient analysis, or a bearing of the study is none: it is missing, or has other
    /// than two nodes.
    pub(super) fn new(
        study: &Study,
        bound: &'static str,
        eccentricity: usize,
        stop: &Arc<AtomicBool>,
    ) -> Result<Self, Mistake> {
        let run = run_to_transient(study, bound, eccentricity, stop)?;
        let engine = &run.interp.host.engine;
        let model = engine.model();
        let mut bearings = vec![];
        for (kind, b) in study.bearings.iter().enumerate() {
            for (i, &tag) in b.tags.iter().enumerate() {
                let wrong = |e| Mistake::new(key!["bearing", kind, "tags", i], format!("{} {tag} {e}", b.name));
                let mut found = bearing(engine, kind, tag).map_err(wrong)?;
                let made_at = i32::try_from(tag).ok().and_then(|t| run.interp.host.builder.made_at.get(&t));
                found.line = made_at.map_or(String::new(), |span| {
                    let at = run.interp.sources.location(*span);
                    format!("{}:{}", at.name, at.line)
                });
                bearings.push(found);
            }
        }
        let masses = masses(model);
        let (low, high) = masses.iter().fold((f64::MAX, f64::MIN), |(low, high), m| (low.min(m[1]), high.max(m[1])));
        Ok(Self { run, bearings, masses, height: high - low })
    }

    /// Horizontal mass at and above the lowest upper node of the bearings.
    pub(super) fn mass_above(&self) -> f64 {
        let lowest = self.bearings.iter().map(|b| b.elevation).fold(f64::MAX, f64::min);
        let above = self.masses.iter().filter(|m| m[1] >= lowest - LEVEL * self.height);
        above.map(|m| m[0]).sum()
    }

    /// Horizontal mass below the lowest upper node of the bearings.
    pub(super) fn mass_below(&self) -> f64 {
        self.masses.iter().map(|m| m[0]).sum::<f64>() - self.mass_above()
    }

    /// Value of a global variable that is a number.
    pub(super) fn variable(&mut self, name: &str) -> Option<f64> {
        self.run.interp.get_var(&format!("::{name}")).ok()?.to_f64().ok().filter(|x| x.is_finite())
    }

    /// Tags and moduli of the laws of steel that no element takes directly: those of sections.
    pub(super) fn steel_of_sections(&self) -> Vec<(i32, f64)> {
        let builder = &self.run.interp.host.builder;
        let materials = &builder.definitions.materials;
        let taken = builder.materials_of_elements();
        let tags = materials.tags().filter(|tag| !taken.contains(tag));
        let steel = tags.filter_map(|tag| Some((tag, materials.get(tag)?)).filter(|(_, m)| m.name().contains("Steel")));
        steel.map(|(tag, m)| (tag, m.initial_tangent())).collect()
    }

    /// Horizontal mass of the nodes at the elevation of a node.
    pub(super) fn mass_at(&self, node: i64) -> Option<f64> {
        let model = self.run.interp.host.engine.model();
        let id = i32::try_from(node).ok().and_then(|t| model.node(t))?;
        let elevation = *model.nodes[id.0].coords.last()?;
        let level = self.masses.iter().filter(|m| (m[1] - elevation).abs() <= LEVEL * self.height);
        Some(level.map(|m| m[0]).sum())
    }

    /// Elevation of a node.
    pub(super) fn elevation(&self, node: i64) -> Option<f64> {
        let model = self.run.interp.host.engine.model();
        let id = i32::try_from(node).ok().and_then(|t| model.node(t))?;
        model.nodes[id.0].coords.last().copied()
    }

    /// Center of the mass at and above the lowest upper node of the bearings; none in a plane model, or without mass.
    pub(super) fn center_of_mass(&self) -> Option<[f64; 2]> {
        let model = self.run.interp.host.engine.model();
        let lowest = self.bearings.iter().map(|b| b.elevation).fold(f64::MAX, f64::min);
        let (mut sum, mut moment) = (0.0, [0.0; 2]);
        for ([mass, elevation], node) in self.masses.iter().zip(&model.nodes) {
            let [x, y, _] = node.coords[..] else { return None };
            if *elevation >= lowest - LEVEL * self.height {
                sum += mass;
                moment = [moment[0] + mass * x, moment[1] + mass * y];
            }
        }
        (sum > 0.0).then(|| moment.map(|m| m / sum))
    }

    /// Horizontal extent of the bearings' upper nodes; none in a plane model.
    pub(super) fn grid(&self) -> Option<[f64; 2]> {
        let model = self.run.interp.host.engine.model();
        let extent = |k: usize| {
            let x = self.bearings.iter().map(|b| model.nodes[model.elements[b.id.0].nodes[1].0].coords.clone());
            let all: Option<Vec<f64>> = x.map(|c| (c.len() == 3).then(|| c[k])).collect();
            let all = all?;
            Some(all.iter().copied().fold(f64::MIN, f64::max) - all.iter().copied().fold(f64::MAX, f64::min))
        };
        Some([extent(0)?, extent(1)?])
    }

    /// The model.
    pub(super) fn model(&self) -> &Model {
        self.run.interp.host.engine.model()
    }

    /// Dimensions of space.
    pub(super) fn dimensions(&self) -> usize {
        self.model().nodes.first().map_or(0, |n| n.coords.len())
    }

    /// Least horizontal distance of two bearings that do not stand in one place; none without two.
    pub(super) fn spacing(&self) -> Option<f64> {
        let model = self.model();
        let place = |b: &ScriptBearing| {
            let coords = &model.nodes[model.elements[b.id.0].nodes[1].0].coords;
            coords[..coords.len() - 1].to_vec()
        };
        let places: Vec<Vec<f64>> = self.bearings.iter().map(place).collect();
        let distance = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
        let all = places.iter().enumerate().flat_map(|(i, a)| places[..i].iter().map(move |b| distance(a, b)));
        all.filter(|d| *d > LEVEL * self.height.max(1.0)).reduce(f64::min)
    }

    /// Axial forces of all bearings under gravity together.
    pub(super) fn gravity(&self) -> f64 {
        self.bearings.iter().map(|b| b.gravity).sum()
    }

    /// Test a bearing by itself in the first direction.
    ///
    /// # Errors
    /// Those of [`shear_test`].
    pub(super) fn test(&self, bearing: &ScriptBearing, amplitude: f64, period: f64) -> Result<BilinearLoop, String> {
        shear_test(&self.run.interp.host.engine, bearing.id, 0, amplitude, period)
    }

    /// The bearing of a type with the median of their axial forces.
    pub(super) fn typical(&self, kind: usize) -> Option<&ScriptBearing> {
        let mut all: Vec<&ScriptBearing> = self.bearings.iter().filter(|b| b.kind == kind).collect();
        all.sort_by(|a, b| a.gravity.total_cmp(&b.gravity));
        all.get(all.len() / 2).copied()
    }
}

fn bearing(engine: &Engine, kind: usize, tag: i64) -> Result<ScriptBearing, String> {
    let model = engine.model();
    let id = i32::try_from(tag).ok().and_then(|t| model.element(t));
    let id = id.ok_or("is no element of the script")?;
    let entry = &model.elements[id.0];
    let [lower, upper] = entry.nodes[..] else {
        return Err(format!("has {} nodes: expected 2", entry.nodes.len()));
    };
    let node = &model.nodes[upper.0];
    if node.ndm() < 2 {
        return Err("stands in a model without a vertical direction".into());
    }
    let mut force = vec![];
    engine.element_force(id, &mut force);
    let gravity = -force[force.len() / 2 + node.ndm() - 1];
    let elevation = node.coords[node.ndm() - 1];
    let rise = elevation - model.nodes[lower.0].coords.last().copied().unwrap_or(elevation);
    let class = entry.element.class().name;
    Ok(ScriptBearing { tag, kind, id, class, gravity, elevation, rise, line: String::new() })
}

/// Mass in the first direction and elevation of each node. A row of a consistent mass matrix counts for its node.
pub(super) fn masses(model: &Model) -> Vec<[f64; 2]> {
    let mut all: Vec<[f64; 2]> = model
        .nodes
        .iter()
        .map(|n| [n.mass.first().copied().unwrap_or(0.0), n.coords.last().copied().unwrap_or(0.0)])
        .collect();
    for e in &model.elements {
        let n = e.element.dofs();
        let per_node = n / e.nodes.len().max(1);
        for (k, node) in e.nodes.iter().enumerate() {
            let row = k * per_node;
            all[node.0][0] += match e.element.mass() {
                Mass::None => 0.0,
                Mass::Lumped(m) => m[row],
                // A unit acceleration of all nodes in the first direction.
                Mass::Consistent(m) => (0..e.nodes.len()).map(|j| m[row * n + j * per_node]).sum(),
            };
        }
    }
    all
}

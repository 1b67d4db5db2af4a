//! Floors of a building that have no mass along a ground motion.

use crate::checks;
use crate::watch::overview::short;
use hysteron_engine::analysis::Engine;
use hysteron_engine::element::Mass;
use hysteron_engine::model::{Model, NodeId, PatternKind};
use hysteron_tcl::diagnostic::Diagnostic;
use std::collections::BTreeSet;

/// Relative difference in height of nodes at one floor.
const LEVEL: f64 = 1e-6;
/// Distance of a mass from its floor, as a share of the smallest height of a storey.
const NEAR: f64 = 0.25;
/// Floors with mass from which on the model is a building, and no bridge with a cap beam below its deck.
const MIN_FLOORS: usize = 2;

/// The vertical axis of a model and a horizontal direction of its ground motions.
fn axes(model: &Model) -> Option<(usize, usize)> {
    let ndm = model.nodes.iter().map(|n| n.ndm()).max().filter(|n| *n > 1)?;
    let moves = |direction: usize| {
        model.patterns.values().any(|p| matches!(&p.kind, PatternKind::Uniform(e) if e.direction == direction))
    };
    // In space the second axis is vertical where the ground moves along the third and not along the second.
    let axis = if ndm == 3 && (moves(1) || !moves(2)) { 2 } else { 1 };
    (0..ndm).find(|d| *d != axis && moves(*d)).map(|direction| (axis, direction))
}

/// Heights of the floors in ascending order, with a node of each: levels at which a beam or a diaphragm joins free nodes.
fn floors(model: &Model, axis: usize, direction: usize) -> Vec<(f64, NodeId)> {
    let place = |n: NodeId| model.nodes[n.0].place();
    let held: BTreeSet<NodeId> = model.fixes.iter().filter(|f| f.dof == direction).map(|f| f.node).collect();
    let beams = model.elements.iter().filter(|e| e.element.class().name.contains("Beam"));
    let beams = beams.filter_map(|e| if let [i, j] = e.nodes[..] { Some((i, j)) } else { None });
    let ties = model.multi_points.iter().filter(|m| m.constrained_dofs.contains(&direction));
    let joined = ties.map(|m| (m.retained, m.constrained)).chain(beams).filter(|(i, j)| {
        let d = place(*j) - place(*i);
        d.norm() > 0.0 && d[axis].abs() <= LEVEL * d.norm() && !held.contains(i)
    });
    let mut found: Vec<(f64, NodeId)> = joined.map(|(i, _)| (place(i)[axis], i)).collect();
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    let extent = found.last().zip(found.first()).map_or(0.0, |(top, bottom)| top.0 - bottom.0);
    found.dedup_by(|b, a| b.0 - a.0 <= LEVEL * extent);
    found
}

/// Heights of the masses that move along a direction.
fn heights_of_masses(model: &Model, axis: usize, direction: usize) -> Vec<f64> {
    let height = |n: &NodeId| model.nodes[n.0].place()[axis];
    let nodes = model.nodes.iter().filter(|n| n.mass.get(direction).is_some_and(|m| *m != 0.0));
    let elements = model.elements.iter().filter(|e| !matches!(e.element.mass(), Mass::None));
    nodes.map(|n| n.place()[axis]).chain(elements.flat_map(|e| e.nodes.iter().map(height))).collect()
}

/// A warning of a floor without mass, where other floors have one and a ground motion acts on the model.
pub(super) fn finding(engine: &Engine) -> Option<Diagnostic> {
    let model = engine.model();
    let (axis, direction) = axes(model)?;
    let floors = floors(model, axis, direction);
    let storey = floors.windows(2).map(|pair| pair[1].0 - pair[0].0).fold(f64::INFINITY, f64::min);
    let masses = heights_of_masses(model, axis, direction);
    let has_mass = |floor: &&(f64, NodeId)| masses.iter().any(|height| (height - floor.0).abs() <= NEAR * storey);
    let (with, without): (Vec<_>, Vec<_>) = floors.iter().partition(has_mass);
    let (height, node) = without.first().filter(|_| with.len() >= MIN_FLOORS)?;
    let message = format!(
        "the floor at height {}, with node {}, has no mass along {}; {} floors have one",
        short(*height),
        model.nodes[node.0].tag,
        direction + 1,
        with.len()
    );
    let d =
        Diagnostic::warning(&checks::analysis::FLOOR_WITHOUT_MASS, message).label("the ground motion does not move it");
    Some(d.help("\"mass\" of its nodes, or a density of its elements, gives it one"))
}

//! Bearings that a ground motion finds without the weight that they should carry.

use crate::checks;
use hysteron_engine::analysis::Engine;
use hysteron_engine::element::Bearing;
use hysteron_engine::model::{ElementEntry, Model, NodeId, PatternKind, Tag};
use hysteron_tcl::diagnostic::Diagnostic;

/// Returns true if the weight matters: a bearing slides, or a structure stands on the bearings. A mass on rubber alone is a study
/// of its law, which needs no weight.
fn needs_weight(model: &Model, bearings: &[(&ElementEntry, usize)]) -> bool {
    bearings.iter().any(|(e, _)| e.element.bearing() == Some(Bearing::Sliding))
        || model.elements.iter().any(|e| e.element.bearing().is_none())
}

/// The vertical axis of a bearing whose upper node may sink. `None` for one that lies along the first axis, or is held.
fn vertical_axis(engine: &Engine, e: &ElementEntry) -> Option<usize> {
    let stiffness = engine.axis_stiffness(e.tag)?;
    let axis = (1..3).max_by(|i, j| stiffness[*i].total_cmp(&stiffness[*j]))?;
    let is_held = |node: &NodeId| engine.model().fixes.iter().any(|f| f.node == *node && f.dof == axis);
    (stiffness[axis] > stiffness[0] && !e.nodes.iter().all(is_held)).then_some(axis)
}

/// Returns true if a pattern has loads along an axis, or loads of elements. An acceleration without an end is gravity.
fn has_load_along(model: &Model, axis: usize) -> bool {
    model.patterns.values().any(|p| {
        let gravity = matches!(&p.kind, PatternKind::Uniform(e) if e.direction == axis && e.accel.end().is_none());
        let moves = p.motions.iter().any(|m| m.dof == axis && m.value != 0.0 && m.ground.is_none());
        let loads = p.nodal_loads.iter().any(|l| l.values.get(axis).is_some_and(|v| *v != 0.0));
        gravity || moves || loads || !p.element_loads.is_empty()
    })
}

/// A warning of bearings without vertical load, where a ground motion acts on the model.
pub(super) fn finding(engine: &Engine) -> Option<Diagnostic> {
    let model = engine.model();
    let (pattern, _) = model.patterns.iter().find(|(_, p)| matches!(p.kind, PatternKind::Uniform(_)))?;
    let bearings = model.elements.iter().filter(|e| e.element.bearing().is_some());
    let bearings: Vec<(&ElementEntry, usize)> = bearings.filter_map(|e| Some((e, vertical_axis(engine, e)?))).collect();
    let is_loaded = |(e, axis): &(&ElementEntry, usize)| {
        let force = &engine.state().force[e.force.clone()];
        has_load_along(model, *axis) || force.get(e.element.dofs() / 2 + axis).is_some_and(|f| *f != 0.0)
    };
    if bearings.iter().any(is_loaded) || !needs_weight(model, &bearings) {
        return None;
    }
    let axis = bearings.first()?.1 + 1;
    let tags: Vec<Tag> = bearings.iter().map(|(e, _)| e.tag).collect();
    let which = match tags[..] {
        [one] => format!("bearing {one} carries"),
        [first, .., last] => format!("the {} bearings, elements {first} to {last}, carry", tags.len()),
        [] => return None,
    };
    let message = format!("the ground motion of pattern {pattern} begins while {which} no load along {axis}");
    let d = Diagnostic::warning(&checks::analysis::NO_GRAVITY, message)
        .label("expected a static analysis of the weight before");
    Some(d.help("hold the weight with \"loadConst -time 0.0\": sliders have no friction without it"))
}

//! Supports that the motion of the ground reaches later than the others.
//!
//! Displacements of a model under a uniform excitation are relative to the ground. A support with a delay moves against it by
//! the difference of the delayed motion and the motion itself.

use crate::args::Args;
use crate::checks;
use crate::text::Arg;
use crate::{Outcome, Tcl, finish};
use hysteron_engine::model::{Ground, GroundMotion, Model, NodeId, PatternKind, SupportMotion, Tag};
use hysteron_engine::series::{Delayed, Series};
use hysteron_tcl::diagnostic::Diagnostic;
use hysteron_tcl::{Exception, Value};
use std::sync::Arc;

const DELAY: Arg = Arg::number("delay", "delay of the support");

/// Option with the delay.
const OPTION: &str = "-by";

/// A support with its delay.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LateSupport {
    node: Tag,
    /// Delay, s; negative for a support that the motion reaches earlier.
    delay: f64,
}

/// `amend node $tag late -by $delay`, behind the name of the amendment: the uniform excitations of the model, and those that
/// follow, reach a support later.
pub(crate) fn late(interp: &mut Tcl, a: &mut Args<'_>, node: NodeId) -> Outcome {
    if !a.flag(OPTION) {
        return Err(a.refuse_at(a.next_span(), "the delay of the support is missing", "expected -by and a time"));
    }
    let delay = a.number(&DELAY)?;
    finish(interp, a)?;
    let model = interp.host.engine.model();
    let support = LateSupport { node: model.nodes[node.0].tag, delay };
    let is_uniform = |kind: &PatternKind| matches!(kind, PatternKind::Uniform(_));
    let uniform: Vec<Tag> = model.patterns.iter().filter(|(_, p)| is_uniform(&p.kind)).map(|(tag, _)| *tag).collect();
    for tag in uniform {
        move_late(interp, a, support, tag)?;
    }
    interp.host.builder.late_supports.push(support);
    Ok(Value::EMPTY)
}

/// Moves the late supports under a uniform excitation that has been made.
pub(crate) fn move_late_supports(interp: &mut Tcl, a: &Args<'_>, pattern: Tag) -> Result<(), Exception> {
    for support in interp.host.builder.late_supports.clone() {
        move_late(interp, a, support, pattern)?;
    }
    Ok(())
}

/// Moves a late support under a uniform excitation, against the ground.
fn move_late(interp: &mut Tcl, a: &Args<'_>, support: LateSupport, pattern: Tag) -> Result<(), Exception> {
    let model = interp.host.engine.model();
    let Some(PatternKind::Uniform(excitation)) = model.patterns.get(&pattern).map(|p| &p.kind) else { return Ok(()) };
    // A support that has been removed moves no more.
    let Some(id) = model.node(support.node) else { return Ok(()) };
    let (dof, node, tag) = (excitation.direction, &model.nodes[id.0], support.node);
    if dof >= node.ndm() {
        let label = "expected translations of the ground alone";
        return Err(a.refuse("a support is late, and the ground turns", label));
    }
    if dof >= node.ndf || !model.fixes.iter().any(|f| f.node == id && f.dof == dof) {
        let message = format!("node {tag} is no support in direction {}", dof + 1);
        return Err(a.refuse(message, "expected a node that is fixed in the direction of the excitation"));
    }
    if model.patterns.values().flat_map(|p| &p.motions).any(|m| m.node == id && m.dof == dof) {
        let message = format!("node {tag} is moved in direction {} by another pattern", dof + 1);
        return Err(a.refuse(message, "expected one motion of a late support"));
    }
    let motion = difference(&excitation.accel, excitation.influence, support.delay).ok_or_else(|| {
        let label = "expected a series of points, which has an end";
        a.refuse(format!("node {tag} is a late support, and the excitation has no end"), label)
    })?;
    let ground = Some(Ground { motion, rates: true });
    let tag = interp.host.sp_tag();
    interp.host.engine.change_model(|m| {
        if let Some(p) = m.patterns.get_mut(&pattern) {
            p.motions.push(SupportMotion { node: id, dof, value: 1.0, constant: false, initial: 0.0, tag, ground });
        }
    });
    Ok(())
}

/// A late support of a model that no uniform excitation moves.
pub(crate) fn finding(late: &[LateSupport], model: &Model) -> Option<Diagnostic> {
    let support = late.first()?;
    if model.patterns.values().any(|p| matches!(p.kind, PatternKind::Uniform(_))) {
        return None;
    }
    let message = format!("node {} is a late support, and no uniform excitation moves the model", support.node);
    Some(Diagnostic::warning(&checks::load::LATE_WITHOUT_MOTION, message))
}

/// The delayed motion less the motion; `None` for one without an end.
fn difference(accel: &Series, factor: f64, delay: f64) -> Option<GroundMotion> {
    accel.end()?;
    let dt = accel.step().unwrap_or(1e-2);
    let of = |accel: Series, factor: f64| GroundMotion::from_series([None, None, Some(accel)], dt, factor);
    let delayed = of(Arc::new(Delayed { of: accel.clone(), by: delay }), factor)?;
    Some(GroundMotion::Interpolated(vec![(1.0, delayed), (-1.0, of(accel.clone(), factor)?)]))
}

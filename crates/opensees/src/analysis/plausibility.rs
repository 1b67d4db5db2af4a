//! Warnings about analyses that run and mean nothing: each comes once, with a place.

use super::{massless_floors, unloaded_bearings};
use crate::checks;
use crate::host::Mode;
use crate::load::late_support;
use crate::session::Session;
use crate::{Tcl, warn};
use hysteron_engine::analysis::{Engine, Kind};
use hysteron_engine::element::Overload;
use hysteron_engine::model::{ElementId, Model, Pattern, PatternKind, Tag};
use hysteron_engine::series::Series;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::{Diagnostic, Span};
use std::collections::BTreeSet;

/// A step over that of a record from which on the analysis does not follow the record. OpenSees' users thin records by two to
/// four.
const MAX_STEP_RATIO: f64 = 4.5;
/// Part of the largest displacement by which a constraint may be missed.
const MAX_LOOSENESS: f64 = 0.01;
/// Steps beyond this part over the stable one grow. The power iteration finds the frequency to a thousandth.
const STABILITY_MARGIN: f64 = 1.001;
/// Work beyond this that a step of the model may take for its highest frequency.
const MAX_EQUATIONS: usize = 200_000;

/// Warn of what an analysis cannot mean, before its first step. `dt` is its step of time.
pub(crate) fn before(interp: &mut Tcl, dt: f64, span: Option<Span>) -> Result<(), Exception> {
    // What follows from a mistake that a check has reported is no news.
    if interp.host.mode == Mode::Check && interp.host.check.rejected {
        return Ok(());
    }
    let state = (interp.host.engine.model().revision(), dt);
    if interp.host.analysis_checks.before == Some(state) {
        return Ok(());
    }
    interp.host.analysis_checks.before = Some(state);
    fixed_and_tied(interp, span)?;
    growing_pattern(interp, dt, span)?;
    if interp.host.kind() != Some(Kind::Transient) {
        return static_ground_motion(interp, span);
    }
    excitations(interp, dt, span)?;
    let engine = &interp.host.engine;
    let late = late_support::finding(&interp.host.builder.late_supports, engine.model());
    let forgotten = [unloaded_bearings::finding(engine), massless_floors::finding(engine), late];
    forgotten.into_iter().flatten().try_for_each(|d| warn_once(interp, d.place(span)))?;
    stability(interp, dt, span)
}

/// Warn of what the committed state of an analysis cannot mean.
pub(crate) fn after(interp: &mut Tcl, span: Option<Span>) -> Result<(), Exception> {
    if interp.host.mode == Mode::Check {
        return Ok(());
    }
    excess(interp, span)?;
    loose_constraint(interp, span)?;
    let session = &mut interp.host;
    session.analysis_checks.largest_displacement =
        session.analysis_checks.largest_displacement.max(session.engine.largest_displacement());
    buckled_beam(interp, span)?;
    match interp.host.output.recorders.isolator_damping.warning(span) {
        Some(d) => warn_once(interp, d),
        None => Ok(()),
    }
}

/// Returns true if [`after`] has nothing to look at more closely.
pub(crate) fn is_plausible(session: &mut Session) -> bool {
    (session.engine.excess.is_none() || session.warnings.has(&checks::analysis::EXCESS))
        && session.engine.loose_constraint(MAX_LOOSENESS, session.analysis_checks.largest_displacement).is_none()
        && euler_loads(session, |engine, loads| engine.buckled_beam(loads).is_none())
        && !session.output.recorders.isolator_damping.is_suspect()
}

/// Look at the Euler loads of the beams, which are worked out once for a revision of the model.
fn euler_loads<T>(session: &mut Session, look: impl FnOnce(&Engine, &[(ElementId, f64)]) -> T) -> T {
    let Session { engine, analysis_checks: checks, .. } = session;
    let revision = engine.model().revision();
    if checks.euler_loads.as_ref().is_none_or(|(of, _)| *of != revision) {
        checks.euler_loads = Some((revision, engine.euler_loads()));
    }
    look(engine, checks.euler_loads.as_ref().map_or(&[], |(_, loads)| loads))
}

/// Warn once in a script for each check.
fn warn_once(interp: &mut Tcl, warning: Diagnostic) -> Result<(), Exception> {
    let is_first = warning.check.is_none_or(|check| interp.host.warnings.note(check));
    if is_first { warn(interp, warning) } else { Ok(()) }
}

/// A degree of freedom that is held and follows another one, which is not held.
fn fixed_and_tied(interp: &mut Tcl, span: Option<Span>) -> Result<(), Exception> {
    let model = interp.host.engine.model();
    if interp.host.warnings.has(&checks::analysis::FIXED_AND_TIED) || model.multi_points.is_empty() {
        return Ok(());
    }
    let held: BTreeSet<_> = model.fixes.iter().map(|f| (f.node, f.dof)).collect();
    let contradiction = model.multi_points.iter().find_map(|m| {
        let rows = m.constrained_dofs.iter().enumerate().filter(|(_, dof)| held.contains(&(m.constrained, **dof)));
        let mut free = rows.filter(|(i, _)| m.row(*i).any(|(dof, c)| c != 0.0 && !held.contains(&(m.retained, dof))));
        free.next().map(|(_, dof)| (model.nodes[m.constrained.0].tag, dof + 1, model.nodes[m.retained.0].tag))
    });
    let Some((node, dof, retained)) = contradiction else { return Ok(()) };
    let message =
        format!("node {node} is held in degree of freedom {dof}, and a constraint ties it to node {retained} too");
    let d = Diagnostic::warning(&checks::analysis::FIXED_AND_TIED, message).at(span, "expected one of both");
    warn_once(interp, d.help(format!("hold node {retained}, which node {node} follows")))
}

/// Steps ahead at which a factor that has only grown is that of a load which grows without end.
const STEPS_AHEAD: f64 = 1000.0;

/// A pattern whose static loads are not held and grow on in the analysis that follows.
///
/// In a check also one that follows a path: a run tells of it where a step fails.
fn growing_pattern(interp: &mut Tcl, dt: f64, span: Option<Span>) -> Result<(), Exception> {
    let Session { engine, analysis_checks: checks, mode, .. } = &mut interp.host;
    let (model, time) = (engine.model(), engine.state().time);
    let Some(setup) = engine.setup() else { return Ok(()) };
    let plain = |p: &Pattern| matches!(p.kind, PatternKind::Plain { .. }) && p.held.is_none() && p.has_loads();
    let going = || model.patterns.iter().filter(|(_, p)| plain(p)).map(|(tag, _)| *tag);
    if setup.kind == Kind::Static && setup.integrator.elapses() {
        checks.static_patterns = going().collect();
        return Ok(());
    }
    let has_new = going().any(|tag| !checks.static_patterns.contains(&tag));
    if setup.kind == Kind::Static && (*mode == Mode::Run || !has_new) {
        return Ok(());
    }
    let step = if dt > 0.0 { dt } else { 1.0 };
    let grows = |tag: &Tag| {
        let pattern = &model.patterns[tag];
        let at = |steps: f64| pattern.factor(time + steps * step).abs();
        at(0.0) < at(1.0) && at(1.0) < at(STEPS_AHEAD) && series(pattern).is_none_or(|s| s.end().is_none())
    };
    let Some(tag) = going().filter(|tag| checks.static_patterns.contains(tag)).find(grows) else { return Ok(()) };
    let factor = model.patterns[&tag].factor(time);
    let message = format!(
        "pattern {tag} still grows with the time: its factor is {factor} after the static analysis, and is not held"
    );
    let d = Diagnostic::warning(&checks::load::GROWING_PATTERN, message)
        .at(span, "expected \"loadConst -time 0.0\" before this");
    warn_once(interp, d)
}

/// The series of the ground motions or loads of a pattern that go on.
fn series(pattern: &Pattern) -> Option<&Series> {
    match &pattern.kind {
        _ if pattern.held.is_some() => None,
        PatternKind::Uniform(e) => Some(&e.accel),
        PatternKind::Plain { series, .. } if !(pattern.nodal_loads.is_empty() && pattern.motions.is_empty()) => {
            Some(series)
        }
        _ => None,
    }
}

/// Excitations that are over, that move no mass, or that the steps do not follow.
fn excitations(interp: &mut Tcl, dt: f64, span: Option<Span>) -> Result<(), Exception> {
    let mut warnings: Vec<Diagnostic> = vec![];
    let session = &mut interp.host;
    let (engine, checks) = (&session.engine, &mut session.analysis_checks);
    let (model, time): (&Model, f64) = (engine.model(), engine.state().time);
    for (tag, pattern) in &model.patterns {
        let is_new = checks.patterns.insert(*tag);
        let Some(series) = series(pattern) else { continue };
        if let Some(end) = series.end().filter(|end| is_new && *end > series.start() && time >= *end) {
            let message =
                format!("the series of pattern {tag} ends at time {end:.6}, and the analysis begins at {time:.6}");
            let d = Diagnostic::warning(&checks::load::RECORD_IS_OVER, message)
                .at(span, "the record is over before it begins");
            warnings.push(d.help("\"loadConst -time 0.0\" after the gravity loads sets the time"));
        }
        let PatternKind::Uniform(e) = &pattern.kind else { continue };
        if !engine.has_mass_along(e.direction) {
            let message =
                format!("pattern {tag} moves the ground along {}, where the model has no mass", e.direction + 1);
            let d = Diagnostic::warning(&checks::load::NO_MASS, message).at(span, "the excitation has no effect");
            warnings.push(d.help("\"mass\" of nodes, or a density of elements, gives it one"));
        }
        if let Some(step) = series.step().filter(|step| dt > MAX_STEP_RATIO * step) {
            let message =
                format!("the steps of {dt} are {:.1} times those of the record of pattern {tag}, {step}", dt / step);
            let d =
                Diagnostic::warning(&checks::load::COARSE_STEPS, message).at(span, "most of the record is passed over");
            warnings.push(d.help("expected steps not longer than those of the record"));
        }
    }
    warnings.into_iter().try_for_each(|d| warn_once(interp, d))
}

/// A record of a ground motion under a static analysis. A series without an end may be gravity.
fn static_ground_motion(interp: &mut Tcl, span: Option<Span>) -> Result<(), Exception> {
    let (model, time) = (interp.host.engine.model(), interp.host.engine.state().time);
    let shakes = |p: &Pattern| {
        matches!(p.kind, PatternKind::Uniform(_)) && series(p).and_then(|s| s.end()).is_some_and(|end| time < end)
    };
    let Some((tag, _)) = model.patterns.iter().find(|(_, p)| shakes(p)) else { return Ok(()) };
    let message = format!("a static analysis runs under the ground motion of pattern {tag}");
    let d = Diagnostic::warning(&checks::analysis::STATIC_GROUND_MOTION, message)
        .at(span, "no mass moves and nothing damps: expected \"analysis Transient\"");
    warn_once(interp, d.help("gravity comes before the command \"pattern UniformExcitation\""))
}

/// An explicit integrator beyond its stable step.
fn stability(interp: &mut Tcl, dt: f64, span: Option<Span>) -> Result<(), Exception> {
    let session = &mut interp.host;
    let setup = session.engine.setup();
    let Some((name, limit)) = setup.and_then(|s| Some((s.integrator.name(), s.integrator.stability_limit()?))) else {
        return Ok(());
    };
    let state = (session.engine.model().revision(), dt);
    let is_known = session.analysis_checks.stability.is_some_and(|known| known.0 == state.0 && known.1 >= dt);
    // Under --compat elements may depend on the number of their calls.
    let is_exempt = session.follows(&[]) || session.mode == Mode::Check;
    if is_known
        || is_exempt
        || session.warnings.has(&checks::analysis::UNSTABLE_STEPS)
        || session.engine.model().dofs() > MAX_EQUATIONS
    {
        return Ok(());
    }
    session.analysis_checks.stability = Some(state);
    let Some(lambda) = session.engine.largest_eigenvalue() else { return Ok(()) };
    let stable = limit / lambda.sqrt();
    if dt <= STABILITY_MARGIN * stable {
        return Ok(());
    }
    let message =
        format!("{name} is explicit and unstable with steps of {dt}: its longest stable step is {stable:.4e}");
    let d = Diagnostic::warning(&checks::analysis::UNSTABLE_STEPS, message)
        .at(span, format!("expected steps up to {stable:.4e}"));
    warn_once(
        interp,
        d.help(format!("the highest frequency of the model is {:.4e} rad per unit of time", lambda.sqrt())),
    )
}

/// A response beyond what the model can mean, which has not ended the analysis.
fn excess(interp: &mut Tcl, span: Option<Span>) -> Result<(), Exception> {
    let Some(excess) =
        interp.host.engine.excess.as_ref().filter(|_| !interp.host.warnings.has(&checks::analysis::EXCESS))
    else {
        return Ok(());
    };
    let message = format!("{} at time {}: {}", excess.element, excess.time, excess.message);
    let d = Diagnostic::warning(&checks::analysis::EXCESS, message).at(span, "the results from there on mean little");
    warn_once(interp, d.help("units, stiffness, and the scale of the excitation are the usual reasons"))
}

/// A penalty that does not hold its constraint.
fn loose_constraint(interp: &mut Tcl, span: Option<Span>) -> Result<(), Exception> {
    if interp.host.warnings.has(&checks::analysis::LOOSE_CONSTRAINT) {
        return Ok(());
    }
    let earlier = interp.host.analysis_checks.largest_displacement;
    let Some(loose) = interp.host.engine.loose_constraint(MAX_LOOSENESS, earlier) else { return Ok(()) };
    let (node, dof) = loose.node;
    let to = loose.retained.map_or("its support".into(), |n| format!("node {n}"));
    let message = format!(
        "the penalty does not hold: node {node} moves by {:.4e} in degree of freedom {dof}, and {to} by {:.4e}",
        loose.found, loose.wanted
    );
    let d = Diagnostic::warning(&checks::analysis::LOOSE_CONSTRAINT, message).at(span, "the constraint is not kept");
    warn_once(interp, d.help("a larger factor of \"constraints Penalty\" holds it, or \"constraints Transformation\""))
}

/// A beam beyond its Euler load.
///
/// The script may study exactly this, and its results up to there are right.
fn buckled_beam(interp: &mut Tcl, span: Option<Span>) -> Result<(), Exception> {
    if interp.host.warnings.has(&checks::analysis::BUCKLED_BEAM) {
        return Ok(());
    }
    let message = euler_loads(&mut interp.host, |engine, loads| {
        engine.buckled_beam(loads).map(|(e, Overload { load, critical })| {
            let (class, tag) = (e.element.class().name, e.tag);
            format!("the compression of {class} {tag} is {load:.4e}, above its Euler load of {critical:.4e}")
        })
    });
    let Some(message) = message else { return Ok(()) };
    let d = Diagnostic::warning(&checks::analysis::BUCKLED_BEAM, message).at(span, "it has buckled");
    warn_once(interp, d.help("\"geomTransf Corotational\" and several elements along it follow it beyond that load"))
}

//! Values that only one side states, or that a script may leave unused: motions, sizes, units, the order of the bounds.

use super::agreement::{StatedValues, place};
use super::script_model::ScriptModel;
use super::study::Study;
use hysteron_engine::model::PatternKind;
use hysteron_identify::study::unit::{Quantity, unit};

/// Difference of the ground's accelerations from those of the study, as a share of the peak, at most.
const MOTION: f64 = 1.0e-3;
/// Mass times gravity over the weight of one floor, at least and at most: part of a floor's mass may be lumped elsewhere.
const FLOOR_MASS: [f64; 2] = [0.2, 5.0];
/// Acceleration of gravity in m/s², at least and at most.
const GRAVITY: [f64; 2] = [9.6, 10.0];
/// Critical load over the largest gravity load of a type, at most.
const CRITICAL: f64 = 500.0;

/// Compare what the agreement of values does not see.
///
/// # Errors
/// Study and script contradict each other. The message has both places and the ratio.
pub(super) fn compare(study: &mut Study, stated: &StatedValues, model: &ScriptModel) -> Result<(), String> {
    length_unit(study, stated)?;
    order_of_bounds(study, stated)?;
    floor_masses(study, stated, model)?;
    sizes(study, stated, model)?;
    motions(study, stated, model)
}

/// The acceleration of gravity says what the unit of length is.
fn length_unit(study: &Study, stated: &StatedValues) -> Result<(), String> {
    let Some(length) = unit(&study.units[1]).filter(|u| u.quantity == Quantity::Length) else { return Ok(()) };
    let found = study.gravity * length.factor;
    if (GRAVITY[0]..=GRAVITY[1]).contains(&found) {
        return Ok(());
    }
    let expected = 9.81 / length.factor;
    Err(format!(
        "{}:{}: gravity = {}, but the unit of length is {} (units = {:?}), in which gravity is {expected:.5}: ratio {:.4}",
        stated.file,
        stated.gravity.line,
        study.gravity,
        length.name,
        study.units,
        study.gravity / expected
    ))
}

/// The lower bound is not above the upper one.
fn order_of_bounds(study: &Study, stated: &StatedValues) -> Result<(), String> {
    for b in &study.bearings {
        for (of, letter) in ["Q_d", "K_d"].into_iter().enumerate() {
            let [low, high] = ["lower", "upper"].map(|bound| study.factor(b, bound, of));
            if low > high {
                return Err(format!(
                    "{}: the factors of the lower bound of {} give {low:.4} times the nominal {letter}, those of the upper bound \
                     {high:.4} times: ratio {:.4}. Are lower and upper exchanged?",
                    stated.file,
                    b.name,
                    low / high
                ));
            }
        }
    }
    Ok(())
}

/// A floor has mass where it has weight.
fn floor_masses(study: &Study, stated: &StatedValues, model: &ScriptModel) -> Result<(), String> {
    for (floor, weight) in study.floors.iter().zip(&stated.floors) {
        let (Some(s), Some(mass)) = (weight, model.mass_at(floor.node)) else { continue };
        let by_mass = mass * study.gravity;
        let ratio = by_mass / s.value;
        if s.value > 0.0 && !(FLOOR_MASS[0]..=FLOOR_MASS[1]).contains(&ratio) {
            return Err(format!(
                "{}:{}: weight = {} of the floor at node {}, but the mass of \"{}\" at its elevation times gravity is \
                 {by_mass:.6}: ratio {ratio:.4}. Is a mass missing?",
                stated.file,
                s.line,
                s.value,
                floor.node,
                study.script.display()
            ));
        }
    }
    Ok(())
}

/// Bearings are smaller than the distances between them, and their critical loads are of the order of their loads.
fn sizes(study: &Study, stated: &StatedValues, model: &ScriptModel) -> Result<(), String> {
    let spacing = model.spacing();
    let script = study.script.display();
    for (kind, b) in study.bearings.iter().enumerate() {
        for (key, value) in [("diameter", b.diameter), ("displacement", b.displacement)] {
            if let (Some(value), Some(spacing)) = (value, spacing)
                && value > spacing
            {
                return Err(format!(
                    "{}: {key} = {value} of {}, but the next two bearings of \"{script}\" are {spacing:.6} apart: ratio {:.4}. \
                     Is it in another unit of length?",
                    stated.file,
                    b.name,
                    value / spacing
                ));
            }
        }
        let load = model.bearings.iter().filter(|m| m.kind == kind).map(|m| m.gravity).fold(0.0, f64::max);
        if let Some(critical) = b.critical_load.filter(|c| load > 0.0 && *c > CRITICAL * load) {
            let bearing = model.typical(kind).map_or(String::new(), |t| place(study, t));
            return Err(format!(
                "{}: critical_load = {critical} of {}, but its bearings carry {load:.6} under gravity at most ({bearing}): ratio \
                 {:.4}. Is it in another unit of force?",
                stated.file,
                b.name,
                critical / load
            ));
        }
    }
    Ok(())
}

/// The ground of the script moves as the motion that the study gives it. Excitations that are no uniform ones are a remark.
fn motions(study: &mut Study, stated: &StatedValues, model: &ScriptModel) -> Result<(), String> {
    let pair = &study.motions[0];
    let [x, y] = &pair.components;
    // A path may end before its last point.
    let points = x.acceleration.len() - 1;
    let patterns: Vec<_> = model
        .model()
        .patterns
        .values()
        .filter_map(|p| match &p.kind {
            PatternKind::Uniform(e) if p.held.is_none() => Some((p, e)),
            _ => None,
        })
        .collect();
    if patterns.is_empty() {
        study.agreement.remarks.push(
            "the script has no pattern UniformExcitation before its first transient analysis: what it does with the motions \
             was not compared"
                .into(),
        );
        return Ok(());
    }
    let horizontal = model.dimensions().saturating_sub(1);
    let meter = study.meter();
    let peak = |values: &[f64]| values.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    let whole = meter * peak(&x.acceleration).max(peak(&y.acceleration));
    for direction in 0..model.dimensions() {
        let of_study: Option<&[f64]> = match direction {
            d if d < horizontal => Some(&pair.components[d.min(1)].acceleration),
            _ => pair.vertical.as_ref().map(|m| m.acceleration.as_slice()),
        };
        let expected: Vec<f64> = (0..points).map(|k| of_study.map_or(0.0, |a| meter * a[k])).collect();
        let applied = |k: usize| -> f64 {
            let along = patterns.iter().filter(|(_, e)| e.direction == direction);
            along.map(|(p, e)| e.influence * p.factor(k as f64 * x.dt)).sum()
        };
        let applied: Vec<f64> = (0..points).map(applied).collect();
        let differs = expected.iter().zip(&applied).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        if differs > MOTION * whole {
            let axis = ["x", "y", "z"][if direction < horizontal { direction } else { 2 }];
            let [stated_peak, applied_peak] = [peak(&expected), peak(&applied)];
            return Err(format!(
                "{}: the motion \"{}\" has a peak of {stated_peak:.6} in {axis} (isolate(a{axis}), isolate(dt)), but the ground of \
                 \"{}\" has {applied_peak:.6} there, and differs by up to {differs:.6}: ratio {:.4}. Each component is to be \
                 applied once, in its direction, with its step and without a factor",
                stated.file,
                x.name,
                study.script.display(),
                applied_peak / stated_peak
            ));
        }
    }
    Ok(())
}

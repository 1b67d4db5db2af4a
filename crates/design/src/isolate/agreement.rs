//! Study and script say the same: bearings, weights, gravity, bounds and eccentricities, before the suite runs.
//!
//! A value that the study leaves out is taken from the script. A value that it gives is compared, and refused where the
//! design would be another one.

use super::excitation;
use super::plausibility;
use super::script_model::{ScriptBearing, ScriptModel};
use super::shear_test::BilinearLoop;
use super::study::{BearingType, Study};
use super::study_file::Transition;
use super::unit_labels;
use super::variants;
use crate::lateral_force::System;
use crate::mistake::{Mistake, key};
use hysteron_identify::report::{Cell, Table};
use std::f64::consts::TAU;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Difference of Q_d, K_d and β from the script's, at most: a bilinear loop stands for any loop this well.
const LOOP: f64 = 0.10;
/// Share of K_eff below which K_d, or Q_d/D, has no weight in a comparison of its own.
pub(super) const NEGLIGIBLE: f64 = 0.02;
/// Difference of the weight from the axial forces of the bearings under gravity, at most.
const WEIGHT: f64 = 0.05;
/// Mass times gravity over weight, at least and at most. Live loads are not all mass; a wrong unit is a factor of 9.8 or 1000.
const MASS: [f64; 2] = [0.7, 1.4];
/// Difference of lengths from the script's, at most.
const HEIGHT: f64 = 0.01;
/// Plan over the grid of the bearings, at most.
const PLAN: f64 = 4.0;
/// Relative change of the design displacement at which its iteration ends, and iterations at most.
const ITERATION: (f64, usize) = (0.01, 30);

/// Values that the file states.
pub(super) struct StatedValues {
    /// Q_d, K_d and D_y of each type.
    pub(super) bearings: Vec<[Option<f64>; 3]>,
    /// The shape of the loops is stated.
    pub(super) transitions: Vec<bool>,
    /// Weights of the floors.
    pub(super) floors: Vec<Option<f64>>,
    /// Heights of the floors.
    pub(super) heights: Vec<Option<f64>>,
}

/// A value of the study beside the script's.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// Quantity.
    pub subject: String,
    /// Unit.
    pub unit: String,
    /// Value of the study; none where it was taken from the script.
    pub study: Option<f64>,
    /// Value of the script.
    pub script: f64,
}

/// Values of the study beside those of the script.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Agreement {
    /// Comparisons.
    pub rows: Vec<Comparison>,
    /// Matters that could not be compared, with the reason.
    pub remarks: Vec<String>,
}

impl Agreement {
    /// As a table.
    pub fn table(&self) -> Table {
        let mut table = Table::new([("quantity", ""), ("unit", ""), ("study", ""), ("script", ""), ("ratio", "")]);
        for row in &self.rows {
            let stated = row.study.map_or(Cell::Word("from the script"), Cell::Number);
            let ratio = row.study.map(|s| s / row.script).filter(|r| r.is_finite());
            table.rows.push(vec![
                row.subject.clone().into(),
                row.unit.clone().into(),
                stated,
                Cell::Number(row.script),
                ratio.map_or(Cell::Word("-"), Cell::Number),
            ]);
        }
        table
    }

    fn add(&mut self, subject: String, unit: &str, study: Option<f64>, script: f64) {
        self.rows.push(Comparison { subject, unit: unit.into(), study, script });
    }
}

/// Loops of the bearings of one type at the design displacement.
struct TypeLoops {
    mean: BilinearLoop,
    abrupt: bool,
}

/// Fill what the study leaves out by the script's values, and compare what it states.
///
/// # Errors
/// The script fails, or study and script contradict each other. The message has both places and the ratio.
pub(super) fn settle(study: &mut Study, stated: &StatedValues, stop: &Arc<AtomicBool>) -> Result<(), Mistake> {
    let mut model = ScriptModel::new(study, "nominal", 0, stop)?;
    heights(study, stated, &model)?;
    plan(study, &model)?;
    plausibility::upside_down(study, &model)?;
    weights(study, stated, &model)?;
    plausibility::compare(study, stated, &model)?;
    unit_labels::compare(study, &mut model)?;
    excitation::compare(study, &model, stop)?;
    let design = design_loops(study, &model)?;
    let [amplitude, period] = design;
    for kind in 0..study.bearings.len() {
        match type_loops(&model, kind, amplitude, period) {
            Ok(loops) => settle_bearings(study, stated, &model, kind, &loops)?,
            Err(e) => untested(study, stated, kind, &e)?,
        }
    }
    variants::compare_bounds(study, &model, design, stop)?;
    variants::compare_eccentricities(study, &model, stop)
}

/// Place of a type in the script, for messages.
pub(super) fn place(study: &Study, bearing: &ScriptBearing) -> String {
    let line = if bearing.line.is_empty() { study.script.display().to_string() } else { bearing.line.clone() };
    format!("{line}, element {} {}", bearing.class, bearing.tag)
}

/// Heights of the floors are differences of the elevations of their nodes.
fn heights(study: &mut Study, stated: &StatedValues, model: &ScriptModel) -> Result<(), Mistake> {
    let script = study.script.display().to_string();
    let length = study.units[1].clone();
    let mut below: Option<f64> = None;
    for (k, floor) in study.floors.iter_mut().enumerate() {
        let missing =
            || Mistake::new(key!["floor", k, "node"], format!("\"{script}\" has no node {} of a floor", floor.node));
        let elevation = model.elevation(floor.node).ok_or_else(missing)?;
        let Some(lower) = below.replace(elevation) else {
            floor.height = 0.0;
            continue;
        };
        let found = elevation - lower;
        if found.is_nan() || found <= 0.0 {
            let message = format!(
                "the floor at node {} is {found:.6} above the floor before it (\"{script}\"): expected floors from the base upwards",
                floor.node
            );
            return Err(Mistake::new(key!["floor", k, "node"], message));
        }
        if let Some(s) = stated.heights[k].filter(|s| (s / found - 1.0).abs() > HEIGHT) {
            let message = format!(
                "height = {s} of the floor at node {}, but the nodes of \"{script}\" are {found:.6} apart: ratio {:.4}. Without \
                 the key the script's value is taken",
                floor.node,
                s / found
            );
            return Err(Mistake::new(key!["floor", k, "height"], message));
        }
        let subject = format!("height of the floor at node {}", floor.node);
        study.agreement.add(subject, &length, stated.heights[k], found);
        floor.height = found;
    }
    Ok(())
}

/// The plan is no smaller than the grid of its bearings, and not many times as large.
fn plan(study: &Study, model: &ScriptModel) -> Result<(), Mistake> {
    let (Some(plan), Some(grid)) = (study.plan, model.grid()) else { return Ok(()) };
    let wrong = |k: usize, than: &str, expected: String| {
        let message = format!(
            "plan = {plan:?} is {than} the grid of the bearings in {}, {:.6} (\"{}\"): ratio {:.4}{expected}",
            ["x", "y"][k],
            grid[k],
            study.script.display(),
            plan[k] / grid[k]
        );
        Err(Mistake::new(key!["plan", k], message))
    };
    if let Some(k) = (0..2).find(|k| plan[*k] < (1.0 - HEIGHT) * grid[*k]) {
        return wrong(k, "smaller than", String::new());
    }
    if let Some(k) = (0..2).find(|k| grid[*k] > 0.0 && plan[*k] > PLAN * grid[*k]) {
        return wrong(k, "far larger than", format!(", expected {PLAN} at most. Is it in another unit of length?"));
    }
    Ok(())
}

fn weights(study: &mut Study, stated: &StatedValues, model: &ScriptModel) -> Result<(), Mistake> {
    let carried = model.gravity();
    let first = &model.bearings[0];
    if carried.is_nan() || carried <= 0.0 {
        let message = format!(
            "the bearings carry {carried:.6} under gravity before the first transient analysis ({}): expected compression",
            place(study, first)
        );
        return Err(Mistake::new(key!["bearing", first.kind, "tags"], message));
    }
    let script = study.script.display();
    for (k, _) in stated.floors.iter().enumerate().filter(|(_, w)| w.is_none()) {
        let node = study.floors[k].node;
        let missing = || Mistake::new(key!["floor", k, "node"], format!("\"{script}\" has no node {node} of a floor"));
        let mass = model.mass_at(node).ok_or_else(missing)?;
        if mass <= 0.0 {
            let message = format!(
                "the floor at node {node} has no weight, and the script no mass at its elevation: expected weight = ..."
            );
            return Err(Mistake::new(key!["floor", k, "node"], message));
        }
        study.floors[k].weight = mass * study.gravity;
    }
    let of_floors: f64 = study.floors.iter().map(|f| f.weight).sum();
    let first_stated = stated.floors.iter().position(Option::is_some);
    study.weight = if study.floors.is_empty() { carried } else { of_floors };
    let force = study.units[0].clone();
    study.agreement.add("weight on the bearings".into(), &force, first_stated.map(|_| of_floors), carried);
    if (study.weight / carried - 1.0).abs() > WEIGHT {
        let message = format!(
            "the floors weigh {:.6}, but the bearings of \"{script}\" carry {carried:.6} under gravity: ratio {:.4}. Expected the \
             same within {} %: weights, the list of bearings or the script's loads are wrong",
            study.weight,
            study.weight / carried,
            100.0 * WEIGHT,
        );
        return Err(Mistake::new(key!["floor", first_stated.unwrap_or(0), "weight"], message));
    }
    let by_mass = model.mass_above() * study.gravity;
    study.agreement.add("mass above the bearings times gravity".into(), &force, Some(study.weight), by_mass);
    study.mass_over_weight = by_mass / study.weight;
    let ratio = by_mass / carried;
    if !(MASS[0]..=MASS[1]).contains(&ratio) {
        let message = format!(
            "gravity = {} times the mass of \"{script}\" above its bearings is {by_mass:.6}, but the bearings carry {carried:.6}: \
             ratio {ratio:.4}. Gravity, the masses or the loads are in another unit, or masses are missing",
            study.gravity,
        );
        return Err(Mistake::new(key!["gravity"], message));
    }
    Ok(())
}

/// Amplitude and period at which bearings are tested: displacement and period of the equivalent lateral force procedure on
/// the tested loops themselves.
fn design_loops(study: &Study, model: &ScriptModel) -> Result<[f64; 2], Mistake> {
    let meter = study.meter();
    let spectrum = |t: f64| meter * study.target.at(t);
    let (mut amplitude, mut period) = (spectrum(2.0) / (TAU / 2.0).powi(2), 2.0);
    for _ in 0..ITERATION.1 {
        let mut system = System {
            q_d: 0.0,
            k_d: 0.0,
            yield_displacement: 0.0,
            weight: study.weight,
            weight_above: study.weight_above(),
            gravity: study.gravity,
            abrupt: false,
        };
        for (kind, b) in study.bearings.iter().enumerate() {
            let found = model.typical(kind).map(|t| model.test(t, amplitude, period));
            // A bearing that cannot be tested has the values of the study, if there are some.
            let (q_d, k_d, yields) = match found {
                Some(Ok(l)) => (l.q_d, l.k_d, l.yield_displacement),
                _ => (b.q_d, b.k_d, if b.yield_displacement.is_nan() { 0.0 } else { b.yield_displacement }),
            };
            let n = b.tags.len() as f64;
            system.q_d += n * q_d;
            system.k_d += n * k_d;
            system.yield_displacement += n * q_d * yields;
        }
        system.yield_displacement = if system.q_d > 0.0 { system.yield_displacement / system.q_d } else { 0.0 };
        let found = match system.procedure(spectrum, &study.code) {
            Ok(found) => found,
            // Bearings are compared all the same, at the last displacement.
            Err(_) => break,
        };
        let change = (found.displacement / amplitude - 1.0).abs();
        (amplitude, period) = (found.displacement, found.period);
        if change < ITERATION.0 {
            break;
        }
    }
    if amplitude.is_finite() && amplitude > 0.0 && period.is_finite() {
        return Ok([amplitude, period]);
    }
    let message =
        "the target spectrum has no value at a period of 2 s: bearings cannot be tested at a design displacement";
    Err(Mistake::new(key!["target"], message))
}

/// Mean of the loops of all bearings of a type, which may differ by their axial forces.
fn type_loops(model: &ScriptModel, kind: usize, amplitude: f64, period: f64) -> Result<TypeLoops, String> {
    let mut all = vec![];
    for b in model.bearings.iter().filter(|b| b.kind == kind) {
        all.push(model.test(b, amplitude, period).map_err(|e| format!("the bearing {} cannot be tested: {e}", b.tag))?);
    }
    let mean = |of: fn(&BilinearLoop) -> f64| all.iter().map(of).sum::<f64>() / all.len() as f64;
    let mean = BilinearLoop {
        q_d: mean(|l| l.q_d),
        k_d: mean(|l| l.k_d),
        yield_displacement: mean(|l| l.yield_displacement),
        amplitude,
        abrupt: all.iter().any(|l| l.abrupt),
    };
    Ok(TypeLoops { abrupt: mean.abrupt, mean })
}

/// Refusal of a value of a type that contradicts the script's.
fn contradiction(study: &Study, model: &ScriptModel, kind: usize, name: &str, what: &str) -> Mistake {
    let bearing = model.typical(kind).map_or(String::new(), |b| place(study, b));
    let message = format!("{what} ({bearing}). Without the key the script's value is taken");
    Mistake::new(key!["bearing", kind, name], message)
}

fn settle_bearings(
    study: &mut Study,
    stated: &StatedValues,
    model: &ScriptModel,
    kind: usize,
    loops: &TypeLoops,
) -> Result<(), Mistake> {
    let found = &loops.mean;
    let d = found.amplitude;
    let [q, k, y] = stated.bearings[kind];
    let name = study.bearings[kind].name.clone();
    let stiffness = found.k_d + found.q_d / d;
    let [force, length] = study.units.clone();
    let per_length = if length.is_empty() { String::new() } else { format!("{force}/{length}") };
    // A part that hardly counts is compared with the whole.
    let limits = [LOOP * found.q_d.max(NEGLIGIBLE * stiffness * d), LOOP * found.k_d.max(NEGLIGIBLE * stiffness)];
    let parts = [("q_d", q, found.q_d, limits[0], &force), ("k_d", k, found.k_d, limits[1], &per_length)];
    for (key, stated_value, script, limit, unit) in parts {
        let subject = format!("{name}: {key} at {d:.4}");
        study.agreement.add(subject, unit, stated_value, script);
        if let Some(s) = stated_value.filter(|s| (s - script).abs() > limit) {
            let what = format!(
                "{key} = {s} of {name}, but the script's bearings have {script:.6} at the design displacement {d:.6}: ratio {:.4}",
                s / script
            );
            return Err(contradiction(study, model, kind, key, &what));
        }
    }
    let (damping, subject) = (found.damping(d), format!("{name}: yield_displacement"));
    study.agreement.add(subject, &length, y, found.yield_displacement);
    if let Some(y) = y {
        let own = BilinearLoop { yield_displacement: y, ..*found }.damping(d);
        if (own - damping).abs() > LOOP * damping {
            let what = format!(
                "yield_displacement = {y} of {name} gives a damping of {own:.4} at the design displacement {d:.6}, but the loop of \
                 the script's bearings has {damping:.4}, as of {:.6}",
                found.yield_displacement
            );
            return Err(contradiction(study, model, kind, "yield_displacement", &what));
        }
    }
    let transition = if loops.abrupt { Transition::Abrupt } else { Transition::Smooth };
    if stated.transitions[kind] && transition == Transition::Abrupt && study.bearings[kind].transition != transition {
        study.agreement.remarks.push(format!(
            "{name}: transition = \"smooth\", but the loop of the script's bearings turns abruptly: the shear above the bearings \
             is larger then. Without the key the tested shape is taken"
        ));
    }
    let own = &mut study.bearings[kind];
    own.q_d = q.unwrap_or(found.q_d);
    own.k_d = k.unwrap_or(found.k_d);
    own.yield_displacement = y.unwrap_or(found.yield_displacement);
    if !stated.transitions[kind] {
        own.transition = transition;
    }
    Ok(())
}

/// A type whose bearings cannot be tested has what the study states.
fn untested(study: &mut Study, stated: &StatedValues, kind: usize, reason: &str) -> Result<(), Mistake> {
    let BearingType { name, yield_displacement, .. } = &mut study.bearings[kind];
    if let Some(key) = ["q_d", "k_d"].iter().zip(&stated.bearings[kind]).find(|(_, s)| s.is_none()).map(|(k, _)| k) {
        return Err(Mistake::new(key!["bearing", kind, *key], format!("{name} has no {key}, and {reason}")));
    }
    if yield_displacement.is_nan() {
        *yield_displacement = 0.0;
    }
    let remark = format!("{name}: Q_d and K_d are not compared with the script's, since {reason}");
    study.agreement.remarks.push(remark);
    Ok(())
}

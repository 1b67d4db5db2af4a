//! Rules about masses, loads and periods: each constant has its reason.

use super::short;
use crate::checks;
use hysteron_engine::analysis::{Engine, LinearEstimate};
use hysteron_tcl::diagnostic::Diagnostic;

/// Gravity in the units of length that scripts use.
const GRAVITIES: [(f64, &str); 5] = [(9.81, "m"), (981.0, "cm"), (9810.0, "mm"), (32.17, "ft"), (386.1, "in")];
/// Relative deviation of loads from masses times g: g is rounded, and part of the live loads has no mass.
const MAX_GRAVITY_DEVIATION: f64 = 0.05;
/// Part of the resultant that is vertical where the loads are those of gravity.
const MIN_VERTICAL_SHARE: f64 = 0.9;
/// Relative difference of ratios that are the same number.
const SAME: f64 = 0.01;
/// Factor between a unit of mass or force and the next: kilograms and tonnes, pounds and kips.
const UNIT_STEP: f64 = 1000.0;
/// Period in s beyond that of the tallest buildings, which have 800 m and sway in about 10 s.
const MAX_PERIOD: f64 = 10.0;
/// Stiffness of a bearing along its load over that across it. Rubber bearings have 100 and more, and no bearing less than 1.
const MIN_AXIAL_RATIO: f64 = 0.1;

/// Static loads beside the masses.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gravity {
    /// The largest mass along an axis.
    pub(super) mass: f64,
    /// Vertical load over mass, without sign.
    pub(super) ratio: f64,
    /// Vertical load; downwards it is negative.
    load: f64,
    /// The gravity that it is, with its unit of length.
    pub(super) known: Option<(f64, &'static str)>,
}

impl Gravity {
    /// Of loads that are mostly vertical.
    pub(super) fn of(axis: Option<usize>, mass: &[f64; 3], statics: Option<&LinearEstimate>) -> Option<Self> {
        let (axis, loads) = axis.zip(statics.map(|s| s.load))?;
        let resultant = loads.iter().map(|x| x * x).sum::<f64>().sqrt();
        let (load, mass) = (loads[axis], mass.iter().copied().fold(0.0, f64::max));
        if mass == 0.0 || load == 0.0 || load.abs() < MIN_VERTICAL_SHARE * resultant {
            return None;
        }
        let ratio = load.abs() / mass;
        let known = GRAVITIES.into_iter().find(|(g, _)| (ratio / g - 1.0).abs() <= MAX_GRAVITY_DEVIATION);
        Some(Self { mass, ratio, load, known })
    }

    /// Gravity in the units of the script, where it is known; else what the loads say.
    pub(super) fn size(&self) -> f64 {
        self.known.map_or(self.ratio, |(g, _)| g)
    }
}

/// The vertical axis, from 0: the second in a plane, the third in space, or there the second where the loads are the masses'
/// weight along it.
pub(super) fn vertical_axis(ndm: usize, mass: &[f64; 3], statics: Option<&LinearEstimate>) -> Option<usize> {
    let is_weight = |axis| Gravity::of(Some(axis), mass, statics).is_some_and(|g| g.known.is_some());
    match ndm {
        2 => Some(1),
        3 if is_weight(1) => Some(1),
        3 => Some(2),
        _ => None,
    }
}

/// What the masses, the loads and the period cannot mean.
pub(super) fn findings(
    engine: &Engine,
    mass: &[f64; 3],
    axis: Option<usize>,
    gravity: Option<&Gravity>,
    period: Option<f64>,
    statics: Option<&LinearEstimate>,
) -> Vec<Diagnostic> {
    let is_known = gravity.is_some_and(|g| g.known.is_some());
    let upwards = gravity.zip(axis).and_then(|(g, axis)| upwards(g, axis));
    let weight = gravity.filter(|_| !is_known).and_then(|g| mass_is_weight(engine, g));
    let units = gravity.filter(|_| !is_known).and_then(mass_in_other_units);
    let is_explained = is_known || weight.is_some() || units.is_some();
    let long = period.filter(|_| !is_explained).and_then(|t| long_period(engine, t, mass));
    let loads = axis.filter(|axis| statics.is_some_and(|s| is_vertical(&s.load, *axis)));
    let sideways = loads.and_then(|axis| bearing_on_its_side(engine, axis));
    [upwards, weight, units, long, sideways].into_iter().flatten().collect()
}

fn is_vertical(load: &[f64; 3], axis: usize) -> bool {
    let resultant = load.iter().map(|x| x * x).sum::<f64>().sqrt();
    load[axis] != 0.0 && load[axis].abs() >= MIN_VERTICAL_SHARE * resultant
}

/// Loads that are the weight of the masses, but upwards.
fn upwards(g: &Gravity, axis: usize) -> Option<Diagnostic> {
    let (size, unit) = g.known.filter(|_| g.load > 0.0)?;
    let axis = axis + 1;
    let message = format!(
        "the static loads are the weight of the masses and push upwards: {} along {axis}, with g = {size} {unit}/s²",
        short(g.load)
    );
    let d = Diagnostic::warning(&checks::analysis::GRAVITY_UPWARDS, message);
    Some(d.label(format!("expected loads along -{axis} before this")))
}

/// Masses with the numbers of the loads, but for those of models without units.
fn mass_is_weight(engine: &Engine, g: &Gravity) -> Option<Diagnostic> {
    let masses = engine.model().nodes.iter().flat_map(|n| &n.mass);
    let has_units = masses.clone().any(|m| *m != 0.0 && *m != 1.0);
    if (g.ratio - 1.0).abs() > SAME || !has_units {
        return None;
    }
    let message = format!("the masses are the same numbers as the static loads, {} in all", short(g.mass));
    let d = Diagnostic::warning(&checks::analysis::MASS_IS_WEIGHT, message);
    Some(d.label("expected a mass that is its weight over g").help("with such masses each period is √g times too long"))
}

/// Masses a thousand times too large for the loads, as kilograms beside kilonewtons. Masses a thousand times too small are not
/// told: 9810 is g in millimetres.
fn mass_in_other_units(g: &Gravity) -> Option<Diagnostic> {
    let size = g.ratio * UNIT_STEP;
    // A wider limit would take 0.981, of centimetres, for the 1 of a model without units.
    if !GRAVITIES.iter().any(|(g, _)| (size / g - 1.0).abs() <= SAME) {
        return None;
    }
    let message = format!(
        "the static loads are {} for each unit of mass, and g is {}: the masses are 1000 times too large",
        short(g.ratio),
        short(size)
    );
    let d = Diagnostic::warning(&checks::analysis::MASS_UNITS, message);
    Some(d.label("expected a mass that is its weight over g").help("tonnes go with kN and m, kilograms with N and m"))
}

/// The period of a building that none has, on fixed supports or on bearings.
fn long_period(engine: &Engine, period: f64, mass: &[f64; 3]) -> Option<Diagnostic> {
    let elements = || engine.model().elements.iter().map(|e| &e.element);
    let is_frame = elements().any(|e| e.class().name.contains("Beam"));
    if period <= MAX_PERIOD || !is_frame {
        return None;
    }
    let mass = mass.iter().copied().fold(0.0, f64::max);
    let message = format!(
        "the first period is {}, longer than the {MAX_PERIOD} s of the tallest buildings, with a mass of {}",
        short(period),
        short(mass)
    );
    let d = Diagnostic::warning(&checks::analysis::LONG_PERIOD, message);
    Some(
        d.label("expected a shorter period")
            .help("a mass is its weight over g, in units that go with those of the stiffness"),
    )
}

/// A bearing whose stiff direction lies across its load.
fn bearing_on_its_side(engine: &Engine, axis: usize) -> Option<Diagnostic> {
    let model = engine.model();
    let is_held = |node: usize| model.fixes.iter().any(|f| f.node.0 == node && f.dof == axis);
    let bearings = model.elements.iter().filter(|e| e.element.bearing().is_some());
    let (e, along, across) = bearings.filter(|e| !e.nodes.iter().all(|n| is_held(n.0))).find_map(|e| {
        let stiffness = engine.axis_stiffness(e.tag)?;
        let across = (0..3).filter(|i| *i != axis).map(|i| stiffness[i]).fold(0.0, f64::max);
        // A bearing with both nodes free carries its load along its own axis. Springs of shear alone carry none.
        (stiffness[axis] > 0.0 && stiffness[axis] < MIN_AXIAL_RATIO * across).then_some((e, stiffness[axis], across))
    })?;
    let message = format!(
        "the local x of {} {} lies across its load: its stiffness is {} along {}, and {} across it",
        e.element.class().name,
        e.tag,
        short(along),
        axis + 1,
        short(across)
    );
    let d = Diagnostic::warning(&checks::analysis::BEARING_ON_ITS_SIDE, message);
    Some(
        d.label("its shear would carry the load")
            .help("\"-orient\" gives the local x, which is the axis of the bearing"),
    )
}

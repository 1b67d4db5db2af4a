//! Rules about records of ground motions.

use super::rules::Gravity;
use super::short;
use crate::checks;
use hysteron_engine::model::{Excitation, Tag};
use hysteron_engine::series::{Path, Series};
use hysteron_tcl::diagnostic::Diagnostic;
use std::any::Any;
use std::sync::Arc;

/// Points that a peak is looked for at.
const MAX_POINTS: f64 = 2e6;
/// Points that a function without steps of its own is looked at.
const POINTS: f64 = 1e4;
/// Points from which a path is a record, and no loading of a few points.
const MIN_RECORD: usize = 100;
/// Peak in g above those of all recorded ground motions: 4.4 g at Ichinoseki in 2008 is the largest.
const MAX_GROUND: f64 = 4.5;
/// Peak in g below which a record is a tremor that no structure is analysed for.
const MIN_GROUND: f64 = 0.04;
/// Peaks of records whose numbers are in g.
const PEAKS_IN_G: std::ops::Range<f64> = 0.02..2.5;

/// The largest acceleration of a pattern.
#[derive(Clone, Debug)]
pub(super) struct Peak {
    tag: Tag,
    /// With its sign, times the factor of the pattern.
    pub(super) value: f64,
    pub(super) time: f64,
    pub(super) end: f64,
    series: Series,
    /// Factor of the pattern.
    influence: f64,
}

impl Peak {
    /// `None` for an acceleration without an end.
    pub(super) fn of(tag: Tag, e: &Excitation) -> Option<Self> {
        let (start, end) = (e.accel.start(), e.accel.end()?);
        let step = e.accel.step().unwrap_or((end - start) / POINTS);
        let points = ((end - start) / step).ceil();
        if !(points > 0.0 && points <= MAX_POINTS) {
            return None;
        }
        let at = |i: usize| start + i as f64 * step;
        let (value, time) = (0..points as usize)
            .map(|i| (e.influence * e.accel.factor(at(i)), at(i)))
            .max_by(|a, b| a.0.abs().total_cmp(&b.0.abs()))?;
        Some(Self { tag, value, time, end, series: e.accel.clone(), influence: e.influence })
    }

    /// Returns true for a long path without any factor.
    fn is_unscaled_record(&self) -> bool {
        let any: &dyn Any = &*self.series;
        self.influence == 1.0
            && any.downcast_ref::<Path>().is_some_and(|p| p.factor == 1.0 && p.values.len() >= MIN_RECORD)
    }
}

/// A record in other units than the model's.
pub(super) fn finding(peak: &Peak, gravity: Option<&Gravity>, in_g: &[(Series, String)]) -> Option<Diagnostic> {
    let (tag, value) = (peak.tag, peak.value.abs());
    let known = gravity.and_then(|g| g.known);
    let file = in_g.iter().find(|(series, _)| Arc::ptr_eq(series, &peak.series)).map(|(_, name)| name);
    if let Some(name) = file.filter(|_| peak.is_unscaled_record()) {
        let message =
            format!("the record of pattern {tag} is in g, as {name} says, and no factor makes accelerations of it");
        let d = Diagnostic::warning(&checks::load::RECORD_IN_G, message)
            .label("expected a factor of g in the units of the model");
        return Some(d);
    }
    let (g, unit) = known?;
    let share = value / g;
    if share > MAX_GROUND {
        let message = format!(
            "the record of pattern {tag} peaks at {}, which is {} g with g = {g} {unit}/s²",
            short(value),
            short(share)
        );
        let d = Diagnostic::warning(&checks::load::RECORD_TOO_STRONG, message)
            .label(format!("expected at most {MAX_GROUND} g, the strongest motion recorded"));
        return Some(d);
    }
    if share < MIN_GROUND && PEAKS_IN_G.contains(&value) && peak.is_unscaled_record() {
        let message = format!(
            "the record of pattern {tag} peaks at {}, which is {} g with g = {g} {unit}/s²",
            short(value),
            short(share)
        );
        let d = Diagnostic::warning(&checks::load::RECORD_IN_G, message).label("a record in g needs a factor of g");
        return Some(d);
    }
    None
}

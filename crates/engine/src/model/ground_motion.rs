//! Motions of the ground at single supports.

use crate::series::{Derivative, Integral, Path, Series};
use std::sync::Arc;

/// Displacement, velocity and acceleration of a support in time.
#[derive(Clone, Debug)]
pub enum GroundMotion {
    /// By series; what was not given has been integrated or differentiated from the others.
    Plain {
        /// Displacement, velocity, acceleration.
        series: [Option<Series>; 3],
        /// Multiplies all of them.
        factor: f64,
    },
    /// A sum of other motions with factors.
    Interpolated(Vec<(f64, GroundMotion)>),
}

impl GroundMotion {
    /// From series of displacement, velocity and acceleration; `None` where no series is given. A series that is missing
    /// follows with steps of `dt`: integrals by the trapezoidal rule, derivatives by differences. Those of a series without an
    /// end are exact.
    pub fn from_series(series: [Option<Series>; 3], dt: f64, factor: f64) -> Option<Self> {
        let [disp, mut vel, mut accel] = with_integrals(series, |series| integral(series, dt))?;
        vel = vel.or_else(|| disp.as_ref().map(|d| derivative(d, dt)));
        accel = accel.or_else(|| vel.as_ref().map(|v| derivative(v, dt)));
        Some(Self::Plain { series: [disp, vel, accel], factor })
    }

    /// The same as OpenSees has it: without derivatives, and with integrals from zero before the first value to the last one.
    pub fn as_opensees(series: [Option<Series>; 3], dt: f64, factor: f64) -> Option<Self> {
        let series = with_integrals(series, |series| integral_of_opensees(series, dt))?;
        Some(Self::Plain { series, factor })
    }

    /// Displacement, velocity and acceleration at a time; at rest before time zero.
    pub fn at(&self, time: f64) -> [f64; 3] {
        match self {
            _ if time < 0.0 => [0.0; 3],
            Self::Plain { series, factor } => {
                [0, 1, 2].map(|i| series[i].as_ref().map_or(0.0, |s| factor * s.factor(time)))
            }
            Self::Interpolated(motions) => motions.iter().fold([0.0; 3], |sum, (factor, motion)| {
                let m = motion.at(time);
                [0, 1, 2].map(|i| sum[i] + factor * m[i])
            }),
        }
    }

    /// Time of the last value given.
    pub fn end(&self) -> Option<f64> {
        match self {
            Self::Plain { series, .. } => series.iter().flatten().filter_map(|s| s.end()).max_by(f64::total_cmp),
            Self::Interpolated(all) => all.iter().filter_map(|(_, m)| m.end()).max_by(f64::total_cmp),
        }
    }
}

/// Series of displacement and velocity that are missing, as integrals of those that are given; `None` where none is.
fn with_integrals(series: [Option<Series>; 3], integral: impl Fn(&Series) -> Series) -> Option<[Option<Series>; 3]> {
    let [mut disp, mut vel, accel] = series;
    vel = vel.or_else(|| accel.as_ref().map(&integral));
    disp = disp.or_else(|| vel.as_ref().map(&integral));
    (disp.is_some() || vel.is_some() || accel.is_some()).then_some([disp, vel, accel])
}

/// Acceleration of a motion that is given by its velocity, or else by its displacement. Derivatives of a formula are exact;
/// those of a series of points are differences over its steps.
pub fn acceleration_of(velocity: Option<&Series>, displacement: Option<&Series>) -> Option<Series> {
    let rate = |series: &Series| match series.step() {
        Some(dt) => derivative(series, dt),
        None => Arc::new(Derivative::new(series.clone())),
    };
    velocity.map(rate).or_else(|| displacement.map(|series| rate(&rate(series))))
}

/// Values of a series at steps of `dt`.
fn samples(series: &Series, dt: f64) -> Vec<f64> {
    /// Points of a series without an end, of which there must be some number.
    const MOST: f64 = 1e7;
    let (start, end) = (series.start(), series.end().unwrap_or(0.0));
    let n = ((end - start) / dt + 1.0).clamp(1.0, MOST) as usize;
    (0..n).map(|i| series.factor(start + dt * i as f64)).collect()
}

fn path(values: Vec<f64>, like: &Series, dt: f64) -> Path {
    Path { values, dt, factor: 1.0, use_last: true, start: like.start() }
}

/// Sums of the trapezoidal rule over the steps of `dt`, from a value one step before the first.
fn sums(series: &Series, dt: f64, before: impl Fn(f64) -> f64) -> Path {
    let mut values = samples(series, dt);
    let (mut sum, mut last) = (0.0, before(values[0]));
    for x in &mut values {
        sum += 0.5 * dt * (last + *x);
        last = *x;
        *x = sum;
    }
    path(values, series, dt)
}

/// Integral by the trapezoidal rule, zero at the start of the series: the value before it cancels the first one. It goes on
/// where the series goes on with its last value.
fn integral(series: &Series, dt: f64) -> Series {
    series.integral().unwrap_or_else(|| {
        let sums = sums(series, dt, |first| -first);
        let [value, slope] = series.after_end();
        if value == 0.0 && slope == 0.0 {
            return Arc::new(sums);
        }
        let end = sums.start + sums.dt * (sums.values.len() as f64 - 1.0);
        Arc::new(Integral { after: [series.factor(end), slope], sums })
    })
}

/// OpenSees' integral: the series is zero one step before its first value, and the integral of a series without an end is zero.
fn integral_of_opensees(series: &Series, dt: f64) -> Series {
    let use_last = series.end().is_some();
    Arc::new(Path { use_last, ..sums(series, dt, |_| 0.0) })
}

/// Derivative by central differences. The one whose trapezoidal integral gives the series back would alternate for ever
/// about a motion that starts with a velocity.
fn derivative(series: &Series, dt: f64) -> Series {
    if series.end().is_none() {
        return Arc::new(Derivative::new(series.clone()));
    }
    let x = samples(series, dt);
    let last = x.len() - 1;
    let slope = |i: usize| {
        let (a, b) = (i.saturating_sub(1), (i + 1).min(last));
        (x[b] - x[a]) / (dt * (b - a).max(1) as f64)
    };
    Arc::new(path((0..=last).map(slope).collect(), series, dt))
}

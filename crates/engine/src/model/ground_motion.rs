//! Motions of the ground at single supports.

use crate::series::{Path, Series};
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
    /// From series of displacement, velocity and acceleration. A series that is missing follows with steps of `dt`: integrals
    /// by the trapezoidal rule, derivatives (with `derive`) by differences. `None` where no series is
    /// given.
    pub fn from_series(series: [Option<Series>; 3], dt: f64, factor: f64, derive: bool) -> Option<Self> {
        let [mut disp, mut vel, mut accel] = series;
        if disp.is_none() && vel.is_none() && accel.is_none() {
            return None;
        }
        vel = vel.or_else(|| accel.as_ref().map(|a| integral(a, dt)));
        disp = disp.or_else(|| vel.as_ref().map(|v| integral(v, dt)));
        if derive {
            vel = vel.or_else(|| disp.as_ref().map(|d| derivative(d, dt)));
            accel = accel.or_else(|| vel.as_ref().map(|v| derivative(v, dt)));
        }
        Some(Self::Plain { series: [disp, vel, accel], factor })
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

/// Values of a series at steps of `dt`.
fn samples(series: &Series, dt: f64) -> Vec<f64> {
    /// Points of a series without an end, of which there must be some number.
    const MOST: f64 = 1e7;
    let (start, end) = (series.start(), series.end().unwrap_or(0.0));
    let n = ((end - start) / dt + 1.0).clamp(1.0, MOST) as usize;
    (0..n).map(|i| series.factor(start + dt * i as f64)).collect()
}

fn path(values: Vec<f64>, like: &Series, dt: f64) -> Series {
    Arc::new(Path { values, dt, factor: 1.0, use_last: true, start: like.start() })
}

/// Integral by the trapezoidal rule, from zero on.
fn integral(series: &Series, dt: f64) -> Series {
    let (mut sum, mut last) = (0.0, 0.0);
    let mut values = samples(series, dt);
    for x in &mut values {
        sum += 0.5 * dt * (last + *x);
        last = *x;
        *x = sum;
    }
    path(values, series, dt)
}

/// Derivative by central differences. The one whose trapezoidal integral gives the series back would alternate for ever
/// about a motion that starts with a velocity.
fn derivative(series: &Series, dt: f64) -> Series {
    let x = samples(series, dt);
    let last = x.len() - 1;
    let slope = |i: usize| {
        let (a, b) = (i.saturating_sub(1), (i + 1).min(last));
        (x[b] - x[a]) / (dt * (b - a).max(1) as f64)
    };
    path((0..=last).map(slope).collect(), series, dt)
}

//! Series with a formula.

use super::{Series, TimeSeries};
use std::f64::consts::TAU;
use std::sync::Arc;

/// A constant.
#[derive(Clone, Debug, PartialEq)]
pub struct Constant {
    /// The value.
    pub factor: f64,
}

impl TimeSeries for Constant {
    fn factor(&self, _: f64) -> f64 {
        self.factor
    }
    fn derivatives(&self, _: f64) -> [f64; 2] {
        [0.0; 2]
    }
    fn integral(&self) -> Option<Series> {
        Some(Arc::new(Linear { factor: self.factor }))
    }
}

/// Proportional to time.
#[derive(Clone, Debug, PartialEq)]
pub struct Linear {
    /// Value at time 1.
    pub factor: f64,
}

impl TimeSeries for Linear {
    fn factor(&self, time: f64) -> f64 {
        self.factor * time
    }
    fn derivatives(&self, _: f64) -> [f64; 2] {
        [self.factor, 0.0]
    }
    fn integral(&self) -> Option<Series> {
        Some(Arc::new(Power { factor: 0.5 * self.factor, exponent: 2 }))
    }
}

/// Proportional to a power of time.
#[derive(Clone, Debug, PartialEq)]
pub struct Power {
    /// Value at time 1.
    pub factor: f64,
    /// Exponent, at least 2.
    pub exponent: i32,
}

impl TimeSeries for Power {
    fn factor(&self, time: f64) -> f64 {
        self.factor * time.powi(self.exponent)
    }
    fn derivatives(&self, time: f64) -> [f64; 2] {
        let n = f64::from(self.exponent);
        let first = self.factor * n * time.powi(self.exponent - 1);
        [first, self.factor * n * (n - 1.0) * time.powi(self.exponent - 2)]
    }
    fn integral(&self) -> Option<Series> {
        let exponent = self.exponent + 1;
        Some(Arc::new(Self { factor: self.factor / f64::from(exponent), exponent }))
    }
}

/// Common part of the periodic series: they are zero outside `start` to `end`.
#[derive(Clone, Debug, PartialEq)]
pub struct Wave {
    /// Start.
    pub start: f64,
    /// End.
    pub end: f64,
    /// Period.
    pub period: f64,
    /// Phase shift: an angle for [`Trig`], a time for the others.
    pub shift: f64,
    /// Amplitude.
    pub factor: f64,
    /// Value about which it swings.
    pub zero_shift: f64,
}

impl Wave {
    fn covers(&self, time: f64) -> bool {
        time >= self.start && time <= self.end
    }

    /// Fraction of the period that has passed.
    fn phase(&self, time: f64) -> f64 {
        let k = (time - self.start) / self.period;
        k - k.floor()
    }
}

/// Sine: `c sin(2π (t - t₀)/T + φ) + z`, where φ is the phase shift less that which lets it start at zero for z.
#[derive(Clone, Debug, PartialEq)]
pub struct Trig {
    wave: Wave,
    phi: f64,
}

impl Trig {
    /// From what it shares with the others.
    pub fn new(wave: Wave) -> Self {
        let phi = wave.shift - wave.period / TAU * (wave.zero_shift / wave.factor).asin();
        Self { wave, phi }
    }
}

impl TimeSeries for Trig {
    fn factor(&self, time: f64) -> f64 {
        let w = &self.wave;
        if !w.covers(time) {
            return 0.0;
        }
        w.factor * (TAU * (time - w.start) / w.period + self.phi).sin() + w.zero_shift
    }
    fn derivatives(&self, time: f64) -> [f64; 2] {
        let w = &self.wave;
        if !w.covers(time) {
            return [0.0; 2];
        }
        let omega = TAU / w.period;
        let (sin, cos) = (TAU * (time - w.start) / w.period + self.phi).sin_cos();
        [w.factor * omega * cos, -w.factor * omega * omega * sin]
    }
    fn end(&self) -> Option<f64> {
        Some(self.wave.end)
    }
}

/// Triangle wave that starts upwards.
#[derive(Clone, Debug, PartialEq)]
pub struct Triangle(pub Wave);

impl Triangle {
    /// Slope of its rising pieces, and the fraction of the period that has passed.
    fn slope_and_phase(&self, time: f64) -> (f64, f64) {
        let w = &self.0;
        let slope = w.factor / (0.25 * w.period);
        let phi = w.shift - w.zero_shift / slope;
        (slope, w.phase(time + phi))
    }
}

impl TimeSeries for Triangle {
    fn factor(&self, time: f64) -> f64 {
        let w = &self.0;
        if !w.covers(time) {
            return 0.0;
        }
        let (slope, k) = self.slope_and_phase(time);
        let wave = if k < 0.25 {
            slope * k * w.period
        } else if k < 0.75 {
            w.factor - slope * (k - 0.25) * w.period
        } else {
            -w.factor + slope * (k - 0.75) * w.period
        };
        wave + w.zero_shift
    }
    fn derivatives(&self, time: f64) -> [f64; 2] {
        if !self.0.covers(time) {
            return [0.0; 2];
        }
        let (slope, k) = self.slope_and_phase(time);
        let falls = (0.25..0.75).contains(&k);
        [if falls { -slope } else { slope }, 0.0]
    }
    fn end(&self) -> Option<f64> {
        Some(self.0.end)
    }
}

/// Constant between two times, zero outside.
#[derive(Clone, Debug, PartialEq)]
pub struct Rectangular {
    /// Start.
    pub start: f64,
    /// End.
    pub end: f64,
    /// Value.
    pub factor: f64,
}

impl TimeSeries for Rectangular {
    fn factor(&self, time: f64) -> f64 {
        if time >= self.start && time <= self.end { self.factor } else { 0.0 }
    }
    fn derivatives(&self, _: f64) -> [f64; 2] {
        [0.0; 2]
    }
    fn end(&self) -> Option<f64> {
        Some(self.end)
    }
}

/// Rectangular pulses: the amplitude for a fraction `width` of each period, and none for the rest.
#[derive(Clone, Debug, PartialEq)]
pub struct Pulse {
    /// Times, amplitude and shifts.
    pub wave: Wave,
    /// Fraction of the period.
    pub width: f64,
}

impl TimeSeries for Pulse {
    fn factor(&self, time: f64) -> f64 {
        let w = &self.wave;
        if !w.covers(time) {
            return 0.0;
        }
        if w.phase(time + w.shift) < self.width { w.factor + w.zero_shift } else { w.zero_shift }
    }
    fn derivatives(&self, _: f64) -> [f64; 2] {
        [0.0; 2]
    }
    fn end(&self) -> Option<f64> {
        Some(self.wave.end)
    }
}

//! Series with a formula.

use super::TimeSeries;
use std::f64::consts::TAU;

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
    fn end(&self) -> Option<f64> {
        Some(self.wave.end)
    }
}

/// Triangle wave that starts upwards.
#[derive(Clone, Debug, PartialEq)]
pub struct Triangle(pub Wave);

impl TimeSeries for Triangle {
    fn factor(&self, time: f64) -> f64 {
        let w = &self.0;
        if !w.covers(time) {
            return 0.0;
        }
        let slope = w.factor / (0.25 * w.period);
        let phi = w.shift - w.zero_shift / slope;
        let k = w.phase(time + phi);
        let wave = if k < 0.25 {
            slope * k * w.period
        } else if k < 0.75 {
            w.factor - slope * (k - 0.25) * w.period
        } else {
            -w.factor + slope * (k - 0.75) * w.period
        };
        wave + w.zero_shift
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
    fn end(&self) -> Option<f64> {
        Some(self.wave.end)
    }
}

//! Linear oscillator under a motion: the exact solution for accelerations that are linear between samples.
//!
//! Nigam and Jennings (1969), Calculation of response spectra from strong-motion earthquake records, Bulletin of the
//! Seismological Society of America 59(2); coefficients as in Chopra, Dynamics of Structures, table 5.2.1.

use std::f64::consts::TAU;

/// Steps of a period, at least: a maximum between two of them is missed by 0.05 %.
const STEPS_PER_PERIOD: f64 = 100.0;

/// Largest responses of an oscillator.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Peaks {
    /// Relative displacement in m.
    pub displacement: f64,
    /// Relative velocity in m/s.
    pub velocity: f64,
    /// Absolute acceleration in m/s².
    pub acceleration: f64,
}

/// A linear oscillator.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Oscillator {
    /// Natural period in s, more than 0.
    pub period: f64,
    /// Damping as a share of the critical one, from 0 to less than 1.
    pub damping: f64,
}

/// Coefficients of a step: state and accelerations at its start and end give the state at the end.
struct Step {
    u: [f64; 4],
    v: [f64; 4],
}

impl Oscillator {
    /// Angular frequency in rad/s.
    pub fn omega(&self) -> f64 {
        TAU / self.period
    }

    fn step(&self, h: f64) -> Step {
        let (w, z) = (self.omega(), self.damping);
        let k = w * w;
        let root = (1.0 - z * z).sqrt();
        let wd = w * root;
        let e = (-z * w * h).exp();
        let (s, c) = (wd * h).sin_cos();
        let (wh, wdh) = (w * h, wd * h);
        Step {
            u: [
                e * (z / root * s + c),
                e * s / wd,
                (2.0 * z / wh + e * (((1.0 - 2.0 * z * z) / wdh - z / root) * s - (1.0 + 2.0 * z / wh) * c)) / k,
                (1.0 - 2.0 * z / wh + e * ((2.0 * z * z - 1.0) / wdh * s + 2.0 * z / wh * c)) / k,
            ],
            v: [
                -e * w / root * s,
                e * (c - z / root * s),
                (-1.0 / h + e * ((w / root + z / (h * root)) * s + c / h)) / k,
                (1.0 - e * (z / root * s + c)) / (k * h),
            ],
        }
    }

    /// Visit relative displacement, relative velocity and ground acceleration at the steps of a motion and for one period
    /// after it, in which the ground rests. Steps longer than 1/100 of the period are divided.
    fn visit(&self, dt: f64, acceleration: &[f64], mut seen: impl FnMut(f64, f64, f64)) {
        let parts = self.parts(dt);
        let step = self.step(dt / parts);
        let (mut u, mut v) = (0.0, 0.0);
        let after = (self.period / dt).ceil() as usize + 1;
        let mut last = acceleration.first().copied().unwrap_or(0.0);
        seen(u, v, last);
        let rest = std::iter::repeat_n(0.0, after);
        for next in acceleration.iter().copied().skip(1).chain(rest) {
            let slope = (next - last) / parts;
            for part in 0..parts as usize {
                let a0 = last + slope * part as f64;
                let a1 = a0 + slope;
                (u, v) = (
                    step.u[0] * u + step.u[1] * v - step.u[2] * a0 - step.u[3] * a1,
                    step.v[0] * u + step.v[1] * v - step.v[2] * a0 - step.v[3] * a1,
                );
                seen(u, v, a1);
            }
            last = next;
        }
    }

    /// Number of parts that a step is divided into.
    fn parts(&self, dt: f64) -> f64 {
        (dt * STEPS_PER_PERIOD / self.period).ceil().max(1.0)
    }

    /// Relative displacements in m at equal steps, those after the motion included.
    pub fn displacements(&self, dt: f64, acceleration: &[f64]) -> Vec<f64> {
        let mut out = vec![];
        self.visit(dt, acceleration, |u, _, _| out.push(u));
        out
    }

    /// Absolute accelerations in m/s² at equal steps, those after the motion included.
    pub fn accelerations(&self, dt: f64, acceleration: &[f64]) -> Vec<f64> {
        let mut out = vec![];
        self.visit(dt, acceleration, |u, v, _| out.push(self.absolute(u, v)));
        out
    }

    fn absolute(&self, u: f64, v: f64) -> f64 {
        -self.omega() * (2.0 * self.damping * v + self.omega() * u)
    }

    /// Largest responses. Between two steps a maximum is that of the cubic through values and slopes at both.
    pub fn peaks(&self, dt: f64, acceleration: &[f64]) -> Peaks {
        let w = self.omega();
        let mut states: Option<[f64; 4]> = None;
        let h = dt / self.parts(dt);
        let mut peaks = Peaks::default();
        self.visit(dt, acceleration, |u, v, ground| {
            let absolute = self.absolute(u, v);
            let relative = absolute - ground;
            // Slope of the absolute acceleration.
            let slope = -w * (2.0 * self.damping * relative + w * v);
            let now = [u, v, relative, absolute];
            peaks.displacement = peaks.displacement.max(u.abs());
            peaks.velocity = peaks.velocity.max(v.abs());
            peaks.acceleration = peaks.acceleration.max(absolute.abs());
            if let Some([u0, v0, a0, absolute0]) = states {
                peaks.displacement = peaks.displacement.max(between(u0, v0, u, v, h));
                peaks.velocity = peaks.velocity.max(between(v0, a0, v, relative, h));
                let slope0 = -w * (2.0 * self.damping * a0 + w * v0);
                peaks.acceleration = peaks.acceleration.max(between(absolute0, slope0, absolute, slope, h));
            }
            states = Some(now);
        });
        peaks
    }
}

/// Largest absolute value within a step of the cubic through two values and slopes; zero if it has no maximum there.
fn between(x0: f64, d0: f64, x1: f64, d1: f64, h: f64) -> f64 {
    if d0 * d1 >= 0.0 {
        return 0.0;
    }
    // x(s) for s from 0 to 1 with the slopes times h; x'(s) = a s² + b s + c.
    let (m0, m1) = (h * d0, h * d1);
    let jump = x1 - x0;
    let (a, b, c) = (3.0 * (m0 + m1) - 6.0 * jump, 6.0 * jump - 4.0 * m0 - 2.0 * m1, m0);
    let root = (b * b - 4.0 * a * c).max(0.0).sqrt();
    let q = -0.5 * (b + root.copysign(b));
    let s = [q / a, c / q].into_iter().find(|s| (0.0..=1.0).contains(s));
    s.map_or(0.0, |s| (x0 + s * (c + s * (0.5 * b + s * a / 3.0))).abs())
}

#[cfg(test)]
mod tests {
    use super::Oscillator;
    use std::f64::consts::{PI, TAU};

    /// Response to a half sine pulse (Chopra, equations 4.8.2 and 4.8.3), undamped, pulse longer than half a period:
    /// u_max k/p = 1/(1 - T/(2 t_d)) sin(2π l/(1 + 2 t_d/T)) with the largest l for which the time is in the pulse.
    #[test]
    fn half_sine_pulse() {
        let duration = 1.0;
        let n = 20_000;
        let dt = duration / f64::from(n);
        let pulse: Vec<f64> = (0..=n).map(|i| (PI * f64::from(i) / f64::from(n)).sin()).collect();
        for ratio in [0.6, 0.75, 1.0, 1.25, 1.8, 3.0] {
            let period = duration / ratio;
            let o = Oscillator { period, damping: 0.0 };
            let forced = (1..10)
                .map(f64::from)
                .filter(|l| l / (1.0 + 2.0 * ratio) * 2.0 <= 1.0)
                .map(|l| (1.0 / (1.0 - 1.0 / (2.0 * ratio)) * (TAU * l / (1.0 + 2.0 * ratio)).sin()).abs());
            let free = (2.0 * ratio).recip() / ((2.0 * ratio).recip().powi(2) - 1.0) * 2.0 * (PI * ratio).cos();
            let expected = forced.fold(free.abs(), f64::max);
            let got = o.peaks(dt, &pulse).displacement * o.omega().powi(2);
            assert!((got / expected - 1.0).abs() < 1e-6, "t_d/T = {ratio}: {got}, not {expected}");
        }
    }

    #[test]
    fn steady_state_of_a_harmonic_motion() {
        // u0 = (a/ω²)/sqrt((1-r²)² + (2ζr)²), absolute acceleration a sqrt(1+(2ζr)²)/(...).
        let (frequency, amplitude) = (1.3, 2.0);
        for (period, damping) in [(0.3, 0.1), (0.9, 0.2), (3.0, 0.05)] {
            let o = Oscillator { period, damping };
            let dt = 0.002;
            let a: Vec<f64> = (0..60_000).map(|i| amplitude * (TAU * frequency * dt * f64::from(i)).sin()).collect();
            let u = o.displacements(dt, &a);
            let late = &u[u.len() * 3 / 4..u.len() * 9 / 10];
            let got = late.iter().fold(0.0f64, |m, u| m.max(u.abs()));
            let r = frequency * period;
            let (c, s) = (1.0 - r * r, 2.0 * damping * r);
            let expected = amplitude / o.omega().powi(2) / c.hypot(s);
            assert!((got / expected - 1.0).abs() < 1e-3, "{period}: {got}, not {expected}");
            let absolute = o.accelerations(dt, &a);
            let late = &absolute[absolute.len() * 3 / 4..absolute.len() * 9 / 10];
            let got = late.iter().fold(0.0f64, |m, u| m.max(u.abs()));
            assert!((got / (amplitude * 1.0f64.hypot(s) / c.hypot(s)) - 1.0).abs() < 1e-3);
        }
    }

    #[test]
    fn division_of_coarse_steps_changes_nothing_but_finds_the_peaks() {
        // The same broken line sampled 16 times as densely.
        let coarse: Vec<f64> = (0..200).map(|i| ((f64::from(i) * 12.9898).sin() * 43758.5453).fract()).collect();
        let mut dense = vec![];
        for w in coarse.windows(2) {
            dense.extend((0..16).map(|k| w[0] + (w[1] - w[0]) * f64::from(k) / 16.0));
        }
        dense.push(coarse[199]);
        for period in [0.011, 0.04, 0.3, 2.0] {
            let o = Oscillator { period, damping: 0.05 };
            // The same free vibration needs the same fall to zero after the end.
            let with_zero = |mut x: Vec<f64>, n: usize| {
                let last = x[x.len() - 1];
                x.extend((1..=n).map(|k| last * (1.0 - k as f64 / n as f64)));
                x
            };
            let a = o.peaks(0.02, &with_zero(coarse.clone(), 1));
            let b = o.peaks(0.02 / 16.0, &with_zero(dense.clone(), 16));
            for (a, b) in [(a.displacement, b.displacement), (a.velocity, b.velocity), (a.acceleration, b.acceleration)]
            {
                assert!((a / b - 1.0).abs() < 1e-4, "{period}: {a} and {b}");
            }
        }
    }
}

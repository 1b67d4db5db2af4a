//! Measures of the intensity and duration of a motion, and the check of its baseline.

use super::{G, Motion, largest};
use std::f64::consts::PI;

/// Measures of a motion.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Intensity {
    /// Peak acceleration in m/s².
    pub pga: f64,
    /// Peak velocity in m/s.
    pub pgv: f64,
    /// Peak displacement in m.
    pub pgd: f64,
    /// Arias intensity π/(2g) ∫a² dt in m/s (Arias 1970).
    pub arias: f64,
    /// Time between 5 and 75 % of the Arias intensity in s.
    pub d5_75: f64,
    /// Time between 5 and 95 % of the Arias intensity in s (Trifunac and Brady 1975).
    pub d5_95: f64,
    /// Cumulative absolute velocity ∫|a| dt in m/s.
    pub cav: f64,
}

/// End of the integrated motion, which is at rest in the ground.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Baseline {
    /// Velocity at the end as a share of the largest.
    pub velocity: f64,
    /// Displacement at the end as a share of the largest.
    pub displacement: f64,
}

/// Share of the peak velocity at the end of the record above which the baseline is suspect.
const MAX_FINAL_VELOCITY: f64 = 0.1;

impl Baseline {
    /// True if the record ends with a velocity that no ground has.
    pub fn is_suspect(&self) -> bool {
        self.velocity.abs() > MAX_FINAL_VELOCITY
    }
}

impl Motion {
    /// Measures of the motion. The acceleration is linear between samples, and integrals are exact for it.
    pub fn intensity(&self) -> Intensity {
        let (v, u) = self.integrated();
        let pieces = self.acceleration.windows(2);
        let squares: Vec<f64> =
            pieces.clone().map(|a| self.dt * (a[0] * a[0] + a[0] * a[1] + a[1] * a[1]) / 3.0).collect();
        let total: f64 = squares.iter().sum();
        let time = |share: f64| self.time_of(&squares, share * total);
        Intensity {
            pga: self.peak(),
            pgv: largest(&v),
            pgd: largest(&u),
            arias: PI / (2.0 * G) * total,
            d5_75: time(0.75) - time(0.05),
            d5_95: time(0.95) - time(0.05),
            cav: pieces.map(|a| self.dt * absolute_mean(a[0], a[1])).sum(),
        }
    }

    /// Time at which the sum of the integrals over the steps reaches a value.
    fn time_of(&self, steps: &[f64], value: f64) -> f64 {
        let mut sum = 0.0;
        for (i, s) in steps.iter().enumerate() {
            if sum + s >= value && *s > 0.0 {
                return self.dt * (i as f64 + (value - sum) / s);
            }
            sum += s;
        }
        self.dt * steps.len() as f64
    }

    /// Velocity and displacement at the end of the record.
    pub fn baseline(&self) -> Baseline {
        let (v, u) = self.integrated();
        let share = |x: &[f64]| match (x.last(), largest(x)) {
            (Some(last), top) if top > 0.0 => last / top,
            _ => 0.0,
        };
        Baseline { velocity: share(&v), displacement: share(&u) }
    }
}

/// Mean of |a| over a step in which a is linear.
fn absolute_mean(a: f64, b: f64) -> f64 {
    if a * b >= 0.0 { 0.5 * (a + b).abs() } else { 0.5 * (a * a + b * b) / (a.abs() + b.abs()) }
}

#[cfg(test)]
mod tests {
    use super::super::{G, Motion};
    use std::f64::consts::{PI, TAU};

    #[test]
    fn measures_of_a_sine_of_whole_periods() {
        // a = A sin(ωt) over 5 s with f = 2 Hz: ∫a² = A² t/2, ∫|a| = (2/π) A t.
        let (amplitude, end) = (3.0, 5.0);
        let n = 50_000;
        let dt = end / f64::from(n);
        let acceleration = (0..=n).map(|i| amplitude * (TAU * 2.0 * dt * f64::from(i)).sin()).collect();
        let m = Motion { name: String::new(), title: String::new(), azimuth: None, dt, acceleration };
        let i = m.intensity();
        assert!((i.arias / (PI / (2.0 * G) * amplitude.powi(2) * end / 2.0) - 1.0).abs() < 1e-6);
        assert!((i.cav / (2.0 / PI * amplitude * end) - 1.0).abs() < 1e-6);
        // Durations to within the wave of the sum, a quarter of a period at most.
        assert!((i.d5_95 - 0.9 * end).abs() < 0.125 && (i.d5_75 - 0.7 * end).abs() < 0.125);
        // From rest, v = (A/ω)(1 - cos ωt).
        assert!((i.pgv - 2.0 * amplitude / (TAU * 2.0)).abs() < 1e-4);
        assert!(!m.baseline().is_suspect());
        let shifted = Motion { acceleration: m.acceleration.iter().map(|a| a + 0.1).collect(), ..m };
        assert!(shifted.baseline().is_suspect());
    }
}

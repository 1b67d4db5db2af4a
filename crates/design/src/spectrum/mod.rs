//! Response spectra of motions and pairs of them.

mod pair;

pub use hysteron_engine::analysis::{Oscillator, Peaks};
pub(crate) use pair::median;
pub use pair::{Combination, PairSpectrum, gm_rot_i};

use crate::motion::Motion;
use std::f64::consts::TAU;

/// Periods of a spectrum where none are given: from 0.02 to 10 s, 30 to a decade.
pub fn default_periods() -> Vec<f64> {
    logarithmic(0.02, 10.0, 82)
}

/// `n` periods from one to another at equal ratios.
pub fn logarithmic(from: f64, to: f64, n: usize) -> Vec<f64> {
    let last = n.max(2) - 1;
    let at = |i: usize| from * (to / from).powf(i as f64 / last as f64);
    // The ends are met to the last bit.
    (0..=last).map(|i| if i == last { to } else { at(i) }).collect()
}

/// Response spectrum of one motion.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Spectrum {
    /// Periods in s.
    pub periods: Vec<f64>,
    /// Largest responses at each period.
    pub peaks: Vec<Peaks>,
}

/// Pseudo-acceleration ω² u.
pub fn pseudo_acceleration(period: f64, displacement: f64) -> f64 {
    (TAU / period).powi(2) * displacement
}

impl Spectrum {
    /// The spectrum of a motion for a share of critical damping from 0 to less than 1.
    pub fn new(motion: &Motion, periods: &[f64], damping: f64) -> Self {
        let of = |period: &f64| Oscillator { period: *period, damping }.peaks(motion.dt, &motion.acceleration);
        Self { periods: periods.to_vec(), peaks: periods.iter().map(of).collect() }
    }

    /// Pseudo-accelerations ω² u in m/s².
    pub fn pseudo_accelerations(&self) -> Vec<f64> {
        self.periods.iter().zip(&self.peaks).map(|(t, p)| pseudo_acceleration(*t, p.displacement)).collect()
    }
}

/// Value at `x` of a line through points with rising abscissas, linear between them in the logarithms of both.
/// Beyond the ends it keeps the values of the ends. Values that are not positive are joined linearly.
pub fn interpolated(xs: &[f64], ys: &[f64], x: f64) -> f64 {
    let n = xs.len().min(ys.len());
    let at = xs[..n].partition_point(|a| *a < x);
    match at {
        _ if n == 0 => f64::NAN,
        0 => ys[0],
        i if i == n => ys[n - 1],
        i => {
            let (x0, x1, y0, y1) = (xs[i - 1], xs[i], ys[i - 1], ys[i]);
            if x0 > 0.0 && y0 > 0.0 && y1 > 0.0 {
                (y0.ln() + (y1 / y0).ln() * (x / x0).ln() / (x1 / x0).ln()).exp()
            } else {
                y0 + (y1 - y0) * (x - x0) / (x1 - x0)
            }
        }
    }
}

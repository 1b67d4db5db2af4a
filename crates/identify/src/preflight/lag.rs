//! Delay of a recorded channel against the simulated one.

use crate::fourier::{Complex, forward, inverse};

/// Largest number of points of the uniform grid.
const MAX_GRID: usize = 8192;
/// Largest delay, over the length of the record.
const MAX_LAG: f64 = 0.2;
/// A shorter delay is preferred to one whose error is no more than this part smaller.
const TOLERANCE: f64 = 0.05;
/// A shorter delay is preferred if it leaves no more than this part of the error without a delay, and no more than
/// `MAX_EXCESS` times the least error.
const SUFFICIENT: f64 = 0.25;
const MAX_EXCESS: f64 = 4.0;
/// Least number of periods of a vibration.
const MIN_PERIODS: f64 = 2.0;
/// Swing about the mean, in standard deviations, that counts as a half cycle.
const MIN_SWING: f64 = 0.25;
/// Correlation at another delay, over that at the best one, from which the delay is not the only one.
const MAX_OTHER_CORRELATION: f64 = 0.8;
/// Departure from rest, over the largest one, at which a motion has begun.
const ONSET: f64 = 0.1;
/// Share of the samples whose mean is the value at rest.
const REST_SHARE: f64 = 0.005;
/// Difference between a delay and that of the onsets, in parts of the delay or of a period.
const ONSET_TOLERANCE: f64 = 0.1;
const ONSET_PERIODS: f64 = 0.25;

/// Sums of two series over their common samples, for each delay of a uniform grid.
pub(super) struct LagScan {
    /// Spacing of the grid, s.
    step: f64,
    /// Variance of the recorded series.
    variance: f64,
    /// Means of the recorded and the simulated series.
    means: [f64; 2],
    /// The recorded and the simulated series on the grid.
    series: [Vec<f64>; 2],
    /// Delays in grid steps, with the number of common samples.
    lags: Vec<i64>,
    counts: Vec<f64>,
    recorded_squares: Vec<f64>,
    simulated_squares: Vec<f64>,
    products: Vec<f64>,
}

/// A delay with its error.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lag {
    /// Delay of the recorded channel, s; negative if it is early.
    pub(super) seconds: f64,
    /// NMSE of the simulated channel with that delay.
    pub(super) nmse: f64,
}

impl LagScan {
    /// Scans the delays up to a fifth of the record. `None` if a series has fewer than 16 samples or is constant.
    pub(super) fn new(times: &[f64], recorded: &[f64], simulated: &[f64]) -> Option<Self> {
        let (first, last) = (times.first()?, times.last()?);
        let n = times.len().min(MAX_GRID);
        let step = (last - first) / (n - 1) as f64;
        let on_grid = |values: &[f64]| {
            let points: Vec<(f64, f64)> =
                times.iter().copied().zip(values.iter().copied()).filter(|p| p.1.is_finite()).collect();
            (points.len() > 15).then(|| resampled(&points, *first, step, n))
        };
        let (v, y) = (on_grid(recorded)?, on_grid(simulated)?);
        let mean = v.iter().sum::<f64>() / n as f64;
        let variance = v.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / n as f64;
        if variance <= 0.0 {
            return None;
        }
        let most = ((MAX_LAG * n as f64) as i64).max(1);
        let products = cross_products(&v, &y, most as usize);
        let (vv, yy) = (cumulative_squares(&v), cumulative_squares(&y));
        let lags: Vec<i64> = (-most..=most).collect();
        // A delay of k steps compares v[i] with y[i - k].
        let window = |k: i64| if k >= 0 { (k as usize, n) } else { (0, n - k.unsigned_abs() as usize) };
        let shifted = |k: i64| if k >= 0 { (0, n - k as usize) } else { (k.unsigned_abs() as usize, n) };
        let sum = |sums: &[f64], (from, to): (usize, usize)| sums[to] - sums[from];
        Some(Self {
            step,
            variance,
            means: [mean, y.iter().sum::<f64>() / n as f64],
            counts: lags.iter().map(|k| (n - k.unsigned_abs() as usize) as f64).collect(),
            recorded_squares: lags.iter().map(|k| sum(&vv, window(*k))).collect(),
            simulated_squares: lags.iter().map(|k| sum(&yy, shifted(*k))).collect(),
            products,
            lags,
            series: [v, y],
        })
    }

    /// Returns true if the series can tell a delay from other ones.
    ///
    /// A delay within half a period of a vibration is the nearest one. A longer one, or that of a motion which does not
    /// come back, must be the only one that fits, or both series must be at rest before or after their motion, as far
    /// apart as the delay says.
    pub(super) fn identifies(&self, seconds: f64) -> bool {
        let [v, y] = &self.series;
        let length = self.step * (v.len() - 1) as f64;
        let period = length / periods(v).max(f64::MIN_POSITIVE);
        let oscillates = length >= MIN_PERIODS * period;
        if oscillates && seconds.abs() <= 0.5 * period {
            return true;
        }
        let distance = 0.5 * if oscillates { period } else { seconds.abs() };
        self.is_only(seconds, distance) || {
            let tolerance = ONSET_TOLERANCE * seconds.abs();
            let tolerance = if oscillates { tolerance.max(ONSET_PERIODS * period) } else { tolerance };
            let later = |a: usize, b: usize| self.step * (a as f64 - b as f64);
            let backwards = |x: &[f64]| x.iter().rev().copied().collect::<Vec<_>>();
            let at_start = later(onset(v), onset(y));
            let at_end = -later(onset(&backwards(v)), onset(&backwards(y)));
            [at_start, at_end].iter().any(|lag| (lag - seconds).abs() <= tolerance)
        }
    }

    /// Returns true if no delay further than a distance from this one, and none of zero, fits nearly as well.
    fn is_only(&self, seconds: f64, distance: f64) -> bool {
        let r: Vec<f64> = self.correlations().collect();
        let of = |i: usize| (self.step * self.lags[i] as f64 - seconds).abs();
        let Some(at) = (0..r.len()).min_by(|a, b| of(*a).total_cmp(&of(*b))) else { return false };
        let is_peak = |i: usize| (i == 0 || r[i] >= r[i - 1]) && (i + 1 == r.len() || r[i] >= r[i + 1]);
        let zero = r.len() / 2;
        let others = (0..r.len()).filter(|i| *i == zero || is_peak(*i) && of(*i) > distance);
        others.map(|i| r[i]).fold(f64::NEG_INFINITY, f64::max) < MAX_OTHER_CORRELATION * r[at]
    }

    /// The delay with the least NMSE; among nearly equal ones the shortest.
    pub(super) fn best(&self) -> Lag {
        let errors: Vec<f64> = (0..self.lags.len())
            .map(|i| {
                let sum = self.recorded_squares[i] + self.simulated_squares[i] - 2.0 * self.products[i];
                sum.max(0.0) / self.counts[i] / self.variance
            })
            .collect();
        let (seconds, nmse) = self.shortest(&errors);
        Lag { seconds, nmse }
    }

    /// The delay with the largest absolute correlation, s.
    pub(super) fn most_correlated(&self) -> f64 {
        let errors: Vec<f64> = self.correlations().map(|r| 1.0 - r.abs()).collect();
        self.shortest(&errors).0
    }

    /// The largest absolute correlation at any delay.
    pub(super) fn largest_correlation(&self) -> f64 {
        self.correlations().fold(0.0, |most, r| most.max(r.abs()))
    }

    /// Correlations about the means of the whole series, by delay.
    fn correlations(&self) -> impl Iterator<Item = f64> {
        let [v, y] = self.means;
        (0..self.lags.len()).map(move |i| {
            let n = self.counts[i];
            let size = ((self.recorded_squares[i] - n * v * v) * (self.simulated_squares[i] - n * y * y)).sqrt();
            if size > 0.0 { ((self.products[i] - n * v * y) / size).clamp(-1.0, 1.0) } else { 0.0 }
        })
    }

    /// The local minimum at the shortest delay whose error is close to the least one, or much less than that without a
    /// delay; refined by a parabola.
    fn shortest(&self, errors: &[f64]) -> (f64, f64) {
        let least = errors.iter().copied().fold(f64::INFINITY, f64::min);
        let zero = errors.len() / 2;
        let is_minimum =
            |i: usize| (i == 0 || errors[i] <= errors[i - 1]) && (i + 1 == errors.len() || errors[i] <= errors[i + 1]);
        let limit = (least * (1.0 + TOLERANCE) + 1e-12).max((SUFFICIENT * errors[zero]).min(MAX_EXCESS * least));
        let near = (0..errors.len()).filter(|i| errors[*i] <= limit && is_minimum(*i));
        let at = near.min_by_key(|i| i.abs_diff(zero)).unwrap_or(zero);
        let mut lag = self.lags[at] as f64;
        if at > 0 && at + 1 < errors.len() {
            let (a, b, c) = (errors[at - 1], errors[at], errors[at + 1]);
            let curvature = a - 2.0 * b + c;
            if curvature > 0.0 {
                lag += (0.5 * (a - c) / curvature).clamp(-0.5, 0.5);
            }
        }
        (lag * self.step, errors[at])
    }
}

/// Number of periods of a series about its mean.
fn periods(x: &[f64]) -> f64 {
    let mean = x.iter().sum::<f64>() / x.len() as f64;
    let deviation = (x.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / x.len() as f64).sqrt();
    let (mut side, mut changes) = (0.0, 0);
    for x in x.iter().map(|x| x - mean).filter(|x| x.abs() > MIN_SWING * deviation) {
        changes += usize::from(side * x < 0.0);
        side = x;
    }
    0.5 * changes as f64
}

/// Index of the first sample that has left the value at rest.
fn onset(x: &[f64]) -> usize {
    let few = ((REST_SHARE * x.len() as f64) as usize).max(1);
    let rest = x[..few].iter().sum::<f64>() / few as f64;
    let most = x.iter().fold(0.0f64, |most, x| most.max((x - rest).abs()));
    x.iter().position(|x| (x - rest).abs() > ONSET * most).unwrap_or(0)
}

/// Linear interpolation of points at `n` uniform times.
fn resampled(points: &[(f64, f64)], first: f64, step: f64, n: usize) -> Vec<f64> {
    let mut k = 0;
    let at = |i: usize| {
        let t = first + step * i as f64;
        while k + 1 < points.len() && points[k + 1].0 < t {
            k += 1;
        }
        match points.get(k + 1) {
            Some(b) => {
                let a = points[k];
                let part = ((t - a.0) / (b.0 - a.0)).clamp(0.0, 1.0);
                a.1 + (b.1 - a.1) * part
            }
            None => points[k].1,
        }
    };
    (0..n).map(at).collect()
}

fn cumulative_squares(x: &[f64]) -> Vec<f64> {
    let mut sum = 0.0;
    let of = |x: &f64| {
        sum += x * x;
        sum
    };
    std::iter::once(0.0).chain(x.iter().map(of).collect::<Vec<_>>()).collect()
}

/// Σ v[i] y[i - k] for k from `-most` to `most`, by the transform of the padded series.
fn cross_products(v: &[f64], y: &[f64], most: usize) -> Vec<f64> {
    let size = (2 * v.len()).next_power_of_two();
    let spectrum = |x: &[f64]| {
        let mut z: Vec<Complex<f64>> = x.iter().map(|x| Complex::new(*x, 0.0)).collect();
        z.resize(size, Complex::default());
        forward(size).process(&mut z);
        z
    };
    let mut z: Vec<Complex<f64>> = spectrum(v).iter().zip(spectrum(y)).map(|(a, b)| a * b.conj()).collect();
    inverse(size).process(&mut z);
    let at = |k: i64| z[k.rem_euclid(size as i64) as usize].re / size as f64;
    (-(most as i64)..=most as i64).map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::LagScan;

    #[test]
    fn delay_of_a_transient_is_found() {
        let times: Vec<f64> = (0..3000).map(|i| 0.01 * f64::from(i)).collect();
        let pulse = |t: f64| (-(t - 9.0).powi(2)).exp() * (5.0 * t).sin();
        let simulated: Vec<f64> = times.iter().map(|t| pulse(*t)).collect();
        for lag in [-1.234, 0.0, 0.505] {
            let mut recorded: Vec<f64> = times.iter().map(|t| pulse(t - lag)).collect();
            recorded[500] = f64::NAN;
            let found = LagScan::new(&times, &recorded, &simulated).expect("a scan").best();
            assert!((found.seconds - lag).abs() < 1e-3 && found.nmse < 1e-3, "{lag} {found:?}");
        }
    }

    /// True if a delay of 4 s between two signals is told from others.
    fn identifies_4_s(signal: impl Fn(f64) -> f64, lag: f64) -> bool {
        let times: Vec<f64> = (0..3000).map(|i| 0.01 * f64::from(i)).collect();
        let simulated: Vec<f64> = times.iter().map(|t| signal(*t)).collect();
        let recorded: Vec<f64> = times.iter().map(|t| signal(t - lag)).collect();
        LagScan::new(&times, &recorded, &simulated).expect("a scan").identifies(lag)
    }

    #[test]
    fn whole_periods_and_ramps_show_no_delay_unless_both_are_at_rest() {
        let growing = |t: f64| (1.0 + 0.05 * t) * (std::f64::consts::PI * t).sin();
        assert!(!identifies_4_s(growing, 4.0) && !identifies_4_s(growing, -4.0), "two periods of a sine");
        assert!(identifies_4_s(growing, 0.3), "a part of a period");
        let from_rest = |t: f64| if (6.0..24.0).contains(&t) { growing(t - 6.0) } else { 0.0 };
        assert!(identifies_4_s(from_rest, 4.0) && identifies_4_s(from_rest, -4.0), "a sine that begins from rest");
        let ramp = |t: f64| 0.1 * t;
        assert!(!identifies_4_s(ramp, 4.0) && !identifies_4_s(ramp, -4.0), "a ramp");
        let hold = |t: f64| (t - 6.0).clamp(0.0, 10.0);
        assert!(identifies_4_s(hold, 4.0), "a ramp that begins from rest");
        let transient = |t: f64| (-(t - 12.0).powi(2)).exp() * (5.0 * t).sin();
        assert!(identifies_4_s(transient, 4.0) && identifies_4_s(transient, -4.0), "a transient");
    }
}

//! Low-pass filters whose damping is a wanted function of the frequency.
//!
//! A filter of cut-off ω_c gives the loss 2 (ω/ω_c) / (1 + (ω/ω_c)²) of its coefficient.

use nalgebra::{DMatrix, DVector};

/// 2 π with the digits of OpenSees.
#[expect(clippy::approx_constant, reason = "the filters are to be those of OpenSees")]
const TWO_PI: f64 = 6.28318530718;

/// Largest number of filters beyond the first that is tried for a uniform damping.
const MAX_FILTERS: usize = 101;

/// Largest difference between the damping of the filters and a uniform one, as a part of it.
const UNIFORM_TOLERANCE: f64 = 0.05;

/// Filters of a damping.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Filters {
    /// Circular cut-off frequency of each, rad/time.
    pub cutoff: Vec<f64>,
    /// Coefficient of each.
    pub coefficient: Vec<f64>,
}

impl Filters {
    /// Filters from cut-off frequencies in cycles per time and their coefficients.
    pub fn new(frequencies: &[f64], coefficient: Vec<f64>) -> Self {
        Self { cutoff: frequencies.iter().map(|f| f * TWO_PI).collect(), coefficient }
    }

    /// Damping ratio at a circular frequency.
    fn ratio(&self, omega: f64) -> f64 {
        self.cutoff.iter().zip(&self.coefficient).map(|(c, a)| a * loss(omega / c)).sum()
    }

    /// Filters of unit damping ratio between two frequencies, in cycles per time (Tian, Huang, Qu, Fei and Lu, 2022,
    /// <https://doi.org/10.1080/13632469.2022.2124557>). `None` if no number of them is good enough.
    pub fn uniform(first: f64, last: f64) -> Option<Self> {
        let (first, last) = (first.log10(), last.log10());
        (2..=MAX_FILTERS).find_map(|n| {
            let points: Vec<(f64, f64)> = spaced(first, last, n).map(|f| (f, 1.0)).collect();
            let filters = least_squares(&points, spaced(first, last, 100 * n).map(|f| (f, 1.0)))?;
            let good = |f: f64| (filters.ratio(TWO_PI * 10f64.powf(f)) - 1.0).abs() <= UNIFORM_TOLERANCE;
            spaced(first, last, 100 * n).all(good).then_some(filters)
        })
    }
}

/// Loss of a filter at a frequency as a multiple of its cut-off.
fn loss(x: f64) -> f64 {
    2.0 * x / (1.0 + x * x)
}

/// `n` numbers from `first` to `last`.
fn spaced(first: f64, last: f64, n: usize) -> impl Iterator<Item = f64> {
    let step = (last - first) / (n - 1) as f64;
    (0..n).map(move |i| first + i as f64 * step)
}

fn solve(matrix: DMatrix<f64>, right: &DVector<f64>) -> Option<Vec<f64>> {
    Some(matrix.lu().solve(right)?.as_slice().to_vec())
}

/// Filters at these points whose ratios have the least squares of errors at the samples: pairs of log10 of the frequency
/// and the ratio there.
fn least_squares(points: &[(f64, f64)], samples: impl Iterator<Item = (f64, f64)>) -> Option<Filters> {
    let n = points.len();
    let cutoff: Vec<f64> = points.iter().map(|p| TWO_PI * 10f64.powf(p.0)).collect();
    let (mut right, mut matrix) = (DVector::zeros(n), DMatrix::zeros(n, n));
    for (log, ratio) in samples {
        let omega = TWO_PI * 10f64.powf(log);
        let phi: Vec<f64> = cutoff.iter().map(|c| loss(omega / c)).collect();
        for j in 0..n {
            right[j] += phi[j] * ratio * points[j].1;
            for k in 0..n {
                matrix[(j, k)] += phi[j] * phi[k] * points[j].1 * points[k].1;
            }
        }
    }
    let alpha = solve(matrix, &right)?;
    Some(Filters { cutoff, coefficient: alpha.iter().zip(points).map(|(a, p)| a * p.1).collect() })
}

/// A wanted damping ratio, piecewise linear over the logarithm of the frequency.
#[derive(Clone, Debug)]
struct Target {
    log: Vec<f64>,
    ratio: Vec<f64>,
}

/// Octaves beyond the range in which the damping must not grow or become negative.
const OCTAVES: i32 = 7;
/// Step of log10 of the frequency in the sums of squares.
const SUM_STEP: f64 = 0.005;
/// Damping ratio up to which the error counts absolutely, and that error.
const SMALL_RATIO: (f64, f64) = (0.005, 0.0002);

impl Target {
    fn slope(&self, i: usize) -> f64 {
        (self.ratio[i + 1] - self.ratio[i]) / (self.log[i + 1] - self.log[i])
    }

    /// Frequencies from the first to the last, with the ratios there.
    fn sampled(&self, n: usize) -> Vec<(f64, f64)> {
        let last = self.log.len() - 2;
        let first = self.log[0];
        let step = (self.log[last + 1] - first) / (n - 1) as f64;
        // Line of each sample: the first whose end the sample does not exceed by more than a step's rounding.
        let line = |sample: usize| {
            let within = |i: &usize| ((self.log[i + 1] - first) / step).floor() + 1.0 > sample as f64;
            if sample == 0 {
                0
            } else if sample + 1 == n {
                last
            } else {
                (0..=last).find(within).unwrap_or(0)
            }
        };
        let mut at = first - step;
        (0..n)
            .map(|i| {
                at += step;
                let line = line(i);
                let slope = self.slope(line);
                (first + i as f64 * step, slope * at + (self.ratio[line] - slope * self.log[line]))
            })
            .collect()
    }

    /// `n` equal parts of every line, and its last point.
    fn divided(&self, n: usize) -> Vec<(f64, f64)> {
        let mut all = vec![];
        for i in 0..self.log.len() - 1 {
            for j in 0..n {
                let at = self.log[i] + (self.log[i + 1] - self.log[i]) / n as f64 * j as f64;
                let slope = self.slope(i);
                all.push((at, slope * at + (self.ratio[i] - slope * self.log[i])));
            }
        }
        all.extend(self.log.last().zip(self.ratio.last()).map(|(l, r)| (*l, *r)));
        all
    }

    /// Filters at these points with the wanted ratios at the points themselves.
    fn collocated(points: &[(f64, f64)]) -> Option<Filters> {
        let n = points.len();
        let cutoff: Vec<f64> = points.iter().map(|p| TWO_PI * 10f64.powf(p.0)).collect();
        let right = DVector::from_iterator(n, points.iter().map(|p| p.1));
        let matrix = DMatrix::from_fn(n, n, |i, j| points[j].1 * loss(cutoff[i] / cutoff[j]));
        let alpha = solve(matrix, &right)?;
        Some(Filters { cutoff, coefficient: alpha.iter().zip(points).map(|(a, p)| a * p.1).collect() })
    }

    fn fits(filters: &Filters, samples: &[(f64, f64)], tolerance: f64) -> bool {
        samples.iter().all(|(log, ratio)| {
            let error = (filters.ratio(TWO_PI * 10f64.powf(*log)) - ratio).abs();
            if *ratio > SMALL_RATIO.0 { error / ratio <= tolerance } else { error <= SMALL_RATIO.1 }
        })
    }

    /// Returns true if the damping beyond both ends is between none and that of the end.
    fn fades(&self, filters: &Filters, points: &[(f64, f64)]) -> bool {
        let octave = 2f64.log10();
        let end = |at: f64, step: f64, ratio: f64| {
            (1..=OCTAVES).all(|i| (0.0..=ratio).contains(&filters.ratio(TWO_PI * 10f64.powf(at + f64::from(i) * step))))
        };
        let (first, last) = (points[0].1, points[points.len() - 1].1);
        end(self.log[0], -octave, first) && end(self.log[self.log.len() - 1], octave, last)
    }
}

/// Filters for damping ratios at some frequencies, in cycles per time, that rise (Tian and others, as for
/// [`Filters::uniform`]). `None` if no number of them up to about `rounds` is good enough.
pub fn user_defined(frequencies: &[f64], ratios: &[f64], tolerance: f64, rounds: usize) -> Option<Filters> {
    let target = Target { log: frequencies.iter().map(|f| f.log10()).collect(), ratio: ratios.to_vec() };
    let range = target.log[target.log.len() - 1] - target.log[0];
    let samples = target.sampled((range / SUM_STEP).ceil() as usize + 1);
    let squares = |points: Vec<(f64, f64)>| {
        let filters = least_squares(&points, samples.iter().copied())?;
        (Target::fits(&filters, &samples, tolerance) && target.fades(&filters, &points)).then_some(filters)
    };
    let collocated = |n: usize| {
        let points = target.divided(n);
        let filters = Target::collocated(&points)?;
        target.fades(&filters, &points).then_some(filters)
    };
    (2..=rounds + 1)
        .find_map(|n| squares(target.sampled(n)))
        .or_else(|| (1..=rounds).find_map(collocated))
        .or_else(|| (1..=rounds).find_map(|n| squares(target.divided(n))))
}

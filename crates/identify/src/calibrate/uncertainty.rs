//! How sure the parameters are, from the curvature of the objective at its least.
//!
//! The parameters minimise Σ w_c |r_c|², r_c the differences of channel c. Their covariance is that of this estimator under
//! noise of standard deviation σ_c whose autocorrelation makes n_c samples worth n_c/τ_c:
//!
//! C = H⁻¹ (Σ w_c² σ_c² τ_c J_cᵀJ_c) H⁻¹,  H = Σ w_c J_cᵀJ_c  (the "sandwich"; White, 1982),
//!
//! with σ_c² the mean square of r_c and τ_c = 1 + 2 Σ ρ_k its integrated autocorrelation, summed while adjacent pairs are
//! positive (Geyer, 1992). Where the model cannot follow the data the differences are no noise, and the intervals tell
//! how well the data fix the best fit, not how near that is to the truth.

use super::problem::{Problem, StudyProblem};
use crate::study::{Fit, Range, Role, Scale};
use nalgebra::{DMatrix, DVector, SymmetricEigen};
use serde::Serialize;

/// Interval of a parameter.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Interval {
    /// Name.
    pub name: String,
    /// Best value.
    pub value: f64,
    /// Ends of the 95 % confidence interval, within the bounds.
    pub lower: f64,
    /// Upper end.
    pub upper: f64,
    /// Standard error in sides of the unit cube: the range of the study is 1.
    pub relative: f64,
}

/// What the data determine.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Uncertainty {
    /// Intervals of the free parameters.
    pub intervals: Vec<Interval>,
    /// Correlations of the free parameters, row by row.
    pub correlation: Vec<Vec<f64>>,
    /// Samples of all channels, and what they are worth given their autocorrelation.
    pub samples: f64,
    /// Independent samples.
    pub effective_samples: f64,
    /// What the data do not determine, in sentences; empty if they determine everything.
    pub undetermined: Vec<String>,
    /// What each run to be fitted determines by itself, where there are several.
    pub alone: Vec<Alone>,
}

impl Uncertainty {
    /// What the data, and each run by itself, do not determine, in sentences.
    pub fn notes(&self) -> Vec<String> {
        let blind = self.alone.iter().filter(|a| !a.undetermined.is_empty());
        let blind = blind.map(|a| format!("{} alone does not determine {}", a.run, a.undetermined.join(", ")));
        self.undetermined.iter().cloned().chain(blind).collect()
    }
}

/// What a run would determine if it were the only one.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Alone {
    /// Its name.
    pub run: String,
    /// Standard errors of the free parameters, in sides of the unit cube.
    pub relative: Vec<f64>,
    /// The parameters that it does not determine.
    pub undetermined: Vec<String>,
}

/// Two-sided 95 % point of the normal distribution.
const Z95: f64 = 1.959_963_985;
/// Step of the differences, in sides of the cube.
const STEP: f64 = 1e-4;
/// Correlation from which two parameters stand for each other.
const TIED: f64 = 0.95;
/// Curvature of a direction without influence, over the largest of a coordinate.
const WEAK: f64 = 1e-9;
/// Standard error, in sides of the cube, from which a parameter is not determined: its interval is its range.
const WIDE: f64 = 0.25;

/// Integrated autocorrelation of some differences, in samples.
pub fn autocorrelation_time(r: &[f64]) -> f64 {
    let n = r.len();
    let mean = r.iter().sum::<f64>() / n as f64;
    let c = |k: usize| r[..n - k].iter().zip(&r[k..]).map(|(a, b)| (a - mean) * (b - mean)).sum::<f64>();
    let c0 = c(0);
    if n < 4 || c0 <= 0.0 {
        return 1.0;
    }
    let mut sum = 0.0;
    let mut k = 0;
    while 2 * k + 1 < n / 2 {
        let pair = (c(2 * k) + c(2 * k + 1)) / c0;
        if pair <= 0.0 {
            break;
        }
        sum += pair;
        k += 1;
    }
    (2.0 * sum - 1.0).clamp(1.0, n as f64 / 2.0)
}

/// Curvature of the objective, and the noise in its slope: H, and the middle of the sandwich.
struct Curvature {
    hessian: DMatrix<f64>,
    middle: DMatrix<f64>,
    /// Independent samples.
    effective: f64,
}

/// What a curvature determines.
struct Known {
    /// Standard errors in sides of the cube.
    error: Vec<f64>,
    correlation: Vec<Vec<f64>>,
    /// Parameters that each direction without influence moves.
    idle: Vec<Vec<usize>>,
}

impl Known {
    /// Whether a parameter has the whole range for its interval.
    fn is_open(&self, i: usize) -> bool {
        self.idle.iter().any(|d| d.contains(&i))
    }
}

impl Curvature {
    fn new(n: usize) -> Self {
        Self { hessian: DMatrix::zeros(n, n), middle: DMatrix::zeros(n, n), effective: 0.0 }
    }

    /// Add a channel: its differences, which carry the weights already, and their derivatives.
    fn add(&mut self, r: &[f64], j: &DMatrix<f64>) {
        let n = r.len() as f64;
        let tau = autocorrelation_time(r);
        let noise = r.iter().map(|x| x * x).sum::<f64>() / n;
        let jj = j.transpose() * j;
        self.middle += &jj * (noise * tau);
        self.hessian += jj;
        self.effective += n / tau;
    }

    fn join(&mut self, other: &Self) {
        self.hessian += &other.hessian;
        self.middle += &other.middle;
        self.effective += other.effective;
    }

    /// What it determines; `None` where nothing has an influence. A direction without influence is left out of the
    /// covariance.
    fn known(self) -> Option<Known> {
        let n = self.hessian.nrows();
        let largest = self.hessian.diagonal().max();
        if largest <= 0.0 {
            return None;
        }
        let eigen = SymmetricEigen::new(self.hessian);
        let is_weak = |k: usize| eigen.eigenvalues[k] <= WEAK * largest;
        let moved = |k: usize| (0..n).filter(|i| eigen.eigenvectors[(*i, k)].abs() > 0.1).collect();
        let idle = (0..n).filter(|k| is_weak(*k)).map(moved).collect();
        let mut known = Known { error: vec![1.0; n], correlation: vec![vec![0.0; n]; n], idle };
        let kept = DVector::from_fn(n, |k, _| if is_weak(k) { 0.0 } else { 1.0 / eigen.eigenvalues[k] });
        let inverse = &eigen.eigenvectors * DMatrix::from_diagonal(&kept) * eigen.eigenvectors.transpose();
        let covariance = &inverse * self.middle * &inverse;
        let deviation = |i: usize| covariance[(i, i)].max(0.0).sqrt();
        for i in 0..n {
            known.correlation[i][i] = 1.0;
            if known.is_open(i) {
                continue;
            }
            known.error[i] = deviation(i);
            for k in (0..i).filter(|k| !known.is_open(*k)).collect::<Vec<_>>() {
                let product = deviation(i) * deviation(k);
                if product > 0.0 {
                    let rho = (covariance[(i, k)] / product).clamp(-1.0, 1.0);
                    (known.correlation[i][k], known.correlation[k][i]) = (rho, rho);
                }
            }
        }
        Some(known)
    }
}

/// Work out what the data determine at the best point.
///
/// # Errors
/// A point beside the best has no answer, or nothing has an influence.
pub fn uncertainty(problem: &StudyProblem, point: &[f64]) -> Result<Uncertainty, String> {
    let study = problem.study().clone();
    let n = point.len();
    let moved = |i: usize, h: f64| {
        let mut p = point.to_vec();
        p[i] = (p[i] + h).clamp(0.0, 1.0);
        p
    };
    let mut points = vec![point.to_vec()];
    points.extend((0..n).flat_map(|i| [moved(i, STEP), moved(i, -STEP)]));
    let evaluated = problem.evaluate(&points, true);
    if let Some(m) = evaluated.iter().find_map(|e| e.mishap.as_ref()) {
        return Err(format!("beside the best point there is no answer: {m}"));
    }
    let r = &evaluated[0].trial.residuals;
    if evaluated.iter().any(|e| e.trial.residuals.len() != r.len()) {
        return Err("beside the best point the analysis ends at another time".into());
    }
    let columns: Vec<Vec<f64>> = (0..n)
        .map(|i| {
            let (up, down) = (1 + 2 * i, 2 + 2 * i);
            let h = points[up][i] - points[down][i];
            let pairs = evaluated[up].trial.residuals.iter().zip(&evaluated[down].trial.residuals);
            pairs.map(|(a, b)| (a - b) / h).collect()
        })
        .collect();
    let values = study.space.values(point).map_err(|o| o.to_string())?;
    let runs: Vec<usize> = study.runs_of(Role::Fit).map(|(i, _)| i).collect();
    let fits = problem.fits(&runs, &values);
    let fits: Vec<&Fit> = fits.iter().flatten().collect();
    let mut all = Curvature::new(n);
    let mut by_run = vec![];
    let mut start = 0;
    for ((_, run), fit) in study.runs_of(Role::Fit).zip(&fits) {
        let mut alone = Curvature::new(n);
        for score in &fit.scores {
            let end = start + score.samples;
            let j = DMatrix::from_fn(score.samples, n, |row, col| columns[col][start + row]);
            alone.add(&r[start..end], &j);
            start = end;
        }
        all.join(&alone);
        by_run.push((run.name.clone(), alone));
    }
    let effective = all.effective;
    let Some(known) = all.known() else {
        return Err("no parameter has an influence on what was recorded".into());
    };
    let free: Vec<(&str, &Range)> =
        study.space.free().map(|(i, range)| (study.space.parameters[i].name.as_str(), range)).collect();
    let mut undetermined: Vec<String> = vec![];
    for direction in &known.idle {
        let names: Vec<&str> = direction.iter().map(|i| free[*i].0).collect();
        undetermined.push(match &names[..] {
            [one] => format!("{one} has no influence on what was recorded"),
            several => format!("only a combination of {} has an influence on what was recorded", several.join(", ")),
        });
    }
    let intervals: Vec<Interval> =
        free.iter().enumerate().map(|(i, f)| interval(f, point[i], known.error[i])).collect();
    for (i, interval) in intervals.iter().enumerate() {
        let name = &interval.name;
        if interval.relative > WIDE && !known.is_open(i) {
            undetermined
                .push(format!("{name} is not determined: its interval is as wide as half of its range or more"));
        }
        for ((other, _), rho) in free.iter().zip(&known.correlation[i]).take(i) {
            if rho.abs() > TIED {
                undetermined
                    .push(format!("{other} and {name} are determined together only: their correlation is {rho:.3}"));
            }
        }
    }
    // A study of one run has said it already.
    let by_run = if by_run.len() > 1 { by_run } else { vec![] };
    let alone = by_run.into_iter().map(|(run, curvature)| {
        let error = curvature.known().map_or_else(|| vec![1.0; n], |k| k.error);
        let undetermined = free.iter().zip(&error).filter(|(_, e)| **e > WIDE).map(|(f, _)| f.0.to_owned()).collect();
        Alone { run, relative: error, undetermined }
    });
    let alone = alone.collect();
    let (correlation, samples) = (known.correlation, r.len() as f64);
    Ok(Uncertainty { intervals, correlation, samples, effective_samples: effective, undetermined, alone })
}

/// The interval of a parameter from its standard error in sides of the cube; for a logarithmic scale that of its logarithm.
fn interval((name, range): &(&str, &Range), place: f64, error: f64) -> Interval {
    let value = range.value(place);
    let at = |side: f64| match range.scale {
        Scale::Linear => value + side * Z95 * error * range.slope(place),
        Scale::Log => value * (side * Z95 * error * range.slope(place) / value).exp(),
    };
    let inside = |x: f64| x.clamp(range.lower, range.upper);
    Interval { name: (*name).to_owned(), value, lower: inside(at(-1.0)), upper: inside(at(1.0)), relative: error }
}

#[cfg(test)]
mod tests {
    use super::autocorrelation_time;

    #[test]
    fn autocorrelation_of_known_noise() {
        // First-order autoregressive noise with coefficient a has τ = (1 + a)/(1 - a).
        let mut state = 12345u64;
        let mut uniform = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
        };
        let mut x = 0.0;
        let red: Vec<f64> = (0..20_000)
            .map(|_| {
                x = 0.8 * x + uniform();
                x
            })
            .collect();
        assert!((autocorrelation_time(&red) - 9.0).abs() < 1.5);
        let white: Vec<f64> = (0..20_000).map(|_| uniform()).collect();
        assert!(autocorrelation_time(&white) < 1.2);
    }
}

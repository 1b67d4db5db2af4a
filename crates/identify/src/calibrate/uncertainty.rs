//! Uncertainty of the parameters from the curvature of the objective at its minimum.
//!
//! The parameters minimise Σ w_c |r_c|² with the differences r_c of channel c. The noise of channel c has the standard
//! deviation σ_c, and its autocorrelation leaves n_c/τ_c independent samples of n_c. The covariance of the estimator is
//!
//! C = H⁻¹ (Σ w_c² σ_c² τ_c J_cᵀJ_c) H⁻¹,  H = Σ w_c J_cᵀJ_c  (the "sandwich"; White, 1982),
//!
//! with σ_c² the mean square of r_c and the integrated autocorrelation τ_c = 1 + 2 Σ ρ_k, summed while adjacent pairs are
//! positive (Geyer, 1992). If the model cannot follow the data, the differences are no noise. [`Judgement`] finds that, and
//! the covariance is widened by the discrepancy.

use super::judgement::{Discrepancy, Influence, Judgement, judge};
use super::problem::{Problem, StudyProblem};
use crate::report::with_half_width;
use crate::study::{ParameterRange, Role, Scale, ScoredRun};
use nalgebra::{DMatrix, DVector, SymmetricEigen};
use serde::Serialize;

/// Confidence interval of a parameter.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Interval {
    /// Name.
    pub name: String,
    /// Best value.
    pub value: f64,
    /// Lower end of the 95 % confidence interval, within the bounds.
    pub lower: f64,
    /// Upper end of the 95 % confidence interval, within the bounds.
    pub upper: f64,
    /// The interval before it was widened by the discrepancy between model and recordings; `None` if there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub from_noise: Option<[f64; 2]>,
    /// Standard error of the unit coordinate, in sides of the cube.
    #[serde(rename = "relative")]
    pub standard_error: f64,
}

impl Interval {
    /// Value, lower and upper end with as many digits as the half width of the interval supports.
    pub fn shown(&self) -> [String; 3] {
        let half_width = 0.5 * (self.upper - self.lower);
        [self.value, self.lower, self.upper].map(|x| with_half_width(x, half_width))
    }
}

/// Uncertainty of the free parameters.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Uncertainty {
    /// Intervals of the free parameters.
    pub intervals: Vec<Interval>,
    /// Correlation matrix of the free parameters, by rows.
    pub correlation: Vec<Vec<f64>>,
    /// Number of samples of all channels.
    pub samples: f64,
    /// Number of independent samples.
    pub effective_samples: f64,
    /// Sentences about parameters that the data do not determine.
    pub undetermined: Vec<String>,
    /// Uncertainty from each fitted run alone; empty for a single run.
    #[serde(rename = "alone")]
    pub by_run: Vec<RunUncertainty>,
    /// Judgement of the residual. The intervals are widened by it.
    #[serde(skip)]
    pub judgement: Judgement,
}

impl Uncertainty {
    /// Sentences about parameters that the data, or single runs, do not determine.
    pub fn notes(&self) -> Vec<String> {
        let incomplete = self.by_run.iter().filter(|r| !r.undetermined.is_empty());
        let of_runs = incomplete.map(|r| format!("{} alone does not determine {}", r.run, r.undetermined.join(", ")));
        self.undetermined.iter().cloned().chain(of_runs).collect()
    }
}

/// Uncertainty of the free parameters if a run were the only one.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RunUncertainty {
    /// Name of the run.
    pub run: String,
    /// Standard errors of the unit coordinates, in sides of the cube.
    #[serde(rename = "relative")]
    pub standard_errors: Vec<f64>,
    /// Names of the parameters that the run does not determine.
    pub undetermined: Vec<String>,
}

/// Two-sided 95 % point of the normal distribution.
const Z95: f64 = 1.959_963_985;
/// Step of the central differences, in sides of the cube.
const DIFFERENCE_STEP: f64 = 1e-4;
/// Two parameters with a larger correlation are determined together only.
const MAX_CORRELATION: f64 = 0.95;
/// A direction with a smaller curvature, relative to the largest of a coordinate, has no influence.
const MIN_RELATIVE_CURVATURE: f64 = 1e-9;
/// A parameter takes part in a direction from this component of the unit eigenvector.
const MIN_COMPONENT: f64 = 0.1;
/// A parameter with a larger standard error, in sides of the cube, is not determined: its interval is its range.
const MAX_STANDARD_ERROR: f64 = 0.25;

/// Integrated autocorrelation time of a series, in samples.
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

/// Curvature of the objective: H, and the middle matrix of the sandwich.
struct Curvature {
    hessian: DMatrix<f64>,
    middle: DMatrix<f64>,
    effective_samples: f64,
}

/// Covariance of the unit coordinates.
struct Covariance {
    /// Standard errors, in sides of the cube; 1 for parameters of a direction without influence.
    standard_errors: Vec<f64>,
    correlation: Vec<Vec<f64>>,
    /// Indices of the parameters in each direction without influence.
    null_directions: Vec<Vec<usize>>,
}

impl Covariance {
    /// Returns true if a parameter takes part in a direction without influence.
    fn is_undetermined(&self, i: usize) -> bool {
        self.null_directions.iter().any(|d| d.contains(&i))
    }
}

impl Curvature {
    fn new(n: usize) -> Self {
        Self { hessian: DMatrix::zeros(n, n), middle: DMatrix::zeros(n, n), effective_samples: 0.0 }
    }

    /// Add the residuals `r` of a channel, with weights, and their derivatives `j` by the unit coordinates.
    fn add_channel(&mut self, r: &[f64], j: &DMatrix<f64>) {
        let n = r.len() as f64;
        let tau = autocorrelation_time(r);
        let variance = r.iter().map(|x| x * x).sum::<f64>() / n;
        let jj = j.transpose() * j;
        self.middle += &jj * (variance * tau);
        self.hessian += jj;
        self.effective_samples += n / tau;
    }

    /// Add a discrepancy to the covariance: Cov = q C + s² H⁻¹.
    fn with_discrepancy(&self, d: Discrepancy) -> Self {
        let middle = &self.middle * d.factor + &self.hessian * d.energy;
        Self { hessian: self.hessian.clone(), middle, effective_samples: self.effective_samples }
    }

    fn add(&mut self, other: &Self) {
        self.hessian += &other.hessian;
        self.middle += &other.middle;
        self.effective_samples += other.effective_samples;
    }

    /// The covariance, without the directions that have no influence; `None` if no parameter has one.
    fn covariance(self) -> Option<Covariance> {
        let n = self.hessian.nrows();
        let largest = self.hessian.diagonal().max();
        if largest <= 0.0 {
            return None;
        }
        let eigen = SymmetricEigen::new(self.hessian);
        let is_null = |k: usize| eigen.eigenvalues[k] <= MIN_RELATIVE_CURVATURE * largest;
        let members = |k: usize| (0..n).filter(|i| eigen.eigenvectors[(*i, k)].abs() > MIN_COMPONENT).collect();
        let null_directions = (0..n).filter(|k| is_null(*k)).map(members).collect();
        let mut covariance =
            Covariance { standard_errors: vec![1.0; n], correlation: vec![vec![0.0; n]; n], null_directions };
        let inverses = DVector::from_fn(n, |k, _| if is_null(k) { 0.0 } else { 1.0 / eigen.eigenvalues[k] });
        let inverse = &eigen.eigenvectors * DMatrix::from_diagonal(&inverses) * eigen.eigenvectors.transpose();
        let matrix = &inverse * self.middle * &inverse;
        let deviation = |i: usize| matrix[(i, i)].max(0.0).sqrt();
        for i in 0..n {
            covariance.correlation[i][i] = 1.0;
            if covariance.is_undetermined(i) {
                continue;
            }
            covariance.standard_errors[i] = deviation(i);
            for k in (0..i).filter(|k| !covariance.is_undetermined(*k)).collect::<Vec<_>>() {
                let product = deviation(i) * deviation(k);
                if product > 0.0 {
                    let rho = (matrix[(i, k)] / product).clamp(-1.0, 1.0);
                    (covariance.correlation[i][k], covariance.correlation[k][i]) = (rho, rho);
                }
            }
        }
        Some(covariance)
    }
}

/// Residuals at a unit point, and their derivatives by each unit coordinate.
struct Linearization {
    residuals: Vec<f64>,
    columns: Vec<Vec<f64>>,
}

impl Linearization {
    /// Central differences about a unit point; one-sided at a bound of the cube.
    fn new(problem: &StudyProblem, unit_point: &[f64]) -> Result<Self, String> {
        let n = unit_point.len();
        let moved = |i: usize, h: f64| {
            let mut p = unit_point.to_vec();
            p[i] = (p[i] + h).clamp(0.0, 1.0);
            p
        };
        let mut unit_points = vec![unit_point.to_vec()];
        unit_points.extend((0..n).flat_map(|i| [moved(i, DIFFERENCE_STEP), moved(i, -DIFFERENCE_STEP)]));
        let evaluations = problem.evaluate(&unit_points, true);
        if let Some(error) = evaluations.iter().find_map(|e| e.error.as_ref()) {
            return Err(format!("close to the best point there is no answer: {error}"));
        }
        let residuals = |k: usize| -> &Vec<f64> { &evaluations[k].trial.residuals };
        if (0..evaluations.len()).any(|k| residuals(k).len() != residuals(0).len()) {
            return Err("close to the best point the analysis ends at another time".into());
        }
        let derivative = |i: usize| {
            let (up, down) = (1 + 2 * i, 2 + 2 * i);
            let h = unit_points[up][i] - unit_points[down][i];
            residuals(up).iter().zip(residuals(down)).map(|(a, b)| (a - b) / h).collect()
        };
        Ok(Self { residuals: residuals(0).clone(), columns: (0..n).map(derivative).collect() })
    }

    /// The curvature of each run, whose residuals follow each other in the order of `scored`.
    fn curvatures<'a>(&self, scored: impl Iterator<Item = &'a ScoredRun>) -> Vec<Curvature> {
        let n = self.columns.len();
        let mut start = 0;
        let of_run = |run: &ScoredRun| {
            let mut curvature = Curvature::new(n);
            for score in &run.scores {
                let end = start + score.samples;
                let j = DMatrix::from_fn(score.samples, n, |row, col| self.columns[col][start + row]);
                curvature.add_channel(&self.residuals[start..end], &j);
                start = end;
            }
            curvature
        };
        scored.map(of_run).collect()
    }
}

/// Estimate the uncertainty of the free parameters at the best unit point.
///
/// # Errors
/// A point beside the best one has no response, or no parameter has an influence.
pub fn uncertainty(problem: &StudyProblem, unit_point: &[f64]) -> Result<Uncertainty, String> {
    let study = problem.study().clone();
    let n = unit_point.len();
    let linearization = Linearization::new(problem, unit_point)?;
    let values = study.space.values_at(unit_point).map_err(|e| e.to_string())?;
    let runs: Vec<usize> = (0..study.runs.len()).collect();
    let scored: Vec<Option<ScoredRun>> = problem.scored_runs(&runs, &values).into_iter().map(Result::ok).collect();
    let fitted = study.runs_of(Role::Fit).filter_map(|(i, _)| scored[i].as_ref());
    let curvatures = linearization.curvatures(fitted);
    let mut total = Curvature::new(n);
    curvatures.iter().for_each(|c| total.add(c));
    let effective_samples = total.effective_samples;
    let no_influence = || "no parameter has an influence on what was recorded".to_owned();
    let from_noise = total.with_discrepancy(Discrepancy::NONE).covariance().ok_or_else(no_influence)?;
    let influences = influences(problem, unit_point, &from_noise);
    let (mut judgement, discrepancy) =
        judge(&study, &scored, &linearization.residuals, &linearization.columns, &influences, unit_point);
    let covariance = total.with_discrepancy(discrepancy).covariance().ok_or_else(no_influence)?;
    let free = || study.space.free_names().zip(study.space.free()).zip(unit_point);
    let intervals_with = |errors: &[f64]| -> Vec<Interval> {
        let all = free().zip(errors).map(|(((name, (_, range)), x), error)| interval(name, range, *x, *error));
        all.collect()
    };
    let mut intervals = intervals_with(&covariance.standard_errors);
    if discrepancy != Discrepancy::NONE {
        for (wide, narrow) in intervals.iter_mut().zip(intervals_with(&from_noise.standard_errors)) {
            wide.from_noise = Some([narrow.lower, narrow.upper]);
        }
    }
    let widenings = covariance.standard_errors.iter().zip(&from_noise.standard_errors).map(|(w, n)| w / n);
    judgement.conclude(widenings.filter(|w| w.is_finite()).fold(1.0, f64::max));
    let undetermined = undetermined(&intervals, &covariance);
    // For a single run this would repeat the result of all runs.
    let by_run = if curvatures.len() > 1 { curvatures } else { vec![] };
    let by_run = study.runs_of(Role::Fit).zip(by_run).map(|((_, run), curvature)| {
        let standard_errors = curvature.covariance().map_or_else(|| vec![1.0; n], |c| c.standard_errors);
        let undetermined = study.space.free_names().zip(&standard_errors).filter(|(_, e)| **e > MAX_STANDARD_ERROR);
        let undetermined = undetermined.map(|(name, _)| name.to_owned()).collect();
        RunUncertainty { run: run.name.clone(), standard_errors, undetermined }
    });
    Ok(Uncertainty {
        by_run: by_run.collect(),
        intervals,
        correlation: covariance.correlation,
        samples: linearization.residuals.len() as f64,
        effective_samples,
        undetermined,
        judgement,
    })
}

/// Runs with one unit coordinate moved.
struct MovedRuns {
    unit_coordinate: f64,
    runs: Vec<ScoredRun>,
}

/// Influence of the uncertain parameters on each channel of each held-out run: derivatives j by the determined parameters in
/// units of their standard errors, and the mean of jᵀCj over the samples. Empty for fitted runs, and where it is not known.
fn influences(problem: &StudyProblem, unit_point: &[f64], covariance: &Covariance) -> Vec<Vec<Influence>> {
    let study = problem.study();
    let runs: Vec<usize> = study.runs_of(Role::Holdout).map(|(i, _)| i).collect();
    let mut influences: Vec<Vec<Influence>> =
        study.runs.iter().map(|r| vec![Influence::default(); r.observe.len()]).collect();
    if runs.is_empty() {
        return influences;
    }
    let simulated = |i: usize, h: f64| -> Option<MovedRuns> {
        let mut p = unit_point.to_vec();
        p[i] = (p[i] + h).clamp(0.0, 1.0);
        let values = study.space.values_at(&p).ok()?;
        let runs = problem.scored_runs(&runs, &values).into_iter().collect::<Result<_, _>>().ok()?;
        Some(MovedRuns { unit_coordinate: p[i], runs })
    };
    let determined: Vec<usize> = (0..unit_point.len()).filter(|i| !covariance.is_undetermined(*i)).collect();
    let pair = |i: &usize| Some([simulated(*i, DIFFERENCE_STEP)?, simulated(*i, -DIFFERENCE_STEP)?]);
    let Some(pairs) = determined.iter().map(pair).collect::<Option<Vec<_>>>() else { return influences };
    let correlation = |a: usize, b: usize| covariance.correlation[determined[a]][determined[b]];
    for (k, run) in runs.iter().enumerate() {
        for (c, o) in study.runs[*run].observe.iter().enumerate() {
            let column = |([up, down], i): (&[MovedRuns; 2], &usize)| {
                let scale = covariance.standard_errors[*i] / (up.unit_coordinate - down.unit_coordinate);
                let ends = up.runs[k].channels[c].iter().zip(&down.runs[k].channels[c]);
                // After the end of one of the analyses there is no derivative.
                ends.map(|(a, b)| Some(scale * (a - b)).filter(|d| d.is_finite()).unwrap_or(0.0)).collect()
            };
            let columns: Vec<Vec<f64>> = pairs.iter().zip(&determined).map(column).collect();
            let kept: Vec<usize> = (0..o.values.len()).filter(|t| !o.values[*t].is_nan()).collect();
            let product = |a: &[f64], b: &[f64]| kept.iter().map(|t| a[*t] * b[*t]).sum::<f64>();
            let mut sum = 0.0;
            for (a, first) in columns.iter().enumerate() {
                for (b, second) in columns.iter().enumerate() {
                    sum += correlation(a, b) * product(first, second);
                }
            }
            influences[*run][c] = Influence { mean_square: sum / kept.len().max(1) as f64, columns };
        }
    }
    influences
}

/// Sentences about parameters that all data together do not determine.
fn undetermined(intervals: &[Interval], covariance: &Covariance) -> Vec<String> {
    let mut sentences: Vec<String> = vec![];
    for direction in &covariance.null_directions {
        let names: Vec<&str> = direction.iter().map(|i| intervals[*i].name.as_str()).collect();
        sentences.push(match &names[..] {
            [one] => format!("{one} has no influence on what was recorded"),
            several => format!("only a combination of {} has an influence on what was recorded", several.join(", ")),
        });
    }
    for (i, interval) in intervals.iter().enumerate() {
        let name = &interval.name;
        if interval.standard_error > MAX_STANDARD_ERROR && !covariance.is_undetermined(i) {
            sentences.push(format!("{name} is not determined: its interval is as wide as half of its range or more"));
        }
        for (other, rho) in intervals.iter().zip(&covariance.correlation[i]).take(i) {
            if rho.abs() > MAX_CORRELATION {
                let other = &other.name;
                sentences
                    .push(format!("{other} and {name} are determined together only: their correlation is {rho:.3}"));
            }
        }
    }
    sentences
}

/// The interval of a parameter from the standard error of its unit coordinate. On a logarithmic scale it is the interval
/// of the logarithm.
fn interval(name: &str, range: &ParameterRange, unit_coordinate: f64, standard_error: f64) -> Interval {
    let value = range.value(unit_coordinate);
    let end = |side: f64| match range.scale {
        Scale::Linear => value + side * Z95 * standard_error * range.slope(unit_coordinate),
        Scale::Log => value * (side * Z95 * standard_error * range.slope(unit_coordinate) / value).exp(),
    };
    let clamped = |x: f64| x.clamp(range.lower, range.upper);
    let (lower, upper) = (clamped(end(-1.0)), clamped(end(1.0)));
    Interval { name: name.to_owned(), value, lower, upper, from_noise: None, standard_error }
}

#[cfg(test)]
mod tests {
    use super::autocorrelation_time;

    #[test]
    fn autocorrelation_time_of_autoregressive_noise() {
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

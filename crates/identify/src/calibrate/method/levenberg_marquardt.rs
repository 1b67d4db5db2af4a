//! Least squares by the method of Levenberg and Marquardt within the unit cube.
//!
//! It asks for all derivatives, and for several trial steps, at a time, so that all threads work. It keeps the bounds of
//! the cube. Published crates evaluate one point after the other and have no bounds.

use super::{Method, Trial, objective_spread};
use nalgebra::{DMatrix, DVector};
use serde::{Deserialize, Serialize};

/// The points that are asked for next.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
enum Phase {
    /// The starting point.
    Start,
    /// Points beside the current one, for derivatives by differences.
    Derivatives,
    /// Trial steps, one for each damping factor.
    Steps,
    /// No points: the search has ended.
    Ended,
}

/// The method of Levenberg and Marquardt, with derivatives by differences and several damping factors at a time.
/// A coordinate at a bound of the cube is fixed there if the descent direction leaves the cube.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct LevenbergMarquardt {
    phase: Phase,
    unit_point: Vec<f64>,
    objective: f64,
    residuals: Vec<f64>,
    /// Step of the differences, in sides of the cube, and that of each coordinate with its sign.
    difference_step: f64,
    difference_steps: Vec<f64>,
    /// Normal matrix JᵀJ by columns, and gradient Jᵀr.
    normal_matrix: Vec<f64>,
    gradient: Vec<f64>,
    damping: f64,
    /// Factors on the damping that are tried at a time.
    damping_factors: Vec<f64>,
    /// The search ends after an iteration with a smaller relative improvement.
    min_relative_gain: f64,
    /// The search also ends before a step that promises a smaller relative improvement.
    checks_promised_gain: bool,
    has_converged: bool,
    budget: usize,
    used: usize,
    last_objectives: Vec<f64>,
}

/// Factors on the damping that are tried at a time.
const DAMPING_FACTORS: [f64; 4] = [1e-2, 1.0, 1e2, 1e4];
/// With single steps, a successful step divides the damping by this. A failed one multiplies it by the square.
const SINGLE_STEP_FACTOR: f64 = 8.0;
/// The search ends above this damping: no step reduces the objective.
const MAX_DAMPING: f64 = 1e10;
/// Damping of a step that shows what an undamped one would gain.
const NEARLY_UNDAMPED: f64 = 1e-6;
/// Above this damping a small improvement is no sign of convergence.
const MAX_TELLING_DAMPING: f64 = 1.0;
/// Default of the least relative improvement of an iteration.
const MIN_RELATIVE_GAIN: f64 = 1e-9;

impl LevenbergMarquardt {
    /// Default step of the differences, in sides of the cube: large against the tolerances of an analysis, small against
    /// the curvature of a loop.
    pub const DIFFERENCE_STEP: f64 = 1e-5;

    /// A search from a unit point, with at most `budget` evaluations.
    pub fn new(start: &[f64], budget: usize) -> Self {
        Self {
            phase: Phase::Start,
            unit_point: start.to_vec(),
            objective: Trial::FAILED,
            residuals: vec![],
            difference_step: Self::DIFFERENCE_STEP,
            difference_steps: vec![],
            normal_matrix: vec![],
            gradient: vec![],
            damping: 1e-2,
            damping_factors: DAMPING_FACTORS.to_vec(),
            min_relative_gain: MIN_RELATIVE_GAIN,
            checks_promised_gain: false,
            has_converged: false,
            budget,
            used: 0,
            last_objectives: vec![],
        }
    }

    /// Try one step at a time, which takes fewer evaluations on one thread. The search ends after an iteration with a
    /// relative improvement below `min_relative_gain`.
    #[must_use]
    pub fn with_single_steps(mut self, min_relative_gain: f64) -> Self {
        self.damping_factors = vec![1.0];
        self.min_relative_gain = min_relative_gain;
        self
    }

    /// End before a step whose improvement, by the linear model of the residuals, is below the least one.
    #[must_use]
    pub fn with_promised_gain(mut self) -> Self {
        self.checks_promised_gain = true;
        self
    }

    /// The point that has been reached, and its objective.
    pub fn reached(&self) -> (&[f64], f64) {
        (&self.unit_point, self.objective)
    }

    /// Set the step of the differences, in sides of the cube. A rough objective needs a wide one.
    #[must_use]
    pub fn with_difference_step(mut self, difference_step: f64) -> Self {
        self.difference_step = difference_step;
        self
    }

    /// The point after a step with a damping, clamped to the cube; `None` if the equations have no finite solution.
    fn damped_step(&self, damping: f64) -> Option<Vec<f64>> {
        let n = self.unit_point.len();
        let a = DMatrix::from_column_slice(n, n, &self.normal_matrix);
        // At a bound, with the descent direction out of the cube.
        let is_fixed = |i: usize| {
            let (x, slope) = (self.unit_point[i], self.gradient[i]);
            (x <= 0.0 && slope > 0.0) || (x >= 1.0 && slope < 0.0)
        };
        let free: Vec<usize> = (0..n).filter(|i| !is_fixed(*i)).collect();
        let m = free.len();
        let largest = a.diagonal().max();
        let matrix = DMatrix::from_fn(m, m, |i, j| {
            let x = a[(free[i], free[j])];
            // A coordinate without influence would make the matrix singular.
            if i == j { x + damping * x.max(1e-12 * largest) } else { x }
        });
        let right = DVector::from_iterator(m, free.iter().map(|i| -self.gradient[*i]));
        let step = matrix.cholesky()?.solve(&right);
        let mut next = self.unit_point.clone();
        for (i, s) in free.iter().zip(step.iter()) {
            next[*i] = (next[*i] + s).clamp(0.0, 1.0);
        }
        next.iter().all(|x| x.is_finite()).then_some(next)
    }

    /// Improvement of the objective at a point, by the linear model of the residuals: -2 gᵀs - sᵀAs with the step s.
    fn promised_gain(&self, next: &[f64]) -> f64 {
        let n = self.unit_point.len();
        let step: Vec<f64> = next.iter().zip(&self.unit_point).map(|(a, b)| a - b).collect();
        let slope: f64 = self.gradient.iter().zip(&step).map(|(g, s)| g * s).sum();
        let curvature: f64 = (0..n * n).map(|k| self.normal_matrix[k] * step[k / n] * step[k % n]).sum();
        -2.0 * slope - curvature
    }

    /// Returns true if the nearly undamped step promises less than the least improvement. One that is cut at a bound
    /// promises little, though another step may gain much.
    fn promises_too_little(&self) -> bool {
        let Some(next) = self.damped_step(NEARLY_UNDAMPED) else { return false };
        let is_cut = next.iter().zip(&self.unit_point).any(|(a, b)| a != b && (*a <= 0.0 || *a >= 1.0));
        !is_cut && self.promised_gain(&next) <= self.min_relative_gain * self.objective
    }

    fn take_derivatives(&mut self, trials: &[Trial]) {
        let n = self.unit_point.len();
        let columns: Vec<Option<Vec<f64>>> = trials
            .iter()
            .zip(&self.difference_steps)
            .map(|(t, h)| {
                let is_comparable = t.residuals.len() == self.residuals.len();
                is_comparable.then(|| t.residuals.iter().zip(&self.residuals).map(|(a, b)| (a - b) / h).collect())
            })
            .collect();
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
        let no_influence = vec![];
        let column = |i: usize| columns[i].as_ref().unwrap_or(&no_influence);
        self.normal_matrix = (0..n * n).map(|k| dot(column(k / n), column(k % n))).collect();
        self.gradient = (0..n).map(|i| dot(column(i), &self.residuals)).collect();
    }
}

impl Method for LevenbergMarquardt {
    fn ask(&mut self) -> Vec<Vec<f64>> {
        if self.used >= self.budget {
            self.phase = Phase::Ended;
        }
        match self.phase {
            Phase::Start => vec![self.unit_point.clone()],
            Phase::Derivatives => {
                let signed = |x: &f64| if *x > 0.5 { -self.difference_step } else { self.difference_step };
                self.difference_steps = self.unit_point.iter().map(signed).collect();
                let moved = |i: usize| {
                    let mut p = self.unit_point.clone();
                    p[i] += self.difference_steps[i];
                    p
                };
                (0..self.unit_point.len()).map(moved).collect()
            }
            Phase::Steps => {
                let next: Vec<Vec<f64>> =
                    self.damping_factors.iter().filter_map(|f| self.damped_step(self.damping * f)).collect();
                self.has_converged = self.checks_promised_gain && self.promises_too_little();
                if self.has_converged || next.is_empty() {
                    self.phase = Phase::Ended;
                    return vec![];
                }
                next
            }
            Phase::Ended => vec![],
        }
    }

    fn tell(&mut self, unit_points: &[Vec<f64>], trials: &[Trial]) {
        self.used += unit_points.len();
        match self.phase {
            Phase::Start => {
                self.objective = trials[0].objective;
                self.residuals.clone_from(&trials[0].residuals);
                self.phase = if self.residuals.is_empty() { Phase::Ended } else { Phase::Derivatives };
            }
            Phase::Derivatives => {
                self.take_derivatives(trials);
                self.phase = Phase::Steps;
            }
            Phase::Steps => {
                self.last_objectives = trials.iter().map(|t| t.objective).collect();
                let best =
                    (0..trials.len()).min_by(|a, b| trials[*a].objective.total_cmp(&trials[*b].objective)).unwrap_or(0);
                let gain = self.objective - trials[best].objective;
                if gain > 0.0 {
                    // A strongly damped step gains little anywhere.
                    let is_telling = !self.checks_promised_gain || self.damping <= MAX_TELLING_DAMPING;
                    self.has_converged = is_telling && gain <= self.min_relative_gain * self.objective;
                    self.unit_point.clone_from(&unit_points[best]);
                    self.objective = trials[best].objective;
                    self.residuals.clone_from(&trials[best].residuals);
                    // A factor without a step shifts the indices of those behind it, which does no harm.
                    let factor = self.damping_factors[best.min(self.damping_factors.len() - 1)];
                    let factor = if self.damping_factors.len() == 1 { 1.0 / SINGLE_STEP_FACTOR } else { factor };
                    self.damping = (self.damping * factor).max(1e-12);
                    self.phase = if self.has_converged { Phase::Ended } else { Phase::Derivatives };
                } else {
                    let largest = self.damping_factors.iter().fold(0.0f64, |a, b| a.max(*b));
                    let is_single = self.damping_factors.len() == 1;
                    self.damping *= if is_single { SINGLE_STEP_FACTOR * SINGLE_STEP_FACTOR } else { 10.0 * largest };
                    if self.damping > MAX_DAMPING {
                        self.has_converged = true;
                        self.phase = Phase::Ended;
                    }
                }
            }
            Phase::Ended => {}
        }
    }

    fn spread(&self) -> f64 {
        objective_spread(&self.last_objectives)
    }

    fn needs_residuals(&self) -> bool {
        true
    }

    fn progress(&self) -> f64 {
        self.used as f64 / self.budget as f64
    }

    fn has_converged(&self) -> bool {
        self.has_converged
    }
}

#[cfg(test)]
mod tests {
    use super::{LevenbergMarquardt, Method as _, Trial};

    /// Minimum found for a parabola with ripples, whose least value is at 0.3.
    fn minimum(mut search: LevenbergMarquardt) -> f64 {
        let residual = |x: f64| vec![x - 0.3 + 2e-3 * (1e5 * x).sin(), 0.01];
        let mut best = (f64::INFINITY, 0.0);
        loop {
            let points = search.ask();
            if points.is_empty() {
                return best.1;
            }
            let trial = |p: &Vec<f64>| {
                let residuals = residual(p[0]);
                Trial { objective: residuals.iter().map(|r| r * r).sum(), residuals }
            };
            let trials: Vec<Trial> = points.iter().map(trial).collect();
            for (p, t) in points.iter().zip(&trials) {
                if t.objective < best.0 {
                    best = (t.objective, p[0]);
                }
            }
            search.tell(&points, &trials);
        }
    }

    /// A curved valley with its end on the edge of the cube: a search that ends early has not reached it.
    #[test]
    fn promised_gain_does_not_end_a_search_early() {
        let mut search = LevenbergMarquardt::new(&[0.05, 0.95], 400).with_single_steps(1e-9).with_promised_gain();
        loop {
            let points = search.ask();
            if points.is_empty() {
                break;
            }
            let trial = |p: &Vec<f64>| {
                let residuals = vec![20.0 * (p[1] - p[0] * p[0]), 1.2 - p[0], 0.1];
                Trial { objective: residuals.iter().map(|r| r * r).sum(), residuals }
            };
            let trials: Vec<Trial> = points.iter().map(trial).collect();
            search.tell(&points, &trials);
        }
        let (reached, objective) = search.reached();
        assert!((reached[0] - 1.0).abs() < 1e-6 && (objective - 0.05).abs() < 1e-6, "{reached:?} {objective}");
        assert!(search.has_converged());
    }

    #[test]
    fn wide_difference_step_ignores_ripples() {
        let search = || LevenbergMarquardt::new(&[0.8], 60).with_single_steps(1e-3);
        assert!((minimum(search()) - 0.3).abs() > 0.1);
        assert!((minimum(search().with_difference_step(1e-2)) - 0.3).abs() < 0.01);
    }
}

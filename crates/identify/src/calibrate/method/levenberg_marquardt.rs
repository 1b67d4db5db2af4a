//! Least squares by Levenberg and Marquardt within the unit cube.
//!
//! Made here because derivatives and trial steps are asked for all at once, for all threads to work on, and because of
//! the sides of the cube; the crates for it take one point after the other and know no bounds.

use super::{Method, Trial, spread_of};
use nalgebra::{DMatrix, DVector};
use serde::{Deserialize, Serialize};

/// What is asked for next.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
enum Phase {
    /// The point that it starts from.
    Start,
    /// A step along each coordinate, for the derivatives.
    Derivatives,
    /// Steps with several factors of damping.
    Steps,
    /// Nothing.
    Ended,
}

/// Levenberg and Marquardt's method with derivatives by differences and several factors of damping tried at once.
/// Coordinates at a side of the cube that the gradient pushes against are held there.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct LevenbergMarquardt {
    phase: Phase,
    point: Vec<f64>,
    score: f64,
    residuals: Vec<f64>,
    /// Step of the differences, and that of each coordinate with its sign.
    width: f64,
    steps: Vec<f64>,
    /// JᵀJ by columns, and Jᵀr.
    normal: Vec<f64>,
    gradient: Vec<f64>,
    damping: f64,
    /// Factors on the damping that are tried at once.
    factors: Vec<f64>,
    /// An improvement by less than this fraction is the last one.
    enough: f64,
    budget: usize,
    used: usize,
    last: Vec<f64>,
}

/// Factors on the damping that are tried at once.
const FACTORS: [f64; 4] = [1e-2, 1.0, 1e2, 1e4];
/// Where steps are tried one by one, the damping is divided by this after each that led down, and multiplied after each
/// that did not.
const EASE: f64 = 8.0;
/// Damping at which there is no way down any more.
const HOPELESS: f64 = 1e10;
/// An improvement by less than this fraction is the last one.
const ENOUGH: f64 = 1e-9;

impl LevenbergMarquardt {
    /// Step of the differences, in sides of the cube: large against the tolerances of an analysis, small against the
    /// curvature of a loop.
    pub const STEP: f64 = 1e-5;

    /// From a point, with at most this many evaluations.
    pub fn new(start: &[f64], budget: usize) -> Self {
        Self {
            phase: Phase::Start,
            point: start.to_vec(),
            score: Trial::FAILED,
            residuals: vec![],
            width: Self::STEP,
            steps: vec![],
            normal: vec![],
            gradient: vec![],
            damping: 1e-2,
            factors: FACTORS.to_vec(),
            enough: ENOUGH,
            budget,
            used: 0,
            last: vec![],
        }
    }

    /// One step at a time: fewer evaluations where there is but one thread to make them. An improvement by less than a
    /// fraction `enough` is the last one.
    #[must_use]
    pub fn one_by_one(mut self, enough: f64) -> Self {
        self.factors = vec![1.0];
        self.enough = enough;
        self
    }

    /// With differences over steps so wide, in sides of the cube: where the objective is rough, narrow ones tell its ripples.
    #[must_use]
    pub fn with_steps(mut self, width: f64) -> Self {
        self.width = width;
        self
    }

    /// The step to take with a factor of damping; coordinates that would leave the cube stop at its side.
    fn step(&self, damping: f64) -> Option<Vec<f64>> {
        let n = self.point.len();
        let a = DMatrix::from_column_slice(n, n, &self.normal);
        // At a side, and downhill is outside.
        let held = |i: usize| {
            (self.point[i] <= 0.0 && self.gradient[i] > 0.0) || (self.point[i] >= 1.0 && self.gradient[i] < 0.0)
        };
        let free: Vec<usize> = (0..n).filter(|i| !held(*i)).collect();
        let m = free.len();
        let largest = a.diagonal().max();
        let matrix = DMatrix::from_fn(m, m, |i, j| {
            let x = a[(free[i], free[j])];
            // A coordinate that nothing depends on is damped all the same.
            if i == j { x + damping * x.max(1e-12 * largest) } else { x }
        });
        let right = DVector::from_iterator(m, free.iter().map(|i| -self.gradient[*i]));
        let step = matrix.cholesky()?.solve(&right);
        let mut next = self.point.clone();
        for (i, s) in free.iter().zip(step.iter()) {
            next[*i] = (next[*i] + s).clamp(0.0, 1.0);
        }
        next.iter().all(|x| x.is_finite()).then_some(next)
    }

    fn take_derivatives(&mut self, trials: &[Trial]) {
        let n = self.point.len();
        let columns: Vec<Option<Vec<f64>>> = trials
            .iter()
            .zip(&self.steps)
            .map(|(t, h)| {
                let same = t.residuals.len() == self.residuals.len();
                same.then(|| t.residuals.iter().zip(&self.residuals).map(|(a, b)| (a - b) / h).collect())
            })
            .collect();
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
        let zero = vec![];
        let column = |i: usize| columns[i].as_ref().unwrap_or(&zero);
        self.normal = (0..n * n).map(|k| dot(column(k / n), column(k % n))).collect();
        self.gradient = (0..n).map(|i| dot(column(i), &self.residuals)).collect();
    }
}

impl Method for LevenbergMarquardt {
    fn ask(&mut self) -> Vec<Vec<f64>> {
        if self.used >= self.budget {
            self.phase = Phase::Ended;
        }
        match self.phase {
            Phase::Start => vec![self.point.clone()],
            Phase::Derivatives => {
                self.steps = self.point.iter().map(|x| if *x > 0.5 { -self.width } else { self.width }).collect();
                let moved = |i: usize| {
                    let mut p = self.point.clone();
                    p[i] += self.steps[i];
                    p
                };
                (0..self.point.len()).map(moved).collect()
            }
            Phase::Steps => {
                let next: Vec<Vec<f64>> = self.factors.iter().filter_map(|f| self.step(self.damping * f)).collect();
                if next.is_empty() {
                    self.phase = Phase::Ended;
                }
                next
            }
            Phase::Ended => vec![],
        }
    }

    fn tell(&mut self, points: &[Vec<f64>], trials: &[Trial]) {
        self.used += points.len();
        match self.phase {
            Phase::Start => {
                self.score = trials[0].score;
                self.residuals.clone_from(&trials[0].residuals);
                self.phase = if self.residuals.is_empty() { Phase::Ended } else { Phase::Derivatives };
            }
            Phase::Derivatives => {
                self.take_derivatives(trials);
                self.phase = Phase::Steps;
            }
            Phase::Steps => {
                self.last = trials.iter().map(|t| t.score).collect();
                let best = (0..trials.len()).min_by(|a, b| trials[*a].score.total_cmp(&trials[*b].score)).unwrap_or(0);
                let gain = self.score - trials[best].score;
                if gain > 0.0 {
                    let enough = gain <= self.enough * self.score;
                    self.point.clone_from(&points[best]);
                    self.score = trials[best].score;
                    self.residuals.clone_from(&trials[best].residuals);
                    // The factors cannot be told from fewer points than there are of them; it does no harm.
                    let factor = self.factors[best.min(self.factors.len() - 1)];
                    let factor = if self.factors.len() == 1 { 1.0 / EASE } else { factor };
                    self.damping = (self.damping * factor).max(1e-12);
                    self.phase = if enough { Phase::Ended } else { Phase::Derivatives };
                } else {
                    let most = self.factors.iter().fold(0.0f64, |a, b| a.max(*b));
                    self.damping *= if self.factors.len() == 1 { EASE * EASE } else { 10.0 * most };
                    if self.damping > HOPELESS {
                        self.phase = Phase::Ended;
                    }
                }
            }
            Phase::Ended => {}
        }
    }

    fn spread(&self) -> f64 {
        spread_of(&self.last)
    }

    fn wants_residuals(&self) -> bool {
        true
    }

    fn progress(&self) -> f64 {
        self.used as f64 / self.budget as f64
    }
}

#[cfg(test)]
mod tests {
    use super::{LevenbergMarquardt, Method as _, Trial};

    /// Where a search ends whose objective is a parabola with ripples.
    fn found(mut search: LevenbergMarquardt) -> f64 {
        let residual = |x: f64| vec![x - 0.3 + 2e-3 * (1e5 * x).sin(), 0.01];
        let mut best = (f64::INFINITY, 0.0);
        loop {
            let points = search.ask();
            if points.is_empty() {
                return best.1;
            }
            let trial = |p: &Vec<f64>| {
                let residuals = residual(p[0]);
                Trial { score: residuals.iter().map(|r| r * r).sum(), residuals }
            };
            let trials: Vec<Trial> = points.iter().map(trial).collect();
            for (p, t) in points.iter().zip(&trials) {
                if t.score < best.0 {
                    best = (t.score, p[0]);
                }
            }
            search.tell(&points, &trials);
        }
    }

    #[test]
    fn wide_differences_see_beyond_ripples() {
        let search = || LevenbergMarquardt::new(&[0.8], 60).one_by_one(1e-3);
        assert!((found(search()) - 0.3).abs() > 0.1);
        assert!((found(search().with_steps(1e-2)) - 0.3).abs() < 0.01);
    }
}

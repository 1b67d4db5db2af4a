//! Step search along the parameters, one after the other.
//!
//! Source: D. A. Nguyen, A rheology model of high damping rubber bearings for seismic analysis at room and low temperatures,
//! dissertation, Fig 3.7 and Eqs 3.16 and 3.17. The dissertation has neither the rates nor the least step.

use super::{Method, Trial};
use serde::{Deserialize, Serialize};

/// The search of Fig 3.7: a coordinate is raised and lowered by its step, and the best of the three points is kept. The step
/// then grows, or shrinks where no move helps. A coordinate is left when its step is small, the search ends with the last.
///
/// A step is a part of the range, so that it is a factor on a logarithmic parameter, as in Eq 3.16.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct StepSearch {
    unit_point: Vec<f64>,
    objective: f64,
    /// Step of each coordinate D, sides of the cube.
    steps: Vec<f64>,
    /// Coordinate that is varied; `None` before the start is evaluated.
    coordinate: Option<usize>,
    last_objectives: Vec<f64>,
    budget: usize,
    used: usize,
}

/// First step: 10 %.
const FIRST_STEP: f64 = 0.1;
/// Rate S_l by which a step grows, and S_r by which it shrinks. Choices.
const GROWTH: f64 = 1.2;
const SHRINKAGE: f64 = 0.5;
/// A coordinate is left with a step up to this, ε_D. A choice.
const MIN_STEP: f64 = 1e-4;

impl StepSearch {
    /// A search from a unit point, with at most `budget` evaluations.
    pub fn new(start: &[f64], budget: usize) -> Self {
        Self {
            unit_point: start.to_vec(),
            objective: Trial::FAILED,
            steps: vec![FIRST_STEP; start.len()],
            coordinate: None,
            last_objectives: vec![],
            budget,
            used: 0,
        }
    }

    /// The next coordinate after `last` whose step is not small.
    fn next_coordinate(&self, last: Option<usize>) -> Option<usize> {
        let n = self.steps.len();
        let first = last.map_or(0, |i| i + 1);
        (first..first + n).map(|i| i % n).find(|i| self.steps[*i] > MIN_STEP)
    }
}

impl Method for StepSearch {
    fn ask(&mut self) -> Vec<Vec<f64>> {
        if self.used >= self.budget || self.has_converged() {
            return vec![];
        }
        let Some(i) = self.coordinate else { return vec![self.unit_point.clone()] };
        let moved = |step: f64| {
            let mut point = self.unit_point.clone();
            point[i] = (point[i] + step).clamp(0.0, 1.0);
            point
        };
        vec![moved(self.steps[i]), moved(-self.steps[i])]
    }

    fn tell(&mut self, unit_points: &[Vec<f64>], trials: &[Trial]) {
        self.used += trials.len();
        self.last_objectives = trials.iter().map(|t| t.objective).collect();
        let best = unit_points.iter().zip(trials).min_by(|a, b| a.1.objective.total_cmp(&b.1.objective));
        let Some((point, trial)) = best else { return };
        let is_better = trial.objective < self.objective;
        if is_better {
            (self.unit_point, self.objective) = (point.clone(), trial.objective);
        }
        if let Some(i) = self.coordinate {
            self.steps[i] *= if is_better { GROWTH } else { SHRINKAGE };
        }
        self.coordinate = self.next_coordinate(self.coordinate);
    }

    fn spread(&self) -> f64 {
        super::objective_spread(&self.last_objectives)
    }

    fn progress(&self) -> f64 {
        if self.has_converged() {
            return 1.0;
        }
        (self.used as f64 / self.budget.max(1) as f64).min(1.0)
    }

    fn has_converged(&self) -> bool {
        self.used > 0 && self.next_coordinate(None).is_none()
    }
}

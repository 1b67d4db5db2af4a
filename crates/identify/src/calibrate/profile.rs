//! Profile likelihoods: the best objective over all other parameters, as a function of one parameter.
//!
//! With noise of unknown variance the likelihood is S^(-n/2), with the objective S and n independent samples. The statistic
//! D = n ln(S/S_min) is compared with the 95 % point of χ² with one degree of freedom (Raue et al., 2009). On a side where
//! D stays below it up to the bound, the data do not limit the parameter.

use super::method::{LevenbergMarquardt, Method as _, Trial};
use super::problem::{Evaluation, Problem, StudyProblem};
use super::uncertainty::Uncertainty;
use crate::study::ParameterRange;
use serde::Serialize;

/// The profile of a parameter.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Profile {
    /// Name.
    pub name: String,
    /// Increasing values of the parameter, and D there.
    pub points: Vec<(f64, f64)>,
    /// Lower end of the 95 % interval; `None` if the data do not limit it.
    pub lower: Option<f64>,
    /// Upper end of the 95 % interval; `None` if the data do not limit it.
    pub upper: Option<f64>,
}

/// 95 % point of χ² with one degree of freedom.
const CHI_SQUARED_95: f64 = 3.841_458_821;
/// Greatest number of points on a side.
const MAX_POINTS: usize = 10;

/// A problem with one coordinate fixed.
struct WithFixedCoordinate<'a> {
    problem: &'a dyn Problem,
    coordinate: usize,
    at: f64,
}

impl Problem for WithFixedCoordinate<'_> {
    fn dimension(&self) -> usize {
        self.problem.dimension() - 1
    }

    fn evaluate(&self, unit_points: &[Vec<f64>], needs_residuals: bool) -> Vec<Evaluation> {
        let complete = |point: &Vec<f64>| {
            let mut p = point.clone();
            p.insert(self.coordinate, self.at);
            p
        };
        let unit_points: Vec<Vec<f64>> = unit_points.iter().map(complete).collect();
        self.problem.evaluate(&unit_points, needs_residuals)
    }
}

/// The point of the least objective by least squares from `start`, and this objective.
fn minimise(problem: &dyn Problem, start: &[f64]) -> (Vec<f64>, f64) {
    let mut search = LevenbergMarquardt::new(start, 12 * (start.len() + 4));
    let (mut best, mut least) = (start.to_vec(), Trial::FAILED);
    loop {
        let unit_points = search.ask();
        if unit_points.is_empty() {
            return (best, least);
        }
        let trials: Vec<Trial> = problem.evaluate(&unit_points, true).into_iter().map(|e| e.trial).collect();
        for (p, t) in unit_points.iter().zip(&trials) {
            if t.objective < least {
                best.clone_from(p);
                least = t.objective;
            }
        }
        search.tell(&unit_points, &trials);
    }
}

/// One side of a profile: unit coordinates with D from the best point outwards, and the end of the interval.
type Side = (Vec<(f64, f64)>, Option<f64>);

/// Profiles about the best point.
struct Profiler<'a> {
    problem: &'a StudyProblem,
    best: &'a [f64],
    objective: f64,
    effective_samples: f64,
}

impl Profiler<'_> {
    fn statistic(&self, objective: f64) -> f64 {
        if objective < Trial::FAILED {
            self.effective_samples * (objective / self.objective).ln()
        } else {
            f64::INFINITY
        }
    }

    /// The side of coordinate `i` in the direction of the signed `step`.
    fn side(&self, i: usize, step: f64) -> Side {
        let mut others = self.best.to_vec();
        let mut at = others.remove(i);
        let mut points: Vec<(f64, f64)> = vec![(at, 0.0)];
        for _ in 0..MAX_POINTS {
            let next = (at + step).clamp(0.0, 1.0);
            if next == at {
                break;
            }
            at = next;
            let (best, least) = minimise(&WithFixedCoordinate { problem: self.problem, coordinate: i, at }, &others);
            others = best;
            let d = self.statistic(least);
            let (before, d_before) = points[points.len() - 1];
            points.push((at, d));
            if d > CHI_SQUARED_95 {
                // √D is nearly linear in the coordinate.
                let (a, b) = (d_before.max(0.0).sqrt(), d.sqrt());
                let share = if b.is_finite() { (CHI_SQUARED_95.sqrt() - a) / (b - a) } else { 1.0 };
                return (points, Some(before + share * (at - before)));
            }
        }
        (points, None)
    }
}

/// The profiles of all free parameters about the best unit point, whose objective is `objective`.
pub fn profiles(problem: &StudyProblem, best: &[f64], objective: f64, uncertainty: &Uncertainty) -> Vec<Profile> {
    let space = &problem.study().space;
    let profiler = Profiler { problem, best, objective, effective_samples: uncertainty.effective_samples };
    let profile = |i: usize, name: &str, range: &ParameterRange| {
        let step = uncertainty.intervals[i].standard_error.clamp(1e-3, 0.1);
        let (down, lower) = profiler.side(i, -step);
        let (up, upper) = profiler.side(i, step);
        let value = |unit_coordinate: f64| range.value(unit_coordinate);
        let points = down.into_iter().rev().chain(up.into_iter().skip(1));
        Profile {
            name: name.to_owned(),
            points: points.map(|(x, d)| (value(x), d)).collect(),
            lower: lower.map(value),
            upper: upper.map(value),
        }
    };
    let parameters = space.free_names().zip(space.free()).enumerate();
    parameters.map(|(i, (name, (_, range)))| profile(i, name, range)).collect()
}

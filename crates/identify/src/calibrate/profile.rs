//! Profile likelihoods: the best that is left when one parameter is held, over the values that it is held at.
//!
//! With noise whose size is not known the likelihood is S^(-n/2), S the objective and n the independent samples. The
//! statistic D = n ln(S/S_min) of a held parameter is compared with the 95 % point of χ² of one degree of freedom
//! (Raue et al., 2009). A side on which D stays below it up to the bound is open: the data do not limit the parameter there.

use super::method::{LevenbergMarquardt, Method as _, Trial};
use super::problem::{Evaluated, Problem, StudyProblem};
use super::uncertainty::Uncertainty;
use serde::Serialize;

/// The profile of a parameter.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Profile {
    /// Name.
    pub name: String,
    /// Values at which it was held, increasing, and D there.
    pub points: Vec<(f64, f64)>,
    /// Ends of the 95 % interval; none on a side that is open up to its bound.
    pub lower: Option<f64>,
    /// Upper end.
    pub upper: Option<f64>,
}

/// 95 % point of χ² with one degree of freedom.
const CHI2: f64 = 3.841_458_821;
/// Points on a side at most.
const POINTS: usize = 10;

/// A problem with one coordinate held.
struct Held<'a> {
    of: &'a dyn Problem,
    coordinate: usize,
    at: f64,
}

impl Held<'_> {
    fn whole(&self, point: &[f64]) -> Vec<f64> {
        let mut p = point.to_vec();
        p.insert(self.coordinate, self.at);
        p
    }
}

impl Problem for Held<'_> {
    fn dimension(&self) -> usize {
        self.of.dimension() - 1
    }

    fn evaluate(&self, points: &[Vec<f64>], residuals: bool) -> Vec<Evaluated> {
        let whole: Vec<Vec<f64>> = points.iter().map(|p| self.whole(p)).collect();
        self.of.evaluate(&whole, residuals)
    }
}

/// The best point near another one, and its score.
fn settle(problem: &dyn Problem, start: &[f64]) -> (Vec<f64>, f64) {
    let mut search = LevenbergMarquardt::new(start, 12 * (start.len() + 4));
    let (mut best, mut score) = (start.to_vec(), Trial::FAILED);
    loop {
        let points = search.ask();
        if points.is_empty() {
            return (best, score);
        }
        let trials: Vec<Trial> = problem.evaluate(&points, true).into_iter().map(|e| e.trial).collect();
        for (p, t) in points.iter().zip(&trials) {
            if t.score < score {
                best.clone_from(p);
                score = t.score;
            }
        }
        search.tell(&points, &trials);
    }
}

/// The profiles of all free parameters about the best point.
pub fn profiles(problem: &StudyProblem, best: &[f64], score: f64, sure: &Uncertainty) -> Vec<Profile> {
    let space = &problem.study().space;
    let n = sure.effective_samples;
    let ranges: Vec<_> = space.free().map(|(_, range)| *range).collect();
    let one = |i: usize| {
        let step = sure.intervals[i].relative.clamp(1e-3, 0.1);
        let mut rest = best.to_vec();
        rest.remove(i);
        let statistic = |s: f64| if s < Trial::FAILED { n * (s / score).ln() } else { f64::INFINITY };
        let side = |sign: f64| {
            let (mut at, mut others) = (best[i], rest.clone());
            let mut points: Vec<(f64, f64)> = vec![(best[i], 0.0)];
            let mut end = None;
            for _ in 0..POINTS {
                let next = (at + sign * step).clamp(0.0, 1.0);
                if next == at {
                    break;
                }
                at = next;
                let held = Held { of: problem, coordinate: i, at };
                let (found, s) = settle(&held, &others);
                others = found;
                let d = statistic(s);
                let (before, d0) = points[points.len() - 1];
                points.push((at, d));
                if d > CHI2 {
                    // √D is nearly straight.
                    let (a, b) = (d0.max(0.0).sqrt(), d.sqrt());
                    let share = if b.is_finite() { (CHI2.sqrt() - a) / (b - a) } else { 1.0 };
                    end = Some(before + share * (at - before));
                    break;
                }
            }
            (points, end)
        };
        let (down, lower) = side(-1.0);
        let (up, upper) = side(1.0);
        let value = |place: f64| ranges[i].value(place);
        let points = down.into_iter().rev().chain(up.into_iter().skip(1));
        Profile {
            name: space.free_name(i).to_owned(),
            points: points.map(|(x, d)| (value(x), d)).collect(),
            lower: lower.map(value),
            upper: upper.map(value),
        }
    };
    (0..best.len()).map(one).collect()
}

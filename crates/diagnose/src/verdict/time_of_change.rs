//! Times at which a parameter of the user's changed, with the intervals in which they may lie.
//!
//! A parameter that does nothing for a while may change at any moment of it: the error stays as it is, and derivatives say
//! nothing. Each time is put into the middle of the interval in which it does, and has the interval in which the error hardly
//! grows.

use crate::candidate::variant::Variant;
use crate::fit::job::FittedModel;
use crate::prior::EFFECTIVE_SAMPLES;
use hysteron_identify::calibrate::Uncertainty;
use hysteron_identify::study::{ScoredRun, Study, objective};

/// A time of change.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct TimeOfChange {
    /// Name of its parameter.
    name: String,
    /// Its value, s.
    value: f64,
    /// Ends of its interval of 95 %, s.
    bounds: [f64; 2],
    /// A quarter of that interval, in sides of the unit cube.
    standard_error: f64,
}

/// Share by which the error may grow where a time of change is as good as the best.
const AS_GOOD: f64 = 0.01;
/// Value of chi-square with one degree of freedom that 95 % do not exceed. Twice the log likelihood falls by it: N ln E grows.
const CHI_SQUARE: f64 = 3.84;
/// Least step of the search, in parts of the longest run.
const STEP: f64 = 1.0 / 400.0;

impl TimeOfChange {
    /// Puts the times of a fit into the middle of their intervals. `simulate` gives the fitted runs at values of all parameters.
    pub(super) fn settle(
        study: &Study,
        variant: &Variant,
        fitted: &mut FittedModel,
        mut simulate: impl FnMut(&[f64]) -> Option<Vec<ScoredRun>>,
    ) -> Vec<Self> {
        let space = &variant.study.space;
        let names: Vec<&str> = space.free_names().collect();
        let mut at = |point: &[f64]| {
            let values = space.values_at(point).ok()?;
            let fits = simulate(&values)?;
            let error = objective(study, &fits.iter().collect::<Vec<_>>());
            Some(FittedModel { point: point.to_vec(), values, objective: error, fits })
        };
        let mut out = vec![];
        for k in variant.change_point_coordinates() {
            let moved =
                |point: &[f64], x: f64| point.iter().enumerate().map(|(i, p)| if i == k { x } else { *p }).collect();
            let start: Vec<f64> = fitted.point.clone();
            let mut error = |x: f64| {
                let point: Vec<f64> = moved(&start, x);
                at(&point).map_or(f64::INFINITY, |f| f.objective)
            };
            let best = fitted.objective;
            let [low, high] = interval(start[k], best * (1.0 + AS_GOOD), &mut error);
            let [least, most] = interval(start[k], best * (CHI_SQUARE / EFFECTIVE_SAMPLES).exp(), &mut error);
            let middle: Vec<f64> = moved(&start, 0.5 * (low + high));
            if let Some(settled) = at(&middle).filter(|f| f.objective <= best * (1.0 + AS_GOOD)) {
                *fitted = settled;
            }
            let value = |x: f64| space.values_at(&moved(&start, x)).ok()?.get(space.free().nth(k)?.0).copied();
            let found = || Some((value(fitted.point[k])?, [value(least)?, value(most)?]));
            let standard_error = 0.25 * (most - least);
            out.extend(found().map(|(value, bounds)| Self {
                name: names[k].to_owned(),
                value,
                bounds,
                standard_error,
            }));
        }
        out
    }

    /// Writes the interval in the place of that from derivatives.
    pub(super) fn correct(&self, uncertainty: &mut Uncertainty) {
        for i in uncertainty.intervals.iter_mut().filter(|i| i.name == self.name) {
            (i.value, [i.lower, i.upper], i.standard_error) = (self.value, self.bounds, self.standard_error);
        }
    }
}

/// The interval around a coordinate in which the error is at most a limit.
fn interval(x: f64, most: f64, error: &mut dyn FnMut(f64) -> f64) -> [f64; 2] {
    [-1.0, 1.0].map(|sign| {
        let room = if sign > 0.0 { 1.0 - x } else { x };
        let (mut inside, mut step) = (0.0f64, STEP);
        // Twice as far each time, and then back by halves.
        while inside < room && error(x + sign * (inside + step).min(room)) <= most {
            inside = (inside + step).min(room);
            step *= 2.0;
        }
        while step > STEP && inside < room {
            step *= 0.5;
            let farther = (inside + step).min(room);
            if error(x + sign * farther) <= most {
                inside = farther;
            }
        }
        x + sign * inside
    })
}

#[cfg(test)]
mod tests {
    use super::{STEP, interval};

    #[test]
    fn an_interval_ends_where_the_error_grows() {
        let mut evaluations = 0;
        let mut error = |x: f64| {
            evaluations += 1;
            if (0.2..=0.37).contains(&x) { 1.0 } else { 2.0 }
        };
        let [low, high] = interval(0.22, 1.01, &mut error);
        assert!((low - 0.2).abs() <= STEP && (high - 0.37).abs() <= STEP, "{low} {high}");
        assert!(evaluations < 30, "{evaluations}");
        assert_eq!(interval(0.5, 1.01, &mut |_| 1.0), [0.0, 1.0]);
    }
}

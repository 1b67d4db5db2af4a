//! Governing responses over a suite.

use crate::isolate::{JobOutcome, Study};

/// A response at a bound over the suite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Response {
    /// Mean over the motions, the largest of the eccentricities.
    pub mean: f64,
    /// Largest of all analyses.
    pub largest: f64,
    /// The value that counts: the mean if there are as many pairs as the code asks for, else the largest.
    pub governing: f64,
}

/// Pairs from which on the mean counts in place of the largest value.
pub(super) fn mean_from(study: &Study) -> usize {
    study.code.value("suite_size", "mean_from").map_or(usize::MAX, |n| n as usize)
}

/// A response of the complete analyses of a bound; `None` without one.
pub fn governing(
    study: &Study,
    outcomes: &[JobOutcome],
    bound: &str,
    of: &dyn Fn(&JobOutcome) -> Option<f64>,
) -> Option<Response> {
    let by_eccentricity = |e: &[f64; 2]| {
        let all: Vec<f64> = outcomes
            .iter()
            .filter(|o| o.bound == bound && o.eccentricity == *e && o.failure.is_empty())
            .filter_map(of)
            .collect();
        let largest = all.iter().copied().reduce(f64::max)?;
        let mean = all.iter().sum::<f64>() / all.len() as f64;
        Some(Response { mean, largest, governing: if all.len() >= mean_from(study) { mean } else { largest } })
    };
    study.eccentricities.iter().filter_map(by_eccentricity).reduce(|a, b| Response {
        mean: a.mean.max(b.mean),
        largest: a.largest.max(b.largest),
        governing: a.governing.max(b.governing),
    })
}

/// The value that counts; NaN without one.
pub(super) fn value(
    study: &Study,
    outcomes: &[JobOutcome],
    bound: &str,
    of: &dyn Fn(&JobOutcome) -> Option<f64>,
) -> f64 {
    governing(study, outcomes, bound, of).map_or(f64::NAN, |r| r.governing)
}

/// Largest of some numbers; `None` without any.
pub(super) fn top(values: &[f64]) -> Option<f64> {
    values.iter().copied().reduce(f64::max)
}

//! Simulations at points that are spread over the ranges of the parameters.

use super::motions::ImposedMotions;
use crate::halton::halton;
use crate::study::{InitialRun, SimulationError, Simulator as _, SimulatorFactory, Study, WorkerPool};

/// Largest number of points beside the script's own values.
const MAX_POINTS: usize = 16;
/// Number of steps times elements that the points may take together.
const MAX_WORK: u64 = 5_000_000;

/// Number of points of a study.
#[derive(Clone, Copy, Debug)]
pub(super) struct PointSettings {
    /// Number of points beside the script's own values.
    count: usize,
    /// True if each parameter is also moved to its bounds.
    with_bounds: bool,
}

/// Work of the points at the bounds over [`MAX_WORK`], at most.
const MAX_BOUND_WORK: u64 = 4;

impl PointSettings {
    /// As many points as the work of the script allows. The number does not depend on the speed of the machine.
    pub(super) fn of(study: &Study, initial_run: &InitialRun, motions: &[ImposedMotions]) -> Self {
        let steps = initial_run.limits.iter().map(|l| l.first_steps());
        let work: u64 = steps.zip(motions).map(|(s, m)| s * (m.elements as u64 + 1)).sum();
        let at_bounds = work.saturating_mul(2 * study.space.dimension() as u64);
        Self {
            count: (MAX_WORK / work.max(1)).min(MAX_POINTS as u64) as usize,
            with_bounds: at_bounds <= MAX_BOUND_WORK * MAX_WORK,
        }
    }
}

/// Simulated channels of a run at a point.
type Response = Result<Vec<Vec<f64>>, SimulationError>;

/// Simulated channels at all points.
pub(super) struct SimulatedPoints {
    /// The script's own values of all parameters.
    pub(super) own_values: Vec<f64>,
    /// Responses by point, the script's own values first, then by run.
    responses: Vec<Vec<Response>>,
    /// Responses with each free parameter in turn at its bounds, and those at the corners of the ranges where channels are
    /// largest and least; empty if that takes too much work.
    extremes: Vec<Vec<Response>>,
}

impl SimulatedPoints {
    /// Simulates all runs at all points.
    pub(super) fn new(
        study: &Study,
        factory: &SimulatorFactory,
        initial_run: &InitialRun,
        settings: PointSettings,
        threads: usize,
    ) -> std::io::Result<Self> {
        let space = &study.space;
        let n = space.dimension();
        let unit_points =
            (1..=settings.count).map(|i| (0..n).map(|k| halton(i, k).unwrap_or(0.5)).collect::<Vec<f64>>());
        let spread = unit_points.filter_map(|p| space.values_at(&p).ok());
        // Fixed and tied parameters as in the study, free ones as in the script.
        let own =
            space.values_at(&space.unit_point(&initial_run.values)).unwrap_or_else(|_| initial_run.values.clone());
        let values: Vec<Vec<f64>> = std::iter::once(own.clone()).chain(spread).collect();
        let runs = study.runs.len();
        let pool = WorkerPool::new(threads)?;
        let simulate = |(run, v): (usize, &Vec<f64>)| -> Response { factory.simulator().simulate(run, v) };
        let simulate_all = |values: &[Vec<f64>]| -> Vec<Vec<Response>> {
            let jobs = values.iter().flat_map(|v| (0..runs).map(move |r| (r, v)));
            let results = pool.run(jobs, simulate).into_iter();
            let mut results = results.map(|r| r.unwrap_or(Err(SimulationError::Defect)));
            values.iter().map(|_| results.by_ref().take(runs).collect()).collect()
        };
        let responses = simulate_all(&values);
        let mut extremes = vec![];
        if settings.with_bounds {
            let own_point = space.unit_point(&initial_run.values);
            let moved = |k: usize, bound: f64| {
                let mut point = own_point.clone();
                point[k] = bound;
                point
            };
            let at = |points: Vec<Vec<f64>>| -> Vec<Vec<f64>> {
                points.iter().map(|p| space.values_at(p).unwrap_or_else(|_| own.clone())).collect()
            };
            extremes = simulate_all(&at((0..n).flat_map(|k| [moved(k, 0.0), moved(k, 1.0)]).collect()));
            let corners = simulate_all(&at(corners(&extremes)));
            extremes.extend(corners);
        }
        Ok(Self { own_values: own, responses, extremes })
    }

    /// Channels of a run with the script's own values.
    ///
    /// # Errors
    /// The script has no response.
    pub(super) fn own(&self, run: usize) -> Result<&[Vec<f64>], &SimulationError> {
        self.responses[0][run].as_deref()
    }

    /// Least and largest size of each channel of a run at all points, over that with the script's own values. Empty if the
    /// parameters were not moved to their bounds.
    pub(super) fn reachable_sizes(&self, run: usize) -> Vec<[f64; 2]> {
        let (Ok(own), false) = (self.own(run), self.extremes.is_empty()) else { return vec![] };
        let all = || self.responses.iter().chain(&self.extremes).filter_map(|p| p[run].as_ref().ok());
        let of_channel = |k: usize| {
            let sizes = all().map(|y| deviation(&y[k]) / deviation(&own[k])).filter(|s| s.is_finite());
            sizes.fold([1.0f64, 1.0f64], |[low, high], s| [low.min(s), high.max(s)])
        };
        (0..own.len()).map(of_channel).collect()
    }

    /// Channels of a run at all points with a response.
    pub(super) fn of_run(&self, run: usize) -> Vec<&[Vec<f64>]> {
        self.responses.iter().filter_map(|p| p[run].as_deref().ok()).collect()
    }
}

/// Largest number of corners of the ranges.
const MAX_CORNERS: usize = 8;

/// Corners of the unit cube at which each channel of the first run is largest and least, if each parameter changes its size
/// as it does alone. `moved` are the responses with each parameter in turn at its lower and its upper bound.
fn corners(moved: &[Vec<Response>]) -> Vec<Vec<f64>> {
    let size = |response: &[Response], k: usize| Some(deviation(response.first()?.as_ref().ok()?.get(k)?));
    let channels = moved.iter().filter_map(|r| r.first()?.as_ref().ok()).map(Vec::len).max().unwrap_or(0);
    let mut out: Vec<Vec<f64>> = vec![];
    for k in 0..channels {
        let grows =
            |pair: &[Vec<Response>]| matches!((size(&pair[0], k), size(&pair[1], k)), (Some(a), Some(b)) if b > a);
        let largest: Vec<f64> = moved.chunks_exact(2).map(|pair| f64::from(u8::from(grows(pair)))).collect();
        let least = largest.iter().map(|x| 1.0 - x).collect();
        for corner in [largest, least] {
            if !out.contains(&corner) && out.len() < MAX_CORNERS {
                out.push(corner);
            }
        }
    }
    out
}

/// Standard deviation of the finite samples.
fn deviation(values: &[f64]) -> f64 {
    let finite: Vec<f64> = values.iter().copied().filter(|v| v.is_finite()).collect();
    let mean = finite.iter().sum::<f64>() / finite.len() as f64;
    (finite.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / finite.len() as f64).sqrt()
}

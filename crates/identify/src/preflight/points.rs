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
}

impl PointSettings {
    /// As many points as the work of the script allows. The number does not depend on the speed of the machine.
    pub(super) fn of(initial_run: &InitialRun, motions: &[ImposedMotions]) -> Self {
        let steps = initial_run.limits.iter().map(|l| l.first_steps());
        let work: u64 = steps.zip(motions).map(|(s, m)| s * (m.elements as u64 + 1)).sum();
        Self { count: (MAX_WORK / work.max(1)).min(MAX_POINTS as u64) as usize }
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
        let jobs = values.iter().flat_map(|v| (0..runs).map(move |r| (r, v)));
        let simulate = |(run, v): (usize, &Vec<f64>)| -> Response { factory.simulator().simulate(run, v) };
        let mut results = pool.run(jobs, simulate).into_iter().map(|r| r.unwrap_or(Err(SimulationError::Defect)));
        let responses = values.iter().map(|_| results.by_ref().take(runs).collect()).collect();
        Ok(Self { own_values: own, responses })
    }

    /// Channels of a run with the script's own values.
    ///
    /// # Errors
    /// The script has no response.
    pub(super) fn own(&self, run: usize) -> Result<&[Vec<f64>], &SimulationError> {
        self.responses[0][run].as_deref()
    }

    /// Channels of a run at all points with a response.
    pub(super) fn of_run(&self, run: usize) -> Vec<&[Vec<f64>]> {
        self.responses.iter().filter_map(|p| p[run].as_deref().ok()).collect()
    }
}

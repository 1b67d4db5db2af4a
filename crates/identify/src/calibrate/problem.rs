//! The objective of a calibration.

use super::method::Trial;
use crate::study::{
    Role, ScoredRun, ScriptSimulator, SimulationError, Simulator, Study, WorkerPool, objective, simulate_and_score_all,
};
use hysteron_engine::numeric::wide::WIDTH;
use std::cell::Cell;
use std::sync::Arc;

/// Result of a unit point.
#[derive(Clone, Debug, PartialEq)]
pub struct Evaluation {
    /// Objective and residuals.
    pub trial: Trial,
    /// The error, if the objective is [`Trial::FAILED`].
    pub error: Option<SimulationError>,
}

impl Evaluation {
    /// The evaluation of a point where the model has no response.
    pub fn failed(error: SimulationError) -> Self {
        Self { trial: Trial { objective: Trial::FAILED, residuals: vec![] }, error: Some(error) }
    }
}

/// An objective on the unit cube.
pub trait Problem {
    /// Number of coordinates.
    fn dimension(&self) -> usize;

    /// Evaluate unit points, with residuals if they are needed. Results are in the order of the points.
    fn evaluate(&self, unit_points: &[Vec<f64>], needs_residuals: bool) -> Vec<Evaluation>;
}

/// A run to simulate with values of all parameters.
struct Job {
    run: usize,
    values: Arc<[f64]>,
}

thread_local! {
    /// The simulator of a worker thread. Values of a script cannot be sent to other threads, so it lives in one.
    /// The threads of a pool serve one [`StudyProblem`] only.
    static SIMULATOR: Cell<Option<Box<dyn Simulator>>> = const { Cell::new(None) };
}

/// Groups of jobs that go side by side, as equal as can be: they take the same time.
fn groups_of<T>(jobs: &[T]) -> impl Iterator<Item = &[T]> {
    let groups = jobs.len().div_ceil(WIDTH);
    (0..groups).map(move |i| &jobs[i * jobs.len() / groups..(i + 1) * jobs.len() / groups])
}

/// The objective of a study: the mean NMSE of the fitted channels.
pub struct StudyProblem {
    study: Arc<Study>,
    pool: WorkerPool,
    make_simulator: Box<dyn Fn() -> Box<dyn Simulator> + Send + Sync>,
}

impl Drop for StudyProblem {
    fn drop(&mut self) {
        // The threads of a pool end some time after it, and would keep their simulators until then.
        self.pool.run_in_each_thread(|| drop(SIMULATOR.take()));
    }
}

impl StudyProblem {
    /// A problem with a pool of `threads` threads, each with a simulator of its own.
    ///
    /// # Errors
    /// A thread could not be started.
    pub fn new<S: Simulator + 'static>(
        study: Arc<Study>,
        threads: usize,
        make_simulator: impl Fn() -> S + Send + Sync + 'static,
    ) -> std::io::Result<Self> {
        let make_simulator = Box::new(move || Box::new(make_simulator()) as Box<dyn Simulator>);
        Ok(Self { study, pool: WorkerPool::new(threads)?, make_simulator })
    }

    /// A problem whose model is the script of the study. The simulator has made its initial run.
    ///
    /// # Errors
    /// A thread could not be started.
    pub fn of_script(simulator: &ScriptSimulator, threads: usize) -> std::io::Result<Self> {
        let factory = simulator.factory();
        Self::new(simulator.study().clone(), threads, move || factory.simulator())
    }

    /// The study.
    pub fn study(&self) -> &Arc<Study> {
        &self.study
    }

    /// Simulate and score runs in parallel. Results are in the order of the jobs.
    fn run(&self, jobs: impl IntoIterator<Item = Job>) -> Vec<Result<ScoredRun, SimulationError>> {
        let mut jobs: Vec<(usize, Job)> = jobs.into_iter().enumerate().collect();
        let mut results = vec![Err(SimulationError::Defect); jobs.len()];
        // Candidates of one run may go side by side. The groups follow from the jobs, not from the threads.
        jobs.sort_by_key(|(_, job)| job.run);
        let groups: Vec<&[(usize, Job)]> = jobs.chunk_by(|a, b| a.1.run == b.1.run).flat_map(groups_of).collect();
        let done = self.pool.run(groups.iter().copied(), |group| self.scored(group));
        let (lost, done): (Vec<_>, Vec<_>) = groups.into_iter().zip(done).partition(|(_, done)| done.is_none());
        // A panic costs one candidate, and not those beside it.
        let alone = lost.into_iter().flat_map(|(group, _)| group.chunks(1));
        let alone = self.pool.run(alone, |one| self.scored(one));
        let all = done.into_iter().map(|(_, done)| done).chain(alone);
        all.flatten().flatten().for_each(|(i, scored)| results[i] = scored);
        results
    }

    /// Simulate and score candidates for one run, in a worker thread; with the numbers of the jobs.
    fn scored(&self, group: &[(usize, Job)]) -> Vec<(usize, Result<ScoredRun, SimulationError>)> {
        let Some((_, first)) = group.first() else { return vec![] };
        // A simulator whose run panics is not put back, so the next job gets a new one.
        let mut simulator = SIMULATOR.take().unwrap_or_else(|| (self.make_simulator)());
        let values: Vec<&[f64]> = group.iter().map(|(_, job)| &*job.values).collect();
        let scored = simulate_and_score_all(&mut *simulator, &self.study, first.run, &values);
        SIMULATOR.set(Some(simulator));
        group.iter().map(|(i, _)| *i).zip(scored).collect()
    }

    /// Simulate and score runs of the study with values of all parameters.
    pub fn scored_runs(&self, runs: &[usize], values: &[f64]) -> Vec<Result<ScoredRun, SimulationError>> {
        let values: Arc<[f64]> = values.into();
        self.run(runs.iter().map(|r| Job { run: *r, values: values.clone() }))
    }

    fn fitted_runs(&self) -> Vec<usize> {
        self.study.runs_of(Role::Fit).map(|(i, _)| i).collect()
    }

    /// Scaled differences of all fitted channels, whose sum of squares is the objective.
    pub fn residuals(&self, scored: &[&ScoredRun]) -> Vec<f64> {
        let runs: Vec<usize> = self.fitted_runs();
        let channels: usize = runs.iter().map(|r| self.study.runs[*r].observe.len()).sum();
        let mut residuals = vec![];
        for (run, scored_run) in runs.iter().zip(scored) {
            let observed = self.study.runs[*run].observe.iter();
            for ((o, s), simulated) in observed.zip(&scored_run.scores).zip(&scored_run.channels) {
                let scale = (o.weight / (s.samples as f64 * o.variance * channels as f64)).sqrt();
                let pairs = simulated.iter().zip(&o.values).filter(|(y, v)| !y.is_nan() && !v.is_nan());
                residuals.extend(pairs.map(|(y, v)| scale * (y - v)));
            }
        }
        residuals
    }
}

impl Problem for StudyProblem {
    fn dimension(&self) -> usize {
        self.study.space.dimension()
    }

    fn evaluate(&self, unit_points: &[Vec<f64>], needs_residuals: bool) -> Vec<Evaluation> {
        let runs = self.fitted_runs();
        let values: Vec<_> =
            unit_points.iter().map(|p| self.study.space.values_at(p).map(Arc::<[f64]>::from)).collect();
        let jobs = values.iter().flatten().flat_map(|v| runs.iter().map(|r| Job { run: *r, values: v.clone() }));
        let mut results = self.run(jobs).into_iter();
        let evaluations = values.iter().map(|v| {
            if let Err(e) = v {
                return Evaluation::failed(SimulationError::OutOfRange(e.to_string()));
            }
            let scored: Vec<Result<ScoredRun, SimulationError>> = results.by_ref().take(runs.len()).collect();
            let scored: Result<Vec<&ScoredRun>, SimulationError> =
                scored.iter().map(|r| r.as_ref().map_err(SimulationError::clone)).collect();
            match scored {
                Err(error) => Evaluation::failed(error),
                Ok(scored) => {
                    let residuals = if needs_residuals { self.residuals(&scored) } else { vec![] };
                    Evaluation { trial: Trial { objective: objective(&self.study, &scored), residuals }, error: None }
                }
            }
        });
        evaluations.collect()
    }
}

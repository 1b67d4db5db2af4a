//! What is to be made least.

use super::method::Trial;
use crate::study::{Fit, Mishap, Role, ScriptSimulator, Simulator, Study, WorkerPool, fit, objective};
use std::cell::Cell;
use std::sync::Arc;

/// What a point came to, and why, if it came to nothing.
#[derive(Clone, Debug, PartialEq)]
pub struct Evaluated {
    /// Score and residuals.
    pub trial: Trial,
    /// Why there is no score.
    pub mishap: Option<Mishap>,
}

impl Evaluated {
    /// A point without an answer.
    pub fn failed(mishap: Mishap) -> Self {
        Self { trial: Trial { score: Trial::FAILED, residuals: vec![] }, mishap: Some(mishap) }
    }
}

/// A function on the unit cube.
pub trait Problem {
    /// Number of coordinates.
    fn dimension(&self) -> usize;

    /// What some points come to, in their order; with residuals where they are wanted.
    fn evaluate(&self, points: &[Vec<f64>], residuals: bool) -> Vec<Evaluated>;
}

/// A run to simulate with values of all parameters.
struct Job {
    run: usize,
    values: Arc<[f64]>,
}

thread_local! {
    /// The simulator of a worker thread. A script's values cannot be sent between threads, so it is made and dropped here.
    /// The threads of a pool serve one [`StudyProblem`] only.
    static SIMULATOR: Cell<Option<Box<dyn Simulator>>> = const { Cell::new(None) };
}

/// The parameters of a study that follow its recordings.
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
    /// With a simulator for each of some threads.
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

    /// The study's own script as the model; the simulator has been opened.
    ///
    /// # Errors
    /// A thread could not be started.
    pub fn of_script(simulator: &ScriptSimulator, threads: usize) -> std::io::Result<Self> {
        let blueprint = simulator.blueprint();
        Self::new(simulator.study().clone(), threads, move || blueprint.simulator())
    }

    /// Simulate runs in parallel; results in their order.
    fn simulate(&self, jobs: impl IntoIterator<Item = Job>) -> impl Iterator<Item = Result<Fit, Mishap>> {
        let results = self.pool.run(jobs, |job: Job| {
            // A simulator whose run panics is not put back, so the next job gets a new one.
            let mut simulator = SIMULATOR.take().unwrap_or_else(|| (self.make_simulator)());
            let result = fit(&mut *simulator, &self.study, job.run, &job.values);
            SIMULATOR.set(Some(simulator));
            result
        });
        results.into_iter().map(|r| r.unwrap_or(Err(Mishap::Defect)))
    }

    /// The study.
    pub fn study(&self) -> &Arc<Study> {
        &self.study
    }

    /// Runs with some values of all parameters.
    pub fn fits(&self, runs: &[usize], values: &[f64]) -> Vec<Result<Fit, Mishap>> {
        let values: Arc<[f64]> = values.into();
        self.simulate(runs.iter().map(|r| Job { run: *r, values: values.clone() })).collect()
    }

    fn fitted_runs(&self) -> Vec<usize> {
        self.study.runs_of(Role::Fit).map(|(i, _)| i).collect()
    }

    /// Differences of all channels over their scales, such that their squares add up to the objective.
    pub fn residuals(&self, fits: &[&Fit]) -> Vec<f64> {
        let runs: Vec<usize> = self.fitted_runs();
        let channels: usize = runs.iter().map(|r| self.study.runs[*r].observe.len()).sum();
        let mut out = vec![];
        for (run, fit) in runs.iter().zip(fits) {
            for ((o, s), simulated) in self.study.runs[*run].observe.iter().zip(&fit.scores).zip(&fit.channels) {
                let scale = (o.weight / (s.samples as f64 * o.variance * channels as f64)).sqrt();
                let pairs = simulated.iter().zip(&o.values).filter(|(n, e)| !n.is_nan() && !e.is_nan());
                out.extend(pairs.map(|(num, exp)| scale * (num - exp)));
            }
        }
        out
    }
}

impl Problem for StudyProblem {
    fn dimension(&self) -> usize {
        self.study.space.dimension()
    }

    fn evaluate(&self, points: &[Vec<f64>], residuals: bool) -> Vec<Evaluated> {
        let runs = self.fitted_runs();
        let values: Vec<_> = points.iter().map(|p| self.study.space.values(p).map(Arc::<[f64]>::from)).collect();
        let jobs = values.iter().flatten().flat_map(|v| runs.iter().map(|r| Job { run: *r, values: v.clone() }));
        let mut answers = self.simulate(jobs);
        let evaluated = values.iter().map(|v| {
            if let Err(outside) = v {
                return Evaluated::failed(Mishap::Outside(outside.to_string()));
            }
            let fits: Vec<Result<Fit, Mishap>> = answers.by_ref().take(runs.len()).collect();
            let good: Result<Vec<&Fit>, Mishap> = fits.iter().map(|f| f.as_ref().map_err(Mishap::clone)).collect();
            match good {
                Err(mishap) => Evaluated::failed(mishap),
                Ok(fits) => {
                    let residuals = if residuals { self.residuals(&fits) } else { vec![] };
                    Evaluated { trial: Trial { score: objective(&self.study, &fits), residuals }, mishap: None }
                }
            }
        });
        evaluated.collect()
    }
}

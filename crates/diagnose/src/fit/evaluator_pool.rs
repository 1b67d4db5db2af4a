//! Evaluators on several threads.

use super::evaluator::evaluate;
use super::job::{EvaluationSettings, Job, JobResult};
use hysteron_identify::study::{SimulatorFactory, WorkerPool};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Threads that work off jobs.
pub(crate) struct EvaluatorPool {
    workers: WorkerPool,
    factory: SimulatorFactory,
    evaluations: AtomicUsize,
}

impl EvaluatorPool {
    /// A pool with an evaluator per thread.
    ///
    /// # Errors
    /// A thread could not be started.
    pub(crate) fn new(factory: SimulatorFactory, threads: usize) -> std::io::Result<Self> {
        Ok(Self { workers: WorkerPool::new(threads)?, factory, evaluations: AtomicUsize::new(0) })
    }

    /// Evaluations of the fitted runs so far, each at one point.
    pub(crate) fn evaluations(&self) -> usize {
        self.evaluations.load(Ordering::Relaxed)
    }

    /// Results in the order of the jobs; `None` where an evaluator failed.
    pub(crate) fn run(&self, jobs: Vec<Job>, settings: EvaluationSettings) -> Vec<Option<JobResult>> {
        let mut factory = self.factory.clone();
        factory.refine(settings.step_parts);
        self.workers.run(jobs, |job| evaluate(&factory, &job, &self.evaluations, settings.difference_step))
    }
}

//! Evaluators on several threads.

use super::evaluator::evaluate;
use super::job::{EvaluationSettings, Job, JobResult};
use hysteron_identify::study::{Blueprint, Crew};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Threads that work off jobs.
pub(crate) struct EvaluatorPool {
    workers: Crew<(Job, EvaluationSettings), JobResult>,
    evaluations: Arc<AtomicUsize>,
}

impl EvaluatorPool {
    /// A pool with an evaluator per thread.
    ///
    /// # Errors
    /// A thread could not be started.
    pub(crate) fn new(blueprint: Blueprint, threads: usize) -> std::io::Result<Self> {
        let make = move || blueprint.clone();
        let evaluations = Arc::new(AtomicUsize::new(0));
        let counted = evaluations.clone();
        let workers =
            Crew::new(threads, make, move |b: &mut Blueprint, (job, settings): (Job, EvaluationSettings)| {
                b.refine(settings.step_parts);
                evaluate(b, &job, &counted, settings.difference_step)
            })?;
        Ok(Self { workers, evaluations })
    }

    /// Evaluations of the fitted runs so far, each at one point.
    pub(crate) fn evaluations(&self) -> usize {
        self.evaluations.load(Ordering::Relaxed)
    }

    /// Results in the order of the jobs; `None` where an evaluator failed.
    pub(crate) fn run(&self, jobs: Vec<Job>, settings: EvaluationSettings) -> Vec<Option<JobResult>> {
        self.workers.run(jobs.into_iter().map(|job| (job, settings)))
    }
}

//! Batches of jobs with progress, cancellation and the cache of their results.

use super::checkpoint::{CheckpointEntry, EvaluationCache};
use super::evaluator_pool::EvaluatorPool;
use super::fitted::{FittedHypothesis, ScreenedHypothesis, sort_by_score};
use super::job::{EvaluationSettings, FittedModel, Job, JobResult, Task};
use super::linearized::LinearizedFit;
use super::search_settings::JOBS_PER_BATCH;
use crate::candidate::variant::Variant;
use hysteron_identify::calibrate::LevenbergMarquardt;
use hysteron_identify::study::Study;
use std::sync::Arc;

/// Receiver of a diagnosis' progress.
pub trait ProgressMonitor {
    /// `done` of `total` jobs of a stage are complete.
    fn stage(&mut self, name: &str, done: usize, total: usize);
    /// Returns true if the diagnosis is to stop.
    fn is_cancelled(&self) -> bool;
    /// All results so far, from which an interrupted diagnosis can resume.
    fn checkpoint(&mut self, entries: &[CheckpointEntry]);
}

/// A variant with the points at which it is screened.
pub(crate) type VariantPoints = (Arc<Variant>, Vec<Vec<f64>>);

/// Schedules jobs; the methods return an error if the user cancels.
pub(crate) struct Scheduler<'a> {
    /// The user's study.
    pub(crate) study: Arc<Study>,
    pool: EvaluatorPool,
    settings: EvaluationSettings,
    monitor: &'a mut dyn ProgressMonitor,
    cache: EvaluationCache,
}

impl<'a> Scheduler<'a> {
    /// A scheduler for a study, with the entries of an interrupted diagnosis.
    pub(crate) fn new(
        study: Arc<Study>,
        pool: EvaluatorPool,
        monitor: &'a mut dyn ProgressMonitor,
        checkpoint: Vec<CheckpointEntry>,
    ) -> Self {
        let settings = EvaluationSettings { step_parts: 1, difference_step: LevenbergMarquardt::DIFFERENCE_STEP };
        Self { study, pool, settings, monitor, cache: EvaluationCache::new(checkpoint) }
    }

    /// Number of parts into which later jobs divide each step of the script.
    pub(crate) fn set_step_parts(&mut self, parts: u32) {
        self.settings.step_parts = parts;
    }

    /// Parts into which each step of the script is divided.
    pub(crate) fn step_parts(&self) -> u32 {
        self.settings.step_parts
    }

    /// Step of finite differences of later jobs, in coordinates of the unit cube.
    pub(crate) fn set_difference_step(&mut self, step: f64) {
        self.settings.difference_step = step;
    }

    /// Evaluations of the fitted runs so far.
    pub(crate) fn evaluations(&self) -> usize {
        self.pool.evaluations()
    }

    /// # Errors
    /// The user has cancelled.
    pub(crate) fn check_cancelled(&self) -> Result<(), String> {
        if self.monitor.is_cancelled() { Err("interrupted".into()) } else { Ok(()) }
    }

    /// Results in the order of the jobs; `None` where an evaluator failed.
    fn run(&mut self, stage: &str, jobs: Vec<Job>) -> Result<Vec<Option<JobResult>>, String> {
        let total = jobs.len();
        let mut out = Vec::with_capacity(total);
        let mut jobs = jobs.into_iter().peekable();
        while jobs.peek().is_some() {
            self.check_cancelled()?;
            self.monitor.stage(stage, out.len(), total);
            let batch: Vec<Job> = jobs.by_ref().take(JOBS_PER_BATCH).collect();
            let (pool, settings) = (&self.pool, self.settings);
            let results = self.cache.results(batch, |missing| pool.run(missing, settings));
            // Analyses that were cut off are no results, so that this batch is not committed.
            let cancelled = self.check_cancelled();
            if cancelled.is_ok() {
                self.cache.commit();
            }
            self.monitor.checkpoint(self.cache.entries());
            cancelled?;
            out.extend(results);
        }
        self.monitor.stage(stage, total, total);
        Ok(out)
    }

    /// Fitted models of searches or evaluations; `None` where the analysis failed.
    pub(crate) fn fit(&mut self, stage: &str, jobs: Vec<Job>) -> Result<Vec<Option<FittedModel>>, String> {
        let fitted = |result| match result {
            Some(JobResult::Fitted(f)) if !f.fits.is_empty() => Some(f),
            _ => None,
        };
        Ok(self.run(stage, jobs)?.into_iter().map(fitted).collect())
    }

    /// Screens variants at points near a known point of a simpler variant: best first.
    ///
    /// The first coordinates of every point are those of `known`, and follow by the derivatives of `simpler` there.
    pub(crate) fn screen(
        &mut self,
        stage: &str,
        simpler: &Arc<Variant>,
        known: &[f64],
        candidates: Vec<VariantPoints>,
    ) -> Result<Vec<ScreenedHypothesis>, String> {
        let task = Task::Project { point: known.to_vec() };
        let projection = match self.run(stage, vec![Job { variant: simpler.clone(), task }])?.pop() {
            Some(Some(JobResult::Projected(Some(projection)))) => Arc::new(projection),
            _ => return Ok(vec![]),
        };
        let at_known = |p: &Vec<f64>| known.iter().chain(&p[known.len()..]).copied().collect();
        let candidates = candidates.into_iter().map(|(v, points)| (v, points.iter().map(at_known).collect())).collect();
        let mut out = self.screen_points(stage, candidates, Some(&projection))?;
        out.sort_by(|a, b| a.score().total_cmp(&b.score()));
        Ok(out)
    }

    /// The best point of each variant with its objective; variants without a result are left out.
    pub(crate) fn best_points(
        &mut self,
        stage: &str,
        candidates: Vec<VariantPoints>,
    ) -> Result<Vec<ScreenedHypothesis>, String> {
        self.screen_points(stage, candidates, None)
    }

    fn screen_points(
        &mut self,
        stage: &str,
        candidates: Vec<VariantPoints>,
        projection: Option<&Arc<super::projection::Projection>>,
    ) -> Result<Vec<ScreenedHypothesis>, String> {
        let variants: Vec<Arc<Variant>> = candidates.iter().map(|(v, _)| v.clone()).collect();
        let job = |(variant, points)| Job { variant, task: Task::Screen { points, projection: projection.cloned() } };
        let results = self.run(stage, candidates.into_iter().map(job).collect())?;
        let screened = |(variant, result)| match result {
            Some(JobResult::Screened(Some((expected_objective, start)))) => {
                Some(ScreenedHypothesis { variant, start, expected_objective })
            }
            _ => None,
        };
        Ok(variants.into_iter().zip(results).filter_map(screened).collect())
    }

    /// Searches from screened starts: best first.
    pub(crate) fn search(
        &mut self,
        stage: &str,
        from: Vec<ScreenedHypothesis>,
        iterations: usize,
    ) -> Result<Vec<FittedHypothesis>, String> {
        let jobs = from.iter().map(|s| Job::search(&s.variant, s.start.clone(), iterations)).collect();
        let fitted = self.fit(stage, jobs)?;
        let hypothesis = |(s, f): (ScreenedHypothesis, _)| Some(FittedHypothesis::new(s.variant, f?));
        let mut all: Vec<FittedHypothesis> = from.into_iter().zip(fitted).filter_map(hypothesis).collect();
        sort_by_score(&mut all);
        Ok(all)
    }

    /// Searches from the optima of hypotheses; without a result they stay as they are.
    pub(crate) fn refine(
        &mut self,
        stage: &str,
        all: Vec<FittedHypothesis>,
        iterations: usize,
    ) -> Result<Vec<FittedHypothesis>, String> {
        let jobs = all.iter().map(|e| Job::search(&e.variant, e.fitted.point.clone(), iterations));
        let fitted = self.fit(stage, jobs.collect())?;
        let refined = |(e, fitted)| match fitted {
            Some(fitted) => FittedHypothesis { fitted, ..e },
            None => e,
        };
        Ok(all.into_iter().zip(fitted).map(refined).collect())
    }

    /// A hypothesis at its optimum with another division of steps, which later jobs keep.
    pub(crate) fn evaluate_with_step_parts(
        &mut self,
        stage: &str,
        parts: u32,
        e: &FittedHypothesis,
    ) -> Result<Option<FittedModel>, String> {
        self.set_step_parts(parts);
        let job = Job { variant: e.variant.clone(), task: Task::Evaluate { point: e.fitted.point.clone() } };
        Ok(self.fit(stage, vec![job])?.pop().flatten())
    }

    /// Linearized fits of hypotheses; `None` where the analysis failed.
    pub(crate) fn linearize(
        &mut self,
        stage: &str,
        all: &[&FittedHypothesis],
    ) -> Result<Vec<Option<LinearizedFit>>, String> {
        let job = |e: &&FittedHypothesis| {
            let task = Task::Linearize { point: e.fitted.point.clone() };
            Job { variant: e.variant.clone(), task }
        };
        let linearized = |result| match result {
            Some(JobResult::Linearized(fit)) => fit,
            _ => None,
        };
        Ok(self.run(stage, all.iter().map(job).collect())?.into_iter().map(linearized).collect())
    }

    /// Sets the held-out residuals of hypotheses.
    pub(crate) fn hold_out(&mut self, stage: &str, all: &mut [FittedHypothesis]) -> Result<(), String> {
        let job = |e: &FittedHypothesis| {
            let task = Task::HoldOut { point: e.fitted.point.clone() };
            Job { variant: e.variant.clone(), task }
        };
        let results = self.run(stage, all.iter().map(job).collect())?;
        for (e, result) in all.iter_mut().zip(results) {
            e.held_out = match result {
                Some(JobResult::HeldOut(r)) => r,
                _ => None,
            };
        }
        Ok(())
    }
}

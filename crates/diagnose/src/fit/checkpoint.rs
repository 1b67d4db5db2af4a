//! Cache of job results, from which an interrupted diagnosis resumes.
//!
//! Every job follows from the results before it, so that the results in their order restore a diagnosis. Each entry has the
//! key of its job, and all of them the [`identity`] of the study. Entries behind a job with another key are invalid.

use super::job::{Job, JobResult, Task};
use hysteron_identify::study::{InitialRun, ScriptSimulator, simulate_and_score};
use serde::{Deserialize, Serialize};
use std::hash::{DefaultHasher, Hash as _, Hasher as _};

/// Result of a job, without the parts that are cheaper to compute again.
#[derive(Clone, Debug, Serialize, Deserialize)]
enum CachedResult {
    /// Optimum of a search; the model is evaluated there again.
    Fitted(Vec<f64>),
    /// Expected objective and start point of a screening.
    Screened(Option<(f64, Vec<f64>)>),
    /// Nothing; the job runs again.
    Recompute,
}

/// A cached result with the key of its job.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct CheckpointEntry {
    job: u64,
    result: CachedResult,
}

impl CheckpointEntry {
    fn new(job: u64, result: Option<&JobResult>) -> Self {
        let result = match result {
            Some(JobResult::Fitted(f)) => CachedResult::Fitted(f.point.clone()),
            Some(JobResult::Screened(s)) => CachedResult::Screened(s.clone()),
            _ => CachedResult::Recompute,
        };
        Self { job, result }
    }
}

/// Results of all jobs so far, and those of an interrupted diagnosis that are still to be reached.
pub(crate) struct EvaluationCache {
    entries: Vec<CheckpointEntry>,
    /// Number of jobs so far.
    jobs: usize,
    /// Entries of the last batch.
    uncommitted: Vec<CheckpointEntry>,
}

impl EvaluationCache {
    /// A cache with the entries of an interrupted diagnosis.
    pub(crate) fn new(entries: Vec<CheckpointEntry>) -> Self {
        Self { entries, jobs: 0, uncommitted: vec![] }
    }

    /// All entries, to be saved.
    pub(crate) fn entries(&self) -> &[CheckpointEntry] {
        &self.entries
    }

    /// Results of a batch of jobs in their order. `evaluate` computes those that the cache does not hold.
    pub(crate) fn results(
        &mut self,
        jobs: Vec<Job>,
        evaluate: impl FnOnce(Vec<Job>) -> Vec<Option<JobResult>>,
    ) -> Vec<Option<JobResult>> {
        let (mut keys, mut cached, mut missing) = (vec![], vec![], vec![]);
        for job in jobs {
            let key = job_key(&job);
            keys.push(key);
            match self.next_entry(key) {
                Some(CachedResult::Screened(result)) => cached.push(Some(JobResult::Screened(result))),
                Some(CachedResult::Fitted(point)) => {
                    missing.push(Job { task: Task::Evaluate { point }, ..job });
                    cached.push(None);
                }
                Some(CachedResult::Recompute) | None => {
                    missing.push(job);
                    cached.push(None);
                }
            }
        }
        let mut computed = evaluate(missing).into_iter();
        let results: Vec<Option<JobResult>> =
            cached.into_iter().map(|known| known.or_else(|| computed.next().flatten())).collect();
        self.uncommitted = keys.into_iter().zip(&results).map(|(k, r)| CheckpointEntry::new(k, r.as_ref())).collect();
        results
    }

    /// Adds the results of the last batch, unless an analysis of it was cut off.
    pub(crate) fn commit(&mut self) {
        let before = self.jobs - self.uncommitted.len();
        let known = self.entries.len().saturating_sub(before);
        self.entries.extend(self.uncommitted.drain(..).skip(known));
    }

    /// The result of the next job. An entry of another job invalidates itself and all entries behind it.
    fn next_entry(&mut self, key: u64) -> Option<CachedResult> {
        let number = self.jobs;
        self.jobs += 1;
        let entry = self.entries.get(number)?;
        if entry.job == key {
            return Some(entry.result.clone());
        }
        self.entries.truncate(number);
        None
    }
}

/// Hash of a job: its script, its proposal, its task and its points.
fn job_key(job: &Job) -> u64 {
    let mut hasher = DefaultHasher::new();
    (&*job.variant.text, format!("{:?}", job.variant.proposal)).hash(&mut hasher);
    let mut hash_points = |kind: u8, points: &[Vec<f64>]| {
        kind.hash(&mut hasher);
        points.iter().flatten().for_each(|x| x.to_bits().hash(&mut hasher));
    };
    match &job.task {
        Task::Fit { start, max_evaluations, precise } => {
            hash_points(0, std::slice::from_ref(start));
            (max_evaluations, precise).hash(&mut hasher);
        }
        Task::Screen { points, projection } => hash_points(if projection.is_some() { 1 } else { 2 }, points),
        Task::Project { point } => hash_points(3, std::slice::from_ref(point)),
        Task::HoldOut { point } => hash_points(4, std::slice::from_ref(point)),
        Task::Linearize { point } => hash_points(5, std::slice::from_ref(point)),
        Task::Evaluate { point } => hash_points(6, std::slice::from_ref(point)),
    }
    hasher.finish()
}

/// Hash of a study: its file, recordings, script and library, the program's version, and the model's channels at the
/// values of the script. The channels depend on every file that is read, and on the program.
pub fn identity(simulator: &ScriptSimulator, initial_run: &InitialRun, text: &str, excluded_causes: &[String]) -> u64 {
    let study = simulator.study();
    let mut hasher = DefaultHasher::new();
    (format!("{study:?}"), text, excluded_causes, env!("CARGO_PKG_VERSION")).hash(&mut hasher);
    let values = study.space.values_at(&study.space.unit_point(&initial_run.values)).unwrap_or_default();
    let mut simulator = simulator.factory().simulator_of_script(study.clone(), text);
    for run in 0..study.runs.len() {
        match simulate_and_score(&mut simulator, study, run, &values) {
            Ok(f) => f.channels.iter().flatten().for_each(|x| x.to_bits().hash(&mut hasher)),
            Err(error) => format!("{error:?}").hash(&mut hasher),
        }
    }
    hasher.finish()
}

#[cfg(test)]
mod tests {
    use super::EvaluationCache;
    use crate::fit::job::{Job, JobResult, Task};
    use crate::test_support::baseline;

    fn screening(x: f64) -> Job {
        Job { variant: baseline().variant, task: Task::Screen { points: vec![vec![x]], projection: None } }
    }

    /// Results of screenings at some points, and the number of jobs that were evaluated for them.
    fn screened(cache: &mut EvaluationCache, points: &[f64]) -> (Vec<f64>, usize) {
        let mut evaluated = 0;
        let results = cache.results(points.iter().map(|x| screening(*x)).collect(), |jobs| {
            evaluated = jobs.len();
            let objective = |job: &Job| match &job.task {
                Task::Screen { points, .. } => 10.0 * points[0][0],
                _ => f64::NAN,
            };
            jobs.iter().map(|job| Some(JobResult::Screened(Some((objective(job), vec![]))))).collect()
        });
        cache.commit();
        let objective = |result: Option<JobResult>| match result {
            Some(JobResult::Screened(Some((objective, _)))) => objective,
            _ => f64::NAN,
        };
        (results.into_iter().map(objective).collect(), evaluated)
    }

    #[test]
    fn known_jobs_are_not_evaluated_again_until_one_differs() {
        let mut cache = EvaluationCache::new(vec![]);
        assert_eq!(screened(&mut cache, &[0.1, 0.2, 0.3]), (vec![1.0, 2.0, 3.0], 3));
        let mut resumed = EvaluationCache::new(cache.entries().to_vec());
        assert_eq!(screened(&mut resumed, &[0.1]), (vec![1.0], 0));
        // Another second job, so that the third is evaluated again although it is known.
        assert_eq!(screened(&mut resumed, &[0.5, 0.3]), (vec![5.0, 3.0], 2));
        assert_eq!(resumed.entries().len(), 3);
        let mut again = EvaluationCache::new(resumed.entries().to_vec());
        assert_eq!(screened(&mut again, &[0.1, 0.5, 0.3, 0.4]), (vec![1.0, 5.0, 3.0, 4.0], 1));
    }
}

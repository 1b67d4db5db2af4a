//! Least squares of a variant, several variants side by side.

use super::variant::Variant;
use crate::calibrate::{LevenbergMarquardt, Method, Trial};
use crate::study::{Blueprint, Crew, Fit, Mishap, Role, Simulator, Study, fit};
use std::sync::Arc;

/// Which samples are used: blocks of time, every other of which can be held back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Samples {
    /// All.
    All,
    /// All blocks but those of a number modulo the folds.
    Without(usize),
}

/// Blocks of a run.
const BLOCKS: usize = 8;
/// Every block belongs to one of so many folds.
pub(super) const FOLDS: usize = 2;

impl Samples {
    fn uses(self, t: usize, n: usize) -> bool {
        match self {
            Self::All => true,
            Self::Without(fold) => (t * BLOCKS / n.max(1)) % FOLDS != fold,
        }
    }

    /// The samples that it leaves out.
    pub(super) fn holds_back(self, t: usize, n: usize) -> bool {
        !self.uses(t, n)
    }
}

/// A search to be made.
#[derive(Clone)]
pub(super) struct Job {
    /// What is fitted.
    pub(super) variant: Arc<Variant>,
    /// Where it starts, in the unit cube.
    pub(super) start: Vec<f64>,
    /// Most evaluations.
    pub(super) budget: usize,
    /// What is looked at.
    pub(super) samples: Samples,
}

/// Where a search has come to.
#[derive(Clone, Debug)]
pub(super) struct Fitted {
    /// The point in the unit cube.
    pub(super) point: Vec<f64>,
    /// Values of all parameters there.
    pub(super) values: Vec<f64>,
    /// Objective of the study over the samples looked at.
    pub(super) objective: f64,
    /// The fitted runs there, in their order; empty where the model has no answer.
    pub(super) fits: Vec<Fit>,
}

/// Work a job off.
pub(super) fn work(blueprint: &Blueprint, job: &Job) -> Fitted {
    let study = &job.variant.study;
    let mut simulator = job.variant.simulator(blueprint);
    let mut search = LevenbergMarquardt::new(&job.start, job.budget);
    let mut best = (Trial::FAILED, job.start.clone());
    loop {
        let points = search.ask();
        if points.is_empty() {
            break;
        }
        let trials: Vec<Trial> = points
            .iter()
            .map(|p| {
                let trial = trial(&mut simulator, study, p, job.samples);
                if trial.score < best.0 {
                    best = (trial.score, p.clone());
                }
                trial
            })
            .collect();
        search.tell(&points, &trials);
    }
    let (objective, point) = best;
    let values = study.space.values(&point).unwrap_or_default();
    let runs = study.runs_of(Role::Fit).map(|(i, _)| i).collect::<Vec<_>>();
    let fits: Result<Vec<Fit>, Mishap> = runs.iter().map(|r| fit(&mut simulator, study, *r, &values)).collect();
    Fitted { point, values, objective, fits: fits.unwrap_or_default() }
}

/// What a point comes to.
fn trial(simulator: &mut dyn Simulator, study: &Study, point: &[f64], samples: Samples) -> Trial {
    let failed = Trial { score: Trial::FAILED, residuals: vec![] };
    let Ok(values) = study.space.values(point) else { return failed };
    let runs: Vec<usize> = study.runs_of(Role::Fit).map(|(i, _)| i).collect();
    let channels: usize = runs.iter().map(|r| study.runs[*r].observe.len()).sum();
    let mut residuals = vec![];
    for r in runs {
        let Ok(f) = fit(simulator, study, r, &values) else { return failed };
        for (o, simulated) in study.runs[r].observe.iter().zip(&f.channels) {
            let n = simulated.len();
            let used: Vec<f64> = (0..n)
                .filter(|t| samples.uses(*t, n))
                .map(|t| simulated[t] - o.values[t])
                .filter(|d| d.is_finite())
                .collect();
            let scale = (o.weight / (used.len().max(1) as f64 * o.variance * channels as f64)).sqrt();
            residuals.extend(used.iter().map(|d| scale * d));
        }
    }
    Trial { score: residuals.iter().map(|r| r * r).sum(), residuals }
}

/// Workers that fit variants.
pub(super) struct Bench {
    crew: Crew<Job, Fitted>,
}

impl Bench {
    /// With a worker for each of some threads.
    ///
    /// # Errors
    /// A thread could not be started.
    pub(super) fn new(blueprint: Blueprint, threads: usize) -> std::io::Result<Self> {
        let make = move || blueprint.clone();
        Ok(Self { crew: Crew::new(threads, make, |b: &mut Blueprint, job: Job| work(b, &job))? })
    }

    /// Fit all; `None` where a worker broke down.
    pub(super) fn fit(&self, jobs: impl IntoIterator<Item = Job>) -> Vec<Option<Fitted>> {
        self.crew.run(jobs)
    }
}

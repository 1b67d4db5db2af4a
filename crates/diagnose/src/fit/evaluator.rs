//! What workers do with a variant: fit it, try points of it, see how far it predicts what it was not fitted to.

use crate::candidate::variant::{Variant, VariantSimulator};
use crate::evidence::likelihood::Residuals;
use crate::evidence::parametric_bootstrap::Near;
use crate::fit::checkpoint::Told;
use crate::fit::projection::Projection;
use hysteron_identify::calibrate::{LevenbergMarquardt, Method, Trial};
use hysteron_identify::study::{Blueprint, Crew, Fit, Mishap, Observe, Role, Study, fit};
use nalgebra::{DMatrix, DVector};
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, AtomicU64, AtomicUsize, Ordering};

/// Blocks of a run, each held back in one of the folds.
const BLOCKS: usize = 8;
/// Every block belongs to one of so many folds.
const FOLDS: usize = 4;
/// A search ends where an iteration gains less than this part of the objective.
const ENOUGH: f64 = 1e-3;
/// The same for the last search.
const CLOSELY: f64 = 1e-6;
/// Iterations in which the fault of a channel is followed when it is screened.
const FAULTS: usize = 6;

fn fold(t: usize, n: usize) -> usize {
    (t * BLOCKS / n.max(1)) % FOLDS
}

/// A step of least squares by the normal matrix and the gradient of a residual, damped by a hundredth of a sum of squares:
/// what the samples do not tell stays where it is.
pub(crate) fn damped_step(mut normal: DMatrix<f64>, gradient: &DVector<f64>, square: f64) -> Option<DVector<f64>> {
    for i in 0..normal.nrows() {
        normal[(i, i)] += square.max(f64::MIN_POSITIVE) / 100.0;
    }
    Some(normal.cholesky()?.solve(&-gradient))
}

/// A thing to be done with a variant.
#[derive(Clone)]
pub(crate) struct Job {
    /// What is looked at.
    pub(crate) variant: Arc<Variant>,
    /// What is done.
    pub(crate) task: Task,
}

/// What is done.
#[derive(Clone)]
pub(crate) enum Task {
    /// Least squares from a point of the unit cube, with at most so many evaluations.
    Fit { start: Vec<f64>, budget: usize, closely: bool },
    /// Which of some points comes nearest, when the model's known parameters are allowed to follow if it is said how.
    Screen { points: Vec<Vec<f64>>, known: Option<Arc<Projection>> },
    /// Derivatives at a point, for [`Task::Screen`].
    Derive { point: Vec<f64> },
    /// Residuals on samples that it was not fitted to.
    HoldBack { point: Vec<f64> },
    /// What is left near a point.
    Near { point: Vec<f64> },
    /// What the model says at a point.
    Look { point: Vec<f64> },
    /// What an earlier diagnosis of the same study came to.
    Told(Told),
}

/// What came of it.
pub(crate) enum Answer {
    /// Of [`Task::Fit`] and [`Task::Look`].
    Fitted(Fitted),
    /// Of [`Task::Screen`]: the objective to be expected, and where a search had best start.
    Screened(Option<(f64, Vec<f64>)>),
    /// Of [`Task::Derive`].
    Derived(Option<Projection>),
    /// Of [`Task::HoldBack`].
    HeldBack(Option<Residuals>),
    /// Of [`Task::Near`].
    Near(Option<Near>),
}

/// Where a search has come to.
#[derive(Clone, Debug)]
pub(crate) struct Fitted {
    /// The point in the unit cube.
    pub(crate) point: Vec<f64>,
    /// Values of all parameters there.
    pub(crate) values: Vec<f64>,
    /// Objective of the study.
    pub(crate) objective: f64,
    /// The fitted runs there, in their order; empty where the model has no answer.
    pub(crate) fits: Vec<Fit>,
}

/// A variant with its simulator.
struct Bed<'a> {
    study: &'a Study,
    simulator: VariantSimulator,
    /// Sets of runs that were looked at, by all workers.
    looks: &'a AtomicUsize,
    /// Step of the differences that are taken for derivatives, in sides of the cube.
    width: f64,
}

impl Bed<'_> {
    fn runs(&self) -> impl Iterator<Item = usize> + use<'_> {
        self.study.runs_of(Role::Fit).map(|(i, _)| i)
    }

    fn fits(&mut self, values: &[f64]) -> Result<Vec<Fit>, Mishap> {
        let runs: Vec<usize> = self.runs().collect();
        self.looks.fetch_add(1, Ordering::Relaxed);
        runs.into_iter().map(|r| fit(&mut self.simulator, self.study, r, values)).collect()
    }

    /// Weighted residuals, whose squares add up to the objective.
    fn trial(&mut self, point: &[f64]) -> Trial {
        let failed = Trial { score: Trial::FAILED, residuals: vec![] };
        let Ok(values) = self.study.space.values(point) else { return failed };
        let Ok(fits) = self.fits(&values) else { return failed };
        let channels: usize = self.runs().map(|r| self.study.runs[r].observe.len()).sum();
        let mut residuals = vec![];
        for (r, f) in self.runs().zip(&fits) {
            for (o, simulated) in self.study.runs[r].observe.iter().zip(&f.channels) {
                let own: Vec<f64> =
                    simulated.iter().zip(&o.values).map(|(y, v)| y - v).filter(|d| d.is_finite()).collect();
                let scale = (o.weight / (own.len().max(1) as f64 * o.variance * channels as f64)).sqrt();
                residuals.extend(own.iter().map(|d| scale * d));
            }
        }
        Trial { score: residuals.iter().map(|r| r * r).sum(), residuals }
    }

    fn search(&mut self, start: &[f64], budget: usize, closely: bool) -> Fitted {
        let enough = if closely { CLOSELY } else { ENOUGH };
        let (objective, point) = descend(start, budget, enough, self.width, |p| self.trial(p));
        self.fitted(point, objective)
    }

    /// What the model says at a point.
    fn look(&mut self, point: &[f64]) -> Fitted {
        let objective = self.trial(point).score;
        self.fitted(point.to_vec(), objective)
    }

    /// What the model says at the end of a search.
    fn fitted(&mut self, point: Vec<f64>, objective: f64) -> Fitted {
        let values = self.study.space.values(&point).unwrap_or_default();
        let fits = self.fits(&values).unwrap_or_default();
        Fitted { point, values, objective, fits }
    }

    /// Residual at a point and its derivatives by all coordinates; those of a coordinate without an answer are zero.
    fn derivatives(&mut self, point: &[f64]) -> Option<(Vec<f64>, DMatrix<f64>)> {
        let here = self.trial(point).residuals;
        if here.is_empty() {
            return None;
        }
        let mut j = DMatrix::zeros(here.len(), point.len());
        for i in 0..point.len() {
            let h = if point[i] > 0.5 { -self.width } else { self.width };
            let mut p = point.to_vec();
            p[i] += h;
            let there = self.trial(&p).residuals;
            if there.len() == here.len() {
                j.column_mut(i).iter_mut().zip(there.iter().zip(&here)).for_each(|(d, (a, b))| *d = (a - b) / h);
            }
        }
        Some((here, j))
    }

    fn screen(
        &mut self,
        points: &[Vec<f64>],
        known: Option<&Projection>,
        of_a_channel: bool,
    ) -> Option<(f64, Vec<f64>)> {
        let mut best: Option<(f64, Vec<f64>)> = None;
        let mut nearest = None;
        for p in points {
            let trial = self.trial(p);
            let followed = match known {
                Some(known) => known.follow(&trial.residuals, p),
                None => (trial.score < Trial::FAILED).then(|| (trial.score, p.clone())),
            };
            let Some((score, start)) = followed else { continue };
            if best.as_ref().is_none_or(|b| score < b.0) {
                best = Some((score, start));
                nearest = Some(p);
            }
        }
        // Faults of channels need no analysis: they are followed to where they are best.
        let (Some(known), Some(nearest)) = (known.filter(|_| of_a_channel), nearest) else { return best };
        let own = known.dimension();
        let budget = FAULTS * (nearest.len() - own + 2);
        let (_, added) = descend(&nearest[own..], budget, ENOUGH, LevenbergMarquardt::STEP, |added| {
            let left = known.left(&self.trial(&[&nearest[..own], added].concat()).residuals);
            left.map_or(Trial { score: Trial::FAILED, residuals: vec![] }, |r| Trial {
                score: r.iter().map(|x| x * x).sum(),
                residuals: r,
            })
        });
        let point = [&nearest[..own], &added[..]].concat();
        let followed = known.follow(&self.trial(&point).residuals, &point);
        followed.filter(|f| best.as_ref().is_none_or(|b| f.0 < b.0)).or(best)
    }

    /// What is left of all channels at a point, and the derivatives there.
    fn near(&mut self, point: &[f64]) -> Option<Near> {
        let (r, j) = self.derivatives(point)?;
        let there = |o: &Observe| o.values.iter().filter(|v| v.is_finite()).count();
        let samples: Vec<usize> = self.runs().flat_map(|run| self.study.runs[run].observe.iter()).map(there).collect();
        (samples.iter().sum::<usize>() == r.len()).then(|| Near::new(&r, &j, &samples))
    }

    /// For each fold, a step from the fit to all samples towards that without the fold, by the derivatives; what the
    /// model says there of the fold.
    fn held_back(&mut self, point: &[f64]) -> Option<Residuals> {
        let (r, j) = self.derivatives(point)?;
        let study = self.study;
        let shape: Vec<(usize, Vec<bool>)> = self
            .runs()
            .flat_map(|run| study.runs[run].observe.iter())
            .map(|o| (o.values.len(), o.values.iter().map(|v| v.is_finite()).collect()))
            .collect();
        // Rows of the residual with the fold of each; samples where the analysis had ended are not supposed.
        let folds: Vec<usize> =
            shape.iter().flat_map(|(n, there)| (0..*n).filter(|t| there[*t]).map(|t| fold(t, *n))).collect();
        if folds.len() != r.len() {
            return None;
        }
        let mut out = r.clone();
        for f in 0..FOLDS {
            let kept: Vec<usize> = (0..r.len()).filter(|i| folds[*i] != f).collect();
            let (a, b) = (j.select_rows(&kept), DVector::from_iterator(kept.len(), kept.iter().map(|i| r[*i])));
            let step = damped_step(a.tr_mul(&a), &a.tr_mul(&b), b.norm_squared())?;
            let own = |r: &[f64], inside: bool| -> f64 {
                (0..r.len()).filter(|i| (folds[*i] == f) == inside).map(|i| r[i] * r[i]).sum()
            };
            // The derivatives may promise too much: the longest step that is one towards what is kept.
            for part in [1.0, 0.3, 0.1] {
                let moved = |(p, s): (&f64, &f64)| (p + part * s).clamp(0.0, 1.0);
                let next: Vec<f64> = point.iter().zip(step.iter()).map(moved).collect();
                let there = self.trial(&next).residuals;
                if there.len() == r.len() && own(&there, false) <= own(&r, false) {
                    (0..r.len()).filter(|i| folds[*i] == f).for_each(|i| out[i] = there[i]);
                    break;
                }
            }
        }
        let mut rest = &out[..];
        let mut channels = vec![];
        for (_, there) in &shape {
            let (own, after) = rest.split_at(there.iter().filter(|x| **x).count());
            channels.push(own.to_vec());
            rest = after;
        }
        Some(channels)
    }
}

/// Least squares from a point, with at most so many evaluations and differences so wide: the best score, and where.
fn descend(
    start: &[f64],
    budget: usize,
    enough: f64,
    width: f64,
    mut trial: impl FnMut(&[f64]) -> Trial,
) -> (f64, Vec<f64>) {
    let mut search = LevenbergMarquardt::new(start, budget).one_by_one(enough).with_steps(width);
    let mut best = (Trial::FAILED, start.to_vec());
    loop {
        let points = search.ask();
        if points.is_empty() {
            return best;
        }
        let trials: Vec<Trial> = points.iter().map(|p| trial(p)).collect();
        for (p, trial) in points.iter().zip(&trials).filter(|(_, t)| t.score < Trial::FAILED) {
            if trial.score < best.0 {
                best = (trial.score, p.clone());
            }
        }
        search.tell(&points, &trials);
    }
}

/// Work a job off.
fn work(blueprint: &Blueprint, job: &Job, looks: &AtomicUsize, width: f64) -> Answer {
    let mut bed = Bed { study: &job.variant.study, simulator: job.variant.simulator(blueprint), looks, width };
    match &job.task {
        Task::Fit { start, budget, closely } => Answer::Fitted(bed.search(start, *budget, *closely)),
        Task::Screen { points, known } => {
            Answer::Screened(bed.screen(points, known.as_deref(), job.variant.of_a_channel()))
        }
        Task::Derive { point } => Answer::Derived(bed.derivatives(point).and_then(|(r, j)| Projection::new(&r, j))),
        Task::Near { point } => Answer::Near(bed.near(point)),
        Task::HoldBack { point } => Answer::HeldBack(bed.held_back(point)),
        Task::Look { point } | Task::Told(Told::Fitted(point)) => Answer::Fitted(bed.look(point)),
        Task::Told(Told::Screened(said)) => Answer::Screened(said.clone()),
        Task::Told(Told::Again) => Answer::Screened(None),
    }
}

/// Workers that look at variants.
pub(crate) struct Bench {
    crew: Crew<Job, Answer>,
    looks: Arc<AtomicUsize>,
    parts: Arc<AtomicU32>,
    /// Bits of the width of differences.
    width: Arc<AtomicU64>,
}

impl Bench {
    /// With a worker for each of some threads.
    ///
    /// # Errors
    /// A thread could not be started.
    pub(crate) fn new(blueprint: Blueprint, threads: usize) -> std::io::Result<Self> {
        let make = move || blueprint.clone();
        let (looks, parts) = (Arc::new(AtomicUsize::new(0)), Arc::new(AtomicU32::new(1)));
        let width = Arc::new(AtomicU64::new(LevenbergMarquardt::STEP.to_bits()));
        let (counted, wanted, wide) = (looks.clone(), parts.clone(), width.clone());
        let crew = Crew::new(threads, make, move |b: &mut Blueprint, job: Job| {
            b.refine(wanted.load(Ordering::Relaxed));
            work(b, &job, &counted, f64::from_bits(wide.load(Ordering::Relaxed)))
        })?;
        Ok(Self { crew, looks, parts, width })
    }

    /// Make the steps of the script in so many parts from now on, with closer tests where there is more than one.
    pub(crate) fn refine(&self, parts: u32) {
        self.parts.store(parts, Ordering::Relaxed);
    }

    /// Take differences over steps so wide from now on, in sides of the cube.
    pub(crate) fn widen(&self, width: f64) {
        self.width.store(width.to_bits(), Ordering::Relaxed);
    }

    /// In how many parts the steps are made.
    pub(crate) fn parts(&self) -> u32 {
        self.parts.load(Ordering::Relaxed)
    }

    /// How often the fitted runs have been looked at, for one set of values each.
    pub(crate) fn looks(&self) -> usize {
        self.looks.load(Ordering::Relaxed)
    }

    /// Do all; `None` where a worker broke down.
    pub(crate) fn run(&self, jobs: impl IntoIterator<Item = Job>) -> Vec<Option<Answer>> {
        self.crew.run(jobs)
    }
}

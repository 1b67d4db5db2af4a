//! Execution of a job: least squares, screening, derivatives and held-out residuals of a variant.

use super::job::{ChannelResiduals, FittedModel, Job, JobResult, Task};
use super::linearized::{LinearizedFit, damped_step};
use super::projection::Projection;
use super::search_settings::{
    CHANGE_POINT_MOVES, CHANGE_POINT_ROUNDS, CHANNEL_FAULT_ITERATIONS, EXTRA_EVALUATIONS, PRECISE_SEARCH_TOLERANCE,
    SEARCH_TOLERANCE,
};
use crate::candidate::variant::VariantSimulator;
use crate::prior::{HOLDOUT_BLOCKS, HOLDOUT_FOLDS, HOLDOUT_STEP_FRACTIONS};
use hysteron_identify::calibrate::{LevenbergMarquardt, Method, Trial};
use hysteron_identify::study::{
    ObservedChannel, Role, ScoredRun, SimulationError, SimulatorFactory, Study, simulate_and_score,
};
use nalgebra::{DMatrix, DVector};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Result of a job. `evaluations` counts the evaluations of the fitted runs.
pub(crate) fn evaluate(
    factory: &SimulatorFactory,
    job: &Job,
    evaluations: &AtomicUsize,
    difference_step: f64,
) -> JobResult {
    let simulator = job.variant.simulator(factory);
    let mut evaluator = Evaluator { study: &job.variant.study, simulator, evaluations, difference_step };
    match &job.task {
        Task::Fit { start, max_evaluations, precise } => {
            let change_points = job.variant.change_point_coordinates();
            JobResult::Fitted(evaluator.search(start, *max_evaluations, *precise, &change_points))
        }
        Task::Screen { points, projection } => {
            JobResult::Screened(evaluator.screen(points, projection.as_deref(), job.variant.is_channel_fault()))
        }
        Task::Project { point } => {
            JobResult::Projected(evaluator.derivatives(point).and_then(|(r, j)| Projection::new(&r, j)))
        }
        Task::Linearize { point } => JobResult::Linearized(evaluator.linearize(point)),
        Task::HoldOut { point } => JobResult::HeldOut(evaluator.held_out(point)),
        Task::Evaluate { point } => JobResult::Fitted(evaluator.model_at(point)),
    }
}

/// Fold of a sample in a run of n samples.
fn fold(t: usize, n: usize) -> usize {
    (t * HOLDOUT_BLOCKS / n.max(1)) % HOLDOUT_FOLDS
}

fn failed_trial() -> Trial {
    Trial { objective: Trial::FAILED, residuals: vec![] }
}

/// A variant with its simulator.
struct Evaluator<'a> {
    study: &'a Study,
    simulator: VariantSimulator,
    evaluations: &'a AtomicUsize,
    /// Step of finite differences, in coordinates of the unit cube.
    difference_step: f64,
}

impl Evaluator<'_> {
    /// Numbers of the fitted runs.
    fn runs(&self) -> impl Iterator<Item = usize> + use<'_> {
        self.study.runs_of(Role::Fit).map(|(i, _)| i)
    }

    /// Channels of the fitted runs, run after run.
    fn channels(&self) -> impl Iterator<Item = &ObservedChannel> {
        self.runs().flat_map(|run| self.study.runs[run].observe.iter())
    }

    fn fits(&mut self, values: &[f64]) -> Result<Vec<ScoredRun>, SimulationError> {
        let runs: Vec<usize> = self.runs().collect();
        self.evaluations.fetch_add(1, Ordering::Relaxed);
        runs.into_iter().map(|r| simulate_and_score(&mut self.simulator, self.study, r, values)).collect()
    }

    /// Weighted residuals, whose squares add up to the objective.
    fn trial(&mut self, point: &[f64]) -> Trial {
        let Ok(values) = self.study.space.values_at(point) else { return failed_trial() };
        let Ok(fits) = self.fits(&values) else { return failed_trial() };
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
        Trial { objective: residuals.iter().map(|r| r * r).sum(), residuals }
    }

    /// Least squares from a point. `change_points` are the coordinates of times at which a parameter changes: their
    /// derivatives say only what the step at that time tells, so that other times are tried as well.
    fn search(&mut self, start: &[f64], max_evaluations: usize, precise: bool, change_points: &[usize]) -> FittedModel {
        let tolerance = if precise { PRECISE_SEARCH_TOLERANCE } else { SEARCH_TOLERANCE };
        let step = self.difference_step;
        let mut best = least_squares(start, max_evaluations, tolerance, step, |p| self.trial(p));
        for _ in 0..CHANGE_POINT_ROUNDS {
            let moved = self.with_moved_change_points(&best, change_points);
            if moved.0 >= (1.0 - SEARCH_TOLERANCE) * best.0 {
                break;
            }
            best = least_squares(&moved.1, max_evaluations, tolerance, step, |p| self.trial(p));
        }
        self.fitted_model(best.1, best.0)
    }

    /// A point with its objective, and with the best of some other times of change, each moved alone.
    fn with_moved_change_points(
        &mut self,
        (objective, point): &(f64, Vec<f64>),
        change_points: &[usize],
    ) -> (f64, Vec<f64>) {
        let mut best = (*objective, point.clone());
        for k in change_points {
            for by in CHANGE_POINT_MOVES.into_iter().flat_map(|by| [-by, by]) {
                let mut moved = best.1.clone();
                moved[*k] = (moved[*k] + by).clamp(0.0, 1.0);
                let objective = self.trial(&moved).objective;
                if objective < best.0 {
                    best = (objective, moved);
                }
            }
        }
        best
    }

    fn model_at(&mut self, point: &[f64]) -> FittedModel {
        let objective = self.trial(point).objective;
        self.fitted_model(point.to_vec(), objective)
    }

    fn fitted_model(&mut self, point: Vec<f64>, objective: f64) -> FittedModel {
        let values = self.study.space.values_at(&point).unwrap_or_default();
        let fits = self.fits(&values).unwrap_or_default();
        FittedModel { point, values, objective, fits }
    }

    /// Residuals r at a point and their Jacobian ∂r/∂p by finite differences; columns without a result are zero.
    fn derivatives(&mut self, point: &[f64]) -> Option<(Vec<f64>, DMatrix<f64>)> {
        let here = self.trial(point).residuals;
        if here.is_empty() {
            return None;
        }
        let mut j = DMatrix::zeros(here.len(), point.len());
        for i in 0..point.len() {
            // Towards the middle of the range.
            let h = if point[i] > 0.5 { -self.difference_step } else { self.difference_step };
            let mut p = point.to_vec();
            p[i] += h;
            let there = self.trial(&p).residuals;
            if there.len() == here.len() {
                j.column_mut(i).iter_mut().zip(there.iter().zip(&here)).for_each(|(d, (a, b))| *d = (a - b) / h);
            }
        }
        Some((here, j))
    }

    /// The best of some points, with its expected objective.
    fn screen(
        &mut self,
        points: &[Vec<f64>],
        projection: Option<&Projection>,
        is_channel_fault: bool,
    ) -> Option<(f64, Vec<f64>)> {
        let mut best: Option<(f64, Vec<f64>)> = None;
        let mut best_point = None;
        for p in points {
            let trial = self.trial(p);
            let expected = match projection {
                Some(projection) => projection.follow(&trial.residuals, p),
                None => (trial.objective < Trial::FAILED).then(|| (trial.objective, p.clone())),
            };
            let Some((score, start)) = expected else { continue };
            if best.as_ref().is_none_or(|b| score < b.0) {
                best = Some((score, start));
                best_point = Some(p);
            }
        }
        // Channel faults need no analysis, so that they are followed to their optimum.
        let (Some(projection), Some(point)) = (projection.filter(|_| is_channel_fault), best_point) else {
            return best;
        };
        let own = projection.dimension();
        let budget = CHANNEL_FAULT_ITERATIONS * (point.len() - own + EXTRA_EVALUATIONS);
        let step = LevenbergMarquardt::DIFFERENCE_STEP;
        let (_, added) = least_squares(&point[own..], budget, SEARCH_TOLERANCE, step, |added| {
            let remaining = projection.remaining(&self.trial(&[&point[..own], added].concat()).residuals);
            remaining.map_or_else(failed_trial, |r| Trial { objective: r.iter().map(|x| x * x).sum(), residuals: r })
        });
        let point = [&point[..own], &added[..]].concat();
        let followed = projection.follow(&self.trial(&point).residuals, &point);
        followed.filter(|f| best.as_ref().is_none_or(|b| f.0 < b.0)).or(best)
    }

    /// The linearized fit at a point. `None` if the analysis failed, or ended before a recorded sample.
    fn linearize(&mut self, point: &[f64]) -> Option<LinearizedFit> {
        let (r, j) = self.derivatives(point)?;
        let samples: Vec<usize> = self.channels().map(|o| o.values.iter().filter(|v| v.is_finite()).count()).collect();
        (samples.iter().sum::<usize>() == r.len()).then(|| LinearizedFit::new(&r, &j, &samples))
    }

    /// Residuals of each fold after a linear step from the fit of all samples towards the fit without the fold.
    fn held_out(&mut self, point: &[f64]) -> Option<ChannelResiduals> {
        let (r, j) = self.derivatives(point)?;
        let recorded: Vec<Vec<bool>> =
            self.channels().map(|o| o.values.iter().map(|v| v.is_finite()).collect()).collect();
        // Fold of each row of the residual.
        let folds_of = |recorded: &Vec<bool>| {
            let n = recorded.len();
            (0..n).filter(|t| recorded[*t]).map(|t| fold(t, n)).collect::<Vec<usize>>()
        };
        let folds: Vec<usize> = recorded.iter().flat_map(folds_of).collect();
        // An analysis that ended early has fewer rows.
        if folds.len() != r.len() {
            return None;
        }
        let mut out = r.clone();
        for f in 0..HOLDOUT_FOLDS {
            let kept: Vec<usize> = (0..r.len()).filter(|i| folds[*i] != f).collect();
            let (a, b) = (j.select_rows(&kept), DVector::from_iterator(kept.len(), kept.iter().map(|i| r[*i])));
            let step = damped_step(a.tr_mul(&a), &a.tr_mul(&b), b.norm_squared())?;
            let kept_square = |r: &[f64]| -> f64 { (0..r.len()).filter(|i| folds[*i] != f).map(|i| r[i] * r[i]).sum() };
            // Derivatives may promise too much: the longest step that does not worsen the kept samples.
            for part in HOLDOUT_STEP_FRACTIONS {
                let moved = |(p, s): (&f64, &f64)| (p + part * s).clamp(0.0, 1.0);
                let next: Vec<f64> = point.iter().zip(step.iter()).map(moved).collect();
                let there = self.trial(&next).residuals;
                if there.len() == r.len() && kept_square(&there) <= kept_square(&r) {
                    (0..r.len()).filter(|i| folds[*i] == f).for_each(|i| out[i] = there[i]);
                    break;
                }
            }
        }
        let mut rest = &out[..];
        let mut channels = vec![];
        for recorded in &recorded {
            let (own, after) = rest.split_at(recorded.iter().filter(|x| **x).count());
            channels.push(own.to_vec());
            rest = after;
        }
        Some(channels)
    }
}

/// Levenberg-Marquardt from a point: the best score, and its point.
fn least_squares(
    start: &[f64],
    max_evaluations: usize,
    tolerance: f64,
    difference_step: f64,
    mut trial: impl FnMut(&[f64]) -> Trial,
) -> (f64, Vec<f64>) {
    let mut search = LevenbergMarquardt::new(start, max_evaluations)
        .with_single_steps(tolerance)
        .with_difference_step(difference_step);
    let mut best = (Trial::FAILED, start.to_vec());
    loop {
        let points = search.ask();
        if points.is_empty() {
            return best;
        }
        let trials: Vec<Trial> = points.iter().map(|p| trial(p)).collect();
        for (p, trial) in points.iter().zip(&trials).filter(|(_, t)| t.objective < Trial::FAILED) {
            if trial.objective < best.0 {
                best = (trial.objective, p.clone());
            }
        }
        search.tell(&points, &trials);
    }
}

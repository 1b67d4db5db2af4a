//! Tasks for a variant, and their results.

use super::linearized::LinearizedFit;
use super::projection::Projection;
use super::search_settings::{EXTRA_EVALUATIONS, LAST_ITERATIONS};
use crate::candidate::variant::Variant;
use hysteron_identify::study::ScoredRun;
use std::sync::Arc;

/// Weighted residuals of the fitted runs, channel after channel; missing samples are left out.
pub(crate) type ChannelResiduals = Vec<Vec<f64>>;

/// A task for a variant.
#[derive(Clone)]
pub(crate) struct Job {
    /// The variant.
    pub(crate) variant: Arc<Variant>,
    /// The task.
    pub(crate) task: Task,
}

impl Job {
    /// Least squares from a point of the unit cube.
    pub(crate) fn search(variant: &Arc<Variant>, start: Vec<f64>, iterations: usize) -> Self {
        let max_evaluations = iterations * (variant.dimension() + EXTRA_EVALUATIONS);
        let task = Task::Fit { start, max_evaluations, precise: iterations >= LAST_ITERATIONS };
        Self { variant: variant.clone(), task }
    }
}

/// A task. Points are those of the unit cube.
#[derive(Clone)]
pub(crate) enum Task {
    /// Least squares from a point.
    Fit { start: Vec<f64>, max_evaluations: usize, precise: bool },
    /// The best of some points, with the user's parameters following by their derivatives if a projection is given.
    Screen { points: Vec<Vec<f64>>, projection: Option<Arc<Projection>> },
    /// Derivatives at a point, for [`Task::Screen`].
    Project { point: Vec<f64> },
    /// Residuals of samples that the variant is not fitted to.
    HoldOut { point: Vec<f64> },
    /// Residuals and derivatives at a point.
    Linearize { point: Vec<f64> },
    /// The model at a point.
    Evaluate { point: Vec<f64> },
}

/// Result of a task.
pub(crate) enum JobResult {
    /// Of [`Task::Fit`] and [`Task::Evaluate`].
    Fitted(FittedModel),
    /// Of [`Task::Screen`]: the expected objective, and the start of a search.
    Screened(Option<(f64, Vec<f64>)>),
    /// Of [`Task::Project`].
    Projected(Option<Projection>),
    /// Of [`Task::HoldOut`].
    HeldOut(Option<ChannelResiduals>),
    /// Of [`Task::Linearize`].
    Linearized(Option<LinearizedFit>),
}

/// A model at the end of a search.
#[derive(Clone, Debug)]
pub(crate) struct FittedModel {
    /// Point of the unit cube.
    pub(crate) point: Vec<f64>,
    /// Values of all parameters.
    pub(crate) values: Vec<f64>,
    /// Objective of the study: mean NMSE.
    pub(crate) objective: f64,
    /// The fitted runs, in their order; empty if the analysis failed.
    pub(crate) fits: Vec<ScoredRun>,
}

/// Numerical settings of an evaluation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct EvaluationSettings {
    /// Parts into which each step of the script is divided; closer convergence tests where there are several.
    pub(crate) step_parts: u32,
    /// Step of finite differences, in coordinates of the unit cube.
    pub(crate) difference_step: f64,
}

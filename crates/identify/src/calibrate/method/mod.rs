//! Methods that minimise an objective on the unit cube.
//!
//! A [`Method`] asks for evaluations of trial points and is told their results. It evaluates nothing itself, so the points
//! of one call can be evaluated in any order and by any number of threads. Its state, random numbers included, goes into
//! checkpoints, and the search continues from one to the same bits.

mod cma_es;
mod differential_evolution;
mod levenberg_marquardt;
mod shade;
mod step_search;

use rand::RngExt as _;
use rand_pcg::Pcg32;
use serde::{Deserialize, Serialize};

pub use cma_es::CmaEs;
pub use differential_evolution::{Crossover, DifferentialEvolution, EvolutionSettings};
pub use levenberg_marquardt::LevenbergMarquardt;
pub use shade::{Shade, ShadeVariant};
pub use step_search::StepSearch;

/// Result of a trial point.
#[derive(Clone, Debug, PartialEq)]
pub struct Trial {
    /// Objective, which is minimised; [`Trial::FAILED`] if the model has no response.
    pub objective: f64,
    /// Residuals whose sum of squares is the objective; empty if the method does not need them.
    pub residuals: Vec<f64>,
}

impl Trial {
    /// Objective of a point where the model has no response: worse than any other, and finite.
    pub const FAILED: f64 = f64::MAX;
}

/// A minimisation method on the unit cube.
pub trait Method {
    /// The unit points to evaluate next; empty at the end of the search.
    fn ask(&mut self) -> Vec<Vec<f64>>;

    /// Take the results of the points of the last [`Method::ask`], in their order.
    fn tell(&mut self, unit_points: &[Vec<f64>], trials: &[Trial]);

    /// Greatest less least objective of the current points.
    fn spread(&self) -> f64;

    /// Returns true if the method needs the residuals of a trial.
    fn needs_residuals(&self) -> bool {
        false
    }

    /// Share of the budget that is used, from 0 to 1.
    fn progress(&self) -> f64;

    /// Returns true if the search has ended because it has converged, and not because its budget is used.
    fn has_converged(&self) -> bool {
        false
    }
}

/// State of a method in a checkpoint.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub enum MethodState {
    /// Differential evolution.
    DifferentialEvolution(DifferentialEvolution),
    /// Adaptive differential evolution.
    Shade(Shade),
    /// Evolution strategy with covariance matrix adaptation.
    CmaEs(CmaEs),
    /// Least squares from one starting point.
    LevenbergMarquardt(LevenbergMarquardt),
    /// Step search along the parameters.
    StepSearch(StepSearch),
}

impl MethodState {
    /// The method.
    pub fn method(&mut self) -> &mut dyn Method {
        match self {
            Self::DifferentialEvolution(m) => m,
            Self::Shade(m) => m,
            Self::CmaEs(m) => m,
            Self::LevenbergMarquardt(m) => m,
            Self::StepSearch(m) => m,
        }
    }
}

/// A point from the uniform distribution over the unit cube.
fn random_point(rng: &mut Pcg32, dimension: usize) -> Vec<f64> {
    (0..dimension).map(|_| rng.random::<f64>()).collect()
}

/// Greatest less least objective, failed points left out.
fn objective_spread(objectives: &[f64]) -> f64 {
    let successful = || objectives.iter().filter(|s| **s < Trial::FAILED);
    let greatest = successful().fold(f64::NEG_INFINITY, |m, s| m.max(*s));
    let least = successful().fold(f64::INFINITY, |m, s| m.min(*s));
    (greatest - least).max(0.0)
}

/// The coordinate of a mutant. One outside of the cube is put half way between the coordinate `from` and the bound.
fn halfway_to_bound(mutant: f64, from: f64) -> f64 {
    match mutant {
        x if x < 0.0 => 0.5 * from,
        x if x > 1.0 => 0.5 * (1.0 + from),
        x => x,
    }
}

/// A standard normal number, by the polar method (Marsaglia and Bray, 1964).
pub(super) fn standard_normal(rng: &mut Pcg32) -> f64 {
    loop {
        let (u, v) = (2.0 * rng.random::<f64>() - 1.0, 2.0 * rng.random::<f64>() - 1.0);
        let s = u * u + v * v;
        if s > 0.0 && s < 1.0 {
            return u * (-2.0 * s.ln() / s).sqrt();
        }
    }
}

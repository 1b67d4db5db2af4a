//! Methods that look for the least value of a function on the unit cube.
//!
//! A [`Method`] is asked for points and told what they came to; it never evaluates anything itself, so the points of one
//! asking can be worked out in any order and by any number of threads with the same result. What a method knows is data,
//! random numbers included: written into a checkpoint and read back, it goes on as if nothing had happened.

mod cma_es;
mod de;
mod levenberg_marquardt;
mod shade;

use rand::RngExt as _;
use rand_pcg::Pcg32;
use serde::{Deserialize, Serialize};

pub use cma_es::CmaEs;
pub use de::{Crossover, Differential, Evolution};
pub use levenberg_marquardt::LevenbergMarquardt;
pub use shade::{Shade, Variant};

/// What a point came to.
#[derive(Clone, Debug, PartialEq)]
pub struct Trial {
    /// Value of the function: the least is sought. [`Trial::FAILED`] where there is none.
    pub score: f64,
    /// Numbers whose squares add up to the score, if the method wants them and there are any.
    pub residuals: Vec<f64>,
}

impl Trial {
    /// Score of a point at which the model has no answer: worse than any other, and yet a number.
    pub const FAILED: f64 = f64::MAX;
}

/// Looks for the least value of a function on the unit cube.
pub trait Method {
    /// The points to evaluate next; none when it has ended.
    fn ask(&mut self) -> Vec<Vec<f64>>;

    /// What the points asked for came to, in their order.
    fn tell(&mut self, points: &[Vec<f64>], trials: &[Trial]);

    /// Greatest less least score of the points that it works with.
    fn spread(&self) -> f64;

    /// Whether it needs the residuals of a trial.
    fn wants_residuals(&self) -> bool {
        false
    }

    /// How much of its way it has gone, from 0 to 1, where that is known.
    fn progress(&self) -> f64;
}

/// A method that can be written into a checkpoint.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub enum Search {
    /// Differential evolution.
    Evolution(Evolution),
    /// Differential evolution that adapts itself.
    Shade(Shade),
    /// Evolution of a normal distribution.
    CmaEs(CmaEs),
    /// Least squares from one point.
    LevenbergMarquardt(LevenbergMarquardt),
}

impl Search {
    /// The method behind it.
    pub fn method(&mut self) -> &mut dyn Method {
        match self {
            Self::Evolution(m) => m,
            Self::Shade(m) => m,
            Self::CmaEs(m) => m,
            Self::LevenbergMarquardt(m) => m,
        }
    }
}

/// A point anywhere in the unit cube.
fn anywhere(rng: &mut Pcg32, dimension: usize) -> Vec<f64> {
    (0..dimension).map(|_| rng.random::<f64>()).collect()
}

/// Greatest less least of some scores, failed ones left out.
fn spread_of(scores: &[f64]) -> f64 {
    let good = || scores.iter().filter(|s| **s < Trial::FAILED);
    let most = good().fold(f64::NEG_INFINITY, |m, s| m.max(*s));
    let least = good().fold(f64::INFINITY, |m, s| m.min(*s));
    (most - least).max(0.0)
}

/// A coordinate that a mutation has put outside: half way from where it came to the side that it went through.
fn inside(mutant: f64, from: f64) -> f64 {
    match mutant {
        x if x < 0.0 => 0.5 * from,
        x if x > 1.0 => 0.5 * (1.0 + from),
        x => x,
    }
}

/// A normally distributed number, by the polar method (Marsaglia and Bray, 1964).
pub(super) fn normal(rng: &mut Pcg32) -> f64 {
    loop {
        let (u, v) = (2.0 * rng.random::<f64>() - 1.0, 2.0 * rng.random::<f64>() - 1.0);
        let s = u * u + v * v;
        if s > 0.0 && s < 1.0 {
            return u * (-2.0 * s.ln() / s).sqrt();
        }
    }
}

//! The error of the steps of an analysis, below which nothing is diagnosed.
//!
//! A right model with long steps differs from its recordings all the same, and what the steps do follows the motion and
//! looks like physics. So the best explanation at hand is run once more with its steps in two parts and its tests passed
//! closer. Where that moves a channel by more than a small part of what is left of it, explanations are weighed with steps in
//! as many parts as make the rest of the error small; but not where that takes the model away from the recordings, as where a
//! motion was sampled no finer than the steps. What is reported of the repaired model is of the steps of the script.

use super::noise::power;
use super::work::{Explained, Work};
use crate::study::{Fit, Observe, Role, Study};

/// Part of the power of a residual that steps of half the length may move.
const SMALL: f64 = 0.005;
/// A channel that is followed to this part of its variance is followed.
const FAITHFUL: f64 = 1e-4;
/// Iterations in which the best explanation follows the steps.
const AGAIN: usize = 6;
/// Parts that a step is made in, at most.
const MOST: u32 = 4;
/// Steps of half the length that move as much as this part of what the whole ones do lead nowhere.
const LEADS_NOWHERE: f64 = 0.5;

/// How long the steps of the script are for what is to be told apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct StepError {
    /// Parts that they have to be made in.
    pub(super) parts: u32,
    /// Largest part of the power that is left of a channel which halving them moves.
    pub(super) share: f64,
}

impl StepError {
    /// What is to be said of it, where there is something to say.
    pub(super) fn says(&self) -> String {
        if self.share <= SMALL {
            return String::new();
        }
        let moved =
            format!("Steps of half the length move {:.1} % of what the model leaves of a channel", 100.0 * self.share);
        match self.parts {
            1 => format!(" {moved}, and bring it no nearer to the recordings."),
            n => format!(" {moved}: the causes were weighed with steps in {n} parts."),
        }
    }
}

/// Find it for the best explanation at hand.
pub(super) fn step_error(work: &mut Work<'_>, best: &Explained) -> Result<StepError, String> {
    let mut moves: Vec<f64> = vec![];
    let mut steps = best.fitted.fits.clone();
    let mut parts = 1;
    while parts < MOST {
        let Some(halved) = work.with_steps_in(2 * parts, best)? else { break };
        let moved = moved(&work.study, &steps, &halved);
        let nowhere = moves.last().is_some_and(|before| moved > LEADS_NOWHERE * before);
        moves.push(moved);
        if nowhere {
            parts = 1;
        }
        if nowhere || moved <= SMALL {
            break;
        }
        (steps, parts) = (halved, 2 * parts);
    }
    let mut left = |parts: u32| -> Result<f64, String> {
        work.bench.refine(parts);
        let again = Work::search(&best.variant, best.fitted.point.clone(), AGAIN);
        let fitted = work.fit("the error of the steps", vec![again])?.pop().flatten();
        Ok(fitted.map_or(f64::INFINITY, |f| f.objective))
    };
    if parts > 1 && left(parts)? >= left(1)? {
        parts = 1;
    }
    Ok(StepError { parts, share: moves.first().copied().unwrap_or(0.0) })
}

/// Largest part of the power of a residual that other steps move, over the channels that are fitted.
fn moved(study: &Study, steps: &[Fit], others: &[Fit]) -> f64 {
    let runs = study.runs.iter().filter(|r| r.role == Role::Fit);
    let channels = runs
        .zip(steps.iter().zip(others))
        .flat_map(|(run, (a, b))| run.observe.iter().zip(a.channels.iter().zip(&b.channels)));
    let part = |(o, (y, z)): (&Observe, (&Vec<f64>, &Vec<f64>))| {
        let finite = |x: Vec<f64>| x.into_iter().filter(|x| x.is_finite()).collect::<Vec<f64>>();
        let left = power(&finite(y.iter().zip(&o.values).map(|(y, v)| y - v).collect()));
        let change = power(&finite(y.iter().zip(z).map(|(y, z)| y - z).collect()));
        change / left.max(FAITHFUL * o.variance).max(f64::MIN_POSITIVE)
    };
    channels.map(part).fold(0.0, f64::max)
}

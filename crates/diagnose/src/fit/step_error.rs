//! The error of the steps of an analysis, below which nothing is diagnosed.
//!
//! A right model with long steps differs from its recordings all the same, and what the steps do follows the motion and
//! looks like physics. So the model as it is and the best explanation at hand are run once more with their steps in two
//! parts and their tests passed closer. Where that moves a channel by more than a small part of what is left of it,
//! explanations are weighed with steps in as many parts as make the rest of the error small; but not where that takes the
//! model away from the recordings, as where a motion was sampled no finer than the steps. What is reported of the repaired
//! model is of the steps of the script.

use crate::fit::scheduler::{Explained, Work};
use crate::residual::noise::power;
use hysteron_identify::study::{Fit, Observe, Role, Study};

/// Part of the power of a residual that steps of half the length may move.
const SMALL: f64 = 0.005;
/// A channel that is followed to this part of its variance is followed.
const FAITHFUL: f64 = 1e-4;
/// Iterations in which an explanation follows the steps.
const AGAIN: usize = 6;
/// Parts that a step is made in, at most.
const MOST: u32 = 8;
/// Steps of half the length that move as much as this part of what the whole ones do lead nowhere.
const LEADS_NOWHERE: f64 = 0.5;
const STAGE: &str = "the error of the steps";

/// How long the steps of the script are for what is to be told apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct StepError {
    /// Parts that they have to be made in.
    pub(crate) parts: u32,
    /// Largest part of the power that is left of a channel which halving them moves.
    pub(crate) share: f64,
    /// The same of the steps in parts.
    pub(crate) rest: f64,
}

impl StepError {
    /// What is to be said of it, where there is something to say.
    pub(crate) fn says(&self) -> String {
        if self.share <= SMALL {
            return String::new();
        }
        let moved =
            format!("Steps of half the length move {:.1} % of what the model leaves of a channel", 100.0 * self.share);
        match self.parts {
            1 => format!(" {moved}, and bring it no nearer to the recordings."),
            n if self.rest <= SMALL => format!(" {moved}: the causes were weighed with steps in {n} parts."),
            n => format!(
                " {moved}, and halving steps in {n} parts, with which the causes were weighed, still {:.1} %: what is told from so \
                 little may be the error of the steps.",
                100.0 * self.rest
            ),
        }
    }
}

/// Find it for the model as it is and for the best explanation at hand: by the former where there is nothing else to be
/// found, since a wrong law may have taken the place of shorter steps; by the latter where an effect hides it.
pub(crate) fn step_error(
    work: &mut Work<'_>,
    baseline: &Explained,
    best: Option<&Explained>,
) -> Result<StepError, String> {
    let of_baseline = of_one(work, baseline)?;
    let of_best = best.map(|e| of_one(work, e)).transpose()?.unwrap_or(of_baseline);
    // The one that asks for more parts; of equals, the best explanation has less to lose to the steps.
    Ok(if of_baseline.parts > of_best.parts { of_baseline } else { of_best })
}

fn of_one(work: &mut Work<'_>, e: &Explained) -> Result<StepError, String> {
    let mut moves: Vec<f64> = vec![];
    let mut steps = e.fitted.fits.clone();
    let mut parts = 1;
    while let Some(halved) = work.with_steps_in(STAGE, 2 * parts, e)? {
        let halved = halved.fits;
        let moved = moved(&work.study, &steps, &halved);
        let nowhere = moves.last().is_some_and(|before| moved > LEADS_NOWHERE * before);
        moves.push(moved);
        if nowhere {
            parts = 1;
        }
        if nowhere || moved <= SMALL || parts == MOST {
            break;
        }
        (steps, parts) = (halved, 2 * parts);
    }
    let mut left = |parts: u32| -> Result<f64, String> {
        work.bench.refine(parts);
        let again = Work::search(&e.variant, e.fitted.point.clone(), AGAIN);
        let fitted = work.fit(STAGE, vec![again])?.pop().flatten();
        Ok(fitted.map_or(f64::INFINITY, |f| f.objective))
    };
    if parts > 1 && left(parts)? >= left(1)? {
        parts = 1;
    }
    let [share, rest] = [moves.first(), moves.last()].map(|m| m.copied().unwrap_or(0.0));
    Ok(StepError { parts, share, rest })
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

//! Error of the time steps, below which nothing is diagnosed.
//!
//! The error of long steps follows the motion and looks like physics. The baseline and the best hypothesis are therefore run
//! with halved steps. If that moves a channel by more than a small share of its residual, the ranking uses divided steps. The
//! division goes on until the remaining error is small. Steps stay as they are if their division worsens the fit, as where a motion was
//! sampled no finer. The repaired model is always reported with the steps of the script.

use super::fitted::FittedHypothesis;
use super::job::Job;
use super::scheduler::Scheduler;
use super::search_settings::STEP_ERROR_ITERATIONS;
use crate::prior::{MAX_STEP_ERROR_RATIO, MAX_STEP_PARTS, NEGLIGIBLE_STEP_ERROR, REPRODUCED_CHANNEL};
use crate::series::power;
use hysteron_identify::study::{ObservedChannel, Role, ScoredRun, Study};

const STAGE: &str = "the error of the steps";

/// Error of the time steps against the residuals.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct StepError {
    /// Parts into which each step is divided for the ranking.
    pub(crate) parts: u32,
    /// Largest share of a channel's residual power that halved steps move.
    pub(crate) share: f64,
    /// The same for the divided steps.
    pub(crate) remaining_share: f64,
}

impl StepError {
    /// The error in words; empty if it is negligible.
    pub(crate) fn description(&self) -> String {
        if self.share <= NEGLIGIBLE_STEP_ERROR {
            return String::new();
        }
        let moved =
            format!("Steps of half the length move {:.1} % of what the model leaves of a channel", 100.0 * self.share);
        match self.parts {
            1 => format!(" {moved}, and bring it no nearer to the recordings."),
            n if self.remaining_share <= NEGLIGIBLE_STEP_ERROR => {
                format!(" {moved}: the causes were weighed with steps in {n} parts.")
            }
            n => format!(
                " {moved}, and halving steps in {n} parts, with which the causes were weighed, still {:.1} %: what is told from so \
                 little may be the error of the steps.",
                100.0 * self.remaining_share
            ),
        }
    }
}

/// Step error of the baseline or of the best hypothesis, whichever needs more parts.
///
/// A wrong law may have compensated for long steps, and a missing effect may hide their error. On a tie the best hypothesis
/// counts, because it has less residual to lose to the steps.
pub(crate) fn step_error(
    scheduler: &mut Scheduler<'_>,
    baseline: &FittedHypothesis,
    best: Option<&FittedHypothesis>,
) -> Result<StepError, String> {
    let of_baseline = step_error_of(scheduler, baseline)?;
    let of_best = best.map(|e| step_error_of(scheduler, e)).transpose()?.unwrap_or(of_baseline);
    Ok(if of_baseline.parts > of_best.parts { of_baseline } else { of_best })
}

fn step_error_of(scheduler: &mut Scheduler<'_>, e: &FittedHypothesis) -> Result<StepError, String> {
    let mut moves: Vec<f64> = vec![];
    let mut present = e.fitted.fits.clone();
    let mut parts = 1;
    while let Some(halved) = scheduler.evaluate_with_step_parts(STAGE, 2 * parts, e)? {
        let halved = halved.fits;
        let moved = moved_share(&scheduler.study, &present, &halved);
        let diverges = moves.last().is_some_and(|before| moved > MAX_STEP_ERROR_RATIO * before);
        moves.push(moved);
        if diverges {
            parts = 1;
        }
        if diverges || moved <= NEGLIGIBLE_STEP_ERROR || parts == MAX_STEP_PARTS {
            break;
        }
        (present, parts) = (halved, 2 * parts);
    }
    let mut objective_with = |parts: u32| -> Result<f64, String> {
        scheduler.set_step_parts(parts);
        let job = Job::search(&e.variant, e.fitted.point.clone(), STEP_ERROR_ITERATIONS);
        let fitted = scheduler.fit(STAGE, vec![job])?.pop().flatten();
        Ok(fitted.map_or(f64::INFINITY, |f| f.objective))
    };
    if parts > 1 && objective_with(parts)? >= objective_with(1)? {
        parts = 1;
    }
    let [share, remaining_share] = [moves.first(), moves.last()].map(|m| m.copied().unwrap_or(0.0));
    Ok(StepError { parts, share, remaining_share })
}

/// Largest share of a channel's residual power that other steps move, over the fitted channels.
fn moved_share(study: &Study, fits: &[ScoredRun], others: &[ScoredRun]) -> f64 {
    let runs = study.runs.iter().filter(|r| r.role == Role::Fit);
    let channels = runs
        .zip(fits.iter().zip(others))
        .flat_map(|(run, (a, b))| run.observe.iter().zip(a.channels.iter().zip(&b.channels)));
    let share = |(o, (y, z)): (&ObservedChannel, (&Vec<f64>, &Vec<f64>))| {
        let finite = |x: Vec<f64>| x.into_iter().filter(|x| x.is_finite()).collect::<Vec<f64>>();
        let residual = power(&finite(y.iter().zip(&o.values).map(|(y, v)| y - v).collect()));
        let change = power(&finite(y.iter().zip(z).map(|(y, z)| y - z).collect()));
        change / residual.max(REPRODUCED_CHANNEL * o.variance).max(f64::MIN_POSITIVE)
    };
    channels.map(share).fold(0.0, f64::max)
}

//! Fit of the user's model.

use super::fitted::FittedHypothesis;
use super::global_search::global_search;
use super::job::{FittedModel, Job};
use super::scheduler::Scheduler;
use super::search_settings::{
    BASELINE_ITERATIONS, LAST_ITERATIONS, MIN_WIDER_STEP_GAIN, POOR_NMSE, POOR_NMSE_AT_BOUND, WIDER_DIFFERENCE_STEPS,
    WIDER_STEP_STARTS, is_at_bound,
};
use crate::candidate::variant::Variant;
use hysteron_identify::calibrate::LevenbergMarquardt;
use hysteron_identify::study::InitialRun;
use std::sync::Arc;

const STAGE: &str = "the model as it is";

/// Starts of the baseline in n coordinates besides the user's values: the middle of the cube, and four vertices of a smaller one.
fn baseline_starts(n: usize) -> Vec<Vec<f64>> {
    let (low, high) = (0.2, 0.8);
    let vertex = |even, odd| (0..n).map(|i| if i % 2 == 0 { even } else { odd }).collect();
    vec![vec![0.5; n], vertex(low, high), vertex(high, low), vertex(low, low), vertex(high, high)]
}

/// The user's model fitted from several starts. Where it is poor, a minimum that is found from evenly spread points counts if it
/// explains nearly all. The step of differences that fits best is kept for all later jobs.
///
/// # Errors
/// The model has no result for any values, or the user cancelled.
pub(crate) fn fit_baseline(
    scheduler: &mut Scheduler<'_>,
    initial_run: &InitialRun,
    text: &str,
) -> Result<FittedHypothesis, String> {
    let variant = Arc::new(Variant::baseline(&scheduler.study, text));
    let mut starts = vec![scheduler.study.space.unit_point(&initial_run.values)];
    starts.extend(baseline_starts(variant.dimension()));
    let jobs = starts.into_iter().map(|s| Job::search(&variant, s, BASELINE_ITERATIONS)).collect();
    let mut sorted: Vec<FittedModel> = scheduler.fit(STAGE, jobs)?.into_iter().flatten().collect();
    sorted.sort_by(|a, b| a.objective.total_cmp(&b.objective));
    let precise = |f: &FittedModel| Job::search(&variant, f.point.clone(), LAST_ITERATIONS);
    let first = scheduler.fit(STAGE, sorted.first().map(precise).into_iter().collect())?.pop().flatten();
    let first = first.ok_or("the model has no answer for any values of its parameters")?;
    let mut best = (LevenbergMarquardt::DIFFERENCE_STEP, first.clone());
    sorted[0] = first;
    for step in WIDER_DIFFERENCE_STEPS {
        scheduler.set_difference_step(step);
        let fits = scheduler.fit(STAGE, sorted.iter().take(WIDER_STEP_STARTS).map(precise).collect())?;
        let better = fits.into_iter().flatten().min_by(|a, b| a.objective.total_cmp(&b.objective));
        if let Some(f) = better.filter(|f| f.objective < (1.0 - MIN_WIDER_STEP_GAIN) * best.1.objective) {
            best = (step, f);
        }
    }
    scheduler.set_difference_step(best.0);
    let baseline = FittedHypothesis::new(variant.clone(), best.1);
    if !is_poor(&baseline) {
        return Ok(baseline);
    }
    // A minimum of the model itself that no start has come to would be taken for physics that is missing. One that explains
    // little may make up for such physics, and says no more of the parameters than the user's values.
    let mut fitted = vec![baseline.clone()];
    global_search(scheduler, STAGE, &baseline, &[variant], LAST_ITERATIONS, &mut fitted)?;
    Ok(fitted.into_iter().find(|f| f.fitted.objective <= POOR_NMSE_AT_BOUND).unwrap_or(baseline))
}

/// Returns true if the error of a baseline is too large to trust its parameters.
///
/// A smaller error suffices if a parameter is at a bound, where it compensates for a missing effect.
pub(crate) fn is_poor(baseline: &FittedHypothesis) -> bool {
    let nmse = baseline.fitted.objective;
    nmse > POOR_NMSE || nmse > POOR_NMSE_AT_BOUND && baseline.fitted.point.iter().any(|p| is_at_bound(*p))
}

/// The baseline fitted again with the present step length.
///
/// # Errors
/// The model has no result, or the user cancelled.
pub(crate) fn refit_baseline(
    scheduler: &mut Scheduler<'_>,
    baseline: &FittedHypothesis,
) -> Result<FittedHypothesis, String> {
    let job = Job::search(&baseline.variant, baseline.fitted.point.clone(), LAST_ITERATIONS);
    let fitted = scheduler.fit(STAGE, vec![job])?.pop().flatten();
    let fitted = fitted.ok_or("the model has no answer with shorter steps")?;
    Ok(FittedHypothesis::new(baseline.variant.clone(), fitted))
}

#[cfg(test)]
mod tests {
    use super::baseline_starts;

    #[test]
    fn starts_differ() {
        for n in 2..5 {
            let starts = baseline_starts(n);
            assert!(starts.iter().enumerate().all(|(i, a)| starts[..i].iter().all(|b| a != b)), "{n}: {starts:?}");
        }
    }
}

//! Repeated searches for the look-alikes of the best hypothesis.

use super::fitted::{FittedHypothesis, sort_by_score};
use super::halton_points::halton_points;
use super::scheduler::Scheduler;
use super::search_settings::{COMPETITOR_POINTS, FIRST_ROUND_ITERATIONS};
use crate::hypothesis::look_alike;
use std::sync::Arc;

/// Refits the look-alikes of the best hypothesis from its values of the user's parameters.
///
/// These values are nearer to the truth beside its look-alikes than those of the baseline. Contact and slack have several
/// minima, so that added parameters start from many points. `fitted` is sorted before and after.
pub(crate) fn refit_competitors(
    scheduler: &mut Scheduler<'_>,
    baseline: &FittedHypothesis,
    fitted: &mut [FittedHypothesis],
) -> Result<(), String> {
    let own = baseline.variant.dimension();
    let Some(best) = fitted.first().filter(|e| e.score() < baseline.score()).cloned() else { return Ok(()) };
    let stage = "what looks like the best of them";
    let competitors = fitted.iter().filter(|e| look_alike(e.cause(), best.cause()));
    let points = |e: &FittedHypothesis| {
        let start = [&best.fitted.point[..own], &e.fitted.point[own..]].concat();
        (e.variant.clone(), halton_points(&start, own, COMPETITOR_POINTS))
    };
    let candidates = competitors.map(points).collect();
    let starts = scheduler.best_points(stage, candidates)?;
    for FittedHypothesis { variant, fitted: f, .. } in scheduler.search(stage, starts, FIRST_ROUND_ITERATIONS)? {
        let known = fitted.iter_mut().find(|e| Arc::ptr_eq(&e.variant, &variant));
        if let Some(e) = known.filter(|e| f.objective < e.fitted.objective) {
            e.fitted = f;
        }
    }
    sort_by_score(fitted);
    Ok(())
}

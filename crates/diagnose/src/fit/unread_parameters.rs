//! The user's parameters that a whole law leaves without effect: those of the law that it replaces.
//!
//! They take no part in a fit, so that they do not count as parameters of it either.

use super::fitted::FittedHypothesis;
use super::job::{FittedModel, Job, Task};
use super::scheduler::Scheduler;
use crate::candidate::proposal::Proposal;
use crate::candidate::variant::Variant;
use crate::inspect::insertion::InsertionPoint;
use std::sync::Arc;

const STAGE: &str = "what may have been left out";

/// Move of a parameter, in coordinates of the unit cube.
const MOVE: f64 = 0.25;

/// Proposals with the user's parameters that they leave without effect on any observed channel.
///
/// # Errors
/// The user cancelled.
pub(crate) fn with_unread_parameters(
    scheduler: &mut Scheduler<'_>,
    baseline: &FittedHypothesis,
    point: &InsertionPoint,
    mut proposals: Vec<Proposal>,
) -> Result<Vec<Proposal>, String> {
    for proposal in proposals.iter_mut().filter(|p| p.whole_law.is_some()) {
        if let Some(variant) = baseline.variant.with_proposal(point, proposal) {
            proposal.unread = unread_parameters(scheduler, baseline, &Arc::new(variant))?;
        }
    }
    Ok(proposals)
}

/// Indices of the user's free parameters that change no channel of a variant; none if its start has no result.
fn unread_parameters(
    scheduler: &mut Scheduler<'_>,
    baseline: &FittedHypothesis,
    variant: &Arc<Variant>,
) -> Result<Vec<usize>, String> {
    let start = variant.start(&baseline.fitted.values);
    let own: Vec<usize> = baseline.variant.study.space.free().map(|(index, _)| index).collect();
    let moved = |coordinate: usize| {
        let mut point = start.clone();
        point[coordinate] += if point[coordinate] > 0.5 { -MOVE } else { MOVE };
        point
    };
    let points = std::iter::once(start.clone()).chain((0..own.len()).map(moved));
    let jobs = points.map(|point| Job { variant: variant.clone(), task: Task::Evaluate { point } }).collect();
    let mut models = scheduler.fit(STAGE, jobs)?.into_iter();
    let Some(here) = models.next().flatten() else { return Ok(vec![]) };
    let same = |there: &FittedModel| {
        let pairs = here.fits.iter().zip(&there.fits).flat_map(|(a, b)| a.channels.iter().zip(&b.channels));
        let mut samples = pairs.flat_map(|(a, b)| a.iter().zip(b));
        samples.all(|(a, b)| a == b || a.is_nan() && b.is_nan())
    };
    Ok(own.into_iter().zip(models).filter(|(_, m)| m.as_ref().is_some_and(same)).map(|(index, _)| index).collect())
}

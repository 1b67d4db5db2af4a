//! Channels that no edit of the script changes: nothing about the model can be learned from them.

use super::fitted::FittedHypothesis;
use super::job::{Job, Task};
use super::scheduler::Scheduler;
use crate::candidate::proposal::Proposal;
use crate::inspect::insertion::InsertionPoint;
use hysteron_identify::study::{ObservedChannel, Role};
use std::sync::Arc;

const STAGE: &str = "what may have been left out";

/// NMSE below which a channel has no error to be explained.
const MIN_NMSE: f64 = 1e-2;
/// Difference of a channel that counts as none, in standard deviations of the recording.
const MIN_CHANGE: f64 = 1e-9;

/// Observed channels with an error that every proposal leaves as it is at its start, by name, each once.
///
/// # Errors
/// The user cancelled.
pub(crate) fn unmoved_channels(
    scheduler: &mut Scheduler<'_>,
    baseline: &FittedHypothesis,
    point: &InsertionPoint,
    proposals: &[Proposal],
) -> Result<Vec<ObservedChannel>, String> {
    let study = scheduler.study.clone();
    let observed: Vec<&Vec<ObservedChannel>> = study.runs_of(Role::Fit).map(|(_, run)| &run.observe).collect();
    let fits = &baseline.fitted.fits;
    let mut unmoved = vec![];
    for (run, (fit, channels)) in fits.iter().zip(&observed).enumerate() {
        unmoved.extend((0..channels.len()).filter(|k| fit.scores[*k].nmse > MIN_NMSE).map(|k| (run, k)));
    }
    let mut tried = false;
    for proposal in proposals.iter().filter(|p| p.edits_script()) {
        if unmoved.is_empty() {
            return Ok(vec![]);
        }
        let Some(variant) = baseline.variant.with_proposal(point, proposal).map(Arc::new) else { continue };
        let task = Task::Evaluate { point: variant.start(&baseline.fitted.values) };
        let model = scheduler.fit(STAGE, vec![Job { variant, task }])?.pop().flatten();
        let Some(model) = model else { continue };
        tried = true;
        unmoved.retain(|&(run, k): &(usize, usize)| {
            let least = MIN_CHANGE * observed[run][k].variance.sqrt();
            let pairs = fits[run].channels[k].iter().zip(&model.fits[run].channels[k]);
            pairs.into_iter().all(|(a, b)| !a.is_finite() || !b.is_finite() || (a - b).abs() <= least)
        });
    }
    let mut out: Vec<ObservedChannel> = vec![];
    for (run, k) in unmoved.into_iter().filter(|_| tried) {
        let channel = &observed[run][k];
        if out.iter().all(|o| o.channel != channel.channel) {
            out.push(channel.clone());
        }
    }
    Ok(out)
}

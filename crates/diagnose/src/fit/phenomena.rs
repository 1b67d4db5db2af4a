//! Phenomena of a whole law, switched off one at a time.

use super::fitted::FittedHypothesis;
use super::job::{ChannelResiduals, Job};
use super::scheduler::Scheduler;
use super::search_settings::SECOND_ROUND_ITERATIONS;
use crate::candidate::proposal::Switch;
use crate::candidate::variant::Variant;
use crate::inspect::insertion::InsertionPoint;
use std::sync::Arc;

const STAGE: &str = "what the law does";

/// Share of the gain of a whole law that is lost without each of its phenomena, and its basis in words.
#[derive(Clone, Debug)]
pub(crate) struct PhenomenonShares {
    /// Phenomena, the largest share first.
    pub(crate) shares: Vec<(&'static str, f64)>,
    /// Behaviour that is left without them, in words.
    pub(crate) basis: &'static str,
    /// Phenomena that are effects of other causes than that of the law.
    pub(crate) of_other_causes: Vec<PhenomenonOnBlocks>,
}

/// Residuals on blocks held back with a phenomenon and without it.
#[derive(Clone, Debug)]
pub(crate) struct PhenomenonOnBlocks {
    /// Cause that it is an effect of.
    pub(crate) cause: &'static str,
    /// Parameters of it.
    pub(crate) parameters: usize,
    pub(crate) with: ChannelResiduals,
    pub(crate) without: ChannelResiduals,
}

/// Shares of the phenomena of a fitted whole law; none for other hypotheses.
///
/// Without a phenomenon the other parameters are fitted again from the optimum. The share is the error that comes back over
/// the error that the hypothesis takes from the baseline.
///
/// # Errors
/// The user cancelled.
pub(crate) fn phenomenon_shares(
    scheduler: &mut Scheduler<'_>,
    baseline: &FittedHypothesis,
    point: &InsertionPoint,
    e: &FittedHypothesis,
) -> Result<Option<PhenomenonShares>, String> {
    let Some(parts) = e.variant.proposal.as_ref().and_then(|p| p.whole_law.clone()) else { return Ok(None) };
    let gain = baseline.fitted.objective - e.fitted.objective;
    let (mut shares, mut compared, mut causes) = (vec![], vec![e.clone()], vec![]);
    for switch in &parts.switches {
        let Some(job) = without(baseline, point, e, switch) else { continue };
        let variant = job.variant.clone();
        let Some(fitted) = scheduler.fit(STAGE, vec![job])?.pop().flatten() else { continue };
        if let Some(cause) = switch.cause.filter(|c| *c != e.cause() && Some(*c) != e.second_cause()) {
            causes.push((cause, switch.neutral.len()));
            compared.push(FittedHypothesis::new(variant, fitted.clone()));
        }
        let share = (fitted.objective - e.fitted.objective) / gain;
        if share.is_finite() {
            shares.push((switch.phenomenon, share.clamp(0.0, 1.0)));
        }
    }
    shares.sort_by(|a, b| b.1.total_cmp(&a.1));
    if !causes.is_empty() {
        scheduler.hold_out(STAGE, &mut compared)?;
    }
    let with = compared[0].held_out.clone();
    let of = |((cause, parameters), e): ((&'static str, usize), &FittedHypothesis)| {
        Some(PhenomenonOnBlocks { cause, parameters, with: with.clone()?, without: e.held_out.clone()? })
    };
    let of_other_causes = causes.into_iter().zip(&compared[1..]).filter_map(of).collect();
    Ok(Some(PhenomenonShares { shares, basis: parts.basis, of_other_causes }))
}

/// A search without a phenomenon, from the optimum of a hypothesis.
fn without(baseline: &FittedHypothesis, point: &InsertionPoint, e: &FittedHypothesis, switch: &Switch) -> Option<Job> {
    let proposal = e.variant.proposal.as_ref()?.without(switch);
    let variant: Variant = baseline.variant.with_proposal(point, &proposal)?;
    let kept = |name: &str| switch.neutral.iter().all(|(neutral, _)| neutral != name);
    let names = e.variant.study.space.free().map(|(index, _)| &e.variant.study.space.parameters[index].name);
    let start = names.zip(&e.fitted.point).filter(|(name, _)| kept(name)).map(|(_, x)| *x).collect();
    Some(Job::search(&Arc::new(variant), start, SECOND_ROUND_ITERATIONS))
}

impl PhenomenonShares {
    /// The shares in words; empty if nothing could be switched off.
    pub(crate) fn description(&self) -> String {
        if self.shares.is_empty() {
            return format!(" The law in the place of yours has {}.", self.basis);
        }
        let share = |(name, share): &(&str, f64)| format!("{:.0} % without its {name}", 100.0 * share);
        let shares: Vec<String> = self.shares.iter().map(share).collect();
        format!(
            " Of what the law in the place of yours gains, the fit loses {}; the rest is its basis, {}.",
            shares.join(", "),
            self.basis
        )
    }
}

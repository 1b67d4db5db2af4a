//! Everything that the verdict weighs, as it stands in `diagnosis.json`.
//!
//! The map from these numbers to probabilities is fitted to cases with a known truth. Each diagnosis therefore writes them
//! down, whether or not the map uses them today.

use super::holdout::HeldOutErrors;
use super::memory_evidence::RecordedEvidence;
use super::parametric_bootstrap::BootstrapResult;
use super::ranking::prior_log_odds;
use crate::fit::fitted::FittedHypothesis;
use crate::fit::job::ChannelResiduals;
use crate::fit::search_settings::is_at_bound;
use crate::hypothesis;
use crate::inspect::response::ResponseRanges;
use crate::residual::unmodelled_structure::{UnmodelledStructure, recurring_structure, unmodelled_structure};
use crate::series::power;
use hysteron_identify::calibrate::autocorrelation_time;
use hysteron_identify::noise::innovation_variance;
use hysteron_identify::study::{Role, ScoredRun, Study};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Evidence of one diagnosis.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct VerdictEvidence {
    /// Ranked hypotheses: the best form of each cause and of each pair of causes, the most evidence first.
    pub hypotheses: Vec<HypothesisEvidence>,
    /// Structure that the user's model leaves: shares of the residual power by kind.
    pub structure_before: BTreeMap<String, f64>,
    /// Structure that the first hypothesis leaves.
    pub structure_after: BTreeMap<String, f64>,
    /// Share of the explainable misfit that the first hypothesis takes away, from 0 to 1.
    pub explained_share: f64,
    /// Mean NMSE of the user's model in the fitted runs.
    pub nmse_before: f64,
    /// Parameters of the user at a bound, as fitted.
    pub user_parameters_at_bound: usize,
    /// Number of fitted runs.
    pub fitted_runs: usize,
    /// Number of fitted channels, over all runs.
    pub channels: usize,
    /// Causes of which runs held out had refuted a repair, which was left out.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub left_out: Vec<String>,
    /// Repairs that the runs held out have judged.
    pub judged: Vec<RepairEvidence>,
    /// Limits of the probabilities of causes, by physics, bounds and channels of their repairs.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub limits: Vec<ProbabilityLimit>,
    /// What the recordings themselves say: their noise, and the kinds of memory of a device.
    #[serde(default)]
    pub recorded: RecordedEvidence,
}

/// Limit of the probability of a cause.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct ProbabilityLimit {
    /// The cause.
    pub cause: String,
    /// Largest probability; 0 for what cannot be.
    pub most: f64,
    /// What speaks against the cause, in words.
    pub reason: String,
    /// The probability that the cause loses goes to `none`.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub for_complete_model: bool,
}

impl ProbabilityLimit {
    /// A limit for a reason. What it takes goes to the other causes.
    pub(crate) fn new(cause: &str, most: f64, reason: String) -> Self {
        Self { cause: cause.into(), most, reason, for_complete_model: false }
    }
}

/// Evidence for one hypothesis.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct HypothesisEvidence {
    /// Its cause; `none` for the user's model.
    pub cause: String,
    /// Cause of its second effect.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub also: Option<String>,
    /// Log evidence from samples that it was not fitted to, without prior odds, nats.
    pub log_likelihood: f64,
    /// Log odds before the fit, nats.
    pub prior_log_odds: f64,
    /// Part of them that the recordings themselves and auxiliary channels give, nats.
    pub direct_log_odds: f64,
    /// Mean NMSE in the fitted runs.
    pub nmse: f64,
    /// Number of parameters that it adds.
    pub parameters: usize,
    /// Number of added parameters at a bound.
    pub parameters_at_bound: usize,
    /// The user's parameters at a bound.
    pub user_parameters_at_bound: usize,
    /// Share of this cause's own recordings in which the first cause gains as much over it; none if it takes no part.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub equal_gain: Option<f64>,
    /// True if its law and that of the first hypothesis look alike.
    pub looks_like_first: bool,
    /// True if a channel is at fault, not the model.
    pub channel_fault: bool,
    /// True if a channel has another factor or limit in one of several fitted runs.
    #[serde(default)]
    pub range_fault_in_one_run: bool,
    /// Share that it takes of what differs where a motion repeats; none where that is less than half, or another cause takes as
    /// much.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub repeated_share: Option<f64>,
    /// Cause of which a form at the same place is the same model.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub same_model: Option<String>,
    /// Mean NMSE on blocks of the fitted runs that were held back in turn.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub held_back: Option<f64>,
    /// Part of that error which its own past does not predict: the noise is at most that.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub unpredicted: Option<f64>,
    /// Number of independent samples of these residuals, by their autocorrelation.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub independent_samples: Option<f64>,
    /// Error on these blocks of the channel of the device whose kinds of memory compete.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub device_held_back: Option<f64>,
}

/// Errors of the runs held out before and after a repair.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct RepairEvidence {
    /// Cause of the repair.
    pub cause: String,
    /// Cause of its second effect.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub also: Option<String>,
    /// Mean NMSE; none without runs held out.
    #[serde(flatten)]
    pub errors: Option<HeldOutErrors>,
    /// Mean NMSE in the runs held out of the channel of the device whose kinds of memory compete.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub device_held_out: Option<f64>,
    /// True if its effect is a condition of one fitted run, which no run held out contains.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub of_one_run: bool,
}

/// Returns the number of coordinates at an end of the unit interval.
fn at_bound(coordinates: &[f64]) -> usize {
    coordinates.iter().filter(|p| is_at_bound(**p)).count()
}

fn by_kind(structure: &UnmodelledStructure) -> BTreeMap<String, f64> {
    structure.by_kind.iter().map(|(kind, share)| ((*kind).to_owned(), *share)).collect()
}

/// Ranked hypotheses of one diagnosis, best first, with what they were fitted to.
pub(crate) struct RankedStudy<'a> {
    pub(crate) study: &'a Study,
    pub(crate) responses: &'a ResponseRanges,
    /// The fitted user's model.
    pub(crate) baseline: &'a FittedHypothesis,
    pub(crate) ranked: &'a [FittedHypothesis],
    pub(crate) bootstrap: Option<&'a BootstrapResult>,
    /// Causes of which runs held out had refuted a repair, which was left out.
    pub(crate) left_out: &'a [&'static str],
    pub(crate) recorded: &'a RecordedEvidence,
}

impl VerdictEvidence {
    /// Evidence before any repair is judged, and the structure that the first hypothesis leaves.
    pub(crate) fn of(of: &RankedStudy<'_>) -> (Self, UnmodelledStructure) {
        let (study, ranked, first) = (of.study, of.ranked, &of.ranked[0]);
        let baseline = ranked.iter().find(|e| e.cause() == "none").unwrap_or(of.baseline);
        let before = unmodelled_structure(study, of.responses, &baseline.fitted.fits, true);
        let after = structure_left(of);
        let [nmse_before, nmse_after] = [baseline, first].map(|e| total_nmse(study, &e.fitted.fits));
        let noise = nmse_after * (1.0 - after.share);
        let explainable = nmse_before - noise;
        let fits = &first.fitted.fits;
        let evidence = Self {
            hypotheses: hypotheses(of),
            structure_before: by_kind(&before),
            structure_after: by_kind(&after),
            explained_share: if explainable > 0.0 {
                ((nmse_before - nmse_after) / explainable).clamp(0.0, 1.0)
            } else {
                1.0
            },
            nmse_before: baseline.fitted.objective,
            user_parameters_at_bound: at_bound(&baseline.fitted.point),
            fitted_runs: fits.len(),
            channels: fits.iter().map(|f| f.channels.len()).sum(),
            left_out: of.left_out.iter().map(|c| (*c).to_owned()).collect(),
            judged: vec![],
            limits: vec![],
            recorded: of.recorded.clone(),
        };
        (evidence, after)
    }

    /// Log likelihood of the user's model; -∞ if it was not ranked.
    pub(crate) fn log_likelihood_of_none(&self) -> f64 {
        self.hypotheses.iter().find(|h| h.cause == "none").map_or(f64::NEG_INFINITY, |h| h.log_likelihood)
    }
}

/// Structure that the first hypothesis leaves.
///
/// A geometric effect has no wrong form of law that could leave a residual along the stroke, so that such a residual counts.
fn structure_left(of: &RankedStudy<'_>) -> UnmodelledStructure {
    let first = &of.ranked[0];
    let fits = &first.fitted.fits;
    let mut left = unmodelled_structure(of.study, of.responses, fits, first.cause() == "none");
    if first.variant.proposal.as_ref().is_some_and(|p| p.geometric) {
        left.join(recurring_structure(of.study, of.responses, fits));
    }
    left
}

/// The best form of each cause and of each pair of causes, in the order of the ranking.
fn hypotheses(of: &RankedStudy<'_>) -> Vec<HypothesisEvidence> {
    let (ranked, bootstrap) = (of.ranked, of.bootstrap);
    let rests = has_channel_at_rest(of.baseline);
    let mut out: Vec<HypothesisEvidence> = vec![];
    for e in ranked.iter().filter(|e| e.log_evidence.is_finite()) {
        let (cause, also) = (e.cause(), e.second_cause());
        if out.iter().any(|h| (h.cause.as_str(), h.also.as_deref()) == (cause, also)) {
            continue;
        }
        let own = e.variant.own_coordinates(&e.fitted.point);
        let added = &e.fitted.point[own.len()..];
        let unread = e.variant.unread_coordinates();
        let read = own.iter().enumerate().filter(|(i, _)| !unread.contains(i)).map(|(_, x)| *x).collect::<Vec<_>>();
        let prior_log_odds = prior_log_odds(e);
        out.push(HypothesisEvidence {
            cause: cause.into(),
            also: also.map(Into::into),
            log_likelihood: e.log_evidence - prior_log_odds,
            prior_log_odds,
            direct_log_odds: e.variant.direct_log_odds(),
            nmse: e.fitted.objective,
            parameters: added.len(),
            parameters_at_bound: at_bound(added),
            user_parameters_at_bound: at_bound(&read),
            equal_gain: bootstrap.and_then(|b| b.equal_gain(cause)),
            looks_like_first: hypothesis::look_alike(ranked[0].cause(), cause),
            channel_fault: e.variant.is_channel_fault(),
            range_fault_in_one_run: e.variant.has_range_fault_in_one_run(),
            repeated_share: e.repeated_share,
            same_model: e.variant.proposal.as_ref().and_then(|p| p.same_model).filter(|_| !rests).map(Into::into),
            held_back: held_back(e),
            unpredicted: e.held_out.as_ref().and_then(unpredicted),
            independent_samples: e.held_out.as_ref().map(independent_samples),
            device_held_back: held_back_of_channel(of.study, e, &of.recorded.channel),
        });
    }
    out
}

/// Returns true if a channel shows what the user's model holds at rest, such as the rotation of a footing: it tells models apart
/// that are the same for all other channels.
fn has_channel_at_rest(baseline: &FittedHypothesis) -> bool {
    let mut channels = baseline.fitted.fits.iter().flat_map(|fit| &fit.channels);
    channels.any(|y| y.first().is_some_and(|first| y.iter().all(|value| value == first)))
}

/// Mean NMSE on blocks held back: the squares of the scaled residuals add up to it.
fn held_back(e: &FittedHypothesis) -> Option<f64> {
    Some(e.held_out.as_ref()?.iter().flatten().map(|r| r * r).sum())
}

/// Part of the error of some residuals that their own past does not predict; `None` for a channel that is too short.
pub(crate) fn unpredicted(residuals: &ChannelResiduals) -> Option<f64> {
    residuals.iter().map(|r| Some(r.len() as f64 * innovation_variance(r)?)).sum()
}

/// Number of independent samples of some residuals.
pub(crate) fn independent_samples(residuals: &ChannelResiduals) -> f64 {
    let of = |r: &&Vec<f64>| !r.is_empty();
    residuals.iter().filter(of).map(|r| r.len() as f64 / autocorrelation_time(r)).sum()
}

/// The error on blocks held back of one channel.
fn held_back_of_channel(study: &Study, e: &FittedHypothesis, channel: &str) -> Option<f64> {
    let residuals = e.held_out.as_ref()?;
    let observed = study.runs_of(Role::Fit).flat_map(|(_, r)| &r.observe);
    let own = observed.zip(residuals).filter(|(o, _)| o.channel == channel && o.weight > 0.0);
    let nmse: Vec<f64> =
        own.map(|(o, r)| residuals.len() as f64 / o.weight * r.iter().map(|x| x * x).sum::<f64>()).collect();
    (!nmse.is_empty()).then(|| nmse.iter().sum::<f64>() / nmse.len() as f64)
}

/// Sum of the NMSE of all fitted channels.
fn total_nmse(study: &Study, fits: &[ScoredRun]) -> f64 {
    let runs = study.runs.iter().filter(|r| r.role == Role::Fit);
    let channels = runs.zip(fits).flat_map(|(r, f)| r.observe.iter().zip(&f.channels));
    channels
        .map(|(o, y)| {
            let r: Vec<f64> = y.iter().zip(&o.values).map(|(y, v)| y - v).filter(|d| d.is_finite()).collect();
            power(&r) / o.variance
        })
        .sum()
}

#[cfg(test)]
mod tests {
    use super::has_channel_at_rest;
    use crate::test_support::baseline;
    use hysteron_identify::study::ScoredRun;

    #[test]
    fn a_channel_that_the_model_holds_is_at_rest() {
        let rests = |channels: &[&[f64]]| {
            let mut model = baseline();
            model.fitted.fits =
                vec![ScoredRun { channels: channels.iter().map(|y| y.to_vec()).collect(), scores: vec![] }];
            has_channel_at_rest(&model)
        };
        assert!(rests(&[&[0.0, 0.1], &[0.0, 0.0]]));
        assert!(!rests(&[&[0.0, 0.1], &[0.0, -0.2]]) && !rests(&[]) && !rests(&[&[f64::NAN, f64::NAN]]));
    }
}

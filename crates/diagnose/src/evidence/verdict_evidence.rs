//! Everything that the verdict weighs, as it stands in `diagnosis.json`.
//!
//! The map from these numbers to probabilities is fitted to cases with a known truth. Each diagnosis therefore writes them
//! down, whether or not the map uses them today.

use super::holdout::HeldOutErrors;
use super::parametric_bootstrap::BootstrapResult;
use super::probabilities::CauseProbabilities;
use crate::fit::fitted::FittedHypothesis;
use crate::fit::search_settings::BOUND_DISTANCE;
use crate::hypothesis;
use crate::residual::unmodelled_structure::UnmodelledStructure;
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
    /// Repairs that the runs held out have judged.
    pub judged: Vec<RepairEvidence>,
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
    /// Those of them at a bound.
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
}

/// Returns the number of coordinates at an end of the unit interval.
fn at_bound(coordinates: &[f64]) -> usize {
    coordinates.iter().filter(|p| **p < BOUND_DISTANCE || **p > 1.0 - BOUND_DISTANCE).count()
}

fn by_kind(structure: &UnmodelledStructure) -> BTreeMap<String, f64> {
    structure.by_kind.iter().map(|(kind, share)| ((*kind).to_owned(), *share)).collect()
}

impl VerdictEvidence {
    /// Evidence of ranked hypotheses, best first, before any repair is judged.
    ///
    /// `prior_log_odds` gives the log odds of a hypothesis before the fit.
    pub(crate) fn of(
        ranked: &[FittedHypothesis],
        causes: &CauseProbabilities,
        bootstrap: Option<&BootstrapResult>,
        prior_log_odds: impl Fn(&FittedHypothesis) -> f64,
    ) -> Self {
        let mut hypotheses: Vec<HypothesisEvidence> = vec![];
        for e in ranked {
            let (cause, also) = (e.cause(), e.second_cause());
            if hypotheses.iter().any(|h| (h.cause.as_str(), h.also.as_deref()) == (cause, also)) {
                continue;
            }
            let own = e.variant.own_coordinates(&e.fitted.point);
            let added = &e.fitted.point[own.len()..];
            let prior_log_odds = prior_log_odds(e);
            hypotheses.push(HypothesisEvidence {
                cause: cause.into(),
                also: also.map(Into::into),
                log_likelihood: e.log_evidence - prior_log_odds,
                prior_log_odds,
                direct_log_odds: e.variant.direct_log_odds(),
                nmse: e.fitted.objective,
                parameters: added.len(),
                parameters_at_bound: at_bound(added),
                user_parameters_at_bound: at_bound(own),
                equal_gain: bootstrap.and_then(|b| b.equal_gain(cause)),
                looks_like_first: hypothesis::look_alike(ranked[0].cause(), cause),
                channel_fault: e.variant.is_channel_fault(),
            });
        }
        let baseline = ranked.iter().find(|e| e.cause() == "none");
        let fits = &ranked[0].fitted.fits;
        Self {
            hypotheses,
            structure_before: by_kind(&causes.structure_before),
            structure_after: by_kind(&causes.structure),
            explained_share: causes.explained_share,
            nmse_before: baseline.map_or(f64::NAN, |e| e.fitted.objective),
            user_parameters_at_bound: baseline.map_or(0, |e| at_bound(&e.fitted.point)),
            fitted_runs: fits.len(),
            channels: fits.iter().map(|f| f.channels.len()).sum(),
            judged: vec![],
        }
    }
}

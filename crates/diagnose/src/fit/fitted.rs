//! Hypotheses after screening and after fitting.

use super::job::{ChannelResiduals, FittedModel};
use crate::candidate::variant::Variant;
use crate::prior::EFFECTIVE_SAMPLES;
use std::sync::Arc;

/// Score of a fit for sorting, the less the better: ln(objective) + (k ln N - 2 log odds) / N.
///
/// It has k parameters and N = [`EFFECTIVE_SAMPLES`]. The score times -N/2 is an approximate log evidence (Schwarz 1978).
pub(crate) fn penalised_score(objective: f64, dimension: usize, log_odds: f64) -> f64 {
    objective.ln() + (dimension as f64 * EFFECTIVE_SAMPLES.ln() - 2.0 * log_odds) / EFFECTIVE_SAMPLES
}

/// Approximate log evidence of one score over another, nats.
pub(crate) fn approximate_gain(score: f64, over: f64) -> f64 {
    0.5 * EFFECTIVE_SAMPLES * (over - score)
}

/// A hypothesis after fitting: a variant at its optimum.
#[derive(Clone)]
pub(crate) struct FittedHypothesis {
    /// The variant.
    pub(crate) variant: Arc<Variant>,
    /// Its optimum.
    pub(crate) fitted: FittedModel,
    /// Residuals of samples that it was not fitted to.
    pub(crate) held_out: Option<ChannelResiduals>,
    /// Log evidence with prior odds, nats; -∞ before it is ranked.
    pub(crate) log_evidence: f64,
    /// Share that it takes of what differs where a motion repeats; none where that is less than half, or another cause takes as
    /// much.
    pub(crate) repeated_share: Option<f64>,
}

impl FittedHypothesis {
    /// Not ranked yet.
    pub(crate) fn new(variant: Arc<Variant>, fitted: FittedModel) -> Self {
        Self { variant, fitted, held_out: None, log_evidence: f64::NEG_INFINITY, repeated_share: None }
    }

    /// Its cause; `none` for the user's model.
    pub(crate) fn cause(&self) -> &'static str {
        self.variant.cause()
    }

    /// Cause of the second of two effects.
    pub(crate) fn second_cause(&self) -> Option<&'static str> {
        self.variant.second_cause()
    }

    /// Its [`penalised_score`].
    pub(crate) fn score(&self) -> f64 {
        penalised_score(self.fitted.objective, self.variant.counted_parameters(), self.variant.direct_log_odds())
    }
}

/// Sorts by score, the best first.
pub(crate) fn sort_by_score(all: &mut [FittedHypothesis]) {
    all.sort_by(|a, b| a.score().total_cmp(&b.score()));
}

/// A hypothesis after screening.
#[derive(Clone)]
pub(crate) struct ScreenedHypothesis {
    /// The variant.
    pub(crate) variant: Arc<Variant>,
    /// Start of a search, a point of the unit cube.
    pub(crate) start: Vec<f64>,
    /// Expected objective.
    pub(crate) expected_objective: f64,
}

impl ScreenedHypothesis {
    /// Its expected [`penalised_score`].
    pub(crate) fn score(&self) -> f64 {
        penalised_score(self.expected_objective, self.variant.counted_parameters(), self.variant.direct_log_odds())
    }
}

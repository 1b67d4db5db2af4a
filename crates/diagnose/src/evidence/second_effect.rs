//! The second effect of a pair: what it gains over the first alone, and how likely it is.

use super::verdict_evidence::{HypothesisEvidence, VerdictEvidence};
use super::verdict_weights::PAIR_WEIGHTS;
use crate::prior::{MIN_TAKEN_SHARE, SECOND_EFFECT_LOG_ODDS};

/// The effects of a pair, each alone.
fn parts_alone<'a>(
    evidence: &'a VerdictEvidence,
    pair: &'a HypothesisEvidence,
) -> impl Iterator<Item = &'a HypothesisEvidence> {
    let is_part =
        |h: &&HypothesisEvidence| h.also.is_none() && (h.cause == pair.cause || Some(&h.cause) == pair.also.as_ref());
    evidence.hypotheses.iter().filter(is_part)
}

/// Gain of a pair over the better of its effects alone, nats.
pub fn pair_gain(evidence: &VerdictEvidence, pair: &HypothesisEvidence) -> f64 {
    let alone = parts_alone(evidence, pair).map(|h| h.log_likelihood).fold(f64::NEG_INFINITY, f64::max);
    (pair.log_likelihood - alone.max(evidence.log_likelihood_of_none())).clamp(0.0, 1e3)
}

/// Logarithm of the error that the better effect of a pair alone leaves on blocks held back over twice that of the pair; 0
/// where the second effect takes less than half of what the first one leaves.
fn log_error_ratio(evidence: &VerdictEvidence, pair: &HypothesisEvidence) -> f64 {
    let alone = parts_alone(evidence, pair).filter_map(|h| h.held_back).fold(f64::INFINITY, f64::min);
    let ratio = pair.held_back.map_or(1.0, |of_pair| alone / of_pair);
    let ratio = ratio * (1.0 - MIN_TAKEN_SHARE);
    if ratio.is_finite() { ratio.max(1.0).ln() } else { 0.0 }
}

/// Probability that the second effect of a pair is present if the first is: by the gain in nats, whose scale depends on how
/// the samples are counted, and by the error on blocks held back, whose scale does not.
pub(super) fn second_effect_probability(evidence: &VerdictEvidence, pair: &HypothesisEvidence) -> f64 {
    let [constant, of_gain] = PAIR_WEIGHTS;
    let of_error = SECOND_EFFECT_LOG_ODDS * log_error_ratio(evidence, pair);
    1.0 / (1.0 + (-constant - of_gain * pair_gain(evidence, pair).ln_1p() - of_error).exp())
}

/// Returns true if the second effect of a pair is more likely than not.
pub(crate) fn has_second_effect(evidence: &VerdictEvidence, cause: &str, also: &str) -> bool {
    let pair = evidence.hypotheses.iter().find(|h| h.cause == cause && h.also.as_deref() == Some(also));
    pair.is_some_and(|p| second_effect_probability(evidence, p) >= 0.5)
}

#[cfg(test)]
mod tests {
    use super::has_second_effect;
    use crate::evidence::verdict_model::tests::evidence;

    /// A pair that gains 29 nats is judged by the error that its second effect takes on blocks held back.
    #[test]
    fn a_second_effect_counts_by_the_error_that_it_takes() {
        let named = |alone: Option<f64>, pair: Option<f64>| {
            let pairs = [("self_heating", Some("mullins_softening"), 89.0), ("self_heating", None, 60.0)];
            let mut e = evidence(&pairs);
            (e.hypotheses[0].held_back, e.hypotheses[1].held_back) = (pair, alone);
            has_second_effect(&e, "self_heating", "mullins_softening")
        };
        assert!(named(Some(3.2e-4), Some(5.9e-5)));
        assert!(!named(Some(3.2e-4), Some(2.0e-4)) && !named(Some(3.2e-4), Some(4.0e-4)));
        assert!(!named(None, Some(5.9e-5)) && !named(Some(3.2e-4), None));
    }
}

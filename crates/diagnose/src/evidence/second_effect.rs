//! The second effect of a pair: what it gains over the first alone, and how likely it is.

use super::verdict_evidence::{HypothesisEvidence, VerdictEvidence, independent_samples};
use super::verdict_weights::PAIR_WEIGHTS;
use crate::fit::job::ChannelResiduals;
use crate::fit::phenomena::PhenomenonOnBlocks;
use crate::prior::{MIN_HOLDOUT_SIGNAL_RATIO, MIN_REPAIR_GAIN, MIN_TAKEN_SHARE, PREDICTED_SHARE, SECOND_EFFECT_LEAD};

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

/// Gain of a pair over the better of its effects alone by all independent samples, nats; `None` where the pair takes less than
/// half of what its first effect leaves, or neither reaches the noise nor takes nearly all, as no other second effect does.
///
/// The likelihood counts few samples, because models are roughly right and their residuals are alike for long. An effect that
/// lives in a quarter of a cycle is drowned by that. What leaves noise alone has no such residuals. A second effect that makes
/// up for the wrong form of the first leaves a third and more of it.
fn gain_on_blocks(evidence: &VerdictEvidence, pair: &HypothesisEvidence) -> Option<f64> {
    let better = parts_alone(evidence, pair).filter(|h| h.held_back.is_some());
    let better = better.min_by(|a, b| a.held_back.unwrap_or(f64::NAN).total_cmp(&b.held_back.unwrap_or(f64::NAN)))?;
    let (alone, of_pair) = (better.held_back?, pair.held_back?);
    let noise = evidence.recorded.noise.into_iter().chain(pair.unpredicted).reduce(f64::min)?;
    let takes_half = of_pair <= (1.0 - MIN_TAKEN_SHARE) * alone;
    let reaches_noise = of_pair <= MIN_HOLDOUT_SIGNAL_RATIO * noise;
    let takes_nearly_all = alone - of_pair >= PREDICTED_SHARE * (alone - noise);
    let is_present = takes_half && (reaches_noise || takes_nearly_all && leads_second_effects(evidence, pair));
    let samples = pair.independent_samples?;
    let parameters = pair.parameters.saturating_sub(better.parameters) as f64;
    is_present.then(|| 0.5 * (samples * (alone / of_pair).ln() - parameters * samples.ln()).clamp(0.0, 1e3))
}

/// Returns true if no other second effect beside the first of a pair is as likely within odds of 20.
fn leads_second_effects(evidence: &VerdictEvidence, pair: &HypothesisEvidence) -> bool {
    let is_other = |h: &&HypothesisEvidence| h.cause == pair.cause && h.also.is_some() && h.also != pair.also;
    let mut others = evidence.hypotheses.iter().filter(is_other);
    others.all(|h| h.log_likelihood <= pair.log_likelihood - SECOND_EFFECT_LEAD)
}

/// Probability that the second effect of a pair is present if the first is.
pub(super) fn second_effect_probability(evidence: &VerdictEvidence, pair: &HypothesisEvidence) -> f64 {
    let [constant, of_gain] = PAIR_WEIGHTS;
    let gain = gain_on_blocks(evidence, pair).unwrap_or(0.0).max(pair_gain(evidence, pair));
    1.0 / (1.0 + (-constant - of_gain * gain.ln_1p()).exp())
}

/// Returns true if the second effect of a pair is more likely than not.
pub(crate) fn has_second_effect(evidence: &VerdictEvidence, cause: &str, also: &str) -> bool {
    let pair = evidence.hypotheses.iter().find(|h| h.cause == cause && h.also.as_deref() == Some(also));
    pair.is_some_and(|p| second_effect_probability(evidence, p) >= 0.5)
}

/// Causes of phenomena of a law without which it predicts blocks held back clearly worse, by all independent samples: the law
/// has each in the form that tests found, so that none was sought.
pub(crate) fn causes_within_law(phenomena: &[PhenomenonOnBlocks]) -> Vec<&'static str> {
    let square = |r: &ChannelResiduals| r.iter().flatten().map(|x| x * x).sum::<f64>();
    let gain = |p: &PhenomenonOnBlocks| {
        let samples = independent_samples(&p.with);
        0.5 * (samples * (square(&p.without) / square(&p.with)).ln() - p.parameters as f64 * samples.ln())
    };
    phenomena.iter().filter(|p| gain(p) >= MIN_REPAIR_GAIN).map(|p| p.cause).collect()
}

#[cfg(test)]
mod tests {
    use super::{causes_within_law, has_second_effect};
    use crate::evidence::verdict_model::tests::evidence;
    use crate::fit::phenomena::PhenomenonOnBlocks;

    /// A pair that gains 9 nats by few samples is named where it reaches the noise, and its first effect alone does not.
    #[test]
    fn a_second_effect_counts_where_both_reach_the_noise() {
        let named = |alone: Option<f64>, pair: Option<f64>, noise: f64, samples: f64| {
            let pairs = [("self_heating", Some("mullins_softening"), 69.0), ("self_heating", None, 60.0)];
            let mut e = evidence(&pairs);
            (e.hypotheses[0].held_back, e.hypotheses[1].held_back) = (pair, alone);
            (e.hypotheses[0].unpredicted, e.hypotheses[0].independent_samples) = (Some(noise), Some(samples));
            e.hypotheses[0].parameters = 3;
            has_second_effect(&e, "self_heating", "mullins_softening")
        };
        assert!(named(Some(1.7e-4), Some(7.3e-5), 7.2e-5, 1500.0));
        // Beyond the noise the form of a law leaves as much.
        assert!(!named(Some(1.7e-4), Some(7.3e-5), 3e-5, 1500.0));
        // The form of a law leaves as much as the noise: the second effect takes less than half.
        assert!(!named(Some(1.2e-4), Some(7.3e-5), 7.2e-5, 1500.0));
        // Few independent samples say nothing.
        assert!(!named(Some(1.7e-4), Some(7.3e-5), 7.2e-5, 10.0));
        assert!(!named(None, Some(7.3e-5), 7.2e-5, 1500.0) && !named(Some(1.7e-4), None, 7.2e-5, 1500.0));
    }

    /// Far from the noise a second effect counts that takes nearly all of what the first leaves, and no other as much.
    #[test]
    fn a_second_effect_counts_that_takes_nearly_all() {
        let named = |pair: f64, rival: f64| {
            let mut e = evidence(&[
                ("friction", Some("self_heating"), 80.0),
                ("friction", Some("pinching"), rival),
                ("friction", None, 60.0),
            ]);
            (e.hypotheses[0].held_back, e.hypotheses[2].held_back) = (Some(pair), Some(1.2e-2));
            (e.hypotheses[0].unpredicted, e.hypotheses[0].independent_samples) = (Some(1e-3), Some(120.0));
            e.hypotheses[0].parameters = 5;
            has_second_effect(&e, "friction", "self_heating")
        };
        assert!(named(2.3e-3, 72.0));
        // Another form of the first effect leaves a third.
        assert!(!named(4e-3, 72.0));
        // Another second effect does the same.
        assert!(!named(2.3e-3, 79.0));
    }

    /// A phenomenon is named that predicts blocks better by more than chance.
    #[test]
    fn a_phenomenon_that_does_work_on_blocks_has_its_cause() {
        let named = |samples: usize, ratio: f64| {
            let with = crate::test_support::white_noise(5, samples);
            let without = with.iter().map(|x| x * ratio.sqrt()).collect();
            let (with, without) = (vec![with], vec![without]);
            causes_within_law(&[PhenomenonOnBlocks { cause: "cyclic_degradation", parameters: 1, with, without }])
        };
        assert_eq!(named(200, 1.25), ["cyclic_degradation"]);
        assert!(named(200, 1.02).is_empty() && named(30, 1.25).is_empty() && named(200, 0.9).is_empty());
    }
}

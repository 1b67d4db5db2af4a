//! The effect that takes most of the error away on blocks held back, where no effect is likely.

use super::condition_in_words::FittedCondition;
use super::summary::percent;
use crate::evidence::verdict_evidence::{HypothesisEvidence, VerdictEvidence};
use crate::fit::fitted::FittedHypothesis;
use crate::prior::MIN_TAKEN_SHARE;

/// That effect alone, with its place and its share of the error above the noise; `None` if none takes half of it. A fault of a
/// channel is none: it bends to anything.
pub(super) fn nearest_in_words(ranked: &[FittedHypothesis], evidence: &VerdictEvidence) -> Option<String> {
    let (nearest, share) = nearest(evidence)?;
    let of_cause = |e: &&FittedHypothesis| e.cause() == nearest.cause && e.second_cause().is_none();
    let e = ranked.iter().find(of_cause)?;
    let location = e.variant.proposal.as_ref().map_or_else(String::new, |p| p.location.clone());
    let place = FittedCondition::of(&e.variant, &e.fitted.values).map_or(location, |c| c.description());
    let share = percent(share.min(1.0));
    let cause = &nearest.cause;
    Some(format!(
        "{cause} ({place}) would take {share} of the error above the noise on blocks held back, and is not told from chance"
    ))
}

fn nearest(evidence: &VerdictEvidence) -> Option<(&HypothesisEvidence, f64)> {
    let single = |h: &&HypothesisEvidence| h.also.is_none() && !h.channel_fault;
    let known = evidence.hypotheses.iter().filter(single).filter_map(|h| Some((h, evidence.share_on_blocks(h)?)));
    known.max_by(|a, b| a.1.total_cmp(&b.1)).filter(|(_, share)| *share >= MIN_TAKEN_SHARE)
}

#[cfg(test)]
mod tests {
    use super::nearest;
    use crate::evidence::verdict_model::tests::evidence;

    /// The cause that takes away most is the nearest, if it takes half of the error above a noise of 0.001.
    #[test]
    fn the_nearest_effect_takes_half_of_the_error() {
        let found = |friction: f64, damping: f64| {
            let mut e = evidence(&[("friction", None, 3.0), ("damping", None, 2.0), ("sensor_gain", None, 1.0)]);
            e.recorded.noise = Some(1e-3);
            for h in &mut e.hypotheses {
                h.channel_fault = h.cause == "sensor_gain";
                let left = [("friction", friction), ("damping", damping), ("sensor_gain", 1e-3)];
                let own = left.iter().find(|(cause, _)| *cause == h.cause);
                h.held_back = Some(own.map_or(0.1, |(_, error)| *error));
            }
            nearest(&e).map(|(h, share)| (h.cause.clone(), (100.0 * share).round()))
        };
        assert_eq!(found(0.04, 0.02), Some(("damping".into(), 81.0)));
        assert_eq!(found(0.04, 0.09), Some(("friction".into(), 61.0)));
        assert_eq!(found(0.06, 0.09), None);
    }
}

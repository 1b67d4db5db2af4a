//! Limit of a fault of a sensor by what else would show so.

use super::verdict_evidence::{HypothesisEvidence, ProbabilityLimit, VerdictEvidence};
use crate::prior::{SENSOR_BESIDE_PHYSICS_LOG_ODDS, SENSOR_BESIDE_PHYSICS_PROBABILITY};

impl VerdictEvidence {
    /// Limit of a fault of a sensor where an effect on the structure explains as much.
    pub(super) fn limit_beside_physics(&self, h: &HypothesisEvidence) -> Option<ProbabilityLimit> {
        if !h.channel_fault {
            return None;
        }
        let log_evidence = |h: &HypothesisEvidence| h.log_likelihood + h.prior_log_odds;
        let least = log_evidence(h) - SENSOR_BESIDE_PHYSICS_LOG_ODDS;
        let is_effect = |o: &&HypothesisEvidence| o.cause != "none" && o.also.is_none() && !o.channel_fault;
        let effect = self.hypotheses.iter().filter(is_effect).find(|o| log_evidence(o) > least)?;
        let reason = format!("{} explains as much", effect.cause);
        Some(ProbabilityLimit::new(&h.cause, SENSOR_BESIDE_PHYSICS_PROBABILITY, reason))
    }
}

#[cfg(test)]
mod tests {
    use crate::evidence::verdict_model::tests::evidence;

    /// Ground that gives way by as much as a factor on a channel is not told from it. An effect far behind is.
    #[test]
    fn a_sensor_is_not_told_from_an_effect_that_explains_as_much() {
        let limit = |cause: &str, gap: f64| {
            let mut e = evidence(&[(cause, None, 60.0), ("foundation_flexibility", None, 60.0 - gap)]);
            e.hypotheses.iter_mut().for_each(|h| h.channel_fault = h.cause.starts_with("sensor_"));
            let first = e.hypotheses.iter().find(|h| h.cause == cause).expect("the first");
            e.limit_beside_physics(first).map(|l| l.most)
        };
        assert_eq!(limit("sensor_gain", 1.4), Some(0.5));
        assert_eq!((limit("sensor_gain", 5.0), limit("changed_mass", 1.4)), (None, None));
    }
}

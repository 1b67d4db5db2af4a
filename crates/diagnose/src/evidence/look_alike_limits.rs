//! Limits of a cause by what else would show so.

use super::verdict_evidence::{HypothesisEvidence, ProbabilityLimit, VerdictEvidence};
use crate::hypothesis::{changed_condition, is_sensor_fault};
use crate::prior::{NOT_TOLD_APART_PROBABILITY, SENSOR_BESIDE_PHYSICS_LOG_ODDS};

impl VerdictEvidence {
    /// Limit of a fault of a sensor where an effect on the structure explains as much, beside the same second effect. An instrument
    /// rarely changes between two runs, so that another value of a parameter in one of them leaves nothing of such a fault.
    pub(super) fn limit_beside_physics(&self, h: &HypothesisEvidence) -> Option<ProbabilityLimit> {
        if !h.channel_fault {
            return None;
        }
        let log_evidence = |h: &HypothesisEvidence| h.log_likelihood + h.prior_log_odds;
        let least = log_evidence(h) - SENSOR_BESIDE_PHYSICS_LOG_ODDS;
        let on_structure = |o: &&HypothesisEvidence| o.cause != "none" && !is_sensor_fault(&o.cause);
        let is_alike = |o: &&HypothesisEvidence| o.also.is_none() || o.also == h.also;
        let as_much = |o: &&HypothesisEvidence| on_structure(o) && is_alike(o) && log_evidence(o) > least;
        let mut effects = self.hypotheses.iter().filter(as_much);
        let first = effects.next()?;
        let changed = |o: &&HypothesisEvidence| h.range_fault_in_one_run && o.cause == changed_condition::CAUSE;
        let (effect, most) = match std::iter::once(first).chain(effects).find(changed) {
            Some(changed) => (changed, 0.0),
            None => (first, NOT_TOLD_APART_PROBABILITY),
        };
        Some(ProbabilityLimit::new(&h.cause, most, format!("{} explains as much", effect.cause)))
    }

    /// Limits of the faults of a channel in one run where another value of a parameter is the repair and explains as much.
    pub(super) fn limits_of_faults_beside(&self, repair: &HypothesisEvidence) -> Vec<ProbabilityLimit> {
        if repair.cause != changed_condition::CAUSE {
            return vec![];
        }
        let excluded = |h: &HypothesisEvidence| self.limit_beside_physics(h).filter(|limit| limit.most == 0.0);
        let alike = |h: &&HypothesisEvidence| h.also.is_none() || h.also == repair.also;
        self.hypotheses.iter().filter(alike).filter_map(excluded).collect()
    }
}

impl HypothesisEvidence {
    /// Limit of a cause whose form is, at its place, the same model as a form of another cause.
    pub(super) fn limit_of_same_model(&self) -> Option<ProbabilityLimit> {
        let other = self.same_model.as_ref()?;
        let reason = format!("{other} at the same place is the same model");
        Some(ProbabilityLimit::new(&self.cause, NOT_TOLD_APART_PROBABILITY, reason))
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

    /// A factor in one run beside a drift is no answer where another value of a parameter beside that drift explains as much.
    #[test]
    fn a_factor_in_one_run_is_another_value_of_a_parameter() {
        let drift = Some("sensor_drift");
        let mut e = evidence(&[("sensor_gain", drift, 60.0), ("changed_condition", drift, 60.0)]);
        e.hypotheses.iter_mut().for_each(|h| h.channel_fault = h.cause == "sensor_gain");
        let most = |e: &super::VerdictEvidence| e.limit_beside_physics(&e.hypotheses[0]).map(|l| l.most);
        assert_eq!(most(&e), Some(0.5));
        e.hypotheses[0].range_fault_in_one_run = true;
        assert_eq!(most(&e), Some(0.0));
        let beside = e.limits_of_faults_beside(&e.hypotheses[1]);
        assert_eq!(beside.iter().map(|l| (l.cause.as_str(), l.most)).collect::<Vec<_>>(), [("sensor_gain", 0.0)]);
        e.hypotheses[1].also = Some("sensor_lag".into());
        assert_eq!(most(&e), None);
    }

    /// A hinge at the foot of a column on the ground is soil that yields below it.
    #[test]
    fn causes_that_are_one_model_are_not_told_apart() {
        let mut e = evidence(&[("superstructure_yielding", None, 60.0)]);
        assert!(e.hypotheses[0].limit_of_same_model().is_none());
        e.hypotheses[0].same_model = Some("foundation_flexibility".into());
        let limit = e.hypotheses[0].limit_of_same_model().expect("a limit");
        assert_eq!((limit.cause.as_str(), limit.most), ("superstructure_yielding", 0.5));
        assert!(limit.reason.contains("foundation_flexibility"), "{}", limit.reason);
    }
}

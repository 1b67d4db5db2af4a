//! A repaired model: its fit, its judgement by runs held out, and the effect that they may refute.

use super::conclusion::ConclusionContext;
use super::time_of_change::TimeOfChange;
use crate::evidence::holdout::{self, HeldOutErrors, HoldoutJudgement};
use crate::evidence::verdict_evidence::{ProbabilityLimit, RepairEvidence};
use crate::fit::fitted::FittedHypothesis;
use crate::fit::job::FittedModel;
use crate::hypothesis::is_sensor_fault;
use crate::prior::MAX_SECOND_REPAIR_RATIO;
use hysteron_identify::study::ScoredRun;
use std::sync::Arc;

/// A repaired model.
pub(super) struct Repair {
    /// Hypothesis of the repair.
    pub(super) hypothesis: FittedHypothesis,
    /// Its optimum with the steps of the script.
    pub(super) fitted: FittedModel,
    /// Channels of all runs; none for a run without a result.
    pub(super) fits: Vec<Option<ScoredRun>>,
    pub(super) judgement: HoldoutJudgement,
    /// Errors of the runs held out.
    pub(super) errors: Option<HeldOutErrors>,
    /// Limits of the probability of its cause.
    pub(super) limits: Vec<ProbabilityLimit>,
    /// Times at which a parameter of the user's changed.
    pub(super) times: Vec<TimeOfChange>,
    /// The reason for a changed condition although the model lacks more, in words; empty without one.
    pub(super) told_by: String,
    /// True if its second effect has no sure name.
    pub(super) open_second: bool,
}

impl Repair {
    /// A repair that has passed its own judgement.
    pub(super) fn accepted(hypothesis: FittedHypothesis, fitted: FittedModel, fits: Vec<Option<ScoredRun>>) -> Self {
        Self {
            hypothesis,
            fitted,
            fits,
            judgement: HoldoutJudgement::Accepted,
            errors: None,
            limits: vec![],
            times: vec![],
            told_by: String::new(),
            open_second: false,
        }
    }

    /// Second cause if it has a name; none for an unknown cause.
    pub(super) fn named_second_cause(&self, verdict: &str) -> Option<&'static str> {
        self.hypothesis.second_cause().filter(|_| verdict != "unknown" && !self.open_second)
    }

    /// The second effect in words where its name is open; empty otherwise.
    pub(super) fn open_second_in_words(&self) -> String {
        match self.hypothesis.second_cause().filter(|_| self.open_second) {
            Some(second) => format!(
                " The repair has {second} beside it, because both together predict the runs held out better. Another second effect may do \
                 the same, so that it is not named."
            ),
            None => String::new(),
        }
    }

    /// Returns true if the runs held out or a gate refuse it.
    pub(super) fn is_refused(&self) -> bool {
        self.judgement.refutes() || self.limits.iter().any(|l| l.most == 0.0)
    }

    /// Its effect, or the faulty channel beside it, which bends to anything; none for the user's model.
    pub(super) fn most_flexible_effect(&self) -> Option<RefutedEffect> {
        let (e, second) = (&self.hypothesis, self.hypothesis.second_cause().filter(|c| is_sensor_fault(c)));
        let mechanism = || Some(e.variant.mechanism().to_owned()).filter(|_| e.variant.edits_script());
        match second {
            Some(cause) => Some(RefutedEffect { cause, mechanism: None }),
            None if e.cause() == "none" => None,
            None => Some(RefutedEffect { cause: e.cause(), mechanism: mechanism() }),
        }
    }

    /// Errors of the runs held out, with its causes.
    pub(super) fn evidence(&self, c: &ConclusionContext<'_>) -> RepairEvidence {
        let (cause, also) = (self.hypothesis.cause(), self.hypothesis.second_cause());
        let device_held_out = holdout::channel_nmse(c.study, &self.fits, &c.recorded.channel);
        RepairEvidence {
            cause: cause.into(),
            also: also.map(Into::into),
            errors: self.errors,
            device_held_out,
            of_one_run: self.hypothesis.variant.is_condition_of_one_run(),
        }
    }
}

/// An effect that runs held out refute.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct RefutedEffect {
    pub(super) cause: &'static str,
    /// Its mechanism; none if the cause as a whole is refuted. Ground that rocks may be right where ground that sways is not.
    mechanism: Option<String>,
}

impl RefutedEffect {
    /// Returns true for a hypothesis of this effect.
    pub(super) fn includes(&self, e: &FittedHypothesis) -> bool {
        e.cause() == self.cause && self.mechanism.as_ref().is_none_or(|m| *m == e.variant.mechanism())
    }
}

/// Returns true if two effects together leave clearly less than the first alone in the runs held out, which both must have.
pub(super) fn predicts_clearly_better(both: Option<f64>, alone: Option<f64>) -> bool {
    both.zip(alone).is_some_and(|(both, alone)| both <= MAX_SECOND_REPAIR_RATIO * alone)
}

/// Returns true if a hypothesis is a pair whose first effect alone was repaired.
pub(super) fn is_pair_of_repaired(best: &FittedHypothesis, repaired: &FittedHypothesis) -> bool {
    let is_part = best.second_cause().is_some() && best.cause() == repaired.cause();
    is_part && !Arc::ptr_eq(&best.variant, &repaired.variant)
}

#[cfg(test)]
mod tests {
    use super::{RefutedEffect, Repair, is_pair_of_repaired, predicts_clearly_better};
    use crate::candidate::proposal::Proposal;
    use crate::inspect::insertion::InsertionPoint;
    use crate::test_support::{baseline, fitted_at, script_edit};

    /// A second effect whose name is open stays in the repair, and out of the causes.
    #[test]
    fn an_open_second_effect_is_said_and_not_named() {
        let both = script_edit("friction", &["x"]).combined_with(&script_edit("damping", &["y"]));
        let variant = baseline().variant.with_proposal(&InsertionPoint::At(0), &both).expect("a variant");
        let pair = fitted_at(variant, &[0.5, 0.5]);
        let mut repair = Repair::accepted(pair.clone(), pair.fitted, vec![]);
        assert_eq!(
            (repair.named_second_cause("friction"), repair.open_second_in_words()),
            (Some("damping"), "".into())
        );
        assert_eq!(repair.named_second_cause("unknown"), None);
        repair.open_second = true;
        assert_eq!(repair.named_second_cause("friction"), None);
        assert!(repair.open_second_in_words().contains("has damping beside it"));
    }

    #[test]
    fn a_second_effect_without_a_name_predicts_clearly_better() {
        assert!(predicts_clearly_better(Some(0.03), Some(0.07)));
        assert!(!predicts_clearly_better(Some(0.06), Some(0.07)) && !predicts_clearly_better(Some(0.03), None));
    }

    #[test]
    fn the_pair_of_a_repaired_first_effect_is_its_nearest_repair() {
        let of = |proposal: &Proposal| {
            let variant = baseline().variant.with_proposal(&InsertionPoint::At(0), proposal).expect("a variant");
            fitted_at(variant, &vec![0.5; proposal.parameters.len()])
        };
        let (first, other) = (script_edit("friction", &["x"]), script_edit("damping", &["y"]));
        let (pair, alone) = (of(&first.combined_with(&other)), of(&first));
        assert!(is_pair_of_repaired(&pair, &alone));
        assert!(!is_pair_of_repaired(&pair, &pair) && !is_pair_of_repaired(&pair, &of(&other)));
        assert!(!is_pair_of_repaired(&alone, &of(&first)));
    }

    /// A refuted mechanism leaves the others of its cause in the search, a refuted cause none of them.
    #[test]
    fn a_refuted_effect_is_a_mechanism_of_its_cause() {
        let with = |parameter: &str| {
            let proposal = script_edit("foundation_flexibility", &[parameter]);
            fitted_at(baseline().variant.with_proposal(&InsertionPoint::At(0), &proposal).expect("a variant"), &[0.5])
        };
        let (sways, rocks) = (with("sway"), with("rocking_yield"));
        let mechanism = Some(sways.variant.mechanism().to_owned());
        let refuted = RefutedEffect { cause: "foundation_flexibility", mechanism };
        assert!(refuted.includes(&sways) && !refuted.includes(&rocks));
        let whole = RefutedEffect { mechanism: None, ..refuted };
        assert!(whole.includes(&sways) && whole.includes(&rocks) && !whole.includes(&baseline()));
    }
}

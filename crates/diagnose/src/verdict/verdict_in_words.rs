//! The verdict with its explanation, its probabilities and the other possible causes.

use super::conclusion::{ConclusionContext, JudgedVerdict, Ranking, remaining_share};
use super::explanation::{explanation, unsteady_in_words};
use super::result_file::{Candidate, Verdict};
use super::summary::Summary;
use crate::evidence::ranking::equal_forms;
use crate::evidence::verdict_evidence::{ProbabilityLimit, VerdictEvidence};
use crate::evidence::verdict_model::{bayes_probabilities, effect_probabilities};
use crate::fit::fitted::FittedHypothesis;
use crate::prior::MIN_REPORTED_PROBABILITY;
use crate::residual::unmodelled_structure::UnmodelledStructure;
use hysteron_identify::calibrate::Uncertainty;
use std::sync::Arc;

/// Verdict with its explanation and the other possible causes.
pub(super) fn verdict_in_words(
    c: &ConclusionContext<'_>,
    ranking: &Ranking<'_>,
    structure: &UnmodelledStructure,
    evidence: &VerdictEvidence,
    verdict: &JudgedVerdict,
    uncertainty: Option<&Uncertainty>,
) -> Verdict {
    let (cause, repair) = (verdict.cause, &verdict.repair);
    let Ranking { baseline, ranked, bootstrap, left_out } = ranking;
    let hypothesis = &repair.hypothesis;
    let second_causes: Vec<&str> = repair.named_second_cause(cause).into_iter().collect();
    let share = remaining_share(baseline, repair);
    let judgement = uncertainty.map(|u| &u.judgement);
    let mut text = explanation(cause, hypothesis, &second_causes, &structure.description, share, judgement);
    if let ("none", [_, ..]) = (cause, &structure.unsteady_channels[..]) {
        text += &format!(" {}", unsteady_in_words(&structure.unsteady_channels));
    }
    text += &c.step_error.description();
    if let Some(b) = bootstrap.as_ref().filter(|b| b.cause == cause) {
        text += &b.description();
    }
    let other_form =
        |e: &&FittedHypothesis| equal_forms(e, hypothesis) && !Arc::ptr_eq(&e.variant, &hypothesis.variant);
    if let Some(p) = ranked.iter().find(other_form).and_then(|e| e.variant.proposal.as_ref()) {
        text += &format!(" Another form explains as much: {}, {}.", p.location, p.form);
    }
    if let Some(memory) = evidence.memory_sentence().filter(|_| cause == "unknown") {
        text += &format!(" What the recordings remember: {memory}.");
    }
    if !c.causes_without_clock.is_empty() {
        text += &format!(
            " The times of the recordings count samples: {} need a clock and were left out (--clock takes them for seconds).",
            c.causes_without_clock.join(" and ")
        );
    }
    if let Some(material) = c.study.material.filter(|_| !c.causes_of_other_materials.is_empty()) {
        let causes = c.causes_of_other_materials.join(" and ");
        text += &format!(" Devices of {} have no {causes}, which were left out.", material.name());
    }
    if c.global_search_too_long {
        text += " The fitted model leaves much, and the fitted runs are too long to search for every effect far from its values: fewer of them, or \
                 fewer samples, may tell more.";
    }
    if cause == hypothesis.cause() {
        text += &repair.told_by;
    }
    text += &repair.open_second_in_words();
    text += &repair.judgement.description();
    if !left_out.is_empty() {
        text += &format!(
            " The runs held out refuted {} before, so that the search began again without that repair.",
            left_out.join(" and ")
        );
    }
    if let Some(nearest) = verdict.refused {
        text += &format!(" No repair is written: the nearest, {nearest}, is refused.");
    }
    // A search that began again judges a cause a second time.
    let said_before = |i: usize, l: &ProbabilityLimit| {
        evidence.limits[..i].iter().any(|e| e.cause == l.cause && e.reason == l.reason)
    };
    for (_, l) in evidence.limits.iter().enumerate().filter(|(i, l)| !said_before(*i, l)) {
        let much = if l.most > 0.0 { format!(" has at most {:.0} %", 100.0 * l.most) } else { " is no answer".into() };
        let subject = match l.cause.as_str() {
            "none" => "A complete model (none)".to_owned(),
            "unknown" => "An effect outside the library (unknown)".to_owned(),
            cause => format!("The cause {cause}"),
        };
        text += &format!(" {subject}{much}: {}.", l.reason);
    }
    let candidate = |(cause, p): &(&str, f64)| Candidate { cause: (*cause).into(), confidence: *p };
    let bayes = bayes_probabilities(evidence).first().map_or(("none", 1.0), |first| *first);
    if bayes.0 != cause {
        text += &format!(
            " Bayes' rule with the log evidences alone, which takes one of the fitted hypotheses for true, would say {} ({:.1} %).",
            bayes.0,
            100.0 * bayes.1
        );
    }
    let effects = effect_probabilities(evidence, &verdict.probabilities);
    let others = verdict.probabilities.iter().skip(1).filter(|(_, p)| *p > MIN_REPORTED_PROBABILITY);
    Verdict {
        cause: cause.into(),
        confidence: verdict.probabilities[0].1,
        also: second_causes.iter().map(|a| (*a).to_owned()).collect(),
        also_possible: others.map(candidate).collect(),
        effects: effects.iter().filter(|(_, p)| *p > MIN_REPORTED_PROBABILITY).map(candidate).collect(),
        bayes: candidate(&bayes),
        explanation: text,
        summary: Summary::default(),
    }
}

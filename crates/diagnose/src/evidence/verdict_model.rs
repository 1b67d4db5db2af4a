//! From evidence to probabilities: a multinomial logistic model that is fitted to cases with a known truth.
//!
//! Candidates of a case are the causes with a fitted hypothesis, `none` and `unknown`. Candidate i has features xᵢ and the
//! probability exp(w·xᵢ) / Σⱼ exp(w·xⱼ) (conditional logit, McFadden 1974). The weights w stand in `verdict_weights.rs`. The
//! example `fit_verdict` of this crate makes that file.
//!
//! Features have scales of the order of one. Log likelihoods are those of held-out samples, nats.

use super::likelihood::normalised_probabilities;
pub use super::second_effect::pair_gain;
use super::second_effect::second_effect_probability;
use super::verdict_evidence::{HypothesisEvidence, VerdictEvidence};
use super::verdict_weights::{PAIR_WEIGHTS, WEIGHTS};
use crate::hypothesis;
use crate::prior::{LAPSE_SHARE, MIN_HOLDOUT_SIGNAL_RATIO};
use std::collections::BTreeMap;

/// Number of features.
pub const FEATURE_COUNT: usize = 12;

/// Names of the features, in their order. Others, such as shares of the bootstrap and kinds of structure by their own, were
/// tried: they make the probabilities of authors that the fit has not seen worse.
pub const FEATURES: [&str; FEATURE_COUNT] = [
    // of a named cause
    "named",
    "gain",
    "ln_gap",
    "ln_gap_of_look_alike",
    "at_bound",
    "auxiliary",
    "coincidence",
    "predicted",
    // of `none`
    "none_first",
    // of `unknown`
    "unknown_structure_unexplained",
    "unknown_structure_without_cause",
    "unknown_motion",
];

/// Names of what the log odds of a second effect depend on.
const PAIR_FEATURES: [&str; 2] = ["second_effect", "second_effect_gain"];

/// Largest gap that counts, nats.
const MAX_GAP: f64 = 30.0;
/// Log odds from which a hypothesis is visible in the recording itself, nats; auxiliary channels give less.
const MIN_VISIBLE_LOG_ODDS: f64 = 10.0;
/// Scale of log odds from auxiliary channels, nats.
const AUXILIARY_SCALE: f64 = 4.0;
/// Prior log odds below which a fault in one of several runs is a coincidence, beside those of pairs, nats.
const COINCIDENCE_LOG_ODDS: f64 = -7.0;
/// Largest structured share of a residual that counts.
const MAX_STRUCTURE: f64 = 0.9;

/// A candidate with its features.
#[derive(Clone, Debug)]
pub struct CandidateFeatures {
    /// The cause, `none` or `unknown`.
    pub cause: String,
    /// Features in the order of [`FEATURES`].
    pub x: [f64; FEATURE_COUNT],
}

/// Features under construction, by name.
struct Features(BTreeMap<&'static str, f64>);

impl Features {
    fn of(values: &[(&'static str, f64)]) -> Self {
        Self(values.iter().copied().collect())
    }

    fn candidate(&self, cause: &str) -> CandidateFeatures {
        CandidateFeatures { cause: cause.into(), x: FEATURES.map(|name| self.0.get(name).copied().unwrap_or(0.0)) }
    }
}

/// 1 for true, 0 for false.
fn flag(condition: bool) -> f64 {
    f64::from(u8::from(condition))
}

/// -2 ln(1 - s) of the largest structured share s.
fn structure(shares: &BTreeMap<String, f64>) -> f64 {
    let largest = shares.values().fold(0.0f64, |m, s| m.max(*s));
    -2.0 * (1.0 - largest.min(MAX_STRUCTURE)).ln()
}

/// Evidence of a case, with what all its candidates refer to.
struct Case<'a> {
    evidence: &'a VerdictEvidence,
    /// Log likelihood of the user's model.
    of_none: f64,
    /// Largest log likelihood of a cause.
    best: f64,
}

/// Returns the best hypothesis of each cause, in the order of the evidence.
fn best_of_causes(evidence: &VerdictEvidence) -> Vec<&HypothesisEvidence> {
    let mut best: Vec<&HypothesisEvidence> = vec![];
    for h in evidence.hypotheses.iter().filter(|h| h.cause != "none") {
        if best.iter().all(|known| known.cause != h.cause) {
            best.push(h);
        }
    }
    best
}

/// Candidates of a case with their features; `none` and `unknown` come last.
pub fn candidates(evidence: &VerdictEvidence) -> Vec<CandidateFeatures> {
    let named = best_of_causes(evidence);
    let of_none =
        evidence.hypotheses.iter().find(|h| h.cause == "none").map_or(f64::NEG_INFINITY, |h| h.log_likelihood);
    let best = named.iter().map(|h| h.log_likelihood).fold(f64::NEG_INFINITY, f64::max);
    let case = Case { evidence, of_none, best };
    let mut all: Vec<CandidateFeatures> = named.iter().map(|h| case.named(h)).collect();
    all.extend([case.none(), case.unknown()]);
    all
}

impl Case<'_> {
    /// Gain of the best cause over the user's model, nats.
    fn gain(&self) -> f64 {
        if self.best.is_finite() { (self.best - self.of_none).min(1e3) } else { 0.0 }
    }

    /// Share of the reducible held-out error that the repair of a cause removes, from -1 to 1; none without a judgement.
    fn judged(&self, cause: &str) -> Option<f64> {
        let errors = self.evidence.judged.iter().find(|r| r.cause == cause)?.errors?;
        let before = errors.before?;
        let Some(after) = errors.after else { return Some(-1.0) };
        let judges = before > MIN_HOLDOUT_SIGNAL_RATIO * errors.noise;
        Some(if judges { ((before - after) / (before - errors.noise)).clamp(-1.0, 1.0) } else { 0.0 })
    }

    fn named(&self, h: &HypothesisEvidence) -> CandidateFeatures {
        let gain = (h.log_likelihood - self.of_none).min(1e3);
        let gap = (self.best - h.log_likelihood).clamp(0.0, MAX_GAP);
        let visible = h.direct_log_odds > MIN_VISIBLE_LOG_ODDS;
        let coincidence = h.prior_log_odds - h.direct_log_odds < COINCIDENCE_LOG_ODDS;
        let removed = self.judged(&h.cause).unwrap_or(0.0);
        Features::of(&[
            ("named", 1.0),
            ("gain", gain.max(0.0).ln_1p()),
            ("ln_gap", gap.ln_1p()),
            ("ln_gap_of_look_alike", if h.looks_like_first { gap.ln_1p() } else { 0.0 }),
            ("at_bound", flag(h.parameters_at_bound > 0)),
            ("auxiliary", if visible { 0.0 } else { h.direct_log_odds / AUXILIARY_SCALE }),
            ("coincidence", flag(coincidence)),
            ("predicted", if visible { 0.0 } else { removed }),
        ])
        .candidate(&h.cause)
    }

    fn none(&self) -> CandidateFeatures {
        Features::of(&[("none_first", flag(self.gain() <= 0.0))]).candidate("none")
    }

    fn unknown(&self) -> CandidateFeatures {
        let e = self.evidence;
        let named = e.hypotheses.first().is_some_and(|h| h.cause != "none");
        let unexplained = structure(&e.structure_after) * (1.0 - e.explained_share);
        let motion = e.structure_after.get("motion").copied().unwrap_or(0.0);
        Features::of(&[
            ("unknown_structure_unexplained", if named { unexplained } else { 0.0 }),
            ("unknown_structure_without_cause", if named { 0.0 } else { structure(&e.structure_before) }),
            ("unknown_motion", motion),
        ])
        .candidate("unknown")
    }
}

/// Probabilities of candidates under weights in the order of [`FEATURES`].
pub fn probabilities(candidates: &[CandidateFeatures], weights: &[f64; FEATURE_COUNT]) -> Vec<f64> {
    let score = |c: &CandidateFeatures| c.x.iter().zip(weights).map(|(x, w)| x * w).sum::<f64>();
    normalised_probabilities(&candidates.iter().map(score).collect::<Vec<_>>())
}

/// The fitted weights in the order of [`FEATURES`].
fn fitted_weights() -> [f64; FEATURE_COUNT] {
    FEATURES.map(|name| WEIGHTS.iter().find(|(n, _)| *n == name).map_or(0.0, |(_, w)| *w))
}

/// The fitted weights by feature.
pub(crate) fn weights() -> BTreeMap<&'static str, f64> {
    FEATURES.into_iter().zip(fitted_weights()).chain(PAIR_FEATURES.into_iter().zip(PAIR_WEIGHTS)).collect()
}

/// Probabilities of the causes, of `none` and of `unknown`, the most probable first.
pub(crate) fn cause_probabilities(evidence: &VerdictEvidence) -> CauseProbabilities {
    let all = candidates(evidence);
    let equal = LAPSE_SHARE / all.len() as f64;
    let p = probabilities(&all, &fitted_weights());
    let cost = |cause: &str| if cause == "none" { 0.0 } else { evidence.distance_cost(cause) };
    let further = |cause: &str| evidence.memory_log_odds(cause) - cost(cause);
    let by_memory: Vec<f64> = all.iter().zip(p).map(|(c, p)| p * further(&c.cause).exp()).collect();
    let sum: f64 = by_memory.iter().sum();
    let p = by_memory.into_iter().map(|p| (1.0 - LAPSE_SHARE) * p / sum + equal);
    let mut all: CauseProbabilities = all.iter().map(|c| known_cause(&c.cause)).zip(p).collect();
    refute_complete_model(evidence, equal, &mut all);
    favour_complete_model(evidence, &mut all);
    limit_probabilities(evidence, &mut all);
    sorted(all)
}

/// Gives to `unknown` what a complete model loses for its distance from the best cause: that something is missing says nothing
/// of whether it is in the library. `least` stays.
fn refute_complete_model(evidence: &VerdictEvidence, least: f64, all: &mut CauseProbabilities) {
    let kept = (-evidence.distance_cost("none")).exp();
    let Some(none) = all.iter_mut().find(|(cause, _)| *cause == "none") else { return };
    let lost = (1.0 - kept) * (none.1 - least).max(0.0);
    none.1 -= lost;
    if let Some(unknown) = all.iter_mut().find(|(cause, _)| *cause == "unknown") {
        unknown.1 += lost;
    }
}

/// Gives to `none` what the limits that speak for a complete model take from the causes.
fn favour_complete_model(evidence: &VerdictEvidence, all: &mut CauseProbabilities) {
    let mut taken = 0.0;
    for l in evidence.limits.iter().filter(|l| l.for_complete_model) {
        for (_, p) in all.iter_mut().filter(|(cause, p)| *cause == l.cause && *p > l.most) {
            taken += *p - l.most;
            *p = l.most;
        }
    }
    if let Some(none) = all.iter_mut().find(|(cause, _)| *cause == "none") {
        none.1 += taken;
    }
}

/// Keeps probabilities within their limits. What a limit takes from a cause goes to the others in proportion, and to
/// `unknown` where none is left.
fn limit_probabilities(evidence: &VerdictEvidence, all: &mut CauseProbabilities) {
    let most = |cause: &str| {
        let of_cause = evidence.limits.iter().filter(|l| l.cause == cause);
        of_cause.map(|l| l.most).fold(1.0, f64::min)
    };
    let mut is_held = vec![false; all.len()];
    // What the others get may take them to limits of their own.
    for _ in 0..all.len() {
        let exceeds = |i: &usize| !is_held[*i] && all[*i].1 > most(all[*i].0);
        let beyond: Vec<usize> = (0..all.len()).filter(exceeds).collect();
        if beyond.is_empty() {
            break;
        }
        beyond.iter().for_each(|i| is_held[*i] = true);
        let sum =
            |held: bool, of: &dyn Fn(usize) -> f64| (0..all.len()).filter(|i| is_held[*i] == held).map(of).sum::<f64>();
        let (held, free) = (sum(true, &|i| most(all[i].0)), sum(false, &|i| all[i].1));
        // Where the device remembers what no cause of the library does, no other cause gains by it.
        let scale = if evidence.memory_is_outside_library() {
            1.0
        } else if free > 0.0 {
            (1.0 - held).max(0.0) / free
        } else {
            0.0
        };
        for (x, held) in all.iter_mut().zip(&is_held) {
            x.1 = if *held { most(x.0) } else { x.1 * scale };
        }
    }
    let rest = 1.0 - all.iter().map(|(_, p)| p).sum::<f64>();
    if let Some(unknown) = all.iter_mut().find(|(cause, _)| *cause == "unknown") {
        unknown.1 += rest.max(0.0);
    }
}

/// Probabilities of the causes and of `none` by Bayes' rule from log evidences alone, the most probable first.
///
/// The log evidence is Schwarz' approximation of Laplace's, with the prior odds. It takes one of the hypotheses for true.
pub(crate) fn bayes_probabilities(evidence: &VerdictEvidence) -> CauseProbabilities {
    let none = evidence.hypotheses.iter().filter(|h| h.cause == "none");
    let all: Vec<&HypothesisEvidence> = best_of_causes(evidence).into_iter().chain(none).collect();
    let log_evidence: Vec<f64> = all.iter().map(|h| h.log_likelihood + h.prior_log_odds).collect();
    sorted(all.iter().map(|h| known_cause(&h.cause)).zip(normalised_probabilities(&log_evidence)).collect())
}

/// Probability that each effect is present, alone or beside another, the most probable first.
///
/// `causes` are the probabilities of the first effects. The second effect of a pair is present with a probability of its own.
pub(crate) fn effect_probabilities(evidence: &VerdictEvidence, causes: &CauseProbabilities) -> CauseProbabilities {
    let mut present: BTreeMap<&'static str, f64> = BTreeMap::new();
    for h in best_of_causes(evidence) {
        let cause = known_cause(&h.cause);
        let p = causes.iter().find(|(c, _)| *c == cause).map_or(0.0, |(_, p)| *p);
        *present.entry(cause).or_default() += p;
        if let Some(also) = &h.also {
            *present.entry(known_cause(also)).or_default() += p * second_effect_probability(evidence, h);
        }
    }
    sorted(present.into_iter().map(|(cause, p)| (cause, p.min(1.0))).collect())
}

/// Causes with a probability each.
pub(crate) type CauseProbabilities = Vec<(&'static str, f64)>;

fn sorted(mut all: CauseProbabilities) -> CauseProbabilities {
    all.sort_by(|a, b| b.1.total_cmp(&a.1));
    all
}

/// The static name of a cause, of `none` or of `unknown`.
fn known_cause(name: &str) -> &'static str {
    match hypothesis::of(name) {
        Some(h) => h.cause,
        None if name == "none" => "none",
        None => "unknown",
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::{FEATURES, bayes_probabilities, candidates, cause_probabilities, effect_probabilities, pair_gain};
    use crate::evidence::holdout::HeldOutErrors;
    use crate::evidence::memory_evidence::RecordedEvidence;
    use crate::evidence::verdict_evidence::{HypothesisEvidence, ProbabilityLimit, RepairEvidence, VerdictEvidence};

    pub(crate) fn hypothesis(cause: &str, also: Option<&str>, log_likelihood: f64) -> HypothesisEvidence {
        HypothesisEvidence {
            cause: cause.into(),
            also: also.map(Into::into),
            log_likelihood,
            prior_log_odds: 0.0,
            direct_log_odds: 0.0,
            nmse: 1e-3,
            parameters: 2,
            parameters_at_bound: 0,
            user_parameters_at_bound: 0,
            equal_gain: None,
            looks_like_first: false,
            channel_fault: cause.starts_with("sensor_"),
            range_fault_in_one_run: false,
            repeated_share: None,
            same_model: None,
            held_back: None,
            unpredicted: None,
            independent_samples: None,
            device_held_back: None,
        }
    }

    /// Evidence of causes by their gain over a model that leaves ten per cent.
    pub(crate) fn evidence(gains: &[(&str, Option<&str>, f64)]) -> VerdictEvidence {
        let mut hypotheses: Vec<HypothesisEvidence> =
            gains.iter().map(|(cause, also, gain)| hypothesis(cause, *also, 100.0 + gain)).collect();
        hypotheses.push(HypothesisEvidence { nmse: 0.1, ..hypothesis("none", None, 100.0) });
        VerdictEvidence {
            hypotheses,
            structure_before: [("motion".to_owned(), 0.6)].into(),
            structure_after: [].into(),
            explained_share: 1.0,
            nmse_before: 0.1,
            user_parameters_at_bound: 0,
            fitted_runs: 1,
            channels: 1,
            left_out: vec![],
            judged: vec![],
            limits: vec![],
            recorded: RecordedEvidence::default(),
        }
    }

    fn probability(of: &[(&'static str, f64)], cause: &str) -> f64 {
        of.iter().find(|(c, _)| *c == cause).map_or(0.0, |(_, p)| *p)
    }

    #[test]
    fn a_large_gain_names_a_cause() {
        let p = cause_probabilities(&evidence(&[("friction", None, 60.0), ("damping", None, 10.0)]));
        assert!(p[0].0 == "friction" && p[0].1 > 0.6, "{p:?}");
        assert!((p.iter().map(|(_, p)| p).sum::<f64>() - 1.0).abs() < 1e-12);
    }

    /// Runs held out that get better raise the probability of a repair, and runs that do not lower it beside them.
    #[test]
    fn runs_held_out_weigh() {
        let judged = |after: f64| {
            let mut e = evidence(&[("friction", None, 20.0), ("damping", None, 15.0)]);
            let errors = HeldOutErrors { before: Some(0.1), after: Some(after), noise: 1e-3 };
            e.judged.push(RepairEvidence {
                cause: "friction".into(),
                also: None,
                errors: Some(errors),
                device_held_out: None,
                of_one_run: false,
            });
            probability(&cause_probabilities(&e), "friction")
        };
        let before = probability(
            &cause_probabilities(&evidence(&[("friction", None, 20.0), ("damping", None, 15.0)])),
            "friction",
        );
        assert!(judged(1e-3) > before && before > judged(0.15), "{} {before} {}", judged(1e-3), judged(0.15));
    }

    /// A cause that cannot be is none, and one with a limit stays within it; the others share what it loses.
    #[test]
    fn limits_hold() {
        let mut e = evidence(&[("friction", None, 60.0), ("damping", None, 50.0)]);
        let before = cause_probabilities(&e);
        let limit = |most: f64| ProbabilityLimit::new("friction", most, String::new());
        e.limits = vec![limit(0.5)];
        let half = cause_probabilities(&e);
        assert_eq!(probability(&half, "friction"), 0.5);
        let ratio = |p: &[(&'static str, f64)]| probability(p, "damping") / probability(p, "unknown");
        assert!((ratio(&half) / ratio(&before) - 1.0).abs() < 1e-9);
        e.limits.push(limit(0.0));
        let none = cause_probabilities(&e);
        assert!(
            probability(&none, "friction") == 0.0 && (ratio(&none) / ratio(&before) - 1.0).abs() < 1e-9,
            "{none:?}"
        );
        assert!((none.iter().map(|(_, p)| p).sum::<f64>() - 1.0).abs() < 1e-12);
        e.limits = vec![limit(1.0)];
        assert_eq!(cause_probabilities(&e), before);
    }

    /// Structure that a complete model leaves speaks for `unknown`, and none of it for `none`.
    #[test]
    fn structure_without_a_cause_is_unknown() {
        let of = |share: f64| {
            let mut e = evidence(&[("friction", None, -2.0)]);
            e.hypotheses.rotate_right(1);
            for structure in [&mut e.structure_before, &mut e.structure_after] {
                *structure = [("bursts".to_owned(), share)].into();
            }
            cause_probabilities(&e)
        };
        assert_eq!(of(0.0)[0].0, "none");
        assert!(probability(&of(0.9), "unknown") > probability(&of(0.0), "unknown"));
        assert_eq!(of(0.9)[0].0, "unknown");
    }

    #[test]
    fn effects_are_summed_over_pairs() {
        let e =
            evidence(&[("friction", Some("gap_impact"), 80.0), ("friction", None, 50.0), ("gap_impact", None, 5.0)]);
        assert_eq!(pair_gain(&e, &e.hypotheses[0]), 30.0);
        let causes = cause_probabilities(&e);
        let effects = effect_probabilities(&e, &causes);
        let (alone, present) = (probability(&causes, "gap_impact"), probability(&effects, "gap_impact"));
        assert!(present > alone && present <= 1.0, "{causes:?} {effects:?}");
    }

    #[test]
    fn bayes_rule_knows_no_unknown() {
        let p = bayes_probabilities(&evidence(&[("friction", None, 3.0)]));
        assert_eq!(p.iter().map(|(c, _)| *c).collect::<Vec<_>>(), ["friction", "none"]);
        assert!((p[0].1 - 1.0 / (1.0 + (-3.0f64).exp())).abs() < 1e-12);
    }

    #[test]
    fn every_feature_has_a_name_of_its_own() {
        let mut names = FEATURES.to_vec();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), FEATURES.len());
        let all = candidates(&evidence(&[("friction", None, 3.0)]));
        assert_eq!(all.iter().map(|c| c.cause.as_str()).collect::<Vec<_>>(), ["friction", "none", "unknown"]);
        assert!(all.iter().flat_map(|c| c.x).all(f64::is_finite));
    }
}

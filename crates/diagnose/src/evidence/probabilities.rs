//! Probabilities of the causes, of a complete model (`none`) and of a cause outside the library (`unknown`).

use super::likelihood::normalised_probabilities;
use super::parametric_bootstrap::BootstrapResult;
use crate::fit::fitted::FittedHypothesis;
use crate::hypothesis;
use crate::inspect::response::ResponseRanges;
use crate::prior::{
    EFFECTIVE_SAMPLES, EXPLAINED_SHARE_COST, LOOK_ALIKE_DOUBT_PART, LOOK_ALIKE_POWER, MAX_STRUCTURED_SHARE,
    MIN_BOOTSTRAP_LEAD, MIN_COUNTED_GAIN, MIN_EXPLAINED_SHARE, MIN_GAIN_COUNTING_PART, NAMED_ERROR_SHARE,
    STRUCTURED_ERROR_SHARE, UNKNOWN_OVER_NAMED_COST, UNKNOWN_OVER_NOISE_COST, UNNAMED_ERROR_SHARE,
};
use crate::residual::unmodelled_structure::{UnmodelledStructure, recurring_structure, unmodelled_structure};
use crate::series::power;
use hysteron_identify::study::{Role, ScoredRun, Study};

/// Causes with a number each, log evidence in nats or probability.
pub(crate) type CauseValues = Vec<(&'static str, f64)>;

/// Probabilities of causes, with the structure that the best hypothesis leaves.
pub(crate) struct CauseProbabilities {
    /// Causes, `none` and `unknown`, the most probable first.
    pub(crate) probabilities: CauseValues,
    /// Structure that the best hypothesis leaves.
    pub(crate) structure: UnmodelledStructure,
    /// Structure that the user's model leaves.
    pub(crate) structure_before: UnmodelledStructure,
    /// Share of the explainable misfit that the best hypothesis takes away.
    pub(crate) explained_share: f64,
    /// Log evidence of the user's model, nats; -∞ if it was not ranked.
    pub(crate) log_evidence_of_none: f64,
}

/// Returns true if a cause is in the library: neither `none` nor `unknown`.
fn is_named(cause: &str) -> bool {
    !matches!(cause, "none" | "unknown")
}

/// Best hypothesis as it bears on `unknown`.
#[derive(Clone, Copy, Debug)]
struct BestFit {
    /// Its log evidence, nats.
    log_evidence: f64,
    /// Log evidence of the user's model, nats.
    log_evidence_of_none: f64,
    /// True if it has a cause of the library.
    named: bool,
    /// Structured share of its residual.
    structured_share: f64,
    /// Explained share of the explainable misfit.
    explained_share: f64,
}

impl BestFit {
    /// Log evidence of a cause outside the library, nats.
    fn log_evidence_of_unknown(&self) -> f64 {
        let cost = if self.named { self.cost_over_named() } else { UNKNOWN_OVER_NOISE_COST };
        self.log_evidence.max(self.log_evidence_of_none) + structure_log_evidence(self.structured_share, cost)
    }

    /// Cost of `unknown` against a named cause. It rises with the explained share and with the gain. The gain of a law that explains
    /// little counts nothing, because the law may bend to a foreign effect.
    fn cost_over_named(&self) -> f64 {
        let gain = self.log_evidence - self.log_evidence_of_none;
        let part = self.explained_share / MIN_EXPLAINED_SHARE;
        let gain_weight = ((part - MIN_GAIN_COUNTING_PART) / (1.0 - MIN_GAIN_COUNTING_PART)).clamp(0.0, 1.0);
        UNKNOWN_OVER_NAMED_COST
            + EXPLAINED_SHARE_COST * (self.explained_share - MIN_EXPLAINED_SHARE).max(0.0)
            + gain_weight * (gain - MIN_COUNTED_GAIN).max(0.0)
    }
}

/// Log evidence -½ N ln(1 - s) - cost of `unknown` from a structured share s of the residual, with N effective samples.
fn structure_log_evidence(share: f64, cost: f64) -> f64 {
    -0.5 * EFFECTIVE_SAMPLES * (1.0 - share.min(MAX_STRUCTURED_SHARE)).ln() - cost
}

/// Returns true if the user's model leaves more structure than noise has by chance, so that the verdict would be `unknown`.
pub(crate) fn leaves_structure(study: &Study, responses: &ResponseRanges, baseline: &FittedHypothesis) -> bool {
    let structure = unmodelled_structure(study, responses, &baseline.fitted.fits, true);
    structure_log_evidence(structure.share, UNKNOWN_OVER_NOISE_COST) > 0.0
}

impl CauseProbabilities {
    /// Probabilities from ranked hypotheses, the best first. `baseline` is the fitted user's model.
    pub(crate) fn of(
        study: &Study,
        responses: &ResponseRanges,
        baseline: &FittedHypothesis,
        ranked: &[FittedHypothesis],
        bootstrap: Option<&BootstrapResult>,
    ) -> Self {
        let best = &ranked[0];
        let none = ranked.iter().find(|e| e.cause() == "none");
        // The best hypothesis of a cause represents it, with or without a second effect.
        let mut causes: CauseValues = vec![];
        for e in ranked {
            if causes.iter().all(|(cause, _)| *cause != e.cause()) {
                causes.push((e.cause(), e.log_evidence));
            }
        }
        let named = best.cause() != "none";
        let mut structure = unmodelled_structure(study, responses, &best.fitted.fits, !named);
        let unrepaired = &none.unwrap_or(baseline).fitted.fits;
        let structure_before = unmodelled_structure(study, responses, unrepaired, true);
        let before = total_nmse(study, unrepaired);
        let after = total_nmse(study, &best.fitted.fits);
        let noise = after * (1.0 - structure.share);
        let explained_share = if before > noise { ((before - after) / (before - noise)).clamp(0.0, 1.0) } else { 1.0 };
        let log_evidence_of_none = none.map_or(f64::NEG_INFINITY, |e| e.log_evidence);
        // An effect that the recording shows by itself is independent of other remaining structure.
        let log_evidence = best.log_evidence - best.variant.visible_log_odds();
        let structured_share = structure.share;
        let best_fit = BestFit { log_evidence, log_evidence_of_none, named, structured_share, explained_share };
        let mut unknown = best_fit.log_evidence_of_unknown();
        // A geometric effect has no wrong form of law that could leave a residual along the stroke.
        if best.variant.proposal.as_ref().is_some_and(|p| p.geometric) {
            let recurring = recurring_structure(study, responses, &best.fitted.fits);
            let of_recurring = best.log_evidence + structure_log_evidence(recurring.share, UNKNOWN_OVER_NOISE_COST);
            if recurring.share > 0.0 && of_recurring > unknown {
                unknown = of_recurring;
                let share = structure.share.max(recurring.share);
                structure = UnmodelledStructure { share, description: recurring.description, ..structure };
            }
        }
        causes.push(("unknown", unknown));
        let doubted_share = if best.variant.visible_log_odds() > 0.0 { 0.0 } else { structure.share };
        let probabilities = cause_probabilities(causes, doubted_share, log_evidence_of_none, bootstrap);
        Self { probabilities, structure, structure_before, explained_share, log_evidence_of_none }
    }
}

/// Probabilities of causes from their log evidences, the most probable first.
fn cause_probabilities(
    mut causes: CauseValues,
    structured_share: f64,
    log_evidence_of_none: f64,
    bootstrap: Option<&BootstrapResult>,
) -> CauseValues {
    causes.sort_by(|a, b| b.1.total_cmp(&a.1));
    temper_evidence(&mut causes, structured_share, log_evidence_of_none);
    bound_by_bootstrap(&mut causes, log_evidence_of_none, bootstrap);
    let mut p = normalised_probabilities(&causes.iter().map(|c| c.1).collect::<Vec<_>>());
    doubt_first_cause(&causes, &mut p);
    doubt_library(&causes, structured_share, &mut p);
    let mut out: CauseValues = causes.iter().map(|c| c.0).zip(p).collect();
    out.sort_by(|a, b| b.1.total_cmp(&a.1));
    out
}

/// Reduces the evidence of the first cause against other named causes.
///
/// The likelihood gets the power [`LOOK_ALIKE_POWER`] between look-alikes: only the form of their laws separates them, and
/// nature need not have it. It gets the power 1 - s g for a structured share s of the residual, which the evidence takes for
/// noise (Miller and Dunson 2019, J. Am. Stat. Assoc. 114, 1113-1125). Here g is the gain of the other cause over that of the
/// first. A cause without a gain is no competitor.
fn temper_evidence(causes: &mut CauseValues, structured_share: f64, log_evidence_of_none: f64) {
    let (first, most) = causes[0];
    if !is_named(first) {
        return;
    }
    for (cause, log_evidence) in causes.iter_mut().skip(1).filter(|(cause, _)| is_named(cause)) {
        let gain = (*log_evidence - log_evidence_of_none) / (most - log_evidence_of_none).max(f64::MIN_POSITIVE);
        let gain = gain.clamp(0.0, 1.0);
        let power = if hypothesis::look_alike(first, cause) { LOOK_ALIKE_POWER } else { 1.0 };
        *log_evidence = most - power * (1.0 - structured_share * gain) * (most - *log_evidence);
    }
}

/// Bounds the evidence of the first cause over causes whose own recordings give it an equal gain.
///
/// The first cause keeps a lead of [`MIN_BOOTSTRAP_LEAD`], as the gain still supports it. The share of causes without a gain over
/// `none` goes to `unknown`. The gain of the first decides little there, and the recording does not show them.
fn bound_by_bootstrap(causes: &mut CauseValues, log_evidence_of_none: f64, bootstrap: Option<&BootstrapResult>) {
    let (first, most) = causes[0];
    let Some(b) = bootstrap.filter(|b| b.cause == first && first != "none") else { return };
    let mut unsupported_odds = 0.0;
    for (cause, log_evidence) in causes.iter_mut().skip(1) {
        let Some(bound) = b.max_log_evidence_over(cause) else { continue };
        let bounded = most - bound.max(MIN_BOOTSTRAP_LEAD);
        if *log_evidence > log_evidence_of_none || *cause == "none" {
            *log_evidence = log_evidence.max(bounded);
        } else {
            unsupported_odds += (bounded - most).exp();
        }
    }
    if let Some((_, unknown)) = causes.iter_mut().find(|c| c.0 == "unknown") {
        *unknown = most + ((*unknown - most).exp() + unsupported_odds).ln();
    }
}

/// Takes the share of wrong verdicts from the first cause: an effect may be too weak to show, and no law is exact.
///
/// Half goes to causes that look like the first, in equal parts. The rest goes to `unknown`, or to the second cause if
/// `unknown` is the first.
fn doubt_first_cause(causes: &[(&'static str, f64)], p: &mut [f64]) {
    let first = causes[0].0;
    let amount = p[0] * if is_named(first) { NAMED_ERROR_SHARE } else { UNNAMED_ERROR_SHARE };
    let look_alikes = hypothesis::of(first).map_or(&[][..], |h| h.look_alikes);
    let others: Vec<usize> = (1..p.len()).filter(|i| look_alikes.contains(&causes[*i].0)).collect();
    let unknown = causes.iter().skip(1).position(|c| c.0 == "unknown").map_or(1, |i| i + 1);
    if p.len() < 2 {
        return;
    }
    p[0] -= amount;
    p[unknown] += if others.is_empty() { amount } else { (1.0 - LOOK_ALIKE_DOUBT_PART) * amount };
    others.iter().for_each(|i| p[*i] += LOOK_ALIKE_DOUBT_PART * amount / others.len() as f64);
}

/// Moves a share of every named cause to `unknown` if the first is named and its residual has structure.
///
/// The structure shows that the true law may be none of the library.
fn doubt_library(causes: &[(&'static str, f64)], structured_share: f64, p: &mut [f64]) {
    let unknown = causes.iter().position(|c| c.0 == "unknown").filter(|_| is_named(causes[0].0));
    let Some(unknown) = unknown else { return };
    for i in (0..p.len()).filter(|i| is_named(causes[*i].0)) {
        let amount = STRUCTURED_ERROR_SHARE * structured_share * p[i];
        p[i] -= amount;
        p[unknown] += amount;
    }
}

/// Sum of the NMSE of all fitted channels.
fn total_nmse(study: &Study, fits: &[ScoredRun]) -> f64 {
    let runs = study.runs.iter().filter(|r| r.role == Role::Fit);
    let channels = runs.zip(fits).flat_map(|(r, f)| r.observe.iter().zip(&f.channels));
    channels
        .map(|(o, y)| {
            let r: Vec<f64> = y.iter().zip(&o.values).map(|(y, v)| y - v).filter(|d| d.is_finite()).collect();
            power(&r) / o.variance
        })
        .sum()
}

#[cfg(test)]
mod tests {
    use super::{BestFit, cause_probabilities};
    use crate::evidence::parametric_bootstrap::{BootstrapResult, EqualGain};

    /// Probability of `unknown` against a named cause with a gain.
    fn probability_of_unknown(gain: f64, structured_share: f64, explained_share: f64) -> f64 {
        let s =
            BestFit { log_evidence: gain, log_evidence_of_none: 0.0, named: true, structured_share, explained_share };
        let p = cause_probabilities(
            vec![("damping", gain), ("none", 0.0), ("unknown", s.log_evidence_of_unknown())],
            structured_share,
            0.0,
            None,
        );
        assert!((p.iter().map(|o| o.1).sum::<f64>() - 1.0).abs() < 1e-12);
        p.iter().find(|o| o.0 == "unknown").map_or(0.0, |o| o.1)
    }

    /// A named cause without structured residual keeps the general share of wrong verdicts only.
    #[test]
    fn a_named_cause_that_leaves_noise_is_kept() {
        for explained_share in [0.3, 0.6, 1.0] {
            assert!(probability_of_unknown(20.0, 0.0, explained_share) < 0.1);
        }
    }

    /// A named cause that explains little gives way to `unknown` as the structured share grows.
    #[test]
    fn a_named_cause_that_leaves_most_of_the_structure_is_dropped() {
        assert!(probability_of_unknown(20.0, 0.9, 0.35) > 0.8);
        assert!(probability_of_unknown(8.0, 0.6, 0.1) > 0.8);
        assert!((0.35..0.45).contains(&probability_of_unknown(20.0, 0.9, 0.9)));
        let rising: Vec<f64> = (0..8).map(|k| probability_of_unknown(10.0, 0.1 * f64::from(k), 0.3)).collect();
        assert!(rising.windows(2).all(|w| w[1] >= w[0]), "{rising:?}");
        let falling: Vec<f64> = (0..10).map(|k| probability_of_unknown(10.0, 0.7, 0.1 * f64::from(k))).collect();
        assert!(falling.windows(2).all(|w| w[1] <= w[0]), "{falling:?}");
    }

    /// Structured residual lowers all named causes and keeps their order.
    #[test]
    fn structured_residual_lowers_named_causes() {
        let named = |structured_share| {
            let p = cause_probabilities(
                vec![("damping", 30.0), ("torsion", 29.0), ("none", 0.0), ("unknown", -9.0)],
                structured_share,
                0.0,
                None,
            );
            let names: Vec<&str> = p.iter().map(|o| o.0).filter(|c| *c != "unknown").collect();
            assert_eq!(names, ["damping", "torsion", "none"]);
            assert!((p.iter().map(|o| o.1).sum::<f64>() - 1.0).abs() < 1e-12);
            p.iter().filter(|o| matches!(o.0, "damping" | "torsion")).map(|o| o.1).sum::<f64>()
        };
        assert!(named(0.0) > 0.94 && (0.58..0.64).contains(&named(0.9)), "{} {}", named(0.0), named(0.9));
    }

    /// A cause that the bootstrap does not separate from the first is nearly as probable; the others stay as they are.
    #[test]
    fn bound_brings_indistinct_causes_together() {
        let causes =
            || vec![("friction", 30.0), ("damping", 10.0), ("gap_impact", 10.0), ("none", 0.0), ("unknown", 2.0)];
        let of = |p: &[(&'static str, f64)], cause: &str| p.iter().find(|o| o.0 == cause).map_or(0.0, |o| o.1);
        let separate = cause_probabilities(causes(), 0.0, 0.0, None);
        let equal_gain = EqualGain { cause: "damping", share: 0.6, prior_log_odds: 0.0 };
        let b = BootstrapResult {
            cause: "friction",
            recordings: 199,
            chance: Some(0.005),
            found: 0.5,
            not_told_apart: vec![equal_gain],
        };
        let bounded = cause_probabilities(causes(), 0.0, 0.0, Some(&b));
        assert!(of(&separate, "damping") < 0.05 && of(&bounded, "damping") > 0.35, "{bounded:?}");
        assert_eq!(bounded[0].0, "friction");
        assert!(of(&bounded, "gap_impact") < 0.01 && of(&bounded, "none") < 0.01);
        // A bootstrap of another first cause has no effect.
        assert_eq!(cause_probabilities(causes(), 0.0, 0.0, Some(&BootstrapResult { cause: "torsion", ..b })), separate);
    }

    /// The share of indistinct causes without a gain goes to `unknown`.
    #[test]
    fn bound_moves_unsupported_causes_to_unknown() {
        let of = |evidence| {
            let indistinct = ["damping", "torsion", "sensor_lag"];
            let equal_gain = |cause| EqualGain { cause, share: 0.6, prior_log_odds: 0.0 };
            let b = BootstrapResult {
                cause: "friction",
                recordings: 199,
                chance: Some(0.005),
                found: 0.5,
                not_told_apart: indistinct.map(equal_gain).into(),
            };
            let mut causes = vec![("friction", 4.0), ("none", 0.0), ("unknown", -4.0)];
            causes.extend(indistinct.map(|cause| (cause, evidence)));
            let p = cause_probabilities(causes, 0.0, 0.0, Some(&b));
            assert!((p.iter().map(|o| o.1).sum::<f64>() - 1.0).abs() < 1e-12);
            p[0].0
        };
        assert_eq!((of(1.0), of(-1.0)), ("friction", "unknown"));
    }

    /// A gain that chance often produces leaves `none` probable.
    #[test]
    fn bound_keeps_none_probable_if_chance_gives_the_gain() {
        let b = BootstrapResult {
            cause: "friction",
            recordings: 199,
            chance: Some(0.3),
            found: 0.5,
            not_told_apart: vec![],
        };
        let p = cause_probabilities(vec![("friction", 8.0), ("none", 0.0), ("unknown", -4.0)], 0.0, 0.0, Some(&b));
        let none = p.iter().find(|o| o.0 == "none").map_or(0.0, |o| o.1);
        assert!(p[0].0 == "friction" && none > 0.3, "{p:?}");
    }

    /// Without a named cause, structure alone decides between `none` and `unknown`.
    #[test]
    fn structure_without_a_named_cause_is_unknown() {
        let first = |structured_share| {
            let s = BestFit {
                log_evidence: 0.0,
                log_evidence_of_none: 0.0,
                named: false,
                structured_share,
                explained_share: 0.0,
            };
            cause_probabilities(
                vec![("none", 0.0), ("unknown", s.log_evidence_of_unknown())],
                structured_share,
                0.0,
                None,
            )[0]
            .0
        };
        assert_eq!(first(0.0), "none");
        assert_eq!(first(0.6), "unknown");
    }
}

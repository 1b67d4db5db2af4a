//! Prior odds of hypotheses, and their order by log evidence.

use super::likelihood::NoiseModel;
use super::parametric_bootstrap::{BootstrapResult, Competitor, parametric_bootstrap};
use super::verdict_evidence::{independent_samples, unpredicted};
use crate::fit::fitted::FittedHypothesis;
use crate::fit::linearized::LinearizedFit;
use crate::fit::scheduler::Scheduler;
use crate::inspect::conditions::conditions_differ;
use crate::prior::{
    COMPLETE_MODEL_LOG_ODDS, EQUAL_FORM_LOG_EVIDENCE, MAX_ADVANTAGE_OF_WORSE_FIT, MAX_SECOND_EFFECT_GAIN,
    MIN_HOLDOUT_SIGNAL_RATIO, ONE_EFFECT_LOG_ODDS, RANGE_FAULT_IN_ALL_RUNS_LOG_ODDS,
};
use std::collections::BTreeSet;

/// Sets the log evidence of hypotheses from their held-out residuals, and sorts them: best first.
///
/// The noise is that of the hypothesis with the best score.
///
/// # Errors
/// No hypothesis has held-out residuals.
pub(crate) fn rank(all: &mut [FittedHypothesis]) -> Result<(), String> {
    let tested = all.iter().filter(|e| e.held_out.is_some());
    let best = tested.min_by(|a, b| a.score().total_cmp(&b.score())).and_then(|e| e.held_out.as_ref());
    let noise = NoiseModel::of(best.ok_or("no explanation could be tested on samples that it was not fitted to")?);
    for e in all.iter_mut() {
        let posterior = |r| prior_log_odds(e) + noise.log_evidence(r, e.variant.counted_parameters());
        e.log_evidence = e.held_out.as_ref().map_or(f64::NEG_INFINITY, posterior);
    }
    limit_worse_fits(all);
    all.sort_by(|a, b| b.log_evidence.total_cmp(&a.log_evidence));
    central_form_first(all);
    Ok(())
}

/// Raises the log likelihood of a hypothesis to that of one with no fewer parameters that fits the same samples less closely,
/// held back and fitted, less [`MAX_ADVANTAGE_OF_WORSE_FIT`].
///
/// The noise whitens residuals by one hypothesis, so that a worse fit can seem to have more evidence. Of two second effects
/// beside one first effect that both reach the noise, the closer fit gains by all independent samples.
fn limit_worse_fits(all: &mut [FittedHypothesis]) {
    struct Fit {
        causes: (&'static str, Option<&'static str>),
        parameters: usize,
        errors: [f64; 2],
        log_likelihood: f64,
        samples: f64,
        reaches_noise: bool,
    }
    let of = |e: &FittedHypothesis| {
        let residuals = e.held_out.as_ref()?;
        let held_back = residuals.iter().flatten().map(|r| r * r).sum();
        Some(Fit {
            causes: (e.cause(), e.second_cause()),
            parameters: e.variant.counted_parameters(),
            errors: [held_back, e.fitted.objective],
            log_likelihood: e.log_evidence - prior_log_odds(e),
            samples: independent_samples(residuals),
            reaches_noise: unpredicted(residuals).is_some_and(|n| held_back <= MIN_HOLDOUT_SIGNAL_RATIO * n),
        })
    };
    let fits: Vec<Option<Fit>> = all.iter().map(of).collect();
    for (e, own) in all.iter_mut().zip(&fits) {
        let Some(own) = own else { continue };
        let is_worse =
            |f: &&Fit| f.parameters >= own.parameters && f.errors[0] > own.errors[0] && f.errors[1] > own.errors[1];
        let is_rival = |f: &Fit| {
            let second_effects = f.causes.0 == own.causes.0 && f.causes.1.is_some() && own.causes.1.is_some();
            second_effects && f.causes.1 != own.causes.1 && f.reaches_noise && own.reaches_noise
        };
        let least = |f: &Fit| {
            let gain = 0.5 * own.samples * (f.errors[0] / own.errors[0]).ln();
            f.log_likelihood + if is_rival(f) { gain.min(MAX_SECOND_EFFECT_GAIN) } else { -MAX_ADVANTAGE_OF_WORSE_FIT }
        };
        let most = fits.iter().flatten().filter(is_worse).map(least).fold(f64::NEG_INFINITY, f64::max);
        e.log_evidence += (most - own.log_likelihood).max(0.0);
    }
}

/// Moves the form with the most central user parameters to the front, among those that equal the first.
///
/// Nothing else may show in which of two runs a range is wrong.
fn central_form_first(all: &mut [FittedHypothesis]) {
    let Some(first) = all.first() else { return };
    let distance = |e: &FittedHypothesis| {
        e.variant.own_coordinates(&e.fitted.point).iter().map(|x| (x - 0.5) * (x - 0.5)).sum::<f64>()
    };
    let equal = all.iter().enumerate().filter(|(_, e)| equal_forms(e, first));
    let central = equal.min_by(|(_, a), (_, b)| distance(a).total_cmp(&distance(b))).map(|(n, _)| n);
    if let Some(n) = central {
        all[..=n].rotate_right(1);
    }
}

/// Returns true if both have one cause, and evidence within [`EQUAL_FORM_LOG_EVIDENCE`].
pub(crate) fn equal_forms(one: &FittedHypothesis, other: &FittedHypothesis) -> bool {
    let causes = |e: &FittedHypothesis| (e.cause(), e.second_cause());
    causes(one) == causes(other) && (one.log_evidence - other.log_evidence).abs() < EQUAL_FORM_LOG_EVIDENCE
}

/// Log odds of a hypothesis before the fit, nats.
pub(crate) fn prior_log_odds(e: &FittedHypothesis) -> f64 {
    let of_causes = match (e.cause(), e.second_cause()) {
        ("none", _) => COMPLETE_MODEL_LOG_ODDS,
        (_, Some(_)) => -ONE_EFFECT_LOG_ODDS,
        _ => 0.0,
    };
    let coincidence = e.variant.visible_log_odds() == 0.0
        && e.variant.has_range_fault_in_one_run()
        && conditions_differ(&e.variant.study);
    of_causes + e.variant.direct_log_odds() - if coincidence { RANGE_FAULT_IN_ALL_RUNS_LOG_ODDS } else { 0.0 }
}

/// Bootstrap of the ranked hypotheses, and of the best forms of other causes. `None` if the recording itself shows the first
/// cause, which no noise does.
pub(crate) fn bootstrap_ranking(
    scheduler: &mut Scheduler<'_>,
    ranked: &[FittedHypothesis],
    best_forms: &[FittedHypothesis],
) -> Result<Option<BootstrapResult>, String> {
    if ranked[0].variant.visible_log_odds() > 0.0 {
        return Ok(None);
    }
    let known: BTreeSet<&str> = ranked.iter().map(FittedHypothesis::cause).collect();
    let further = best_forms.iter().filter(|e| !known.contains(e.cause()));
    let all: Vec<&FittedHypothesis> = ranked.iter().chain(further).collect();
    let linearized = scheduler.linearize("recordings as they might have been", &all)?;
    let competitor = |(e, fit): (&&FittedHypothesis, Option<LinearizedFit>)| {
        let (point, parameters) = (e.fitted.point.clone(), e.variant.counted_parameters());
        Some(Competitor { cause: e.cause(), prior_log_odds: prior_log_odds(e), point, parameters, fit: fit? })
    };
    let competitors: Vec<Competitor> = all.iter().zip(linearized).filter_map(competitor).collect();
    let first_takes_part = competitors.first().is_some_and(|c| c.cause == ranked[0].cause());
    Ok(if first_takes_part { parametric_bootstrap(&competitors) } else { None })
}

#[cfg(test)]
mod tests {
    use super::central_form_first;
    use crate::test_support::hypotheses;

    #[test]
    fn among_equal_forms_the_central_one_comes_first() {
        let order = |of: &[(&'static str, f64, f64)]| {
            let mut all = hypotheses(of);
            central_form_first(&mut all);
            all.iter().map(|e| (e.cause(), e.log_evidence)).collect::<Vec<_>>()
        };
        let equal = order(&[("friction", 9.0, 0.1), ("damping", 8.9, 0.5), ("friction", 8.8, 0.4)]);
        assert_eq!(equal, [("friction", 8.8), ("friction", 9.0), ("damping", 8.9)]);
        // A form with less evidence stays behind, wherever its parameters are.
        let worse = order(&[("friction", 9.0, 0.1), ("friction", 8.0, 0.5)]);
        assert_eq!(worse, [("friction", 9.0), ("friction", 8.0)]);
    }
}

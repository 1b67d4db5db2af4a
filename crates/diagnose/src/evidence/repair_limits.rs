//! Limits by what a repair takes away of the error above the noise, and by the kind of memory that explains more.

use super::memory_evidence::MIN_SIGNAL_RATIO;
use super::verdict_evidence::{HypothesisEvidence, ProbabilityLimit, RepairEvidence, VerdictEvidence};
use crate::hypothesis::{self, is_sensor_fault};
use crate::memory::competition::FamilyResult;
use crate::memory::family::Family;
use crate::prior::{
    FREE_DISTANCE, LAPSE_SHARE, MAX_NOISE_OF_SMALL_ERROR, MEMORY_ERROR_RATIO, MEMORY_LOG_ODDS, MEMORY_PROBABILITY,
    MEMORY_TIE, MIN_EXPLAINED_STRUCTURE, MIN_TAKEN_OF_SMALL_ERROR, MIN_TAKEN_SHARE, MIN_TAKEN_SHARE_OF_SENSOR,
    NATS_PER_COST, NEGLIGIBLE_NMSE, PARTIAL_SENSOR_PROBABILITY, REPEATED_NMSE, SMALL_ERROR_PROBABILITY,
    UNKNOWN_PER_SHARE_LEFT,
};

/// Share of the error above the noise that a repair takes away.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TakenShare {
    /// On blocks of the fitted runs that were held back.
    pub(crate) blocks: f64,
    /// On the runs held out; none where they cannot judge.
    pub(crate) runs: Option<f64>,
}

impl TakenShare {
    fn mean(self) -> f64 {
        self.runs.map_or(self.blocks, |r| 0.5 * (self.blocks + r))
    }

    fn least(self) -> f64 {
        self.runs.map_or(self.blocks, |r| self.blocks.min(r))
    }
}

impl VerdictEvidence {
    /// Limits that a judged repair sets: to its own cause, or to `unknown`.
    pub(crate) fn limits_of_repair(&self, repair: &RepairEvidence) -> Vec<ProbabilityLimit> {
        let Some(h) = self.hypothesis(&repair.cause, repair.also.as_deref()) else { return vec![] };
        if h.cause == "none" {
            let better = self.memory_beyond_model(h, repair).map(|f| memory_limit(f, h, repair));
            return better.or_else(|| self.limit_of_small_error(repair)).into_iter().collect();
        }
        let mut out: Vec<ProbabilityLimit> = vec![];
        let limit = ProbabilityLimit::new;
        out.extend(self.limit_of_adequate_model(h, repair).filter(|_| !is_visible(h)));
        out.extend(self.limit_beside_physics(h).filter(|_| !is_visible(h)));
        out.extend(h.limit_of_same_model());
        out.extend(self.limits_of_faults_beside(h));
        let better = self.better_memory(h, repair);
        if let Some(f) = better {
            out.push(memory_limit(f, h, repair));
        }
        let percent = |x: f64| format!("{:.0} %", 100.0 * x.max(0.0));
        let unknown_beside = |share: f64| (UNKNOWN_PER_SHARE_LEFT * (1.0 - share)).clamp(LAPSE_SHARE, 1.0);
        // A condition is what differs where a motion repeats, whatever the model lacks beside it.
        if let Some(share) = h.repeated_share {
            let reason =
                format!("{} takes away {} of what differs where a motion repeats", repair.cause, percent(share));
            out.push(limit("unknown", unknown_beside(share), reason));
            return out;
        }
        // A fault that the recording shows by itself may be short.
        let Some(taken) = self.taken_share(h, repair).filter(|_| !is_visible(h)) else { return out };
        let least = if is_sensor_fault(&repair.cause) { MIN_TAKEN_SHARE_OF_SENSOR } else { MIN_TAKEN_SHARE };
        if taken.mean() < least {
            let most = taken.mean().clamp(0.0, 1.0);
            let most = if is_sensor_fault(&repair.cause) { most.min(PARTIAL_SENSOR_PROBABILITY) } else { most };
            let reason = format!("it takes away {} of the error above the noise", percent(taken.mean()));
            out.push(limit(&repair.cause, most, reason));
        } else if better.is_none() && taken.least() >= MIN_TAKEN_SHARE {
            let reason = format!("{} takes away {} of the error above the noise", repair.cause, percent(taken.least()));
            out.push(limit("unknown", unknown_beside(taken.least()), reason));
        }
        out
    }

    /// Limit of a repair that takes little from a model whose error may be what a test does not repeat, and that leaves
    /// structure itself: model and repair are both roughly right. A small effect that is the whole of the error keeps its name.
    fn limit_of_adequate_model(&self, h: &HypothesisEvidence, repair: &RepairEvidence) -> Option<ProbabilityLimit> {
        let errors = repair.errors?;
        let before = errors.before?;
        let share = |before: f64, after: f64| 1.0 - after / before;
        let runs = share(before, errors.after.unwrap_or(before));
        let taken = runs.max(share(self.nmse_before, h.held_back.unwrap_or(h.nmse))).max(0.0);
        let percent = |x: f64| format!("{:.2} %", 100.0 * x);
        let reason = format!(
            "your model predicts the runs held out within {} of the variance, and the repair within {}: a test hardly repeats better",
            percent(before),
            percent(before * (1.0 - runs))
        );
        let is_adequate = before.max(self.nmse_before) <= REPEATED_NMSE;
        let takes_little = taken < MIN_TAKEN_OF_SMALL_ERROR && self.explained_share < MIN_EXPLAINED_STRUCTURE;
        let limit = ProbabilityLimit::new(&repair.cause, runs.max(0.0), reason);
        (is_adequate && takes_little).then_some(ProbabilityLimit { for_complete_model: true, ..limit })
    }

    /// Limit of `unknown` where no hypothesis is better than a model that leaves very little, and little beside the noise. What
    /// structure that has is of no use to anyone.
    fn limit_of_small_error(&self, repair: &RepairEvidence) -> Option<ProbabilityLimit> {
        let (noise, held_out) = (self.recorded.noise?, repair.errors.and_then(|e| e.before));
        let is_small = self.nmse_before <= NEGLIGIBLE_NMSE.min(MAX_NOISE_OF_SMALL_ERROR * noise);
        let reason = format!(
            "your model leaves {:.2} % of the variance, of which noise is {:.2} %, and nothing takes more away",
            100.0 * self.nmse_before,
            100.0 * noise.min(self.nmse_before)
        );
        let limit = ProbabilityLimit::new("unknown", SMALL_ERROR_PROBABILITY, reason);
        (is_small && held_out.is_none_or(|e| e <= REPEATED_NMSE))
            .then_some(ProbabilityLimit { for_complete_model: true, ..limit })
    }

    fn hypothesis(&self, cause: &str, also: Option<&str>) -> Option<&HypothesisEvidence> {
        self.hypotheses.iter().find(|h| h.cause == cause && h.also.as_deref() == also)
    }

    /// Share of the error above the noise that a hypothesis takes away on blocks held back; `None` where the user's model
    /// leaves hardly more than noise.
    pub(crate) fn share_on_blocks(&self, h: &HypothesisEvidence) -> Option<f64> {
        let (before, after) = (self.hypothesis("none", None)?.held_back?, h.held_back?);
        let noise = self.noise_on_blocks()?;
        (before >= MIN_SIGNAL_RATIO * noise && h.cause != "none").then(|| (before - after) / (before - noise))
    }

    /// Share that a repair takes away; `None` where the user's model leaves hardly more than noise.
    pub(crate) fn taken_share(&self, h: &HypothesisEvidence, repair: &RepairEvidence) -> Option<TakenShare> {
        let blocks = self.share_on_blocks(h)?;
        let of_runs = |errors: super::holdout::HeldOutErrors| {
            let (before, noise) = (errors.before?, self.noise_in_runs(errors.after)?);
            let after = errors.after.unwrap_or(before);
            (before >= MIN_SIGNAL_RATIO * noise && after != before).then(|| (before - after) / (before - noise))
        };
        let errors = repair.errors.filter(|_| !repair.of_one_run);
        Some(TakenShare { blocks: blocks.min(1.0), runs: errors.and_then(of_runs).map(|s| s.min(1.0)) })
    }

    /// Noise of the fitted runs. No model can leave less than it on blocks held back, so that the least such error bounds it;
    /// the error of the causes alone is no estimate of it.
    fn noise_on_blocks(&self) -> Option<f64> {
        let of_families = self.recorded.families.iter().filter(|_| self.recorded.is_single).map(|f| f.blocks);
        let known = of_families.chain(self.recorded.noise).reduce(f64::min)?;
        Some(self.hypotheses.iter().filter_map(|h| h.held_back).fold(known, f64::min))
    }

    /// Noise of the runs held out, bounded by the error `after` a repair in the same way.
    fn noise_in_runs(&self, after: Option<f64>) -> Option<f64> {
        let families = self.recorded.families.iter().filter(|_| self.recorded.is_single);
        let known = families.filter_map(|f| f.held_out).chain(self.recorded.noise_held_out).reduce(f64::min)?;
        Some(after.map_or(known, |error| known.min(error)))
    }

    /// The kind of memory that clearly explains more than a repair of other kinds, on what both have not seen.
    pub(crate) fn better_memory(&self, h: &HypothesisEvidence, repair: &RepairEvidence) -> Option<&FamilyResult> {
        let best = self.recorded.families.first()?;
        // The cause of a second effect has its own memory.
        let own: Vec<Family> =
            [Some(h.cause.as_str()), h.also.as_deref()].into_iter().flatten().flat_map(memory_of).collect();
        let sensor = is_sensor_fault(&h.cause) || h.also.as_deref().is_some_and(is_sensor_fault);
        if (own.is_empty() && !sensor) || is_visible(h) {
            return None;
        }
        let shape = self.recorded.families.iter().find(|f| f.family == Family::Shape.name());
        // What needs no memory is a matter of the law's shape, which many causes change.
        let remembers = best.family != Family::Shape.name() && shape.is_none_or(|s| s.behind > MEMORY_TIE);
        let ties =
            self.recorded.families.iter().any(|f| f.behind < MEMORY_TIE && own.iter().any(|o| o.name() == f.family));
        if ties || !remembers {
            return None;
        }
        let ratio = |repair: Option<f64>, family: Option<f64>| Some(repair? / family?.max(f64::MIN_POSITIVE));
        let blocks = ratio(h.device_held_back, Some(best.blocks))?;
        let runs = ratio(repair.device_held_out, best.held_out);
        // A sensor is blamed last: a memory that explains as much, and holds in other runs, suffices.
        let holds = |before: Option<f64>| Some(before? > MEMORY_ERROR_RATIO * best.held_out?);
        let beats = match runs {
            _ if sensor => {
                let gap = shape.is_some_and(|s| s.behind > MEMORY_ERROR_RATIO.ln());
                gap && blocks * MEMORY_ERROR_RATIO > 1.0 && holds(repair.errors.and_then(|e| e.before)).unwrap_or(false)
            }
            Some(runs) => blocks.min(runs) > MEMORY_ERROR_RATIO,
            // Blocks alone say less.
            None => blocks > MEMORY_ERROR_RATIO * MEMORY_ERROR_RATIO,
        };
        beats.then_some(best)
    }

    /// The kind of memory that clearly explains more than the user's model and than any law without memory, on what none has
    /// seen: a complete model would leave it nothing.
    fn memory_beyond_model(&self, none: &HypothesisEvidence, repair: &RepairEvidence) -> Option<&FamilyResult> {
        let best = self.recorded.families.first()?;
        let shape = self.recorded.families.iter().find(|f| f.family == Family::Shape.name())?;
        let beats = |own: Option<f64>, law: Option<f64>| Some(own? > MEMORY_ERROR_RATIO * law?);
        let on_blocks = beats(none.device_held_back, Some(best.blocks))?;
        // Without runs held out the blocks alone say less.
        let held = beats(repair.device_held_out, best.held_out);
        let holds = held.unwrap_or_else(|| {
            none.device_held_back.is_some_and(|b| b > MEMORY_ERROR_RATIO * MEMORY_ERROR_RATIO * best.blocks)
        });
        (shape.behind > MEMORY_ERROR_RATIO.ln() && on_blocks && holds).then_some(best)
    }

    /// Log odds of a cause by the distance of its kinds of memory from the best, at most 0, nats.
    ///
    /// They count where the best kind explains the device as well as the best cause of the library does. A cause without memory
    /// that itself explains as much needs none: the law learned of a shape alone may be coarser than its own.
    pub(crate) fn memory_log_odds(&self, cause: &str) -> f64 {
        let Some(best) = self.recorded.families.first() else { return 0.0 };
        let left = |of: &dyn Fn(&str) -> bool| {
            let all = self.hypotheses.iter().filter(|h| of(&h.cause)).filter_map(|h| h.device_held_back);
            all.fold(f64::INFINITY, f64::min)
        };
        let behind = |f: &Family| {
            let of_family = self.recorded.families.iter().filter(|r| r.family == f.name());
            of_family.map(|r| r.behind).fold(f64::INFINITY, f64::min)
        };
        let shape = self.recorded.families.iter().find(|f| f.family == Family::Shape.name());
        if shape.is_some_and(|s| s.behind < MEMORY_TIE) {
            return 0.0;
        }
        let own = memory_of(cause);
        let least = own.iter().map(behind).fold(f64::INFINITY, f64::min);
        if best.blocks > MEMORY_ERROR_RATIO * left(&|_| true) || !least.is_finite() {
            return 0.0;
        }
        let needs_none = own.contains(&Family::Shape);
        let of_cause = (left(&|c| c == cause) / best.blocks).ln().max(0.0);
        -MEMORY_LOG_ODDS * least.min(if needs_none { of_cause } else { 1.0 }).min(1.0)
    }

    /// Log odds that a cause or a complete model loses for its distance from the best cause beyond what the fitted weights
    /// count, nats.
    ///
    /// The weights count the logarithm of a distance, and half of it between look-alikes. No rival is left so far behind.
    pub(crate) fn distance_cost(&self, cause: &str) -> f64 {
        let of = |h: &&HypothesisEvidence| h.cause == cause;
        let likelihood = |h: &HypothesisEvidence| h.log_likelihood;
        let own = self.hypotheses.iter().filter(of).map(likelihood).fold(f64::NEG_INFINITY, f64::max);
        let named = self.hypotheses.iter().filter(|h| h.cause != "none" && h.direct_log_odds <= VISIBLE);
        let best = named.map(likelihood).fold(f64::NEG_INFINITY, f64::max);
        let is_candidate = (cause == "none" || hypothesis::of(cause).is_some()) && own.is_finite();
        if is_candidate { ((best - own - FREE_DISTANCE) / NATS_PER_COST).max(0.0) } else { 0.0 }
    }

    /// Returns true if the best kind of memory leaves clearly less than none, and no cause of the library has it.
    pub(crate) fn memory_is_outside_library(&self) -> bool {
        let shape = self.recorded.families.iter().find(|f| f.family == Family::Shape.name());
        let best = self.recorded.families.first().and_then(|f| Family::of_name(&f.family));
        let in_library = |family: Family| hypothesis::ALL.iter().any(|h| h.memory.contains(&family));
        shape.is_some_and(|s| s.behind > MEMORY_ERROR_RATIO.ln()) && best.is_some_and(|f| !in_library(f))
    }

    /// The best kind of memory in words, where a law that remembers it leaves clearly less than one without memory.
    pub(crate) fn memory_sentence(&self) -> Option<String> {
        let best = self.recorded.families.first()?;
        let family = Family::of_name(&best.family)?;
        let shape = self.recorded.families.iter().find(|f| f.family == Family::Shape.name())?;
        if shape.behind <= MEMORY_ERROR_RATIO.ln() {
            return None;
        }
        let of_channel = if best.channel.is_empty() { String::new() } else { format!(" ({})", best.channel) };
        let causes: Vec<&str> =
            hypothesis::ALL.iter().filter(|h| h.memory.contains(&family)).map(|h| h.cause).collect();
        let library = match &causes[..] {
            [] => "no cause of the library has this memory".to_owned(),
            all => format!("of the library {} has this memory", all.join(" or ")),
        };
        let tie = self.recorded.families[1..].iter().find(|f| f.behind < MEMORY_TIE);
        let tie = tie
            .and_then(|f| Family::of_name(&f.family))
            .map_or_else(String::new, |f| format!(". As well explained is that {}", f.statement()));
        Some(format!("{}{of_channel}: {library}{tie}", family.statement()))
    }
}

/// Kinds of memory of a cause.
fn memory_of(cause: &str) -> Vec<Family> {
    hypothesis::of(cause).map_or_else(Vec::new, |h| h.memory.to_vec())
}

/// Log odds from which the recording itself shows a fault, nats; auxiliary channels give less.
const VISIBLE: f64 = 10.0;

fn is_visible(h: &HypothesisEvidence) -> bool {
    h.direct_log_odds > VISIBLE
}

/// Limit of a cause that leaves what a kind of memory explains.
fn memory_limit(f: &FamilyResult, h: &HypothesisEvidence, repair: &RepairEvidence) -> ProbabilityLimit {
    let reason = memory_reason(f, h, repair);
    ProbabilityLimit::new(&repair.cause, MEMORY_PROBABILITY, reason)
}

fn memory_reason(f: &FamilyResult, h: &HypothesisEvidence, repair: &RepairEvidence) -> String {
    let statement = Family::of_name(&f.family).map_or("", Family::statement);
    let of_runs = match (f.held_out, repair.device_held_out) {
        (Some(own), Some(other)) => format!(", and {own:.2e} in place of {other:.2e} of the runs held out"),
        _ => String::new(),
    };
    format!(
        "{statement}, and a law that remembers this alone leaves {:.2e} in place of {:.2e} of blocks that were held back{of_runs}",
        f.blocks,
        h.device_held_back.unwrap_or(f64::NAN)
    )
}

#[cfg(test)]
mod tests {
    use crate::evidence::holdout::HeldOutErrors;
    use crate::evidence::verdict_evidence::{RepairEvidence, VerdictEvidence};
    use crate::evidence::verdict_model::{cause_probabilities, tests as support};
    use crate::memory::competition::FamilyResult;

    fn family(name: &str, blocks: f64, behind: f64) -> FamilyResult {
        let (family, channel) = (name.to_owned(), String::new());
        FamilyResult { family, channel, blocks, whole_runs: blocks, behind, held_out: Some(blocks), terms: vec![] }
    }

    /// A cause that takes the error from 0.1 to `after` on blocks and in runs held out, with noise of 0.001.
    fn case(cause: &str, after: f64, families: Vec<FamilyResult>) -> (VerdictEvidence, RepairEvidence) {
        let mut e = support::evidence(&[(cause, None, 60.0)]);
        e.recorded.noise = Some(1e-3);
        e.recorded.noise_held_out = Some(1e-3);
        e.recorded.families = families;
        for h in &mut e.hypotheses {
            let error = if h.cause == "none" { 0.1 } else { after };
            (h.held_back, h.device_held_back) = (Some(error), Some(error));
        }
        let errors = HeldOutErrors { before: Some(0.1), after: Some(after), noise: 1e-3 };
        let repair = RepairEvidence {
            cause: cause.into(),
            also: None,
            errors: Some(errors),
            device_held_out: Some(after),
            of_one_run: false,
        };
        (e, repair)
    }

    /// Limits as pairs of cause and largest probability.
    fn limits(of: &(VerdictEvidence, RepairEvidence)) -> Vec<(String, f64)> {
        of.0.limits_of_repair(&of.1).into_iter().map(|l| (l.cause, l.most)).collect()
    }

    #[test]
    fn what_takes_most_of_the_error_leaves_little_for_unknown() {
        let good = limits(&case("friction", 1e-3, vec![]));
        assert_eq!(good, [("unknown".to_owned(), 0.03)]);
        let most = limits(&case("friction", 0.0109, vec![]));
        assert!(most[0].0 == "unknown" && (most[0].1 - 0.15).abs() < 1e-9, "{most:?}");
        let poor = limits(&case("friction", 0.0802, vec![]));
        assert!(poor[0].0 == "friction" && (poor[0].1 - 0.2).abs() < 1e-9, "{poor:?}");
        // Beside an error that is all noise nothing is taken.
        let mut noise = case("friction", 0.05, vec![]);
        noise.0.recorded.noise = Some(0.09);
        noise.0.hypotheses.retain(|h| h.cause == "none");
        assert!(limits(&noise).is_empty());
    }

    /// A condition that takes what differs where a motion repeats is none the worse for what the model lacks beside it.
    #[test]
    fn what_differs_where_a_motion_repeats_leaves_little_for_unknown() {
        let mut told = case("changed_condition", 0.0802, vec![]);
        assert_eq!(limits(&told)[0].0, "changed_condition");
        told.0.hypotheses.iter_mut().filter(|h| h.cause != "none").for_each(|h| h.repeated_share = Some(0.8));
        let most = limits(&told);
        assert!(most.len() == 1 && most[0].0 == "unknown" && (most[0].1 - 0.3).abs() < 1e-9, "{most:?}");
    }

    /// Another kind of memory that leaves a tenth of the error refuses a cause; its own kind does not.
    #[test]
    fn another_memory_that_explains_more_refuses_a_cause() {
        let of = |best: &str| case("rate_dependence", 0.02, vec![family(best, 0.002, 0.0), family("shape", 0.09, 3.8)]);
        let refused = limits(&of("rest"));
        assert!(refused.contains(&("rate_dependence".to_owned(), 0.1)), "{refused:?}");
        assert!(limits(&of("rate")).iter().all(|(cause, _)| cause == "unknown"));
        let (mut e, repair) = of("rest");
        e.limits = e.limits_of_repair(&repair);
        let p = cause_probabilities(&e);
        assert!(p[0].0 == "unknown" && p[0].1 > 0.8, "{p:?}");
        let sentence = e.memory_sentence().expect("a sentence");
        assert!(sentence.contains("time at rest: no cause of the library has this memory"), "{sentence}");
        assert!(of("rate").0.memory_sentence().is_some_and(|s| s.contains("rate_dependence")));
        // A shape that explains as much has no memory.
        let plain = case("rate_dependence", 0.02, vec![family("rest", 0.002, 0.0), family("shape", 0.002, 0.05)]);
        assert_eq!((limits(&plain).iter().any(|l| l.0 == "rate_dependence"), plain.0.memory_sentence()), (false, None));
    }

    /// A faulty sensor of a model that is otherwise right leaves hardly more than noise; a cause may leave more.
    #[test]
    fn a_sensor_that_leaves_much_is_hardly_the_fault() {
        let of = |cause: &str, after| limits(&case(cause, after, vec![])).into_iter().find(|l| l.0 == cause);
        assert_eq!(of("sensor_lag", 0.045), Some(("sensor_lag".to_owned(), 0.3)));
        assert_eq!((of("sensor_lag", 0.01), of("friction", 0.045)), (None, None));
    }

    /// A repair that takes little from an adequate model and leaves structure gives its probability to `none`. One that takes
    /// most of the error, or all of its structure, or repairs a model that is not adequate, keeps it.
    #[test]
    fn a_small_gain_over_an_adequate_model_speaks_for_a_complete_one() {
        let of = |before: f64, after: f64, explained: f64| {
            let (mut e, mut repair) = case("friction", after, vec![]);
            (e.nmse_before, e.explained_share) = (before, explained);
            e.hypotheses.iter_mut().filter(|h| h.cause == "none").for_each(|h| h.held_back = Some(before));
            e.recorded.noise = Some(0.1 * before);
            e.recorded.noise_held_out = Some(0.1 * before);
            repair.errors = Some(HeldOutErrors { before: Some(before), after: Some(after), noise: 0.1 * before });
            e.limits = e.limits_of_repair(&repair);
            let p = cause_probabilities(&e);
            let friction = p.iter().find(|(cause, _)| *cause == "friction").map_or(0.0, |(_, p)| *p);
            (p[0].0, friction)
        };
        // The repair keeps at most the share of the error that it takes away, here 40 %.
        assert!(matches!(of(0.002, 0.0012, 0.8), ("none", friction) if friction <= 0.4 + 1e-9));
        assert_eq!(of(0.002, 0.0004, 0.8).0, "friction");
        assert_ne!(of(0.002, 0.0009, 1.0).0, "none");
        assert_ne!(of(0.02, 0.012, 0.8).0, "none");
    }

    /// Structure in an error that is small, and small beside the noise, leaves the model complete.
    #[test]
    fn a_very_small_error_is_no_unknown() {
        let of = |before: f64, noise: f64, held_out: f64| {
            let (mut e, mut repair) = case("none", before, vec![]);
            e.hypotheses.retain(|h| h.cause == "none");
            (e.nmse_before, e.recorded.noise) = (before, Some(noise));
            repair.errors = Some(HeldOutErrors { before: Some(held_out), after: None, noise });
            limits(&(e, repair))
        };
        assert_eq!(of(5e-4, 4e-4, 3e-3), [("unknown".to_owned(), 0.3)]);
        assert!(
            of(2e-3, 1.9e-3, 3e-3).is_empty() && of(5e-4, 1e-4, 3e-3).is_empty() && of(5e-4, 4e-4, 0.02).is_empty()
        );
    }

    /// A sensor gives way to a memory that explains about as much and holds in other runs.
    #[test]
    fn a_sensor_is_blamed_last() {
        let of = |blocks| case("sensor_drift", 0.01, vec![family("set", blocks, 0.0), family("shape", 0.09, 2.2)]);
        assert!(limits(&of(0.012)).contains(&("sensor_drift".to_owned(), 0.1)));
        assert!(!limits(&of(0.03)).iter().any(|l| l.0 == "sensor_drift"));
    }

    /// A kind of memory that holds in other runs speaks against a complete model; noise has none.
    #[test]
    fn a_complete_model_leaves_no_memory() {
        let of = |blocks, held_out| {
            let shape = family("shape", 0.1, 1.0);
            let (mut e, mut repair) = case("none", 0.1, vec![family("heat", blocks, 0.0), shape]);
            e.recorded.families[0].held_out = Some(held_out);
            e.hypotheses.retain(|h| h.cause == "none");
            repair.device_held_out = Some(0.1);
            limits(&(e, repair))
        };
        assert_eq!(of(0.03, 0.03), [("none".to_owned(), 0.1)]);
        assert!(of(0.09, 0.03).is_empty() && of(0.03, 0.09).is_empty());
    }

    /// A cause without memory that explains as much as the best kind of memory loses nothing; one that explains less does.
    #[test]
    fn what_explains_as_much_without_memory_needs_none() {
        let families =
            vec![family("side", 0.002, 0.0), family("shape", 0.0035, 0.56), family("largest_deformation", 0.0045, 0.8)];
        let odds = |cause: &str, after| case(cause, after, families.clone()).0.memory_log_odds(cause);
        assert_eq!(odds("strain_stiffening", 0.002), 0.0);
        assert!(odds("strain_stiffening", 0.0028) < -0.6, "{}", odds("strain_stiffening", 0.0028));
        // Softening is of another memory, however well it is fitted.
        assert!(odds("mullins_softening", 0.002) < -1.0, "{}", odds("mullins_softening", 0.002));
    }

    #[test]
    fn no_rival_is_left_far_behind() {
        let p = |gap: f64| {
            let all = cause_probabilities(&support::evidence(&[
                ("self_heating", None, 100.0),
                ("cyclic_degradation", None, 100.0 - gap),
            ]));
            all.iter().find(|(c, _)| *c == "cyclic_degradation").map_or(0.0, |x| x.1)
        };
        assert!(p(90.0) < 0.02 && p(5.0) > p(90.0), "{} {}", p(5.0), p(90.0));
        // Nor is a complete model. What all candidates share stays.
        let none = |gain: f64| {
            let all = cause_probabilities(&support::evidence(&[("self_heating", None, gain)]));
            all.iter().find(|(c, _)| *c == "none").map_or(0.0, |x| x.1)
        };
        assert!(none(100.0) < 0.012 && none(10.0) > 0.05, "{} {}", none(100.0), none(10.0));
    }
}

//! Limits by what a repair takes away of the error above the noise, and by the kind of memory that explains more.

use super::memory_evidence::MIN_SIGNAL_RATIO;
use super::verdict_evidence::{HypothesisEvidence, ProbabilityLimit, RepairEvidence, VerdictEvidence};
use crate::hypothesis;
use crate::memory::competition::FamilyResult;
use crate::memory::family::Family;
use crate::prior::{
    MEMORY_ERROR_RATIO, MEMORY_LOG_ODDS, MEMORY_PROBABILITY, MEMORY_TIE, MIN_TAKEN_SHARE, UNKNOWN_PER_SHARE_LEFT,
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
        let mut out: Vec<ProbabilityLimit> = vec![];
        let limit = |cause: &str, most: f64, reason: String| ProbabilityLimit { cause: cause.into(), most, reason };
        let better = self.better_memory(h, repair);
        if let Some(f) = better {
            out.push(limit(&repair.cause, MEMORY_PROBABILITY, memory_reason(f, h, repair)));
        }
        // A fault that the recording shows by itself may be short.
        let Some(taken) = self.taken_share(h, repair).filter(|_| !is_visible(h)) else { return out };
        let percent = |x: f64| format!("{:.0} %", 100.0 * x.max(0.0));
        if taken.mean() < MIN_TAKEN_SHARE {
            let most = taken.mean().clamp(0.0, 1.0);
            let reason = format!("it takes away {} of the error above the noise", percent(taken.mean()));
            out.push(limit(&repair.cause, most, reason));
        } else if better.is_none() && taken.least() >= MIN_TAKEN_SHARE {
            let most = (UNKNOWN_PER_SHARE_LEFT * (1.0 - taken.least())).clamp(0.0, 1.0);
            let reason =
                format!("{} takes away {} of the error above the noise", repair.cause, percent(taken.least()));
            out.push(limit("unknown", most, reason));
        }
        out
    }

    fn hypothesis(&self, cause: &str, also: Option<&str>) -> Option<&HypothesisEvidence> {
        self.hypotheses.iter().find(|h| h.cause == cause && h.also.as_deref() == also)
    }

    /// Share that a repair takes away; `None` where the user's model leaves hardly more than noise.
    pub(crate) fn taken_share(&self, h: &HypothesisEvidence, repair: &RepairEvidence) -> Option<TakenShare> {
        let noise = self.recorded.noise?;
        let (before, after) = (self.hypothesis("none", None)?.held_back?, h.held_back?);
        if before < MIN_SIGNAL_RATIO * noise || h.cause == "none" {
            return None;
        }
        let blocks = (before - after) / (before - noise);
        let of_runs = |errors: super::holdout::HeldOutErrors| {
            let (before, noise) = (errors.before?, self.recorded.noise_held_out?);
            let after = errors.after.unwrap_or(before);
            (before >= MIN_SIGNAL_RATIO * noise && after != before).then(|| (before - after) / (before - noise))
        };
        Some(TakenShare { blocks: blocks.min(1.0), runs: repair.errors.and_then(of_runs).map(|s| s.min(1.0)) })
    }

    /// The kind of memory that clearly explains more than a repair of other kinds, on what both have not seen.
    pub(crate) fn better_memory(&self, h: &HypothesisEvidence, repair: &RepairEvidence) -> Option<&FamilyResult> {
        let best = self.recorded.families.first()?;
        // The cause of a second effect has its own memory.
        let own: Vec<Family> = [Some(h.cause.as_str()), h.also.as_deref()].into_iter().flatten().flat_map(memory_of).collect();
        let sensor = h.channel_fault;
        if (own.is_empty() && !sensor) || is_visible(h) {
            return None;
        }
        let shape = self.recorded.families.iter().find(|f| f.family == Family::Shape.name());
        // What needs no memory is a matter of the law's shape, which many causes change.
        let remembers = best.family != Family::Shape.name() && shape.is_none_or(|s| s.behind > MEMORY_TIE);
        let ties = self.recorded.families.iter().any(|f| f.behind < MEMORY_TIE && own.iter().any(|o| o.name() == f.family));
        if ties || !remembers {
            return None;
        }
        let ratio = |repair: Option<f64>, family: Option<f64>| Some(repair? / family?.max(f64::MIN_POSITIVE));
        let blocks = ratio(h.device_held_back, Some(best.blocks))?;
        let runs = ratio(repair.device_held_out, best.held_out);
        let beats = match runs {
            Some(runs) => blocks.min(runs) > MEMORY_ERROR_RATIO,
            // Blocks alone say less.
            None => blocks > MEMORY_ERROR_RATIO * MEMORY_ERROR_RATIO,
        };
        beats.then_some(best)
    }

    /// Log odds of a cause by the distance of its kinds of memory from the best, at most 0, nats.
    ///
    /// They count where the best kind explains the device as well as the best cause of the library does.
    pub(crate) fn memory_log_odds(&self, cause: &str) -> f64 {
        let Some(best) = self.recorded.families.first() else { return 0.0 };
        let library = self.hypotheses.iter().filter_map(|h| h.device_held_back).fold(f64::INFINITY, f64::min);
        let behind = |f: &Family| {
            let of_family = self.recorded.families.iter().filter(|r| r.family == f.name());
            of_family.map(|r| r.behind).fold(f64::INFINITY, f64::min)
        };
        let own = memory_of(cause);
        let least = own.iter().map(behind).fold(f64::INFINITY, f64::min);
        if best.blocks > MEMORY_ERROR_RATIO * library || !least.is_finite() {
            return 0.0;
        }
        -MEMORY_LOG_ODDS * least.min(1.0)
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
        let tie = tie.and_then(|f| Family::of_name(&f.family)).map_or_else(String::new, |f| {
            format!(". As well explained is that {}", f.statement())
        });
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

fn memory_reason(f: &FamilyResult, h: &HypothesisEvidence, repair: &RepairEvidence) -> String {
    let statement = Family::of_name(&f.family).map_or("", Family::statement);
    let of_runs = match (f.held_out, repair.device_held_out) {
        (Some(own), Some(other)) => format!(", and {:.2e} in place of {other:.2e} of the runs held out", own),
        _ => String::new(),
    };
    format!(
        "{statement}, and a law that remembers this alone leaves {:.2e} in place of {:.2e} of blocks that were held back{of_runs}",
        f.blocks,
        h.device_held_back.unwrap_or(f64::NAN)
    )
}

//! Searches for physics from points of the whole range, where the baseline is poor.
//!
//! A resonance that the baseline misses is not found from its flanks, and a screening from there predicts nothing.

use super::fitted::FittedHypothesis;
use super::halton_points::halton_points;
use super::scheduler::Scheduler;
use super::search_settings::{GLOBAL_GROUPS, GLOBAL_POINTS, GLOBAL_STARTS_PER_CAUSE, MAX_GLOBAL_SAMPLES};
use crate::candidate::proposal::Proposal;
use crate::candidate::variant::Variant;
use hysteron_identify::study::{Role, Study};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Physics that is sought from the whole range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum GlobalScope {
    /// All of it.
    All,
    /// Parts of the structure that may be missing altogether. A fit from the user's values misses these most easily.
    MissingParts,
    /// Nothing.
    Nothing,
}

impl GlobalScope {
    /// The widest scope that the length of the fitted runs allows.
    pub(crate) fn affordable(study: &Study, proposals: &[Proposal]) -> Self {
        let searches = |scope: Self| proposals.iter().filter(|p| p.edits_script() && scope.has(p)).count();
        let scopes = [Self::All, Self::MissingParts];
        scopes.into_iter().find(|scope| is_affordable(study, searches(*scope))).unwrap_or(Self::Nothing)
    }

    fn has(self, proposal: &Proposal) -> bool {
        match self {
            Self::All => true,
            Self::MissingParts => proposal.is_missing_part,
            Self::Nothing => false,
        }
    }

    /// Returns true if a variant is sought. Faults of channels never are.
    pub(crate) fn contains(self, variant: &Variant) -> bool {
        !variant.is_channel_fault() && variant.proposal.as_ref().is_none_or(|p| self.has(p))
    }
}

/// Returns true if the fitted runs are short enough for a number of global searches.
pub(crate) fn is_affordable(study: &Study, searches: usize) -> bool {
    let samples: usize = study.runs_of(Role::Fit).map(|(_, r)| r.recording.times.len()).sum();
    samples * searches <= MAX_GLOBAL_SAMPLES
}

/// Searches from the best of evenly spread points. `fitted` gets new variants, and better optima of known ones.
pub(crate) fn global_search(
    scheduler: &mut Scheduler<'_>,
    stage: &str,
    baseline: &FittedHypothesis,
    variants: &[Arc<Variant>],
    iterations: usize,
    fitted: &mut Vec<FittedHypothesis>,
) -> Result<(), String> {
    let physics: Vec<&Arc<Variant>> = variants.iter().filter(|v| !v.is_channel_fault()).collect();
    // The best point of each group, because the best of all may lie in another valley.
    let groups = physics.iter().flat_map(|v| {
        let points = halton_points(&v.start(&baseline.fitted.values), 0, GLOBAL_POINTS);
        let group = move |g| points.iter().skip(g).step_by(GLOBAL_GROUPS).cloned().collect();
        (0..GLOBAL_GROUPS).map(move |g| ((*v).clone(), group(g)))
    });
    let mut starts = scheduler.best_points(stage, groups.collect())?;
    starts.sort_by(|a, b| a.expected_objective.total_cmp(&b.expected_objective));
    let mut starts_of_cause: BTreeMap<(&str, Option<&str>), usize> = BTreeMap::new();
    starts.retain(|s| {
        let count = starts_of_cause.entry((s.variant.cause(), s.variant.second_cause())).or_default();
        *count += 1;
        *count <= GLOBAL_STARTS_PER_CAUSE
    });
    for FittedHypothesis { variant, fitted: f, .. } in scheduler.search(stage, starts, iterations)? {
        match fitted.iter_mut().find(|e| Arc::ptr_eq(&e.variant, &variant)) {
            Some(known) if f.objective < known.fitted.objective => known.fitted = f,
            Some(_) => {}
            None => fitted.push(FittedHypothesis::new(variant, f)),
        }
    }
    Ok(())
}

//! A second effect beside the first.

use super::evidence::INDEPENDENT;
use super::insertion::Place;
use super::rounds::{SECOND_ROUND, tried};
use super::work::{Explained, Work};
use std::collections::BTreeSet;
use std::sync::Arc;

/// First effects beside which a second is sought, and how much less log evidence than the best they may have: what
/// leads alone may not lead when both have found their second.
const FIRSTS: usize = 3;
const RIVAL: f64 = 20.0;
/// Second effects that are fitted beside each of them.
const PAIRS: usize = 3;
/// Points at which a second effect is tried, for each of its parameters and beside them.
const TRIED: usize = 2;

/// Pairs that may tell more than their first alone. `weighed` are single explanations, best first; `first` those of the
/// first round.
pub(super) fn pairs(
    work: &mut Work<'_>,
    baseline: &Explained,
    weighed: &[Explained],
    first: &[Explained],
    place: &Place,
) -> Result<Vec<Explained>, String> {
    let stage = "a second effect";
    let single: Vec<&Explained> = weighed
        .iter()
        .filter(|e| e.cause() != "none" && e.evidence > weighed[0].evidence - RIVAL)
        .take(FIRSTS)
        .collect();
    // Where nothing is missing, no two things are.
    if weighed[0].cause() == "none" {
        return Ok(vec![]);
    }
    let own = baseline.variant.dimension();
    let mut out = vec![];
    for (n, one) in single.iter().enumerate() {
        let Some(proposal) = &one.variant.proposal else { continue };
        let done: Vec<&str> = single[..=n].iter().map(|e| e.cause()).collect();
        let mut all = vec![];
        // Every form: the best of a cause alone need not be the best beside another.
        for other in first.iter().filter(|e| !done.contains(&e.cause())) {
            let Some(two) = &other.variant.proposal else { continue };
            let Some(v) = baseline.variant.with(place, &proposal.with(two)) else { continue };
            let from = one.fitted.point.len();
            // Where the second was proposed to begin, and as it was fitted alone.
            let mut points = tried(&v.start(&one.fitted.values), from, TRIED);
            points.push([&one.fitted.point[..], &other.fitted.point[own..]].concat());
            all.push((Arc::new(v), points));
        }
        let mut screened = work.screen(stage, &one.variant, &one.fitted.point, all)?;
        // A search costs more than it can tell where nothing is to be expected of it.
        screened.retain(|s| 0.5 * INDEPENDENT * (one.score() - s.score()) > -1.0);
        let mut seconds = BTreeSet::new();
        screened.retain(|s| seconds.insert(s.variant.proposal.as_ref().and_then(|p| p.second)));
        screened.truncate(PAIRS);
        out.extend(work.search_all(stage, screened, SECOND_ROUND)?.into_iter().take(2));
    }
    work.hold_back(stage, &mut out)?;
    Ok(out)
}

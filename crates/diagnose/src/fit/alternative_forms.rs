//! Forms and locations of the leading causes that screening has not approximated well.

use super::fitted::{FittedHypothesis, ScreenedHypothesis, sort_by_score};
use super::halton_points::halton_points;
use super::scheduler::Scheduler;
use super::search_settings::{EXTENDED_FORM_POINTS, FIRST_ROUND_ITERATIONS, LEADING_CAUSES, NEIGHBOUR_EXPANSIONS};
use crate::candidate::variant::Variant;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// Fits unfitted forms that differ from the best form of a leading cause in form alone or in location alone.
///
/// Only causes with several locations take part. With a single location, screening has tried every form from nearby.
pub(crate) fn fit_neighbouring_forms(
    scheduler: &mut Scheduler<'_>,
    stage: &str,
    mut unfitted: Vec<ScreenedHypothesis>,
    fitted: &mut Vec<FittedHypothesis>,
) -> Result<(), String> {
    let mut locations: BTreeMap<&'static str, BTreeSet<&str>> = BTreeMap::new();
    let variants = unfitted.iter().map(|s| &s.variant).chain(fitted.iter().map(|e| &e.variant));
    for (cause, location) in variants.filter_map(|v| v.cause_and_location()) {
        locations.entry(cause).or_default().insert(location);
    }
    let several = |(cause, at): (&'static str, BTreeSet<&str>)| (at.len() > 1).then_some(cause);
    let movable: BTreeSet<&str> = locations.into_iter().filter_map(several).collect();
    unfitted.retain(|s| !s.variant.is_channel_fault() && movable.contains(s.variant.cause()));
    for _ in 0..NEIGHBOUR_EXPANSIONS {
        let (near, far) = neighbours_of_leaders(fitted, unfitted);
        // From the screened start or from the optimum of the leader, whichever is better.
        let points = |(s, leader): (ScreenedHypothesis, FittedHypothesis)| {
            let (own, best) = (leader.variant.own_coordinates(&leader.fitted.point).len(), &leader.fitted.point);
            let one_form = best.len() == s.start.len() && leader.variant.has_form_of(&s.variant);
            let added = if one_form { best } else { &s.start };
            (s.variant.clone(), vec![s.start.clone(), [&best[..own], &added[own..]].concat()])
        };
        let candidates = near.into_iter().map(points).collect();
        let starts = scheduler.best_points(stage, candidates)?;
        fitted.extend(scheduler.search(stage, starts, FIRST_ROUND_ITERATIONS)?);
        unfitted = far;
    }
    Ok(())
}

/// Hypotheses with the leader that they differ from in form alone or in location alone, and the others.
fn neighbours_of_leaders(
    fitted: &mut [FittedHypothesis],
    unfitted: Vec<ScreenedHypothesis>,
) -> (Vec<(ScreenedHypothesis, FittedHypothesis)>, Vec<ScreenedHypothesis>) {
    let leaders = leaders(fitted);
    let (mut near, mut far) = (vec![], vec![]);
    for s in unfitted {
        match leaders.iter().find(|l| l.variant.differs_in_form_or_location(&s.variant)) {
            Some(leader) => near.push((s, (*leader).clone())),
            None => far.push(s),
        }
    }
    (near, far)
}

/// The best of each of the [`LEADING_CAUSES`] first causes.
fn leaders(fitted: &mut [FittedHypothesis]) -> Vec<&FittedHypothesis> {
    sort_by_score(fitted);
    let mut leaders: Vec<&FittedHypothesis> = vec![];
    for e in fitted.iter() {
        if leaders.len() < LEADING_CAUSES && leaders.iter().all(|l| l.cause() != e.cause()) {
            leaders.push(e);
        }
    }
    leaders
}

/// Fits forms that extend the best form of a leading cause by parameters, from the optimum of the latter.
///
/// The right values of the further parameters reproduce the simpler form. An extended form with a larger error has therefore
/// ended in a local minimum, or was never sought.
pub(crate) fn fit_extended_forms(
    scheduler: &mut Scheduler<'_>,
    stage: &str,
    variants: &[Arc<Variant>],
    fitted: &mut Vec<FittedHypothesis>,
) -> Result<(), String> {
    let mut candidates = vec![];
    for leader in leaders(fitted).into_iter().cloned().collect::<Vec<_>>() {
        let behind = |v: &Arc<Variant>| {
            let known = fitted.iter().find(|e| Arc::ptr_eq(&e.variant, v));
            known.is_none_or(|e| e.fitted.objective > leader.fitted.objective)
        };
        for v in variants.iter().filter(|v| v.extends(&leader.variant) && behind(v)) {
            let simpler = leader.fitted.point.len();
            let start = [&leader.fitted.point[..], &v.start(&leader.fitted.values)[simpler..]].concat();
            candidates.push((v.clone(), halton_points(&start, simpler, EXTENDED_FORM_POINTS)));
        }
    }
    let starts = scheduler.best_points(stage, candidates)?;
    for e in scheduler.search(stage, starts, FIRST_ROUND_ITERATIONS)? {
        match fitted.iter_mut().find(|known| Arc::ptr_eq(&known.variant, &e.variant)) {
            Some(known) if e.fitted.objective < known.fitted.objective => *known = e,
            Some(_) => {}
            None => fitted.push(e),
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::neighbours_of_leaders;
    use crate::candidate::proposal::AddedParameter;
    use crate::fit::fitted::{FittedHypothesis, ScreenedHypothesis};
    use crate::inspect::insertion::InsertionPoint;
    use crate::test_support::{baseline, fitted_at, script_edit};
    use std::sync::Arc;

    #[test]
    fn neighbours_differ_in_form_alone_or_in_location_alone() {
        let variant = |cause, form: &str, place: &str| {
            let mut proposal = script_edit(cause, &["x"]);
            (proposal.form, proposal.location) = (form.into(), place.into());
            Arc::new(baseline().variant.with_proposal(&InsertionPoint::At(0), &proposal).expect("a variant"))
        };
        let mut fitted: Vec<FittedHypothesis> = ["here", "there"]
            .map(|place| {
                let mut e = fitted_at((*variant("gap_impact", "wall", place)).clone(), &[0.5]);
                e.fitted.objective = if place == "here" { 0.1 } else { 0.2 };
                e
            })
            .into();
        let forms =
            [("gap_impact", "two walls", "here"), ("gap_impact", "wall", "far"), ("gap_impact", "two walls", "far")];
        let others = [("friction", "wall", "here")];
        let left = forms.iter().chain(&others).map(|(cause, form, place)| ScreenedHypothesis {
            variant: variant(cause, form, place),
            start: vec![],
            expected_objective: 0.3,
        });
        let (near, far) = neighbours_of_leaders(&mut fitted, left.collect());
        let described = |all: &[ScreenedHypothesis]| -> Vec<String> {
            let of = |s: &ScreenedHypothesis| s.variant.proposal.as_ref().map(|p| format!("{} {}", p.form, p.location));
            all.iter().filter_map(of).collect()
        };
        let near: Vec<ScreenedHypothesis> = near.into_iter().map(|(s, _)| s).collect();
        assert_eq!(described(&near), ["two walls here", "wall far"]);
        assert_eq!(described(&far), ["two walls far", "wall here"]);
    }

    #[test]
    fn a_form_with_further_parameters_at_one_location_extends_another() {
        let variant = |cause, place: &str, names: &[&str]| {
            let mut proposal = script_edit(cause, names);
            proposal.location = place.into();
            baseline().variant.with_proposal(&InsertionPoint::At(0), &proposal).expect("a variant")
        };
        let simple = variant("foundation_flexibility", "here", &["sway"]);
        assert!(variant("foundation_flexibility", "here", &["sway", "rocking"]).extends(&simple));
        for (cause, place, names) in [
            ("foundation_flexibility", "here", &["sway"][..]),
            ("foundation_flexibility", "there", &["sway", "rocking"]),
            ("foundation_flexibility", "here", &["rocking", "sway"]),
            ("damping", "here", &["sway", "rocking"]),
        ] {
            assert!(!variant(cause, place, names).extends(&simple), "{cause} {place} {names:?}");
        }
        let mut narrow = script_edit("foundation_flexibility", &["sway", "rocking"]);
        (narrow.location, narrow.parameters[0]) = ("here".into(), AddedParameter::linear("sway", 0.1, 0.2, 0.15));
        assert!(
            !baseline().variant.with_proposal(&InsertionPoint::At(0), &narrow).expect("a variant").extends(&simple)
        );
    }
}

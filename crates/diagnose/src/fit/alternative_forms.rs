//! Forms and places of the first causes that the screening has not shown from near enough.

use crate::candidate::variant::Variant;
use crate::fit::scheduler::{Explained, Screened, Work};
use crate::fit::screening::{FIRST, tried};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// Where a cause can stand at several places, so few of its forms say little. Of so many of the first causes the neighbours of the best
/// form are fitted as well, and so often over, from the best of them (choices).
const ELSEWHERE: usize = 3;
const STEPS_ELSEWHERE: usize = 2;
/// Points at which a form is tried that contains a simpler one, for each parameter that it has more and beside them.
const NESTED_POINTS: usize = 4;

/// Of the first causes that stand at several places: their neighbours in form or place among those that are left.
pub(crate) fn elsewhere(
    work: &mut Work<'_>,
    stage: &str,
    mut left: Vec<Screened>,
    fitted: &mut Vec<Explained>,
) -> Result<(), String> {
    // Where there is one place the screening has seen the forms from as near as any other would be.
    let mut places: BTreeMap<&'static str, BTreeSet<&str>> = BTreeMap::new();
    for (cause, at) in
        left.iter().map(|s| &s.variant).chain(fitted.iter().map(|e| &e.variant)).filter_map(|v| v.place())
    {
        places.entry(cause).or_default().insert(at);
    }
    let several: BTreeSet<&str> = places.into_iter().filter(|(_, at)| at.len() > 1).map(|(cause, _)| cause).collect();
    left.retain(|s| !s.variant.of_a_channel() && several.contains(s.variant.cause()));
    for _ in 0..STEPS_ELSEWHERE {
        let (near, far) = neighbours(fitted, left);
        // From where the screening says or from where the best stands, whichever is nearer.
        let points = |(s, leader): (Screened, Explained)| {
            let (own, best) = (leader.variant.own(&leader.fitted.point).len(), &leader.fitted.point);
            let added =
                if best.len() == s.start.len() && leader.variant.same_form(&s.variant) { best } else { &s.start };
            (s.variant.clone(), vec![s.start.clone(), [&best[..own], &added[own..]].concat()])
        };
        let tried = near.into_iter().map(points).collect();
        let nearest = work.nearest(stage, tried)?;
        fitted.extend(work.search_all(stage, nearest, FIRST)?);
        left = far;
    }
    Ok(())
}

/// Those that differ from the best of one of the first causes in form alone or in place alone, with it, and the others.
fn neighbours(fitted: &mut [Explained], left: Vec<Screened>) -> (Vec<(Screened, Explained)>, Vec<Screened>) {
    let leaders = leaders(fitted);
    let (mut near, mut far) = (vec![], vec![]);
    for s in left {
        match leaders.iter().find(|l| l.variant.differs_in_one(&s.variant)) {
            Some(leader) => near.push((s, (*leader).clone())),
            None => far.push(s),
        }
    }
    (near, far)
}

/// The best of each of the first causes.
fn leaders(fitted: &mut [Explained]) -> Vec<&Explained> {
    fitted.sort_by(|a, b| a.score().total_cmp(&b.score()));
    let mut leaders: Vec<&Explained> = vec![];
    for e in fitted.iter() {
        if leaders.len() < ELSEWHERE && leaders.iter().all(|l| l.cause() != e.cause()) {
            leaders.push(e);
        }
    }
    leaders
}

/// A form with the parameters of a simpler one and some more comes as near as that with the right values of those. Where it has not, the
/// search for it has stuck, or it was not sought: of the first causes such forms are fitted from where the simpler one stands.
pub(crate) fn nested(
    work: &mut Work<'_>,
    stage: &str,
    variants: &[Arc<Variant>],
    fitted: &mut Vec<Explained>,
) -> Result<(), String> {
    let mut from = vec![];
    for leader in leaders(fitted).into_iter().cloned().collect::<Vec<_>>() {
        let behind = |v: &Arc<Variant>| {
            let known = fitted.iter().find(|e| Arc::ptr_eq(&e.variant, v));
            known.is_none_or(|e| e.fitted.objective > leader.fitted.objective)
        };
        for v in variants.iter().filter(|v| v.contains(&leader.variant) && behind(v)) {
            let simpler = leader.fitted.point.len();
            let start = [&leader.fitted.point[..], &v.start(&leader.fitted.values)[simpler..]].concat();
            from.push((v.clone(), tried(&start, simpler, NESTED_POINTS)));
        }
    }
    let nearest = work.nearest(stage, from)?;
    for e in work.search_all(stage, nearest, FIRST)? {
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
    use super::neighbours;
    use crate::fit::scheduler::{Explained, Screened};
    use crate::fit::two_effect_search::tests::{at, baseline, effect};
    use crate::hypothesis::Added;
    use crate::inspect::insertion::Place;
    use std::sync::Arc;

    #[test]
    fn the_best_form_is_followed_to_other_places_and_its_place_to_other_forms() {
        let variant = |cause, form: &str, place: &str| {
            let mut proposal = effect(cause, &["x"]);
            (proposal.form, proposal.at) = (form.into(), place.into());
            Arc::new(baseline().variant.with(&Place::At(0), &proposal).expect("a variant"))
        };
        let mut fitted: Vec<Explained> = ["here", "there"]
            .map(|place| {
                let mut e = at((*variant("gap_impact", "wall", place)).clone(), &[0.5]);
                e.fitted.objective = if place == "here" { 0.1 } else { 0.2 };
                e
            })
            .into();
        let forms =
            [("gap_impact", "two walls", "here"), ("gap_impact", "wall", "far"), ("gap_impact", "two walls", "far")];
        let others = [("friction", "wall", "here")];
        let left = forms.iter().chain(&others).map(|(cause, form, place)| Screened {
            variant: variant(cause, form, place),
            start: vec![],
            expected: 0.3,
        });
        let (near, far) = neighbours(&mut fitted, left.collect());
        let said = |all: &[Screened]| -> Vec<String> {
            let of = |s: &Screened| s.variant.proposal.as_ref().map(|p| format!("{} {}", p.form, p.at));
            all.iter().filter_map(of).collect()
        };
        let near: Vec<Screened> = near.into_iter().map(|(s, _)| s).collect();
        assert_eq!(said(&near), ["two walls here", "wall far"]);
        assert_eq!(said(&far), ["two walls far", "wall here"]);
    }

    #[test]
    fn a_form_with_more_parameters_at_the_same_place_contains_another() {
        let variant = |cause, place: &str, names: &[&str]| {
            let mut proposal = effect(cause, names);
            proposal.at = place.into();
            baseline().variant.with(&Place::At(0), &proposal).expect("a variant")
        };
        let simple = variant("foundation_flexibility", "here", &["sway"]);
        assert!(variant("foundation_flexibility", "here", &["sway", "rocking"]).contains(&simple));
        for (cause, place, names) in [
            ("foundation_flexibility", "here", &["sway"][..]),
            ("foundation_flexibility", "there", &["sway", "rocking"]),
            ("foundation_flexibility", "here", &["rocking", "sway"]),
            ("damping", "here", &["sway", "rocking"]),
        ] {
            assert!(!variant(cause, place, names).contains(&simple), "{cause} {place} {names:?}");
        }
        let mut narrow = effect("foundation_flexibility", &["sway", "rocking"]);
        (narrow.at, narrow.added[0]) = ("here".into(), Added::linear("sway", 0.1, 0.2, 0.15));
        assert!(!baseline().variant.with(&Place::At(0), &narrow).expect("a variant").contains(&simple));
    }
}

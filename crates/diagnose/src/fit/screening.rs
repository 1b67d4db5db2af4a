//! The rounds in which explanations are fitted, fewer and closer in each.

use crate::candidate::variant::Variant;
use crate::evidence::likelihood::{Noise, ahead};
use crate::evidence::parametric_bootstrap::{Bootstrap, Near, Rival, bootstrap};
use crate::fit::alternative_forms::{elsewhere, nested};
use crate::fit::evaluator::Fitted;
use crate::fit::scheduler::{Explained, LAST, Screened, Work};
use crate::hypothesis::{self, Proposal};
use crate::inspect::conditions::differ;
use crate::inspect::insertion::Place;
use hysteron_identify::calibrate::LevenbergMarquardt;
use hysteron_identify::study::{Opening, Role, Study};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// Proposals that are fitted after the screening, and of one cause.
const FIRST_ROUND: usize = 20;
const OF_A_CAUSE: usize = 3;
/// Of those of which nothing is to be expected, so many are fitted with the promising ones, and the rest after them, but
/// for faults of channels: the right one may show only once it has the right size. What is nothing, in log evidence.
const FITTED: usize = 8;
const EXPECTED: f64 = -3.0;
/// Points at which a proposal is tried, for each of its parameters and beside them: from the fitted model, and from the
/// user's values.
const TRIED: usize = 2;
const TRIED_AS_GIVEN: usize = 1;
/// Values that the user gave are tried as well where they are so far from the fitted ones, in sides of the cube.
const APART: f64 = 0.03;
/// Points at which a rival of the best explanation is tried again, for each of its parameters and beside them.
const TWIN_POINTS: usize = 8;
/// A baseline that leaves so much of the recordings says little about its own parameters: physics is tried at points of the
/// whole cube as well, so many for each parameter, the user's too, and beside them, of which the nearest in so many valleys
/// are tried, and so many of the nearest of each cause are followed (a choice). That takes tens of analyses a proposal: only where proposals times
/// samples are at most so many.
const POOR: f64 = 0.2;
/// The same where a parameter is at a bound; how near that is, in sides of the cube.
const POOR_AT_A_BOUND: f64 = 0.02;
const AT_A_BOUND: f64 = 1e-3;
const WIDE_POINTS: usize = 5;
const VALLEYS: usize = 2;
const FOLLOWED: usize = 4;
const WIDE_SAMPLES: usize = 100_000;
/// Where stick and slip or contact make the objective rough, derivatives over a narrow step tell of its ripples and searches stick. Wider
/// steps, in sides of the cube, that are tried for the model as it is, and the part by which it has to come nearer for all else to
/// be sought so as well (choices).
const WIDER: [f64; 2] = [1e-3, 1e-2];
const ROUGH: f64 = 0.02;
/// Iterations of a search: of the baseline, of the first round, of its searches from afar, of the second round.
const BASELINE: usize = 12;
pub(crate) const FIRST: usize = 4;
const WIDE: usize = 6;
pub(crate) const SECOND_ROUND: usize = 12;
/// Log odds, before anything is seen, of nothing missing against any one cause, of one effect against two, and of a channel
/// whose range is wrong in all runs against one of which it is so in a single one of several: where runs differ in axial load, speed
/// or temperature, a law that asks for that explains them without a coincidence.
const NOTHING: f64 = 3.0;
pub(crate) const SECOND: f64 = 6.0;
const OF_ONE_RUN: f64 = 8.0;
/// Log evidence within which two forms of a cause explain as much.
const AS_MUCH: f64 = 0.5;

/// Points of the coordinates from a number on: the first where the proposal starts, the others spread evenly.
pub(crate) fn tried(start: &[f64], from: usize, of_a_parameter: usize) -> Vec<Vec<f64>> {
    const BASES: [usize; 12] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37];
    let n = start.len() - from;
    // Halton (1960).
    let radical_inverse = |mut i: usize, base: usize| {
        let (mut out, mut digit) = (0.0, 1.0 / base as f64);
        while i > 0 {
            out += (i % base) as f64 * digit;
            i /= base;
            digit /= base as f64;
        }
        out
    };
    let spread = |i: usize| -> Vec<f64> {
        let at = |k: usize| if k < BASES.len() { radical_inverse(i, BASES[k]) } else { start[from + k] };
        start[..from].iter().copied().chain((0..n).map(at)).collect()
    };
    // A zero that wanders starts from nothing: with many coordinates a point at random is of no use.
    let more = if n > BASES.len() { 0 } else { of_a_parameter * (n + 1) };
    std::iter::once(start.to_vec()).chain((1..=more).map(spread)).collect()
}

/// The user's model by least squares, from its own values and from others.
pub(crate) fn fit_baseline(work: &mut Work<'_>, opening: &Opening, text: &str) -> Result<Explained, String> {
    let variant = Arc::new(Variant::baseline(&work.study, text));
    let n = variant.dimension();
    let mut starts = vec![work.study.space.point(&opening.values)];
    // Opposite corners of a smaller cube, and its middle.
    starts.push(vec![0.5; n]);
    for k in 0..4usize {
        starts.push((0..n).map(|i| if (i + k) % 2 == k / 2 { 0.2 } else { 0.8 }).collect());
    }
    let jobs = starts.into_iter().map(|s| Work::search(&variant, s, BASELINE)).collect();
    let fitted = work.fit("the model as it is", jobs)?.into_iter().flatten();
    let mut sorted: Vec<Fitted> = fitted.collect();
    sorted.sort_by(|a, b| a.objective.total_cmp(&b.objective));
    let closely = |f: &Fitted| Work::search(&variant, f.point.clone(), LAST);
    let narrow = work.fit("the model as it is", sorted.first().map(closely).into_iter().collect())?.pop().flatten();
    let narrow = narrow.ok_or("the model has no answer for any values of its parameters")?;
    let mut best = (LevenbergMarquardt::STEP, narrow.clone());
    sorted[0] = narrow;
    for width in WIDER {
        work.bench.widen(width);
        let again = work.fit("the model as it is", sorted.iter().take(VALLEYS).map(closely).collect())?;
        let again = again.into_iter().flatten().min_by(|a, b| a.objective.total_cmp(&b.objective));
        if let Some(f) = again.filter(|f| f.objective < (1.0 - ROUGH) * best.1.objective) {
            best = (width, f);
        }
    }
    work.bench.widen(best.0);
    Ok(Explained::new(variant, best.1))
}

/// Whether a fitted model leaves so much that little is to be believed of its parameters, or much and has a parameter at a bound:
/// it would go on from there to make up for what is missing.
pub(crate) fn poor(baseline: &Explained) -> bool {
    let bound = |p: &f64| *p < AT_A_BOUND || *p > 1.0 - AT_A_BOUND;
    let left = baseline.fitted.objective;
    left > POOR || left > POOR_AT_A_BOUND && baseline.fitted.point.iter().any(bound)
}

/// The fitted model once more, with steps of another length.
pub(crate) fn refit(work: &mut Work<'_>, baseline: &Explained) -> Result<Explained, String> {
    let again = Work::search(&baseline.variant, baseline.fitted.point.clone(), LAST);
    let fitted = work.fit("the model as it is", vec![again])?.pop().flatten();
    let fitted = fitted.ok_or("the model has no answer with shorter steps")?;
    Ok(Explained::new(baseline.variant.clone(), fitted))
}

/// Every proposal screened, and the likeliest fitted once, physics from afar as well if it is `wide`: best objective first.
pub(crate) fn first_round(
    work: &mut Work<'_>,
    baseline: &Explained,
    opening: &Opening,
    place: &Place,
    proposals: &[Proposal],
    wide: bool,
) -> Result<Vec<Explained>, String> {
    let own = baseline.variant.dimension();
    let stage = "what may have been left out";
    let variants: Vec<_> = proposals.iter().filter_map(|p| baseline.variant.with(place, p)).map(Arc::new).collect();
    let points = |n: usize| -> Vec<_> {
        let of = |v: &Variant| {
            let fitted = &baseline.fitted.values;
            [tried(&v.start(fitted), own, n), v.further_starts(fitted)].concat()
        };
        variants.iter().map(|v| (v.clone(), of(v))).collect()
    };
    let mut screened = work.screen(stage, &baseline.variant, &baseline.fitted.point, points(TRIED))?;
    // The fit may have swallowed what is missing: the values that the user gave have not.
    let given = work.study.space.point(&opening.values);
    let apart = given.iter().zip(&baseline.fitted.point).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    if apart > APART {
        screened.extend(work.screen(stage, &baseline.variant, &given, points(TRIED_AS_GIVEN))?);
        screened.sort_by(|a, b| a.score().total_cmp(&b.score()));
        let mut seen = BTreeSet::new();
        screened.retain(|s| seen.insert(Arc::as_ptr(&s.variant)));
    }
    // The best of each cause, then its further forms.
    let mut of_a_cause: BTreeMap<&str, usize> = BTreeMap::new();
    let (mut ranked, mut further, mut left) = (vec![], vec![], vec![]);
    for s in screened {
        let form = of_a_cause.entry(s.variant.cause()).or_default();
        *form += 1;
        match *form {
            1 => ranked.push(s),
            2..=OF_A_CAUSE => further.push(s),
            _ => left.push(s),
        }
    }
    ranked.append(&mut further);
    let promising = |s: &Screened| ahead(s.score(), baseline.score()) > EXPECTED;
    let (mut picked, mut others) = (vec![], vec![]);
    for (place, s) in ranked.into_iter().enumerate() {
        if place < FITTED || promising(&s) {
            picked.push(s);
        } else if !s.variant.of_a_channel() {
            others.push(s);
        }
    }
    picked.truncate(FIRST_ROUND);
    let mut fitted = work.search_all(stage, picked, FIRST)?;
    // The screening has followed the fault of a channel to where it is best, but not physics: from the values that the user gave as well.
    let afresh = others.iter().map(|s| {
        let start = [&given[..], &s.variant.start(&baseline.fitted.values)[own..]].concat();
        Screened { start, ..s.clone() }
    });
    let mut all = if apart > APART { afresh.collect() } else { vec![] };
    all.append(&mut others);
    fitted.extend(work.search_all(stage, all, FIRST)?);
    elsewhere(work, stage, left, &mut fitted)?;
    nested(work, stage, &variants, &mut fitted)?;
    if wide {
        widely(work, stage, baseline, &variants, WIDE, &mut fitted)?;
    }
    fitted.sort_by(|a, b| a.score().total_cmp(&b.score()));
    // What was sought from two points is known once.
    let mut seen = BTreeSet::new();
    fitted.retain(|e| seen.insert(Arc::as_ptr(&e.variant)));
    Ok(fitted)
}

/// Whether the fitted runs are short enough that so many searches from points of the whole cube can be waited for.
pub(crate) fn within_reach(study: &Study, searches: usize) -> bool {
    let samples: usize = study.runs_of(Role::Fit).map(|(_, r)| r.recording.times.len()).sum();
    samples * searches <= WIDE_SAMPLES
}

/// Search for physics from the nearest of points of the whole cube: a resonance that is missed is not found from its flanks,
/// and a screening from there says nothing of it. The best of the searches of a variant stays.
pub(crate) fn widely(
    work: &mut Work<'_>,
    stage: &str,
    baseline: &Explained,
    variants: &[Arc<Variant>],
    iterations: usize,
    all: &mut Vec<Explained>,
) -> Result<(), String> {
    let physics: Vec<&Arc<Variant>> = variants.iter().filter(|v| !v.of_a_channel()).collect();
    // The nearest of each of some groups of points: the nearest of all may lie in another valley.
    let groups = physics.iter().flat_map(|v| {
        let points = tried(&v.start(&baseline.fitted.values), 0, WIDE_POINTS);
        let group = move |g| points.iter().skip(g).step_by(VALLEYS).cloned().collect();
        (0..VALLEYS).map(move |g| ((*v).clone(), group(g)))
    });
    let mut nearest = work.nearest(stage, groups.collect())?;
    nearest.sort_by(|a, b| a.expected.total_cmp(&b.expected));
    let mut of_a_cause: BTreeMap<(&str, Option<&str>), usize> = BTreeMap::new();
    nearest.retain(|s| {
        let followed = of_a_cause.entry((s.variant.cause(), s.variant.second())).or_default();
        *followed += 1;
        *followed <= FOLLOWED
    });
    for Explained { variant, fitted: f, .. } in work.search_all(stage, nearest, iterations)? {
        match all.iter_mut().find(|e| Arc::ptr_eq(&e.variant, &variant)) {
            Some(known) if f.objective < known.fitted.objective => known.fitted = f,
            Some(_) => {}
            None => all.push(Explained::new(variant, f)),
        }
    }
    Ok(())
}

/// Search again for what looks like the best explanation: its rivals are worth it, contact and slack have many valleys, and
/// where the best one stands the user's own parameters are nearer to what they are beside its rivals than without any.
pub(crate) fn twins(work: &mut Work<'_>, baseline: &Explained, first: &mut [Explained]) -> Result<(), String> {
    let own = baseline.variant.dimension();
    let Some(best) = first.first().filter(|e| e.score() < baseline.score()).cloned() else { return Ok(()) };
    let stage = "what looks like the best of them";
    let rivals = first.iter().filter(|e| hypothesis::alike(e.cause(), best.cause()));
    let points = |e: &Explained| {
        let start = [&best.fitted.point[..own], &e.fitted.point[own..]].concat();
        (e.variant.clone(), tried(&start, own, TWIN_POINTS))
    };
    let tried = rivals.map(points).collect();
    let nearest = work.nearest(stage, tried)?;
    for Explained { variant, fitted: f, .. } in work.search_all(stage, nearest, FIRST)? {
        if let Some(e) =
            first.iter_mut().find(|e| Arc::ptr_eq(&e.variant, &variant) && f.objective < e.fitted.objective)
        {
            e.fitted = f;
        }
    }
    first.sort_by(|a, b| a.score().total_cmp(&b.score()));
    Ok(())
}

/// The best form of each cause, and the second one of the first cause and its rivals, in their order: what is the best form
/// alone need not be beside another effect.
pub(crate) fn best_of_causes(sorted: &[Explained]) -> Vec<Explained> {
    let mut seen: BTreeMap<&str, usize> = BTreeMap::new();
    let first = sorted.first().map_or("none", Explained::cause);
    let wanted = |e: &&Explained| {
        let forms = seen.entry(e.cause()).or_default();
        *forms += 1;
        *forms <= if e.cause() == first || hypothesis::alike(e.cause(), first) { 2 } else { 1 }
    };
    sorted.iter().filter(wanted).cloned().collect()
}

/// Those of the first causes, so many, with all their forms.
pub(crate) fn of_so_many_causes(sorted: &[Explained], most: usize) -> Vec<Explained> {
    let mut causes = BTreeSet::new();
    let wanted = |e: &&Explained| causes.contains(e.cause()) || causes.len() < most && causes.insert(e.cause());
    sorted.iter().filter(wanted).cloned().collect()
}

/// Explanations fitted more closely.
pub(crate) fn refine(work: &mut Work<'_>, stage: &str, all: Vec<Explained>) -> Result<Vec<Explained>, String> {
    let jobs = all.iter().map(|e| Work::search(&e.variant, e.fitted.point.clone(), SECOND_ROUND));
    let fitted = work.fit(stage, jobs.collect())?;
    let better = |(e, f)| match f {
        Some(f) => Explained { fitted: f, ..e },
        None => e,
    };
    Ok(all.into_iter().zip(fitted).map(better).collect())
}

/// Evidence of explanations on samples that they did not see, by the noise that the best of them leaves: best first.
pub(crate) fn weigh(all: &mut [Explained]) -> Result<(), String> {
    let seen = all.iter().filter(|e| e.held.is_some());
    let best = seen.min_by(|a, b| a.score().total_cmp(&b.score())).and_then(|e| e.held.as_ref());
    let noise = Noise::of(best.ok_or("no explanation could be tested on samples that it was not fitted to")?);
    for e in all.iter_mut() {
        e.evidence =
            e.held.as_ref().map_or(f64::NEG_INFINITY, |r| before(e) + noise.evidence(r, e.variant.dimension()));
    }
    all.sort_by(|a, b| b.evidence.total_cmp(&a.evidence));
    foremost_in_the_middle(all);
    Ok(())
}

/// Of the forms of the first cause that explain as much, the one comes first whose model stands nearest to the middle of what the
/// user holds possible: in which of two runs a range is wrong may be told by nothing else.
fn foremost_in_the_middle(all: &mut [Explained]) {
    let Some(first) = all.first() else { return };
    let off = |e: &Explained| e.variant.own(&e.fitted.point).iter().map(|x| (x - 0.5) * (x - 0.5)).sum::<f64>();
    let equal = all.iter().enumerate().filter(|(_, e)| as_much(e, first));
    let nearest = equal.min_by(|(_, a), (_, b)| off(a).total_cmp(&off(b))).map(|(n, _)| n);
    if let Some(n) = nearest {
        all[..=n].rotate_right(1);
    }
}

/// Whether an explanation explains as much as another of its cause.
pub(crate) fn as_much(one: &Explained, other: &Explained) -> bool {
    let seconds = |e: &Explained| (e.cause(), e.second());
    seconds(one) == seconds(other) && (one.evidence - other.evidence).abs() < AS_MUCH
}

/// Log odds of an explanation before anything is seen: that nothing is missing is what is to be believed first, and two effects
/// last.
fn before(e: &Explained) -> f64 {
    let odds = match (e.cause(), e.second()) {
        ("none", _) => NOTHING,
        (_, Some(_)) => -SECOND,
        _ => 0.0,
    };
    let unseen = e.variant.seen() == 0.0 && e.variant.of_one_run() && differ(&e.variant.study);
    odds + e.variant.known() - if unseen { OF_ONE_RUN } else { 0.0 }
}

/// What explanations would say of recordings that one of them makes: those that were weighed, the likeliest first, and the best of
/// the causes that were not.
pub(crate) fn made_again(
    work: &mut Work<'_>,
    weighed: &[Explained],
    best: &[Explained],
) -> Result<Option<Bootstrap>, String> {
    // What a recording shows by itself no noise makes.
    if weighed[0].variant.seen() > 0.0 {
        return Ok(None);
    }
    let known: BTreeSet<&str> = weighed.iter().map(Explained::cause).collect();
    let more = best.iter().filter(|e| !known.contains(e.cause()));
    let all: Vec<&Explained> = weighed.iter().chain(more).collect();
    let near = work.near("recordings as they might have been", &all)?;
    let rival = |(e, near): (&&Explained, Option<Near>)| {
        Some(Rival { cause: e.cause(), before: before(e), point: e.fitted.point.clone(), near: near? })
    };
    let rivals: Vec<Rival> = all.iter().zip(near).filter_map(rival).collect();
    let leads = rivals.first().is_some_and(|r| r.cause == weighed[0].cause());
    Ok(if leads { bootstrap(&rivals) } else { None })
}

#[cfg(test)]
mod tests {
    use super::{foremost_in_the_middle, of_so_many_causes};
    use crate::fit::scheduler::Explained;
    use crate::fit::two_effect_search::tests::{at, baseline, effect};
    use crate::inspect::insertion::Place;

    /// Explanations by their cause, evidence and where the user's own parameters stand.
    fn explained(of: &[(&'static str, f64, f64)]) -> Vec<Explained> {
        let baseline = baseline();
        let own = baseline.variant.dimension();
        let one = |(cause, evidence, place): &(&'static str, f64, f64)| {
            let variant = baseline.variant.with(&Place::At(0), &effect(cause, &["x"])).expect("a variant");
            let mut e = at(variant, &[0.5]);
            e.fitted.point[..own].fill(*place);
            e.evidence = *evidence;
            e
        };
        of.iter().map(one).collect()
    }

    #[test]
    fn of_what_explains_as_much_the_middle_comes_first() {
        let order = |of: &[(&'static str, f64, f64)]| {
            let mut all = explained(of);
            foremost_in_the_middle(&mut all);
            all.iter().map(|e| (e.cause(), e.evidence)).collect::<Vec<_>>()
        };
        let near = order(&[("friction", 9.0, 0.1), ("damping", 8.9, 0.5), ("friction", 8.8, 0.4)]);
        assert_eq!(near, [("friction", 8.8), ("friction", 9.0), ("damping", 8.9)]);
        // What explains less does not, wherever it stands.
        let far = order(&[("friction", 9.0, 0.1), ("friction", 8.0, 0.5)]);
        assert_eq!(far, [("friction", 9.0), ("friction", 8.0)]);
    }

    #[test]
    fn second_forms_take_no_places_of_causes() {
        let all =
            explained(&[("friction", 9.0, 0.5), ("friction", 8.0, 0.5), ("damping", 7.0, 0.5), ("torsion", 6.0, 0.5)]);
        let causes = |most| of_so_many_causes(&all, most).iter().map(Explained::cause).collect::<Vec<_>>();
        assert_eq!(causes(2), ["friction", "friction", "damping"]);
        assert_eq!(causes(9).len(), 4);
    }
}

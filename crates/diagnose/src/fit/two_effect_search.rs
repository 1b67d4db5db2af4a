//! A second effect beside the first.

use crate::candidate::variant::Variant;
use crate::evidence::likelihood::ahead;
use crate::fit::evaluator::Fitted;
use crate::fit::scheduler::{Explained, Work};
use crate::fit::screening::{SECOND, SECOND_ROUND, poor, refine, tried, widely, within_reach};
use crate::inspect::insertion::Place;
use std::collections::BTreeSet;
use std::sync::Arc;

/// First effects beside which a second is sought, and how much less log evidence than the best they may have: what
/// leads alone may not lead when both have found their second.
const FIRSTS: usize = 3;
const RIVAL: f64 = 20.0;
/// Second effects that are fitted beside each of them.
const PAIRS: usize = 3;
/// Of those so many may be the best.
const KEPT: usize = 2;
/// Points at which a second effect is tried, for each of its parameters and beside them.
const TRIED: usize = 2;
/// Effects of pairs beside which others are tried in the place of the second one, at most.
const EXCHANGES: usize = 4;
/// What is screened has steps of so many times the length that the fits have, where those are made in parts: what is to be expected of
/// a second effect is told well enough by them (a choice).
const ROUGHLY: u32 = 4;
const STAGE: &str = "a second effect";

/// Two effects that have been fitted together, and which of the first round they are, in their order.
struct Pair {
    explained: Explained,
    of: [usize; 2],
}

impl Pair {
    /// By how much it tells more than a single effect, in log evidence.
    fn ahead(&self, single: &Explained) -> f64 {
        ahead(self.explained.score(), single.score())
    }
}

/// Where an effect stands alone, or in a pair.
struct Stands {
    /// Which of the first round it is.
    effect: usize,
    explained: Explained,
}

/// What pairs are made of.
struct Makings<'a> {
    baseline: &'a Explained,
    /// Single explanations, those of the first round: best first.
    first: &'a [Explained],
    place: &'a Place,
    /// Second effects are sought from points of the whole cube as well.
    wide: bool,
}

/// Pairs that may tell more than their first alone. `weighed` are single explanations, best first; `first` those of the
/// first round.
pub(crate) fn pairs(
    work: &mut Work<'_>,
    baseline: &Explained,
    weighed: &[Explained],
    first: &[Explained],
    place: &Place,
) -> Result<Vec<Explained>, String> {
    // From where a poor baseline stands the second effect may not be found: then also from afar.
    let wide = poor(baseline) && within_reach(&work.study, PAIRS * (FIRSTS + EXCHANGES));
    let makings = Makings { baseline, first, place, wide };
    let rivals = weighed.iter().filter(|e| e.cause() != "none" && e.evidence > weighed[0].evidence - RIVAL);
    let known = |e: &Explained| first.iter().position(|f| Arc::ptr_eq(&f.variant, &e.variant));
    let stands = |e: &Explained| known(e).map(|effect| Stands { effect, explained: e.clone() });
    let single: Vec<Stands> = rivals.take(FIRSTS).filter_map(stands).collect();
    let mut out = vec![];
    let mut searched = BTreeSet::new();
    for (n, one) in single.iter().enumerate() {
        let done: Vec<&str> = single[..=n].iter().map(|s| s.explained.cause()).collect();
        out.extend(makings.beside(work, one, |_, e| !done.contains(&e.cause()))?);
        searched.insert(one.effect);
    }
    // Where two tell more than one, the next form of each first is worth it as well.
    if leading(&out).is_some_and(|p| p.ahead(&weighed[0]) > SECOND) {
        let causes: BTreeSet<&str> = single.iter().map(|s| s.explained.cause()).collect();
        let next = |cause: &&str| (0..first.len()).find(|n| first[*n].cause() == *cause && !searched.contains(n));
        let forms: Vec<usize> = causes.iter().filter_map(next).collect();
        let fitted = refine(work, STAGE, forms.iter().map(|n| first[*n].clone()).collect())?;
        for (effect, explained) in forms.into_iter().zip(fitted) {
            let one = Stands { effect, explained };
            let more = makings.beside(work, &one, |n, _| is_new(&out, effect, n))?;
            out.extend(more.into_iter().filter_map(|p| makings.in_order(p)));
            searched.insert(effect);
        }
    }
    makings.exchange(work, &weighed[0], searched, &mut out)?;
    let mut out: Vec<Explained> = out.into_iter().map(|p| p.explained).collect();
    work.hold_back(STAGE, &mut out)?;
    Ok(out)
}

/// Whether two effects have not been fitted together yet.
fn is_new(all: &[Pair], one: usize, two: usize) -> bool {
    all.iter().all(|p| p.of != [one, two] && p.of != [two, one])
}

/// The pair with the best score.
fn leading(all: &[Pair]) -> Option<&Pair> {
    all.iter().min_by(|a, b| a.explained.score().total_cmp(&b.explained.score()))
}

impl Makings<'_> {
    /// Other effects are tried beside each of the two of the pair that leads: what is the best beside the one need not have been
    /// among the best alone.
    fn exchange(
        &self,
        work: &mut Work<'_>,
        single: &Explained,
        mut searched: BTreeSet<usize>,
        all: &mut Vec<Pair>,
    ) -> Result<(), String> {
        for _ in 0..EXCHANGES {
            let Some(best) = leading(all).filter(|p| p.ahead(single) > SECOND) else { break };
            let Some(side) = (0..2).find(|side| !searched.contains(&best.of[*side])) else { break };
            searched.insert(best.of[side]);
            let Some(one) = self.taken_from(best, side) else { continue };
            let more = self.beside(work, &one, |n, _| is_new(all, one.effect, n))?;
            all.extend(more.into_iter().filter_map(|p| self.in_order(p)));
        }
        Ok(())
    }

    /// One effect of a pair, where it stands in it.
    fn taken_from(&self, pair: &Pair, side: usize) -> Option<Stands> {
        let alone = &self.first[pair.of[side]];
        let [own, first, second] = self.parts(&pair.explained, pair.of);
        let point = [own, [first, second][side]].concat();
        let values = alone.variant.study.space.values(&point).ok()?;
        let fitted = Fitted { point, values, ..alone.fitted.clone() };
        Some(Stands { effect: pair.of[side], explained: Explained { fitted, ..alone.clone() } })
    }

    /// Coordinates of the user's own parameters where a pair stands, and of each of its effects.
    fn parts<'p>(&self, pair: &'p Explained, of: [usize; 2]) -> [&'p [f64]; 3] {
        let own = self.baseline.variant.dimension();
        let (both, second) = pair.fitted.point.split_at(self.first[of[0]].variant.dimension());
        let (own, first) = both.split_at(own);
        [own, first, second]
    }

    /// Of two effects the one that tells more alone comes first.
    fn in_order(&self, pair: Pair) -> Option<Pair> {
        let [one, two] = pair.of;
        let rank = |n: usize| self.first.iter().position(|e| e.cause() == self.first[n].cause());
        if rank(one) < rank(two) {
            return Some(pair);
        }
        let proposal = |n: usize| self.first[n].variant.proposal.as_ref();
        let variant = self.baseline.variant.with(self.place, &proposal(two)?.with(proposal(one)?))?;
        let [own, first, second] = self.parts(&pair.explained, pair.of);
        let point = [own, second, first].concat();
        let values = variant.study.space.values(&point).ok()?;
        let fitted = Fitted { point, values, ..pair.explained.fitted };
        Some(Pair { explained: Explained::new(Arc::new(variant), fitted), of: [two, one] })
    }

    /// The likeliest beside one of those of the first round that are wanted, and not of its cause.
    fn beside(
        &self,
        work: &mut Work<'_>,
        one: &Stands,
        wanted: impl Fn(usize, &Explained) -> bool,
    ) -> Result<Vec<Pair>, String> {
        let own = self.baseline.variant.dimension();
        let Some(proposal) = &one.explained.variant.proposal else { return Ok(vec![]) };
        let (variant, point) = (&one.explained.variant, &one.explained.fitted.point);
        let (mut all, mut others) = (vec![], vec![]);
        // Every form: the best of a cause alone need not be the best beside another.
        for (n, other) in
            self.first.iter().enumerate().filter(|(n, e)| e.cause() != one.explained.cause() && wanted(*n, e))
        {
            let Some(two) = &other.variant.proposal else { continue };
            let Some(v) = self.baseline.variant.with(self.place, &proposal.with(two)) else { continue };
            // Where the second was proposed to begin, and as it was fitted alone.
            let mut points = tried(&v.start(&one.explained.fitted.values), point.len(), TRIED);
            points.push([&point[..], &other.fitted.point[own..]].concat());
            let v = Arc::new(v);
            others.push((v.clone(), n));
            all.push((v, points));
        }
        let parts = work.bench.parts();
        let Some(roughly) = work.with_steps_in(STAGE, parts.div_ceil(ROUGHLY), &one.explained)? else {
            work.bench.refine(parts);
            return Ok(vec![]);
        };
        let mut screened = work.screen(STAGE, variant, point, all)?;
        work.bench.refine(parts);
        // A search costs more than it can tell where nothing is to be expected of it.
        let score = Explained { fitted: roughly, ..one.explained.clone() }.score();
        screened.retain(|s| ahead(s.score(), score) > -1.0);
        let mut seconds = BTreeSet::new();
        screened.retain(|s| seconds.insert(s.variant.proposal.as_ref().and_then(|p| p.second)));
        screened.truncate(PAIRS);
        let variants: Vec<Arc<Variant>> = screened.iter().map(|s| s.variant.clone()).collect();
        let mut found = work.search_all(STAGE, screened, SECOND_ROUND)?;
        if self.wide {
            widely(work, STAGE, self.baseline, &variants, SECOND_ROUND, &mut found)?;
            found.sort_by(|a, b| a.score().total_cmp(&b.score()));
        }
        let pair = |explained: Explained| {
            let (_, other) = others.iter().find(|(v, _)| Arc::ptr_eq(v, &explained.variant))?;
            Some(Pair { explained, of: [one.effect, *other] })
        };
        Ok(found.into_iter().take(KEPT).filter_map(pair).collect())
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::{Makings, Pair};
    use crate::candidate::variant::Variant;
    use crate::fit::evaluator::Fitted;
    use crate::fit::scheduler::Explained;
    use crate::hypothesis::{Added, Proposal};
    use crate::inspect::insertion::Place;
    use hysteron_identify::study::Study;
    use hysteron_tcl::diagnostic::SourceMap;
    use std::path::Path;
    use std::sync::Arc;

    pub(crate) fn at(variant: Variant, added: &[f64]) -> Explained {
        let own = variant.dimension() - added.len();
        let point = [&vec![0.5; own][..], added].concat();
        let values = variant.study.space.values(&point).expect("values");
        Explained::new(Arc::new(variant), Fitted { point, values, objective: 1.0, fits: vec![] })
    }

    pub(crate) fn baseline() -> Explained {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tcl-like-inputs/pad_study/study.toml");
        let study = Arc::new(Study::load(&file, &mut SourceMap::default()).expect("a study"));
        at(Variant::baseline(&study, "analyze 1\n"), &[])
    }

    pub(crate) fn effect(cause: &'static str, names: &[&str]) -> Proposal {
        let added = names.iter().map(|n| Added::linear(n, 0.0, 1.0, 0.5)).collect();
        let block = names.iter().map(|n| format!("{n} $hy_{n}")).collect();
        Proposal::edit(cause, cause, "element 1".into(), block, added)
    }

    /// A pair that is turned round keeps the values of all its parameters, and each effect its own.
    #[test]
    fn a_pair_may_be_turned_round() {
        let baseline = baseline();
        let place = Place::At(0);
        let (friction, damping) = (effect("friction", &["force"]), effect("damping", &["c", "n"]));
        let with = |p: &Proposal| baseline.variant.with(&place, p).expect("a variant");
        let first = [at(with(&friction), &[0.1]), at(with(&damping), &[0.2, 0.3])];
        let makings = Makings { baseline: &baseline, first: &first, place: &place, wide: false };
        let pair = Pair { explained: at(with(&damping.with(&friction)), &[0.7, 0.8, 0.9]), of: [1, 0] };
        let turned = makings.in_order(pair).expect("a pair");
        assert_eq!(
            (turned.of, turned.explained.cause(), turned.explained.second()),
            ([0, 1], "friction", Some("damping"))
        );
        let e = &turned.explained;
        let value = |name: &str| {
            let parameters = &e.variant.study.space.parameters;
            parameters.iter().position(|p| p.name == name).map(|i| e.fitted.values[i])
        };
        assert_eq!([value("hy_force"), value("hy2_c"), value("hy2_n")], [Some(0.9), Some(0.7), Some(0.8)]);
        assert_eq!(e.fitted.values[..baseline.fitted.values.len()], baseline.fitted.values);
        let own = baseline.variant.dimension();
        let alone = |side| makings.taken_from(&turned, side).expect("an effect").explained;
        assert_eq!(alone(0).fitted.point[own..], [0.9]);
        assert_eq!(alone(1).fitted.point[own..], [0.7, 0.8]);
        // In its order already: as it is.
        assert_eq!(makings.in_order(turned).expect("a pair").of, [0, 1]);
    }
}

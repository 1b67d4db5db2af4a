//! Search for a second effect beside the first.

use super::baseline::is_poor;
use super::fitted::{FittedHypothesis, approximate_gain, sort_by_score};
use super::global_search::{global_search, is_affordable};
use super::halton_points::halton_points;
use super::job::FittedModel;
use super::scheduler::{Scheduler, VariantPoints};
use super::search_settings::{
    FIRST_EFFECTS, KEPT_PAIRS, MAX_EXCHANGES, MAX_FIRST_EFFECT_DEFICIT, MIN_EXPECTED_PAIR_GAIN, SCREENING_STEP_RATIO,
    SECOND_EFFECT_POINTS, SECOND_EFFECTS, SECOND_ROUND_ITERATIONS,
};
use crate::candidate::variant::Variant;
use crate::inspect::insertion::InsertionPoint;
use crate::prior::ONE_EFFECT_LOG_ODDS;
use std::collections::BTreeSet;
use std::sync::Arc;

const STAGE: &str = "a second effect";

/// Two effects fitted together.
struct EffectPair {
    hypothesis: FittedHypothesis,
    /// Indices of both among the single effects, in their order in the variant.
    effects: [usize; 2],
}

impl EffectPair {
    /// Approximate log evidence over a single effect.
    fn gain(&self, single: &FittedHypothesis) -> f64 {
        approximate_gain(self.hypothesis.score(), single.score())
    }
}

/// An effect at an optimum: its own, or that of a pair.
struct PlacedEffect {
    /// Index among the single effects.
    effect: usize,
    hypothesis: FittedHypothesis,
}

/// Basis of the search for pairs.
struct PairSearch<'a> {
    baseline: &'a FittedHypothesis,
    /// Single effects of the first round, best first.
    singles: &'a [FittedHypothesis],
    /// Single effects whose best forms tell the first effect of a pair.
    order: &'a [FittedHypothesis],
    point: &'a InsertionPoint,
    /// True if second effects are sought from the whole range as well.
    global: bool,
}

/// Pairs of effects that may explain more than their first effect alone, with held-out residuals.
///
/// `ranked` are single hypotheses by log evidence, `singles` those of the first round by score. A single hypothesis of which the
/// best pair shows a better optimum takes that.
pub(crate) fn two_effect_search(
    scheduler: &mut Scheduler<'_>,
    baseline: &FittedHypothesis,
    ranked: &mut [FittedHypothesis],
    singles: &[FittedHypothesis],
    point: &InsertionPoint,
) -> Result<Vec<FittedHypothesis>, String> {
    // The optimum of a poor baseline may be too far from that of a pair.
    let global = is_poor(baseline) && is_affordable(&scheduler.study, SECOND_EFFECTS * (FIRST_EFFECTS + MAX_EXCHANGES));
    let search = PairSearch { baseline, singles, order: singles, point, global };
    let least = ranked[0].log_evidence - MAX_FIRST_EFFECT_DEFICIT;
    let leading = ranked.iter().filter(|e| e.cause() != "none" && e.log_evidence > least);
    let index = |e: &FittedHypothesis| singles.iter().position(|f| Arc::ptr_eq(&f.variant, &e.variant));
    let placed = |e: &FittedHypothesis| index(e).map(|effect| PlacedEffect { effect, hypothesis: e.clone() });
    let firsts: Vec<PlacedEffect> = leading.take(FIRST_EFFECTS).filter_map(placed).collect();
    let mut pairs = vec![];
    let mut searched = BTreeSet::new();
    for (n, first) in firsts.iter().enumerate() {
        let done: Vec<&str> = firsts[..=n].iter().map(|s| s.hypothesis.cause()).collect();
        pairs.extend(search.beside(scheduler, first, |_, e| !done.contains(&e.cause()))?);
        searched.insert(first.effect);
    }
    if best_pair(&pairs).is_some_and(|p| p.gain(&ranked[0]) > ONE_EFFECT_LOG_ODDS) {
        search.try_next_forms(scheduler, &firsts, &mut searched, &mut pairs)?;
    }
    search.exchange_effects(scheduler, &ranked[0], searched, &mut pairs)?;
    search.improve_singles(scheduler, &pairs, ranked)?;
    // A single effect may have become better than the one that was first.
    let refined = PairSearch { order: ranked, ..search };
    let mut out: Vec<FittedHypothesis> =
        pairs.into_iter().filter_map(|p| Some(refined.ordered(p)?.hypothesis)).collect();
    scheduler.hold_out(STAGE, &mut out)?;
    Ok(out)
}

/// Returns true if two effects have not been fitted together.
fn is_new(pairs: &[EffectPair], one: usize, two: usize) -> bool {
    pairs.iter().all(|p| p.effects != [one, two] && p.effects != [two, one])
}

/// The pair with the best score.
fn best_pair(pairs: &[EffectPair]) -> Option<&EffectPair> {
    pairs.iter().min_by(|a, b| a.hypothesis.score().total_cmp(&b.hypothesis.score()))
}

impl PairSearch<'_> {
    /// Seeks second effects beside the next form of each first cause.
    fn try_next_forms(
        &self,
        scheduler: &mut Scheduler<'_>,
        firsts: &[PlacedEffect],
        searched: &mut BTreeSet<usize>,
        pairs: &mut Vec<EffectPair>,
    ) -> Result<(), String> {
        let singles = self.singles;
        let causes: BTreeSet<&str> = firsts.iter().map(|s| s.hypothesis.cause()).collect();
        let next = |cause: &&str| (0..singles.len()).find(|n| singles[*n].cause() == *cause && !searched.contains(n));
        let forms: Vec<usize> = causes.iter().filter_map(next).collect();
        let alone = forms.iter().map(|n| singles[*n].clone()).collect();
        let fitted = scheduler.refine(STAGE, alone, SECOND_ROUND_ITERATIONS)?;
        for (effect, hypothesis) in forms.into_iter().zip(fitted) {
            let first = PlacedEffect { effect, hypothesis };
            let more = self.beside(scheduler, &first, |n, _| is_new(pairs, effect, n))?;
            pairs.extend(more.into_iter().filter_map(|p| self.ordered(p)));
            searched.insert(effect);
        }
        Ok(())
    }

    /// Replaces each effect of the best pair in turn: the best partner need not have been among the best alone.
    fn exchange_effects(
        &self,
        scheduler: &mut Scheduler<'_>,
        single: &FittedHypothesis,
        mut searched: BTreeSet<usize>,
        pairs: &mut Vec<EffectPair>,
    ) -> Result<(), String> {
        for _ in 0..MAX_EXCHANGES {
            let Some(best) = best_pair(pairs).filter(|p| p.gain(single) > ONE_EFFECT_LOG_ODDS) else { break };
            let Some(side) = (0..2).find(|side| !searched.contains(&best.effects[*side])) else { break };
            searched.insert(best.effects[side]);
            let Some(kept) = self.effect_of_pair(best, side) else { continue };
            let more = self.beside(scheduler, &kept, |n, _| is_new(pairs, kept.effect, n))?;
            pairs.extend(more.into_iter().filter_map(|p| self.ordered(p)));
        }
        Ok(())
    }

    /// Searches each effect of the best pair alone, from the optimum of the pair.
    ///
    /// A second effect must not be named for a better optimum of the first.
    fn improve_singles(
        &self,
        scheduler: &mut Scheduler<'_>,
        pairs: &[EffectPair],
        ranked: &mut [FittedHypothesis],
    ) -> Result<(), String> {
        let Some(best) = best_pair(pairs).filter(|p| p.gain(&ranked[0]) > 0.0) else { return Ok(()) };
        let alone = (0..2).filter_map(|side| Some(self.effect_of_pair(best, side)?.hypothesis)).collect();
        for found in scheduler.refine(STAGE, alone, SECOND_ROUND_ITERATIONS)? {
            if let Some(known) = improved_by(ranked, found) {
                scheduler.hold_out(STAGE, std::slice::from_mut(known))?;
            }
        }
        Ok(())
    }

    /// One effect of a pair, at the optimum of the pair.
    fn effect_of_pair(&self, pair: &EffectPair, side: usize) -> Option<PlacedEffect> {
        let alone = &self.singles[pair.effects[side]];
        let [own, first, second] = self.coordinates(&pair.hypothesis, pair.effects);
        let point = [own, [first, second][side]].concat();
        let values = alone.variant.study.space.values_at(&point).ok()?;
        let fitted = FittedModel { point, values, ..alone.fitted.clone() };
        Some(PlacedEffect { effect: pair.effects[side], hypothesis: FittedHypothesis { fitted, ..alone.clone() } })
    }

    /// Coordinates of the user's parameters and of both effects at the optimum of a pair.
    fn coordinates<'p>(&self, pair: &'p FittedHypothesis, effects: [usize; 2]) -> [&'p [f64]; 3] {
        let own = self.baseline.variant.dimension();
        let (both, second) = pair.fitted.point.split_at(self.singles[effects[0]].variant.dimension());
        let (own, first) = both.split_at(own);
        [own, first, second]
    }

    /// The pair with the better single effect first.
    fn ordered(&self, pair: EffectPair) -> Option<EffectPair> {
        let [one, two] = pair.effects;
        let score = |n: usize| {
            let of_cause = self.order.iter().filter(|e| e.cause() == self.singles[n].cause());
            of_cause.map(FittedHypothesis::score).fold(f64::INFINITY, f64::min)
        };
        if score(one) <= score(two) {
            return Some(pair);
        }
        let proposal = |n: usize| self.singles[n].variant.proposal.as_ref();
        let both = proposal(two)?.combined_with(proposal(one)?);
        let variant = self.baseline.variant.with_proposal(self.point, &both)?;
        let [own, first, second] = self.coordinates(&pair.hypothesis, pair.effects);
        let point = [own, second, first].concat();
        let values = variant.study.space.values_at(&point).ok()?;
        let fitted = FittedModel { point, values, ..pair.hypothesis.fitted };
        Some(EffectPair { hypothesis: FittedHypothesis::new(Arc::new(variant), fitted), effects: [two, one] })
    }

    /// Variants of one effect beside each wanted single effect of another cause, with the index and start points of the
    /// latter. All forms take part: the best form alone need not be the best beside another effect.
    fn candidates(
        &self,
        one: &FittedHypothesis,
        wanted: impl Fn(usize, &FittedHypothesis) -> bool,
    ) -> Vec<(usize, VariantPoints)> {
        let own = self.baseline.variant.dimension();
        let point = &one.fitted.point;
        let others = self.singles.iter().enumerate().filter(|(n, e)| e.cause() != one.cause() && wanted(*n, e));
        let candidate = |(n, other): (usize, &FittedHypothesis)| {
            let both = one.variant.proposal.as_ref()?.combined_with(other.variant.proposal.as_ref()?);
            let variant = self.baseline.variant.with_proposal(self.point, &both)?;
            // The second effect at its proposed start, and as it was fitted alone.
            let mut points = halton_points(&variant.start(&one.fitted.values), point.len(), SECOND_EFFECT_POINTS);
            points.push([&point[..], &other.fitted.point[own..]].concat());
            points.extend(variant.further_starts(&one.fitted.values));
            Some((n, (Arc::new(variant), points)))
        };
        others.filter_map(candidate).collect()
    }

    /// The best pairs of one effect with the wanted single effects of other causes.
    fn beside(
        &self,
        scheduler: &mut Scheduler<'_>,
        one: &PlacedEffect,
        wanted: impl Fn(usize, &FittedHypothesis) -> bool,
    ) -> Result<Vec<EffectPair>, String> {
        if one.hypothesis.variant.proposal.is_none() {
            return Ok(vec![]);
        }
        let candidates = self.candidates(&one.hypothesis, wanted);
        let index_of: Vec<(Arc<Variant>, usize)> = candidates.iter().map(|(n, (v, _))| (v.clone(), *n)).collect();
        let candidates = candidates.into_iter().map(|(_, candidate)| candidate).collect();
        // Longer steps predict the gain of a second effect well enough.
        let parts = scheduler.step_parts();
        let coarse =
            scheduler.evaluate_with_step_parts(STAGE, parts.div_ceil(SCREENING_STEP_RATIO), &one.hypothesis)?;
        let Some(coarse) = coarse else {
            scheduler.set_step_parts(parts);
            return Ok(vec![]);
        };
        let (variant, point) = (&one.hypothesis.variant, &one.hypothesis.fitted.point);
        let mut screened = scheduler.screen(STAGE, variant, point, candidates)?;
        scheduler.set_step_parts(parts);
        let score = FittedHypothesis { fitted: coarse, ..one.hypothesis.clone() }.score();
        screened.retain(|s| approximate_gain(s.score(), score) > MIN_EXPECTED_PAIR_GAIN);
        let mut second_causes = BTreeSet::new();
        screened.retain(|s| second_causes.insert(s.variant.second_cause()));
        screened.truncate(SECOND_EFFECTS);
        let variants: Vec<Arc<Variant>> = screened.iter().map(|s| s.variant.clone()).collect();
        let mut found = scheduler.search(STAGE, screened, SECOND_ROUND_ITERATIONS)?;
        if self.global {
            global_search(scheduler, STAGE, self.baseline, &variants, SECOND_ROUND_ITERATIONS, &mut found)?;
            sort_by_score(&mut found);
        }
        let pair = |hypothesis: FittedHypothesis| {
            let (_, other) = index_of.iter().find(|(v, _)| Arc::ptr_eq(v, &hypothesis.variant))?;
            Some(EffectPair { hypothesis, effects: [one.effect, *other] })
        };
        Ok(found.into_iter().take(KEPT_PAIRS).filter_map(pair).collect())
    }
}

/// Gives a known hypothesis the optimum of a search of its variant where that is better; `None` where it is not.
fn improved_by(known: &mut [FittedHypothesis], found: FittedHypothesis) -> Option<&mut FittedHypothesis> {
    let is_improved = |e: &&mut FittedHypothesis| {
        Arc::ptr_eq(&e.variant, &found.variant) && found.fitted.objective < e.fitted.objective
    };
    let known = known.iter_mut().find(is_improved)?;
    known.fitted = found.fitted;
    Some(known)
}

#[cfg(test)]
mod tests {
    use super::{EffectPair, PairSearch, improved_by};
    use crate::inspect::insertion::InsertionPoint;
    use crate::test_support::{baseline, fitted_at, script_edit};

    /// A better optimum counts for the hypothesis of its variant alone, a worse one for none.
    #[test]
    fn a_single_effect_is_improved_by_a_search_from_a_pair() {
        let with = |cause: &'static str| {
            let proposal = script_edit(cause, &["x"]);
            fitted_at(baseline().variant.with_proposal(&InsertionPoint::At(0), &proposal).expect("a variant"), &[0.5])
        };
        let mut known = [with("friction"), with("damping")];
        let mut found = known[1].clone();
        found.fitted.objective = 2.0;
        assert!(improved_by(&mut known, found.clone()).is_none());
        found.fitted.objective = 0.5;
        assert!(improved_by(&mut known, found).is_some_and(|e| e.cause() == "damping"));
        assert_eq!([known[0].fitted.objective, known[1].fitted.objective], [1.0, 0.5]);
        assert!(improved_by(&mut known, with("friction")).is_none());
    }

    /// A reordered pair keeps the values of all parameters, and each effect its own.
    #[test]
    fn a_pair_can_be_reordered() {
        let baseline = baseline();
        let point = InsertionPoint::At(0);
        let (friction, damping) = (script_edit("friction", &["force"]), script_edit("damping", &["c", "n"]));
        let with = |p: &_| baseline.variant.with_proposal(&point, p).expect("a variant");
        let singles = [fitted_at(with(&friction), &[0.1]), fitted_at(with(&damping), &[0.2, 0.3])];
        let search =
            PairSearch { baseline: &baseline, singles: &singles, order: &singles, point: &point, global: false };
        let both = fitted_at(with(&damping.combined_with(&friction)), &[0.7, 0.8, 0.9]);
        let pair = search.ordered(EffectPair { hypothesis: both, effects: [1, 0] }).expect("a pair");
        let e = &pair.hypothesis;
        assert_eq!((pair.effects, e.cause(), e.second_cause()), ([0, 1], "friction", Some("damping")));
        let value = |name: &str| {
            let parameters = &e.variant.study.space.parameters;
            parameters.iter().position(|p| p.name == name).map(|i| e.fitted.values[i])
        };
        assert_eq!([value("hy_force"), value("hy2_c"), value("hy2_n")], [Some(0.9), Some(0.7), Some(0.8)]);
        assert_eq!(e.fitted.values[..baseline.fitted.values.len()], baseline.fitted.values);
        let own = baseline.variant.dimension();
        let effect = |side| search.effect_of_pair(&pair, side).expect("an effect").hypothesis;
        assert_eq!(effect(0).fitted.point[own..], [0.9]);
        assert_eq!(effect(1).fitted.point[own..], [0.7, 0.8]);
        // The second effect has become better alone.
        let mut refined = singles.clone();
        refined[1].fitted.objective *= 0.01;
        let kept = EffectPair {
            hypothesis: fitted_at(with(&friction.combined_with(&damping)), &[0.9, 0.7, 0.8]),
            effects: [0, 1],
        };
        let turned = PairSearch { order: &refined, ..search }.ordered(kept).expect("a pair").hypothesis;
        assert_eq!((turned.cause(), turned.second_cause()), ("damping", Some("friction")));
        assert_eq!(turned.fitted.point[own..], [0.7, 0.8, 0.9]);
        // An ordered pair stays as it is.
        assert_eq!(search.ordered(pair).expect("a pair").effects, [0, 1]);
    }
}

//! First round: every proposal is screened, and the most promising ones are fitted.

use super::alternative_forms::{fit_extended_forms, fit_neighbouring_forms};
use super::fitted::{FittedHypothesis, ScreenedHypothesis, approximate_gain, sort_by_score};
use super::global_search::{GlobalScope, global_search};
use super::halton_points::halton_points;
use super::scheduler::Scheduler;
use super::search_settings::{
    FINALIST_FORMS, FIRST_ROUND_ITERATIONS, FIRST_ROUND_SEARCHES, FORMS_PER_CAUSE, GLOBAL_ITERATIONS,
    MIN_EXPECTED_GAIN, MIN_USER_VALUE_DISTANCE, SCREENING_POINTS, SCREENING_POINTS_AT_USER_VALUES,
    UNPROMISING_SEARCHES,
};
use crate::candidate::proposal::Proposal;
use crate::candidate::variant::Variant;
use crate::hypothesis::look_alike;
use crate::inspect::insertion::InsertionPoint;
use hysteron_identify::study::InitialRun;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

const STAGE: &str = "what may have been left out";

/// Basis of the first round.
pub(crate) struct FirstRound<'a> {
    /// The fitted baseline.
    pub(crate) baseline: &'a FittedHypothesis,
    /// Values of the script.
    pub(crate) initial_run: &'a InitialRun,
    /// Place of added commands.
    pub(crate) point: &'a InsertionPoint,
    /// All proposals.
    pub(crate) proposals: &'a [Proposal],
    /// Physics that is sought from the whole range as well.
    pub(crate) global: GlobalScope,
}

/// Screened proposals in the order of their fits.
struct Selection {
    /// Fitted first.
    first: Vec<ScreenedHypothesis>,
    /// Unpromising edits of the script, fitted after them: their effect may show only at the right size.
    unpromising: Vec<ScreenedHypothesis>,
    /// Further forms of causes that are already represented.
    further_forms: Vec<ScreenedHypothesis>,
}

impl FirstRound<'_> {
    /// Fits the proposals: best score first, each variant once.
    ///
    /// # Errors
    /// The user cancelled.
    pub(crate) fn fit(&self, scheduler: &mut Scheduler<'_>) -> Result<Vec<FittedHypothesis>, String> {
        let baseline = self.baseline;
        let own = baseline.variant.dimension();
        let with = |p| baseline.variant.with_proposal(self.point, p);
        let variants: Vec<_> = self.proposals.iter().filter_map(with).map(Arc::new).collect();
        let user_point = scheduler.study.space.unit_point(&self.initial_run.values);
        let distances = user_point.iter().zip(&baseline.fitted.point).map(|(a, b)| (a - b).abs());
        let user_values_differ = distances.fold(0.0, f64::max) > MIN_USER_VALUE_DISTANCE;
        let screened = self.screen(scheduler, &variants, user_values_differ.then_some(&user_point))?;
        let Selection { first, mut unpromising, further_forms } = self.select(screened);
        let mut fitted = scheduler.search(STAGE, first, FIRST_ROUND_ITERATIONS)?;
        // Screening follows channel faults to their optimum, but not physics, which starts from the user's values as well.
        let at_user_values = unpromising.iter().map(|s| {
            let start = [&user_point[..], &s.variant.start(&baseline.fitted.values)[own..]].concat();
            ScreenedHypothesis { start, ..s.clone() }
        });
        let mut second = if user_values_differ { at_user_values.collect() } else { vec![] };
        second.append(&mut unpromising);
        fitted.extend(scheduler.search(STAGE, second, FIRST_ROUND_ITERATIONS)?);
        fit_neighbouring_forms(scheduler, STAGE, further_forms, &mut fitted)?;
        fit_extended_forms(scheduler, STAGE, &variants, &mut fitted)?;
        let sought: Vec<_> = variants.into_iter().filter(|v| self.global.contains(v)).collect();
        if !sought.is_empty() {
            global_search(scheduler, STAGE, baseline, &sought, GLOBAL_ITERATIONS, &mut fitted)?;
        }
        sort_by_score(&mut fitted);
        // A variant sought from two points stays with its better fit.
        let mut seen = BTreeSet::new();
        fitted.retain(|e| seen.insert(Arc::as_ptr(&e.variant)));
        Ok(fitted)
    }

    /// All variants screened from the fitted baseline, and from the user's point if it is given: best first.
    ///
    /// The fitted baseline may have absorbed the missing effect, while the user's values have not.
    fn screen(
        &self,
        scheduler: &mut Scheduler<'_>,
        variants: &[Arc<Variant>],
        user_point: Option<&Vec<f64>>,
    ) -> Result<Vec<ScreenedHypothesis>, String> {
        let baseline = self.baseline;
        let own = baseline.variant.dimension();
        let candidates = |per_parameter: usize| -> Vec<_> {
            let points = |v: &Variant| {
                let values = &baseline.fitted.values;
                [halton_points(&v.start(values), own, per_parameter), v.further_starts(values)].concat()
            };
            variants.iter().map(|v| (v.clone(), points(v))).collect()
        };
        let candidates_at_fit = candidates(SCREENING_POINTS);
        let mut screened = scheduler.screen(STAGE, &baseline.variant, &baseline.fitted.point, candidates_at_fit)?;
        if let Some(user_point) = user_point {
            let at_user_values = candidates(SCREENING_POINTS_AT_USER_VALUES);
            screened.extend(scheduler.screen(STAGE, &baseline.variant, user_point, at_user_values)?);
            screened.sort_by(|a, b| a.score().total_cmp(&b.score()));
            let mut seen = BTreeSet::new();
            screened.retain(|s| seen.insert(Arc::as_ptr(&s.variant)));
        }
        Ok(screened)
    }

    /// Orders screened proposals: the best of each cause, then its next forms.
    fn select(&self, screened: Vec<ScreenedHypothesis>) -> Selection {
        let mut forms_of_cause: BTreeMap<&str, usize> = BTreeMap::new();
        let mut mechanisms: BTreeSet<(&str, String)> = BTreeSet::new();
        let (mut ranked, mut next_forms, mut further_forms) = (vec![], vec![], vec![]);
        for s in screened {
            let is_first_of_mechanism = mechanisms.insert((s.variant.cause(), s.variant.mechanism().to_owned()));
            let form = forms_of_cause.entry(s.variant.cause()).or_default();
            *form += 1;
            match *form {
                1 => ranked.push(s),
                2..=FORMS_PER_CAUSE => next_forms.push(s),
                // A whole law is far from the user's, so that screening at a few points says little of it. Of another mechanism the
                // forms so far say nothing: springs below a support that sways, and below one that rocks.
                _ if s.variant.is_whole_law() || is_first_of_mechanism => next_forms.push(s),
                _ => further_forms.push(s),
            }
        }
        ranked.append(&mut next_forms);
        let baseline_score = self.baseline.score();
        let promising = |s: &ScreenedHypothesis| approximate_gain(s.score(), baseline_score) > MIN_EXPECTED_GAIN;
        let (mut first, mut unpromising) = (vec![], vec![]);
        for (rank, s) in ranked.into_iter().enumerate() {
            if rank < UNPROMISING_SEARCHES || promising(&s) {
                first.push(s);
            } else if !s.variant.is_channel_fault() {
                unpromising.push(s);
            }
        }
        first.truncate(FIRST_ROUND_SEARCHES);
        Selection { first, unpromising, further_forms }
    }
}

/// The best form of each cause. Of the first cause and its look-alikes the best [`FINALIST_FORMS`] at the place of its best
/// form, and the best at as many places. All stay in their order.
///
/// The best form alone need not be the best beside another effect, and a form elsewhere says nothing of the form here.
pub(crate) fn best_forms(sorted: &[FittedHypothesis]) -> Vec<FittedHypothesis> {
    let first = sorted.first().map_or("none", FittedHypothesis::cause);
    // Places of each cause in the order of their best forms, with the number of forms there.
    let mut places: BTreeMap<&str, Vec<(String, usize)>> = BTreeMap::new();
    let mut wanted = |e: &FittedHypothesis| {
        let most = if e.cause() == first || look_alike(e.cause(), first) { FINALIST_FORMS } else { 1 };
        let of_cause = places.entry(e.cause()).or_default();
        let location = e.variant.cause_and_location().map_or("", |(_, location)| location);
        let place = of_cause.iter().position(|(known, _)| *known == location).unwrap_or_else(|| {
            of_cause.push((location.to_owned(), 0));
            of_cause.len() - 1
        });
        of_cause[place].1 += 1;
        place < most && of_cause[place].1 <= if place == 0 { most } else { 1 }
    };
    sorted.iter().filter(|e| wanted(e)).cloned().collect()
}

/// The hypotheses of the first `count` causes, with all their forms.
pub(crate) fn of_first_causes(sorted: &[FittedHypothesis], count: usize) -> Vec<FittedHypothesis> {
    let mut causes = BTreeSet::new();
    let wanted = |e: &&FittedHypothesis| causes.contains(e.cause()) || causes.len() < count && causes.insert(e.cause());
    sorted.iter().filter(wanted).cloned().collect()
}

#[cfg(test)]
mod tests {
    use super::{FittedHypothesis, best_forms, of_first_causes};
    use crate::candidate::proposal::Proposal;
    use crate::inspect::insertion::InsertionPoint;
    use crate::test_support::{baseline, fitted_at, hypotheses, script_edit};

    /// A form at another place takes no place of a form at the first.
    #[test]
    fn finalists_are_counted_by_place() {
        let baseline = baseline();
        let form = |(cause, place): (&'static str, &str)| {
            let proposal = Proposal { location: place.into(), ..script_edit(cause, &["x"]) };
            fitted_at(baseline.variant.with_proposal(&InsertionPoint::At(0), &proposal).expect("a variant"), &[0.5])
        };
        let of = |forms: &[(&'static str, &str)]| -> Vec<usize> {
            let sorted: Vec<_> = forms.iter().map(|f| form(*f)).collect();
            let kept = best_forms(&sorted);
            let is_kept = |i: &usize| kept.iter().any(|k| std::sync::Arc::ptr_eq(&k.variant, &sorted[*i].variant));
            (0..sorted.len()).filter(is_kept).collect()
        };
        let (wall, drag) = ("gap_impact", "damping");
        // Two at the first place, one at a second, none at a third; another cause has one.
        let forms = [
            (wall, "pad"),
            (wall, "floor"),
            (drag, "floor"),
            (wall, "pad"),
            (wall, "roof"),
            (wall, "pad"),
            (drag, "pad"),
        ];
        assert_eq!(of(&forms), [0, 1, 2, 3]);
        // A look-alike of the first cause has as many as the first.
        assert_eq!(of(&[(wall, "pad"), ("strain_stiffening", "pad"), ("strain_stiffening", "pad")]), [0, 1, 2]);
    }

    #[test]
    fn second_forms_do_not_count_as_causes() {
        let all =
            hypotheses(&[("friction", 9.0, 0.5), ("friction", 8.0, 0.5), ("damping", 7.0, 0.5), ("torsion", 6.0, 0.5)]);
        let causes = |count| of_first_causes(&all, count).iter().map(FittedHypothesis::cause).collect::<Vec<_>>();
        assert_eq!(causes(2), ["friction", "friction", "damping"]);
        assert_eq!(causes(9).len(), 4);
    }
}

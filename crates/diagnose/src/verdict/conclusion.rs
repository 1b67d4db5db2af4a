//! From ranked hypotheses to the verdict and the repaired model.

use super::all_runs::fits_of_all_runs;
use super::diagnosis::Diagnosis;
use super::gates::GatedRepair;
use super::held_out_condition::with_conditions_of_runs_held_out;
use super::learned::{LearnedContext, LearnedModel, learned_repair};
use super::like_motion::RunMotions;
use super::limits_of_none::limit_by_judgement;
use super::presentation::{present, uncertainty_of};
use super::repair::{RefutedEffect, Repair, is_pair_of_repaired, predicts_clearly_better};
use super::time_of_change::TimeOfChange;
use crate::candidate::channel_fault::ChannelFault;
use crate::candidate::variant::Variant;
use crate::evidence::holdout::{self, HeldOutErrors, HoldoutJudgement, judge};
use crate::evidence::memory_evidence::{DeviceRuns, RecordedEvidence};
use crate::evidence::parametric_bootstrap::BootstrapResult;
use crate::evidence::second_effect::has_second_effect;
use crate::evidence::verdict_evidence::{ProbabilityLimit, RankedStudy, VerdictEvidence};
use crate::evidence::verdict_model::{CauseProbabilities, cause_probabilities};
use crate::fit::fitted::FittedHypothesis;
use crate::fit::halton_points::points_around;
use crate::fit::job::{FittedModel, Job};
use crate::fit::phenomena::{PhenomenonShares, phenomenon_shares};
use crate::fit::scheduler::Scheduler;
use crate::fit::search_settings::LAST_ITERATIONS;
use crate::fit::step_error::StepError;
use crate::hypothesis::{changed_condition, is_sensor_fault, look_alike};
use crate::inspect::insertion::InsertionPoint;
use crate::inspect::inventory::ModelInventory;
use crate::inspect::response::ResponseRanges;
use crate::prior::{COMPLETE_MODEL_LOG_ODDS, MIN_REPAIR_GAIN, MIN_REPEATED_SHARE, MIN_SECOND_REPAIR_GAIN};
use crate::residual::unmodelled_structure::UnmodelledStructure;
use hysteron_identify::study::{
    InitialRun, ObservedChannel, Role, ScoredRun, ScriptSimulator, Study, simulate_and_score,
};
use std::sync::Arc;

/// Forms of look-alikes that are tried on the runs held out. A choice.
const LOOK_ALIKE_FORMS: usize = 3;

/// Basis of the conclusion besides the ranking.
pub(super) struct ConclusionContext<'a> {
    pub(super) study: &'a Arc<Study>,
    pub(super) simulator: &'a ScriptSimulator,
    pub(super) initial_run: &'a InitialRun,
    pub(super) text: &'a str,
    pub(super) point: &'a InsertionPoint,
    pub(super) responses: &'a ResponseRanges,
    /// Responses of the fitted runs with the fitted values of the user's model.
    pub(super) fitted_responses: &'a ResponseRanges,
    /// True if motions of nodes are imposed, false if the ground moves.
    pub(super) imposed_motion: bool,
    pub(super) step_error: StepError,
    /// Causes left out because the recordings have no clock.
    pub(super) causes_without_clock: Vec<&'static str>,
    /// Causes left out because devices of the study's material cannot have them.
    pub(super) causes_of_other_materials: Vec<&'static str>,
    /// True if the baseline is poor and the runs are too long for a global search.
    pub(super) global_search_too_long: bool,
    pub(super) inventory: &'a ModelInventory,
    /// Numbers of forms and causes that were tried.
    pub(super) tried: (usize, usize),
    pub(super) threads: usize,
    /// Channels that no edit of the script changes.
    pub(super) unmoved_channels: &'a [ObservedChannel],
    pub(super) recorded: &'a RecordedEvidence,
    /// Runs of the device whose force a channel shows.
    pub(super) device: Option<DeviceRuns>,
    pub(super) has_clock: bool,
}

/// Hypotheses to conclude from.
pub(super) struct Ranking<'a> {
    /// The user's model, fitted with the steps of the script.
    pub(super) baseline: &'a FittedHypothesis,
    /// Best first, with steps as short as necessary.
    pub(super) ranked: &'a [FittedHypothesis],
    pub(super) bootstrap: Option<BootstrapResult>,
    /// Causes of which runs held out had refuted a repair, which was left out.
    pub(super) left_out: &'a [&'static str],
}

/// Cause with the highest probability after the judgement of its repair.
pub(super) struct JudgedVerdict {
    pub(super) cause: &'static str,
    pub(super) repair: Repair,
    /// Cause of the nearest repair if none is written, because it has no name and worsens the runs held out.
    pub(super) refused: Option<&'static str>,
    /// Effect to leave out of a further search.
    pub(super) refuted: Option<RefutedEffect>,
    /// Causes, `none` and `unknown`, the most probable first.
    pub(super) probabilities: CauseProbabilities,
}

/// The decision that the evidence gives, before it is put in words and files.
pub(super) struct Decision {
    pub(super) verdict: JudgedVerdict,
    pub(super) evidence: VerdictEvidence,
    /// Structure that the first hypothesis leaves.
    pub(super) structure: UnmodelledStructure,
    /// Channels of all runs by the user's fitted model; none for a run without a result.
    pub(super) baseline_fits: Vec<Option<ScoredRun>>,
    /// Learned law that is the repair.
    pub(super) learned: Option<LearnedModel>,
    /// Shares of the phenomena of a whole law in the repair.
    pub(super) phenomena: Option<PhenomenonShares>,
}

/// Diagnosis from ranked hypotheses.
///
/// # Errors
/// The user cancelled, or the repaired model has no result.
pub(super) fn conclude(
    scheduler: &mut Scheduler<'_>,
    c: &ConclusionContext<'_>,
    ranking: &Ranking<'_>,
) -> Result<Diagnosis, String> {
    let decision = decide(scheduler, c, ranking)?;
    Ok(present(c, ranking, decision, scheduler.evaluations()))
}

/// Verdict and repair from ranked hypotheses.
fn decide(scheduler: &mut Scheduler<'_>, c: &ConclusionContext<'_>, ranking: &Ranking<'_>) -> Result<Decision, String> {
    let Ranking { baseline, ranked, bootstrap, left_out } = ranking;
    let (mut evidence, structure) = VerdictEvidence::of(&RankedStudy {
        study: c.study,
        responses: c.responses,
        baseline,
        ranked,
        bootstrap: bootstrap.as_ref(),
        left_out,
        recorded: c.recorded,
    });
    let baseline_fits = fits_of_all_runs(c, &baseline.variant, &baseline.fitted.values);
    // The repaired model keeps the steps of the script.
    scheduler.set_step_parts(1);
    let has_condition = ranked.iter().any(|e| e.cause() == changed_condition::CAUSE);
    let mut verdict_judge = VerdictJudge {
        scheduler,
        c,
        baseline,
        ranked,
        baseline_fits: &baseline_fits,
        structured_share: structure.share,
        motions: if has_condition { RunMotions::of(c, &baseline.fitted.values) } else { RunMotions::default() },
    };
    let mut verdict = verdict_judge.verdict(&mut evidence)?;
    let (cause, probabilities) = (verdict.cause, &verdict.probabilities);
    let learned = learned_repair(c, &LearnedContext { cause, probabilities, baseline, baseline_fits: &baseline_fits })
        .map(|l| {
            let fitted = l.hypothesis.fitted.clone();
            (verdict.repair, verdict.refused) = (Repair::accepted(l.hypothesis, fitted, l.fits), None);
            l.told
        });
    let repair = &verdict.repair;
    let repaired = FittedHypothesis { fitted: repair.fitted.clone(), ..repair.hypothesis.clone() };
    let phenomena = phenomenon_shares(scheduler, baseline, c.point, &repaired)?;
    scheduler.check_cancelled()?;
    Ok(Decision { verdict, evidence, structure, baseline_fits, learned, phenomena })
}

/// Finds the verdict by repairing the most probable cause until its repair stands.
struct VerdictJudge<'a, 'b> {
    scheduler: &'a mut Scheduler<'b>,
    c: &'a ConclusionContext<'a>,
    baseline: &'a FittedHypothesis,
    ranked: &'a [FittedHypothesis],
    baseline_fits: &'a [Option<ScoredRun>],
    /// Structured share of the residual that the first hypothesis leaves.
    structured_share: f64,
    motions: RunMotions,
}

impl VerdictJudge<'_, '_> {
    /// Repairs the most probable cause. If the runs held out lower its probability, the next most probable one follows.
    fn verdict(&mut self, evidence: &mut VerdictEvidence) -> Result<JudgedVerdict, String> {
        let (mut repairs, mut look_alikes): (Vec<(&'static str, Repair)>, Vec<Repair>) = (vec![], vec![]);
        let (cause, probabilities) = loop {
            let probabilities = cause_probabilities(evidence);
            let cause = probabilities[0].0;
            // Even for `unknown` the nearest repair is written and judged. That of a complete model is none.
            let is_judged = |(known, _): &(&str, Repair)| *known == cause || cause == "unknown" && *known != "none";
            if repairs.iter().any(is_judged) {
                break (cause, probabilities);
            }
            let known = look_alikes.iter().position(|r| r.hypothesis.cause() == cause);
            let repair = match known {
                Some(n) => look_alikes.swap_remove(n),
                None => self.best_repair(cause, evidence)?,
            };
            let judged = repair.evidence(self.c);
            // A repair with limits of its own does not limit what is unknown.
            let stands = repair.limits.is_empty() && !repair.is_refused();
            let of_repair = evidence.limits_of_repair(&judged).into_iter();
            evidence.limits.extend(of_repair.filter(|l| l.cause != "unknown" || stands));
            evidence.judged.push(judged);
            evidence.limits.extend(repair.limits.clone());
            if let Some((limit, other)) = self.better_look_alike(&repair)? {
                evidence.limits.push(limit);
                look_alikes.push(other);
            }
            if cause == "none" {
                let uncertainty = uncertainty_of(self.c, &repair);
                evidence.limits.extend(uncertainty.and_then(|u| limit_by_judgement(&u.judgement)));
            }
            repairs.push((cause, repair));
        };
        let index = repairs.iter().position(|(known, _)| *known == cause).unwrap_or(0);
        let (repaired_cause, mut repair) = repairs.swap_remove(index);
        if cause == "unknown" {
            repair = self.nearest_repair(repair)?;
        }
        if cause == "unknown" && repair.is_refused() {
            let nearest = if repaired_cause == "unknown" { self.ranked[0].cause() } else { repaired_cause };
            let refuted = repair.most_flexible_effect();
            let repair = self.repair(self.baseline.clone())?;
            return Ok(JudgedVerdict { cause, repair, refused: Some(nearest), refuted, probabilities });
        }
        let hardly = matches!(repair.judgement, HoldoutJudgement::PartlyPredicted(share) if share < MIN_REPEATED_SHARE);
        let refuted = repair.most_flexible_effect().filter(|_| hardly && !evidence.left_out.is_empty());
        Ok(JudgedVerdict { cause, repair, refused: None, refuted, probabilities })
    }

    /// The best form of all for an unknown cause, where a refuted cause was repaired by less than that.
    ///
    /// A pair has the most evidence, and its first effect alone was repaired: nothing is named, so both may stand.
    fn nearest_repair(&mut self, repaired: Repair) -> Result<Repair, String> {
        let best = &self.ranked[0];
        if !is_pair_of_repaired(best, &repaired.hypothesis) {
            return Ok(repaired);
        }
        let nearest = self.repair(best.clone())?;
        let is_better = !nearest.is_refused() && nearest.fitted.objective < repaired.fitted.objective;
        Ok(if is_better { nearest } else { repaired })
    }

    /// Repair by a look-alike beside the same second effect, where a repair predicts the runs held out in part and that one
    /// predicts them clearly better; with the limit of the first cause: its part of the errors that both leave there.
    fn better_look_alike(&mut self, repair: &Repair) -> Result<Option<(ProbabilityLimit, Repair)>, String> {
        let (first, ranked) = (&repair.hypothesis, self.ranked);
        let held_out = |r: &Repair| r.errors.and_then(|e| e.after);
        let own = held_out(repair).filter(|_| matches!(repair.judgement, HoldoutJudgement::PartlyPredicted(_)));
        let is_rival =
            |e: &&FittedHypothesis| look_alike(e.cause(), first.cause()) && e.second_cause() == first.second_cause();
        let mut best: Option<Repair> = None;
        for rival in ranked.iter().filter(|e| own.is_some() && is_rival(e)).take(LOOK_ALIKE_FORMS) {
            let other = self.repair(rival.clone())?;
            let least = best.as_ref().map_or(own, &held_out);
            if !other.is_refused() && predicts_clearly_better(held_out(&other), least) {
                best = Some(other);
            }
        }
        Ok(best.and_then(|other| {
            let (own, others) = (own?, held_out(&other)?);
            let reason = format!("{} predicts the runs held out better", other.hypothesis.cause());
            Some((ProbabilityLimit::new(first.cause(), others / (own + others), reason), other))
        }))
    }

    /// Repair by the best form of a cause, or by its second form if the runs held out refute the first alone.
    ///
    /// A pair whose second effect is less likely than not gives way to its first effect alone.
    fn best_repair(&mut self, cause: &str, evidence: &VerdictEvidence) -> Result<Repair, String> {
        let best = &self.ranked[0];
        let log_evidence_of_none = evidence.log_likelihood_of_none() + COMPLETE_MODEL_LOG_ODDS;
        let likely =
            |e: &&FittedHypothesis| e.second_cause().is_none_or(|also| has_second_effect(evidence, e.cause(), also));
        let hypothesis = match cause {
            "none" => self.baseline,
            "unknown" if best.log_evidence < log_evidence_of_none + MIN_REPAIR_GAIN => self.baseline,
            "unknown" => best,
            _ => {
                let of_cause = || self.ranked.iter().filter(|e| e.cause() == cause);
                of_cause().find(likely).or_else(|| of_cause().next()).unwrap_or(best)
            }
        };
        let repair = self.repair(hypothesis.clone())?;
        let supported = |e: &&FittedHypothesis| e.cause() == cause && e.log_evidence > log_evidence_of_none;
        let other = |e: &&FittedHypothesis| !Arc::ptr_eq(&e.variant, &hypothesis.variant);
        let second_form = self.ranked.iter().filter(supported).find(other).filter(|_| repair.is_refused());
        if let Some(form) = second_form {
            let second = self.repair(form.clone())?;
            if !second.is_refused() {
                return Ok(second);
            }
        }
        if matches!(cause, "none" | "unknown") { Ok(repair) } else { self.with_open_second_effect(repair) }
    }

    /// The repair with a second effect too, whose name is open, where both together predict the runs held out clearly better.
    ///
    /// Several second effects may explain as much, so that none is likely; that there is one may be sure all the same.
    fn with_open_second_effect(&mut self, repair: Repair) -> Result<Repair, String> {
        let first = &repair.hypothesis;
        let is_pair = |e: &&FittedHypothesis| {
            let of_model = e.second_cause().is_some_and(|second| !is_sensor_fault(second));
            of_model && e.cause() == first.cause() && e.log_evidence > first.log_evidence + MIN_SECOND_REPAIR_GAIN
        };
        let pair = self.ranked.iter().find(is_pair).filter(|_| first.second_cause().is_none() && !repair.is_refused());
        let Some(pair) = pair else { return Ok(repair) };
        let both = Repair { open_second: true, ..self.repair(pair.clone())? };
        let held_out = |r: &Repair| r.errors.and_then(|e| e.after);
        let is_better = predicts_clearly_better(held_out(&both), held_out(&repair));
        Ok(if is_better && !both.is_refused() { both } else { repair })
    }

    /// The last search, from the optimum of a hypothesis and from points around it, and the judgement of the runs held out.
    ///
    /// These runs are evaluated here for the first time.
    fn repair(&mut self, hypothesis: FittedHypothesis) -> Result<Repair, String> {
        let (c, study) = (self.c, self.c.study);
        let variant = &hypothesis.variant;
        let starts = points_around(&hypothesis.fitted.point);
        let jobs = starts.into_iter().map(|start| Job::search(variant, start, LAST_ITERATIONS)).collect();
        let refined = self.scheduler.fit("the repaired model", jobs)?.into_iter().flatten();
        let known = Some(hypothesis.fitted.clone()).filter(|_| c.step_error.parts == 1);
        let fitted = known.into_iter().chain(refined).min_by(|a, b| a.objective.total_cmp(&b.objective));
        let mut fitted = fitted.ok_or("the repaired model has no answer with the steps of the script")?;
        let times = self.settled_times(variant, &mut fitted);
        let fits = fits_of_all_runs(c, variant, &fitted.values);
        self.scheduler.check_cancelled()?;
        let hypothesis = FittedHypothesis { fitted: fitted.clone(), ..hypothesis };
        let (hypothesis, fits) = with_conditions_of_runs_held_out(c, &self.baseline.variant, &hypothesis, &fits)
            .unwrap_or((hypothesis, fits));
        let variant = &hypothesis.variant;
        let in_holdout = |f: &ChannelFault| {
            f.run.as_ref().is_none_or(|name| study.runs_of(Role::Holdout).any(|(_, r)| r.name == *name))
        };
        let affects_holdout =
            variant.edits_further_runs() || variant.channel_faults(&fitted.values).iter().any(in_holdout);
        let repair = holdout::Repair {
            before: self.baseline_fits,
            after: &fits,
            structured_share: self.structured_share,
            affects_holdout,
            visible_in_recording: variant.visible_log_odds() > 0.0,
        };
        // The user's model claims nothing.
        let judgement = if hypothesis.cause() == "none" { HoldoutJudgement::Accepted } else { judge(study, &repair) };
        let errors = HeldOutErrors::of(study, &repair);
        let simulate = |variant: &Arc<Variant>, run: usize, values: &[f64]| {
            simulate_and_score(&mut variant.simulator(&c.simulator.factory()), study, run, values).ok()
        };
        let gated = GatedRepair {
            study,
            variant,
            values: &fitted.values,
            point: &fitted.point,
            baseline: self.baseline,
            judged: &repair,
            responses: c.responses,
            motions: &self.motions,
            told_by_repetition: hypothesis.repeated_share.is_some(),
            extent: c.inventory.extent,
            noise: c.recorded.noise,
            left: fitted.objective,
            simulate: &simulate,
        };
        let (limits, told_by) = (gated.limits(), gated.like_motion_in_words());
        Ok(Repair { hypothesis, fitted, fits, judgement, errors, limits, times, told_by, open_second: false })
    }

    /// Times of change of a repair, of which those of the fit are put into the middle of their intervals.
    fn settled_times(&self, variant: &Arc<Variant>, fitted: &mut FittedModel) -> Vec<TimeOfChange> {
        let mut simulator = variant.simulator(&self.c.simulator.factory());
        let study = self.c.study;
        TimeOfChange::settle(study, variant, fitted, |values| {
            let runs = study.runs_of(Role::Fit);
            runs.map(|(run, _)| simulate_and_score(&mut simulator, study, run, values).ok()).collect()
        })
    }
}

/// Share of the baseline's squared error that a repair leaves.
pub(super) fn remaining_share(baseline: &FittedHypothesis, repair: &Repair) -> f64 {
    let before = baseline.fitted.objective;
    if before > 0.0 { repair.fitted.objective / before } else { 1.0 }
}

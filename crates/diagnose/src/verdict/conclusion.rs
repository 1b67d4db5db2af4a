//! From ranked hypotheses to the verdict and the repaired model.

use super::all_runs::{displacements, fits_of_all_runs, script_steps};
use super::device_loop::{BlamedParts, DeviceLoop, LoopSources, blamed_parts, repaired_responses};
use super::diagnosis::{Diagnosis, RankedHypothesis};
use super::discriminating_test::discriminating_test;
use super::explanation::observation;
use super::gates::GatedRepair;
use super::learned::{LearnedContext, learned_repair};
use super::mismatch::mismatches;
use super::nearest::nearest_in_words;
use super::quantity::Units;
use super::residual_force::{FittedModelRuns, ResidualForce, residual_forces};
use super::result_file::{Baseline, Mismatch, Outcome, RepairedModel, UnmovedChannel};
use super::structure_drawing::StructureDrawing;
use super::summary::{SummaryContext, summary};
use super::unmoved::unmoved_in_words;
use super::verdict_in_words::verdict_in_words;
use crate::candidate::channel_fault::ChannelFault;
use crate::candidate::opensees_form::{RepairedModelScript, opensees_script};
use crate::candidate::repaired_script::repaired_script;
use crate::candidate::variant::Variant;
use crate::evidence::holdout::{self, HeldOutErrors, HoldoutJudgement, holdout_nmse, judge};
use crate::evidence::memory_evidence::{DeviceRuns, RecordedEvidence};
use crate::evidence::parametric_bootstrap::BootstrapResult;
use crate::evidence::second_effect::{causes_within_law, has_second_effect};
use crate::evidence::verdict_evidence::{ProbabilityLimit, RankedStudy, RepairEvidence, VerdictEvidence};
use crate::evidence::verdict_model::{self, CauseProbabilities, cause_probabilities};
use crate::fit::fitted::FittedHypothesis;
use crate::fit::halton_points::points_around;
use crate::fit::job::{FittedModel, Job};
use crate::fit::phenomena::phenomenon_shares;
use crate::fit::scheduler::Scheduler;
use crate::fit::search_settings::LAST_ITERATIONS;
use crate::fit::step_error::StepError;
use crate::inspect::insertion::InsertionPoint;
use crate::inspect::inventory::ModelInventory;
use crate::inspect::response::ResponseRanges;
use crate::prior::{self, COMPLETE_MODEL_LOG_ODDS, MIN_REPAIR_GAIN, MIN_REPEATED_SHARE};
use hysteron_identify::calibrate::{StudyProblem, Uncertainty, uncertainty};
use hysteron_identify::study::{
    InitialRun, ObservedChannel, ParameterSpace, Role, ScoredRun, ScriptSimulator, Study, simulate_and_score,
};
use std::collections::BTreeMap;
use std::sync::Arc;

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
    /// Causes left out because runs held out had refuted their repair.
    pub(super) left_out: &'a [&'static str],
}

/// A repaired model.
pub(super) struct Repair {
    /// Hypothesis of the repair.
    pub(super) hypothesis: FittedHypothesis,
    /// Its optimum with the steps of the script.
    fitted: FittedModel,
    /// Channels of all runs; none for a run without a result.
    fits: Vec<Option<ScoredRun>>,
    pub(super) judgement: HoldoutJudgement,
    /// Errors of the runs held out.
    errors: Option<HeldOutErrors>,
    /// Limits of the probability of its cause.
    limits: Vec<ProbabilityLimit>,
}

impl Repair {
    /// A repair that has passed its own judgement.
    fn accepted(hypothesis: FittedHypothesis, fitted: FittedModel, fits: Vec<Option<ScoredRun>>) -> Self {
        Self { hypothesis, fitted, fits, judgement: HoldoutJudgement::Accepted, errors: None, limits: vec![] }
    }

    /// Returns true if the runs held out or a gate refuse it.
    fn is_refused(&self) -> bool {
        self.judgement.refutes() || self.limits.iter().any(|l| l.most == 0.0)
    }

    /// Its cause, or that of a faulty channel beside it, which bends to anything.
    fn most_flexible_cause(&self) -> &'static str {
        let second = self.hypothesis.second_cause().filter(|c| c.starts_with("sensor_"));
        second.unwrap_or(self.hypothesis.cause())
    }

    /// Errors of the runs held out, with its causes.
    fn evidence(&self, c: &ConclusionContext<'_>) -> RepairEvidence {
        let (cause, also) = (self.hypothesis.cause(), self.hypothesis.second_cause());
        let device_held_out = holdout::channel_nmse(c.study, &self.fits, &c.recorded.channel);
        RepairEvidence { cause: cause.into(), also: also.map(Into::into), errors: self.errors, device_held_out }
    }
}

/// Cause with the highest probability after the judgement of its repair.
pub(super) struct JudgedVerdict {
    pub(super) cause: &'static str,
    pub(super) repair: Repair,
    /// Cause of the nearest repair if none is written, because it has no name and worsens the runs held out.
    pub(super) refused: Option<&'static str>,
    /// Cause to leave out of a further search.
    refuted: Option<&'static str>,
    /// Causes, `none` and `unknown`, the most probable first.
    pub(super) probabilities: CauseProbabilities,
}

/// Diagnosis from ranked hypotheses.
pub(super) fn conclude(
    scheduler: &mut Scheduler<'_>,
    c: &ConclusionContext<'_>,
    ranking: &Ranking<'_>,
) -> Result<Diagnosis, String> {
    let Ranking { baseline, ranked, bootstrap, left_out } = ranking;
    let study = c.study;
    let (mut evidence, structure) = VerdictEvidence::of(&RankedStudy {
        study,
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
    let mut verdict_judge = VerdictJudge {
        scheduler,
        c,
        baseline,
        ranked,
        baseline_fits: &baseline_fits,
        structured_share: structure.share,
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
    // The verdict and its strongest competitor, each as fitted.
    let competitor = ranked.iter().find(|e| e.cause() != repair.hypothesis.cause() && e.cause() != "none");
    let observation = observation(verdict.cause, competitor.map(FittedHypothesis::cause));
    let next_test = competitor.filter(|_| repair.hypothesis.cause() != "none").and_then(|other| {
        discriminating_test(&c.simulator.factory(), study, c.imposed_motion, [&repair.hypothesis, other])
    });
    let named_repair = Some(&repair.fits).filter(|_| !matches!(verdict.cause, "none" | "unknown"));
    let values = &repair.fitted.values;
    let script = repaired_script(c.text, &c.initial_run.value_spans, c.point, &repair.hypothesis.variant, values);
    let opensees = opensees_script(&RepairedModelScript {
        simulator: c.simulator,
        text: c.text,
        point: c.point,
        repaired: &script,
        values: repair.hypothesis.variant.split(values).0,
        responses: c.responses,
        fits: &repair.fits,
    });
    let baseline_result = Baseline {
        fit_nmse: baseline.fitted.objective,
        holdout_nmse: holdout_nmse(study, &baseline_fits),
        parameters: values_by_name(&study.space, &baseline.fitted.values),
    };
    let mismatch = mismatches(study, c.responses, &baseline_fits, named_repair);
    let columns: Vec<Vec<String>> =
        (0..study.runs.len()).map(|r| c.simulator.column_names(r, &baseline.fitted.values)).collect();
    let residual_forces = if verdict.cause == "unknown" { missing_forces(c, &baseline_fits, &columns) } else { vec![] };
    let corrected = RepairedModel {
        script: "corrected.tcl".into(),
        opensees: opensees.is_ok().then(|| "corrected_opensees.tcl".into()),
        opensees_reason: opensees.as_ref().err().cloned(),
        parameters: values_by_name(&repair.hypothesis.variant.study.space, &repair.fitted.values),
        unused: repair.hypothesis.variant.unread_names(),
        fit_nmse: repair.fitted.objective,
        holdout_nmse: holdout_nmse(study, &repair.fits),
        channels: repair.hypothesis.variant.channel_faults(&repair.fitted.values),
    };
    let uncertainty = if verdict.cause == "unknown" { None } else { uncertainty_of(c, repair) };
    let mut in_words = verdict_in_words(c, ranking, &structure, &evidence, &verdict, uncertainty.as_ref());
    let repaired = FittedHypothesis { fitted: verdict.repair.fitted.clone(), ..repair.hypothesis.clone() };
    if let Some(shares) = phenomenon_shares(scheduler, baseline, c.point, &repaired)? {
        in_words.explanation += &shares.description();
        let named = !matches!(verdict.cause, "none" | "unknown");
        let within = causes_within_law(&shares.of_other_causes).into_iter().filter(|_| named);
        in_words.also.extend(within.map(str::to_owned));
    }
    scheduler.check_cancelled()?;
    in_words.summary = summary(&SummaryContext {
        study,
        script: c.text,
        inventory: c.inventory,
        verdict: (verdict.cause, in_words.confidence),
        also: &in_words.also,
        also_possible: &in_words.also_possible,
        variant: &repair.hypothesis.variant,
        values: &repair.fitted.values,
        uncertainty: uncertainty.as_ref(),
        baseline: &baseline_result,
        corrected: &corrected,
        mismatch: &mismatch,
        tried: c.tried,
        structure: &structure.description,
        memory: evidence.memory_sentence(),
        nearest: nearest_in_words(ranked, &evidence).filter(|_| verdict.repair.hypothesis.cause() == "none"),
        unsteady_channels: &structure.unsteady_channels,
        residual_forces: &residual_forces,
        columns: &columns,
        step_error: &c.step_error,
        script_steps: script_steps(c, &baseline.fitted.values),
        largest_work: c.responses.largest_work(),
        test: next_test.as_ref().map_or("", |t| &t.description),
    });
    if let Some(l) = &learned {
        l.tell(&mut in_words);
    }
    let unmoved_channels = unmoved_in_words(c.unmoved_channels, c.text);
    in_words.summary.what_next.splice(0..0, unmoved_channels.iter().map(UnmovedChannel::advice));
    let places = &in_words.summary.places;
    let device_loop = device_loop(c, repair, &columns, &blamed_parts(places, &residual_forces), &mismatch);
    let outcome = Outcome {
        study: if study.title.is_empty() { study.model.clone() } else { study.title.clone() },
        baseline: baseline_result,
        mismatch,
        residual_forces,
        verdict: in_words,
        corrected,
        unexplained_share: remaining_share(baseline, repair).min(1.0),
        bootstrap: bootstrap.clone(),
        unmoved_channels,
        evidence,
        prior: prior::numbers(),
        weights: verdict_model::weights(),
        preflight: None,
        learned,
        next_test: match &next_test {
            Some(t) => format!("{}; {observation}", t.description),
            None => observation,
        },
    };
    Ok(Diagnosis {
        outcome,
        repaired_script: script,
        opensees_script: opensees.ok(),
        ranking: ranked.iter().map(RankedHypothesis::of).collect(),
        displacements: displacements(c, &baseline.fitted.values),
        drawing: StructureDrawing::new(c.inventory, &columns),
        device_loop,
        repaired_fits: verdict.repair.fits,
        baseline_fits,
        next_test,
        evaluations: scheduler.evaluations(),
        structured_share: structure.share,
        structure: structure.description,
        refuted: verdict.refuted,
    })
}

/// Forces that the user's fitted model lacks. `columns` are the names of the observed columns by run.
fn missing_forces(
    c: &ConclusionContext<'_>,
    baseline_fits: &[Option<ScoredRun>],
    columns: &[Vec<String>],
) -> Vec<ResidualForce> {
    residual_forces(&FittedModelRuns {
        study: c.study,
        inventory: c.inventory,
        responses: c.fitted_responses,
        fits: baseline_fits,
        columns,
        units: &Units::of(c.study, c.text),
    })
}

/// Loop of the device that the verdict is about, before and after the repair.
fn device_loop(
    c: &ConclusionContext<'_>,
    repair: &Repair,
    columns: &[Vec<String>],
    blamed: &BlamedParts,
    mismatch: &[Mismatch],
) -> Option<DeviceLoop> {
    let (variant, values) = (&repair.hypothesis.variant, &repair.fitted.values);
    let after = repaired_responses(&c.simulator.factory(), c.text, c.point, variant, values);
    let sources = LoopSources {
        study: c.study,
        inventory: c.inventory,
        before: c.fitted_responses,
        after: after.as_ref(),
        columns,
        units: &Units::of(c.study, c.text),
        imposed_motion: c.imposed_motion,
    };
    sources.of_parts(blamed, mismatch)
}

/// Intervals of the repaired model's parameters; `None` if points beside the optimum have no result.
fn uncertainty_of(c: &ConclusionContext<'_>, repair: &Repair) -> Option<Uncertainty> {
    let (factory, variant) = (c.simulator.factory(), repair.hypothesis.variant.clone());
    let study = variant.study.clone();
    let problem = StudyProblem::new(study, c.threads.max(1), move || variant.simulator(&factory)).ok()?;
    uncertainty(&problem, &repair.fitted.point).ok()
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
}

impl VerdictJudge<'_, '_> {
    /// Repairs the most probable cause. If the runs held out lower its probability, the next most probable one follows.
    fn verdict(&mut self, evidence: &mut VerdictEvidence) -> Result<JudgedVerdict, String> {
        let mut repairs: Vec<(&'static str, Repair)> = vec![];
        let (cause, probabilities) = loop {
            let probabilities = cause_probabilities(evidence);
            let cause = probabilities[0].0;
            // Even for `unknown` the nearest repair is written.
            if repairs.iter().any(|(known, _)| *known == cause) || cause == "unknown" && !repairs.is_empty() {
                break (cause, probabilities);
            }
            let repair = self.best_repair(cause, evidence)?;
            let judged = repair.evidence(self.c);
            // A repair with limits of its own does not limit what is unknown.
            let stands = repair.limits.is_empty() && !repair.is_refused();
            let of_repair = evidence.limits_of_repair(&judged).into_iter();
            evidence.limits.extend(of_repair.filter(|l| l.cause != "unknown" || stands));
            evidence.judged.push(judged);
            evidence.limits.extend(repair.limits.clone());
            repairs.push((cause, repair));
        };
        let index = repairs.iter().position(|(known, _)| *known == cause).unwrap_or(0);
        let (repaired_cause, repair) = repairs.swap_remove(index);
        if cause == "unknown" && repair.is_refused() {
            let nearest = if repaired_cause == "unknown" { self.ranked[0].cause() } else { repaired_cause };
            let refuted = Some(repair.most_flexible_cause()).filter(|c| *c != "none");
            let repair = self.repair(self.baseline.clone())?;
            return Ok(JudgedVerdict { cause, repair, refused: Some(nearest), refuted, probabilities });
        }
        let hardly = matches!(repair.judgement, HoldoutJudgement::PartlyPredicted(share) if share < MIN_REPEATED_SHARE);
        let refuted = Some(repair.most_flexible_cause()).filter(|_| hardly && !evidence.left_out.is_empty());
        Ok(JudgedVerdict { cause, repair, refused: None, refuted, probabilities })
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
        Ok(repair)
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
        let fitted = fitted.ok_or("the repaired model has no answer with the steps of the script")?;
        let fits = fits_of_all_runs(c, variant, &fitted.values);
        self.scheduler.check_cancelled()?;
        let in_holdout = |f: &ChannelFault| {
            f.run.as_ref().is_none_or(|name| study.runs_of(Role::Holdout).any(|(_, r)| r.name == *name))
        };
        let affects_holdout = variant.edits_script() || variant.channel_faults(&fitted.values).iter().any(in_holdout);
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
            extent: c.inventory.extent,
            noise: c.recorded.noise,
            left: fitted.objective,
            simulate: &simulate,
        };
        let limits = gated.limits();
        Ok(Repair { hypothesis, fitted, fits, judgement, errors, limits })
    }
}

/// Share of the baseline's squared error that a repair leaves.
pub(super) fn remaining_share(baseline: &FittedHypothesis, repair: &Repair) -> f64 {
    let before = baseline.fitted.objective;
    if before > 0.0 { repair.fitted.objective / before } else { 1.0 }
}

fn values_by_name(space: &ParameterSpace, values: &[f64]) -> BTreeMap<String, f64> {
    space.parameters.iter().map(|p| p.name.clone()).zip(values.iter().copied()).collect()
}

//! The way from a study to its diagnosis.

use super::all_runs::displacements;
use super::conclusion::{ConclusionContext, Ranking, conclude};
use super::device_loop::DeviceLoop;
use super::discriminating_test::DiscriminatingTest;
use super::repair::RefutedEffect;
use super::result_file::Outcome;
use super::structure_drawing::StructureDrawing;
use crate::candidate::proposal::Proposal;
use crate::evidence::memory_evidence::ModelRuns;
use crate::evidence::ranking::{bootstrap_ranking, rank};
use crate::evidence::repeated_motion::{RepeatedMotions, compare_repeated};
use crate::fit::baseline::{fit_baseline, is_poor, refit_baseline};
use crate::fit::checkpoint::CheckpointEntry;
use crate::fit::evaluator_pool::EvaluatorPool;
use crate::fit::fitted::FittedHypothesis;
use crate::fit::global_search::GlobalScope;
use crate::fit::refit_competitors::refit_competitors;
use crate::fit::scheduler::{ProgressMonitor, Scheduler};
use crate::fit::screening::{FirstRound, best_forms, of_first_causes};
use crate::fit::search_settings::{FINALIST_CAUSES, MAX_RESTARTS, SECOND_ROUND_ITERATIONS};
use crate::fit::step_error::step_error;
use crate::fit::two_effect_search::two_effect_search;
use crate::fit::unmoved_channels::unmoved_channels;
use crate::fit::unread_parameters::with_unread_parameters;
use crate::hypothesis::{
    self, changed_condition,
    context::{ProposalContext, Sensitivities},
};
use crate::inspect::conditions::lacks_clock;
use crate::inspect::probe::{inspect_model, record_responses};
use crate::prior::{MIN_STRUCTURE_FOR_PAIRS, MIN_STRUCTURE_FOR_WHOLE_LAWS};
use crate::residual::drift::drift_may_be_noise;
use crate::residual::unmodelled_structure::unmodelled_structure;
use hysteron_identify::calibrate::Displacements;
use hysteron_identify::study::{InitialRun, Role, ScoredRun, ScriptSimulator, Study, simulate_and_score};

/// Settings of a diagnosis.
#[derive(Clone, Debug, Default)]
pub struct Settings {
    /// Causes to be left out of the library.
    pub excluded_causes: Vec<String>,
    /// True if times that count by one are seconds, not numbers of samples.
    pub counted_times_are_seconds: bool,
    /// Number of threads.
    pub threads: usize,
    /// Entries of an interrupted diagnosis of the same study and library.
    pub checkpoint: Vec<CheckpointEntry>,
}

/// Result of a diagnosis.
pub struct Diagnosis {
    /// Content of the result file.
    pub outcome: Outcome,
    /// Text of the repaired script.
    pub repaired_script: String,
    /// The same in OpenSees' standard commands; none if they cannot say the same.
    pub opensees_script: Option<String>,
    /// All ranked hypotheses, best first.
    pub ranking: Vec<RankedHypothesis>,
    /// Observed channels of the baseline, by run; none for a run without a result.
    pub baseline_fits: Vec<Option<ScoredRun>>,
    /// Observed channels of the repaired model, by run.
    pub repaired_fits: Vec<Option<ScoredRun>>,
    /// Displacements over which forces are plotted, by run.
    pub displacements: Displacements,
    /// The structure with its sensors.
    pub drawing: StructureDrawing,
    /// Loop of the device that the verdict is about; none without a device that moves.
    pub device_loop: Option<DeviceLoop>,
    /// Recommended test; none if the motions of the study allow none.
    pub next_test: Option<DiscriminatingTest>,
    /// Number of points at which the fitted runs were evaluated.
    pub evaluations: usize,
    /// Structured share of the residual of the best hypothesis.
    pub structured_share: f64,
    /// Kind of that structure, in words.
    pub structure: String,
    /// Effect of the best repair if the runs held out refute it and nothing else is named, or if a repeated search has
    /// found it and they hardly support it.
    pub(super) refuted: Option<RefutedEffect>,
}

/// A ranked hypothesis.
#[derive(Clone, Debug)]
pub struct RankedHypothesis {
    /// Its cause; `none` for the user's model.
    pub cause: &'static str,
    /// Its form, in words.
    pub form: String,
    /// Part of the model or channel that it changes, in words.
    pub location: String,
    /// Mean NMSE over fitted channels and runs.
    pub objective: f64,
    /// Log evidence from held-out samples, with prior odds, nats.
    pub log_evidence: f64,
}

impl RankedHypothesis {
    /// Content of the verdict about a fitted hypothesis.
    pub(super) fn of(e: &FittedHypothesis) -> Self {
        let proposal = e.variant.proposal.as_ref();
        Self {
            cause: e.cause(),
            form: proposal.map_or_else(String::new, |p| p.form.clone()),
            location: proposal.map_or_else(String::new, |p| p.location.clone()),
            objective: e.fitted.objective,
            log_evidence: e.log_evidence,
        }
    }
}

/// Returns false if the drift of a hypothesis may be slow noise.
fn drift_is_significant(study: &Study, e: &FittedHypothesis) -> bool {
    !drift_may_be_noise(study, &e.variant.channel_faults(&e.fitted.values), &e.fitted.fits)
}

/// Diagnoses a study whose script has been opened. `text` is the script.
///
/// # Errors
/// The model has no result at any values, the script makes no analysis, or the user cancelled.
pub fn diagnose(
    simulator: &ScriptSimulator,
    initial_run: &InitialRun,
    text: &str,
    settings: &Settings,
    monitor: &mut dyn ProgressMonitor,
) -> Result<Diagnosis, String> {
    let study = simulator.study().clone();
    let factory = simulator.factory();
    let pool = EvaluatorPool::new(factory.clone(), settings.threads).map_err(|e| e.to_string())?;
    let mut scheduler = Scheduler::new(study.clone(), pool, monitor, settings.checkpoint.clone());
    let baseline = fit_baseline(&mut scheduler, initial_run, text)?;

    // A poor fit says little of stiffnesses; the user's own values say more.
    let poor = is_poor(&baseline);
    let values = if poor { initial_run.values.clone() } else { baseline.fitted.values.clone() };
    let Some((point, inventory)) = inspect_model(&factory, &study, text, &values) else {
        return Err("the script makes no analysis".into());
    };
    let responses = record_responses(&factory, &study, text, &values, &point, &inventory, Role::Fit);
    let has_clock = settings.counted_times_are_seconds || inventory.base_excited || !lacks_clock(&study);
    let linearized = scheduler.linearize("what may have changed", &[&baseline])?.pop().flatten();
    let sensitivities = linearized.as_ref().map(|l| Sensitivities {
        residual: &l.residual,
        derivatives: &l.derivatives,
        channels: &l.channels,
    });
    let context = ProposalContext {
        inventory: &inventory,
        study: &study,
        responses: &responses,
        fits: &baseline.fitted.fits,
        sensitivities,
        values: &baseline.fitted.values,
        has_clock,
        text,
        model_end: point.byte().unwrap_or(text.len()),
        value_spans: &initial_run.value_spans,
    };
    let library = hypothesis::ALL.iter().filter(|h| !settings.excluded_causes.iter().any(|w| w == h.cause));
    let (without_clock, library): (Vec<_>, Vec<_>) = library.partition(|h| !has_clock && h.needs_clock);
    let (library, of_other_materials): (Vec<_>, Vec<_>) = library.into_iter().partition(|h| h.suits_material(&study));
    let causes_tried = library.len();
    let mut proposals: Vec<Proposal> = library.iter().flat_map(|h| h.proposals(&context)).collect();
    let structure = unmodelled_structure(&study, &responses, &baseline.fitted.fits, true);
    if structure.share > MIN_STRUCTURE_FOR_WHOLE_LAWS {
        // The strain of a law follows from the deformation, which the fitted baseline knows best.
        let of_baseline =
            || record_responses(&factory, &study, text, &baseline.fitted.values, &point, &inventory, Role::Fit);
        let fitted_responses = poor.then(of_baseline);
        let context = ProposalContext { responses: fitted_responses.as_ref().unwrap_or(&responses), ..context };
        let laws = library.iter().flat_map(|h| h.whole_laws(&context)).collect();
        proposals.extend(with_unread_parameters(&mut scheduler, &baseline, &point, laws)?);
    }

    let global = if poor { GlobalScope::affordable(&study, &proposals) } else { GlobalScope::Nothing };
    let first_round = FirstRound { baseline: &baseline, initial_run, point: &point, proposals: &proposals, global };
    let mut singles = first_round.fit(&mut scheduler)?;
    let unmoved_channels = unmoved_channels(&mut scheduler, &baseline, &point, &proposals)?;
    refit_competitors(&mut scheduler, &baseline, &mut singles)?;
    let best = singles.first().filter(|e| e.score() < baseline.score());
    let step_error = step_error(&mut scheduler, &baseline, best)?;
    scheduler.set_step_parts(step_error.parts);
    let baseline_of_script = baseline.clone();
    let baseline = if step_error.parts > 1 { refit_baseline(&mut scheduler, &baseline)? } else { baseline };
    let (recorded, device, fitted_responses) = {
        let values = &baseline_of_script.fitted.values;
        let responses =
            [Role::Fit, Role::Holdout].map(|r| record_responses(&factory, &study, text, values, &point, &inventory, r));
        let mut simulator = factory.simulator_of_script(study.clone(), text);
        let fit = |run: usize| simulate_and_score(&mut simulator, &study, run, values).ok();
        let fits: Vec<Option<ScoredRun>> = (0..study.runs.len()).map(fit).collect();
        let both = [&responses[0], &responses[1]];
        let imposed_motion = !inventory.base_excited;
        let runs =
            ModelRuns { study: &study, fits: &fits, responses: both, imposed_motion, has_clock, lone_device: false };
        let (evidence, device) = (runs.evidence(), runs.learnable_runs());
        let [fitted, _] = responses;
        (evidence, device, fitted)
    };
    let context = ConclusionContext {
        study: &study,
        recorded: &recorded,
        device,
        has_clock,
        simulator,
        initial_run,
        text,
        point: &point,
        responses: &responses,
        fitted_responses: &fitted_responses,
        imposed_motion: !inventory.base_excited,
        step_error,
        causes_without_clock: without_clock.iter().map(|h| h.cause).collect(),
        causes_of_other_materials: of_other_materials.iter().map(|h| h.cause).collect(),
        global_search_too_long: poor && global != GlobalScope::All,
        inventory: &inventory,
        tried: (proposals.len(), causes_tried),
        threads: settings.threads,
        unmoved_channels: &unmoved_channels,
    };
    let search = SecondSearch { context: &context, baseline: &baseline, baseline_of_script: &baseline_of_script };
    search.until_not_refuted(&mut scheduler, singles)
}

/// Motions of all runs that repeat.
fn repeated_motions(c: &ConclusionContext<'_>, values: &[f64]) -> RepeatedMotions {
    let motions: Vec<Option<Vec<f64>>> = displacements(c, values).into_iter().map(|motion| Some(motion?.1)).collect();
    RepeatedMotions::of(&motions)
}

/// From fitted single effects to the verdict.
struct SecondSearch<'a> {
    context: &'a ConclusionContext<'a>,
    baseline: &'a FittedHypothesis,
    /// The baseline with the steps of the script.
    baseline_of_script: &'a FittedHypothesis,
}

impl SecondSearch<'_> {
    /// Concludes from all single effects. If the runs held out refute the best repair and nothing else is named, the search
    /// starts again without its effect, as a flexible wrong effect may hide a right one. What is named then must predict them.
    fn until_not_refuted(
        &self,
        scheduler: &mut Scheduler<'_>,
        mut singles: Vec<FittedHypothesis>,
    ) -> Result<Diagnosis, String> {
        let mut left_out: Vec<&'static str> = vec![];
        let (mut restarts, mut first) = (0, None::<Diagnosis>);
        loop {
            let d = self.conclusion(scheduler, &singles, &left_out)?;
            let Some(refuted) = d.refuted.clone().filter(|_| restarts < MAX_RESTARTS) else {
                let stands = d.refuted.is_none() && !matches!(d.outcome.verdict.cause.as_str(), "none" | "unknown");
                return Ok(first.filter(|_| !stands).unwrap_or(d));
            };
            first.get_or_insert(d);
            restarts += 1;
            if !left_out.contains(&refuted.cause) {
                left_out.push(refuted.cause);
            }
            singles.retain(|e| !refuted.includes(e));
        }
    }

    /// Refines, ranks, pairs and judges single effects, the best first.
    fn conclusion(
        &self,
        scheduler: &mut Scheduler<'_>,
        singles: &[FittedHypothesis],
        left_out: &[&'static str],
    ) -> Result<Diagnosis, String> {
        let (c, baseline) = (self.context, self.baseline);
        scheduler.set_step_parts(c.step_error.parts);
        let finalists = best_forms(singles);
        let second_round = of_first_causes(&finalists, FINALIST_CAUSES);
        let mut ranked = scheduler.refine("the likeliest of them", second_round, SECOND_ROUND_ITERATIONS)?;
        ranked.push(baseline.clone());
        ranked.retain(|e| drift_is_significant(c.study, e));
        scheduler.hold_out("what it predicts", &mut ranked)?;
        rank(&mut ranked)?;
        let has_condition = ranked.iter().any(|e| e.cause() == changed_condition::CAUSE);
        let motions = has_condition.then(|| repeated_motions(c, &self.baseline_of_script.fitted.values));
        let motions = motions.unwrap_or_default();
        compare_repeated(c.study, &mut ranked, &motions);
        // A complete model lacks no two effects. Where no single effect gains anything, two together may.
        let left = || unmodelled_structure(c.study, c.responses, &ranked[0].fitted.fits, true).share;
        if ranked[0].cause() != "none" || left() > MIN_STRUCTURE_FOR_PAIRS {
            let mut pairs = two_effect_search(scheduler, baseline, &mut ranked, singles, c.point)?;
            pairs.retain(|e| drift_is_significant(c.study, e));
            if !pairs.is_empty() {
                ranked.extend(pairs);
                rank(&mut ranked)?;
                compare_repeated(c.study, &mut ranked, &motions);
            }
        }
        let bootstrap = bootstrap_ranking(scheduler, &ranked, &finalists)?;
        conclude(scheduler, c, &Ranking { baseline: self.baseline_of_script, ranked: &ranked, bootstrap, left_out })
    }
}

//! From the decision to what a diagnosis shows: words, files, loop and drawing.

use super::all_runs::{displacements, script_steps};
use super::conclusion::{ConclusionContext, Decision, Ranking, remaining_share};
use super::device_loop::{BlamedParts, DeviceLoop, LoopSources, blamed_parts, repaired_responses};
use super::diagnosis::{Diagnosis, RankedHypothesis};
use super::discriminating_test::{DiscriminatingTest, discriminating_test};
use super::explanation::observation;
use super::mismatch::mismatches;
use super::nearest::nearest_in_words;
use super::quantity::Units;
use super::repair::Repair;
use super::residual_force::{FittedModelRuns, ResidualForce, residual_forces};
use super::result_file::{Baseline, Mismatch, Outcome, RepairedModel, UnmovedChannel, Verdict};
use super::structure_drawing::StructureDrawing;
use super::summary::{Summary, SummaryContext, summary};
use super::unmoved::unmoved_in_words;
use super::verdict_in_words::verdict_in_words;
use crate::candidate::opensees_form::{RepairedModelScript, opensees_script};
use crate::candidate::repaired_script::repaired_script;
use crate::evidence::holdout::holdout_nmse;
use crate::evidence::second_effect::causes_within_law;
use crate::evidence::verdict_model;
use crate::fit::fitted::FittedHypothesis;
use crate::prior;
use hysteron_identify::calibrate::{StudyProblem, Uncertainty, uncertainty};
use hysteron_identify::study::{ParameterSpace, ScoredRun};
use std::collections::BTreeMap;

/// Measures of the decision that several parts of the diagnosis show.
struct Measures {
    baseline: Baseline,
    corrected: RepairedModel,
    uncertainty: Option<Uncertainty>,
    mismatch: Vec<Mismatch>,
    /// Names of the observed columns by run.
    columns: Vec<Vec<String>>,
    residual_forces: Vec<ResidualForce>,
}

/// Diagnosis from its decision. `evaluations` is the number of simulations of the fitted runs.
pub(super) fn present(
    c: &ConclusionContext<'_>,
    ranking: &Ranking<'_>,
    decision: Decision,
    evaluations: usize,
) -> Diagnosis {
    let (study, baseline) = (c.study, ranking.baseline);
    let scripts = Scripts::of(c, &decision.verdict.repair);
    let measures = measures(c, baseline, &decision, &scripts);
    let (next_test, observation) = recommended_test(c, ranking, &decision);
    let mut in_words = verdict_of(c, ranking, &decision, measures.uncertainty.as_ref());
    let test = next_test.as_ref().map_or("", |t| &t.description);
    in_words.summary = summary_of(c, ranking, &decision, &measures, &in_words, test);
    if let Some(learned) = &decision.learned {
        learned.tell(&mut in_words);
    }
    let unmoved_channels = unmoved_in_words(c.unmoved_channels, c.text);
    in_words.summary.what_next.splice(0..0, unmoved_channels.iter().map(UnmovedChannel::advice));
    let repair = &decision.verdict.repair;
    let blamed = blamed_parts(&in_words.summary.places, &measures.residual_forces);
    let device_loop = device_loop(c, repair, &measures.columns, &blamed, &measures.mismatch);
    let drawing = StructureDrawing::new(c.inventory, &measures.columns);
    let outcome = Outcome {
        study: if study.title.is_empty() { study.model.clone() } else { study.title.clone() },
        baseline: measures.baseline,
        mismatch: measures.mismatch,
        residual_forces: measures.residual_forces,
        verdict: in_words,
        corrected: measures.corrected,
        unexplained_share: remaining_share(baseline, repair).min(1.0),
        bootstrap: ranking.bootstrap.clone(),
        unmoved_channels,
        evidence: decision.evidence,
        prior: prior::numbers(),
        weights: verdict_model::weights(),
        preflight: None,
        learned: decision.learned,
        next_test: match &next_test {
            Some(t) => format!("{}; {observation}", t.description),
            None => observation,
        },
    };
    Diagnosis {
        outcome,
        repaired_script: scripts.repaired,
        opensees_script: scripts.opensees.ok(),
        ranking: ranking.ranked.iter().map(RankedHypothesis::of).collect(),
        displacements: displacements(c, &baseline.fitted.values),
        drawing,
        device_loop,
        repaired_fits: decision.verdict.repair.fits,
        baseline_fits: decision.baseline_fits,
        next_test,
        evaluations,
        structured_share: decision.structure.share,
        structure: decision.structure.description,
        refuted: decision.verdict.refuted.clone(),
    }
}

/// Scripts of the repaired model.
struct Scripts {
    repaired: String,
    /// The same in OpenSees' own commands, or why they cannot say it.
    opensees: Result<String, String>,
}

impl Scripts {
    fn of(c: &ConclusionContext<'_>, repair: &Repair) -> Self {
        let (variant, values) = (&repair.hypothesis.variant, &repair.fitted.values);
        let repaired = repaired_script(c.text, &c.initial_run.value_spans, c.point, variant, values);
        let opensees = opensees_script(&RepairedModelScript {
            simulator: c.simulator,
            text: c.text,
            point: c.point,
            repaired: &repaired,
            values: variant.split(values).0,
            responses: c.responses,
            fits: &repair.fits,
        });
        Self { repaired, opensees }
    }
}

fn measures(
    c: &ConclusionContext<'_>,
    baseline: &FittedHypothesis,
    decision: &Decision,
    scripts: &Scripts,
) -> Measures {
    let (study, baseline_fits, verdict) = (c.study, &decision.baseline_fits, &decision.verdict);
    let repair = &verdict.repair;
    let named_repair = Some(&repair.fits).filter(|_| !matches!(verdict.cause, "none" | "unknown"));
    let columns: Vec<Vec<String>> =
        (0..study.runs.len()).map(|r| c.simulator.column_names(r, &baseline.fitted.values)).collect();
    let unknown = verdict.cause == "unknown";
    Measures {
        baseline: Baseline {
            fit_nmse: baseline.fitted.objective,
            holdout_nmse: holdout_nmse(study, baseline_fits),
            parameters: values_by_name(&study.space, &baseline.fitted.values),
        },
        corrected: RepairedModel {
            script: "corrected.tcl".into(),
            opensees: scripts.opensees.is_ok().then(|| "corrected_opensees.tcl".into()),
            opensees_reason: scripts.opensees.as_ref().err().cloned(),
            parameters: values_by_name(&repair.hypothesis.variant.study.space, &repair.fitted.values),
            unused: repair.hypothesis.variant.unread_names(),
            fit_nmse: repair.fitted.objective,
            holdout_nmse: holdout_nmse(study, &repair.fits),
            channels: repair.hypothesis.variant.channel_faults(&repair.fitted.values),
        },
        uncertainty: if unknown { None } else { uncertainty_of(c, repair) },
        mismatch: mismatches(study, c.responses, baseline_fits, named_repair),
        residual_forces: if unknown { missing_forces(c, baseline_fits, &columns) } else { vec![] },
        columns,
    }
}

/// Test that separates the repair from its strongest competitor, and the observation that would refute the verdict.
fn recommended_test(
    c: &ConclusionContext<'_>,
    ranking: &Ranking<'_>,
    decision: &Decision,
) -> (Option<DiscriminatingTest>, String) {
    let repair = &decision.verdict.repair;
    // The verdict and its strongest competitor, each as fitted.
    let competitor = ranking.ranked.iter().find(|e| e.cause() != repair.hypothesis.cause() && e.cause() != "none");
    let observation = observation(decision.verdict.cause, competitor.map(FittedHypothesis::cause));
    let test = competitor.filter(|_| repair.hypothesis.cause() != "none").and_then(|other| {
        discriminating_test(&c.simulator.factory(), c.study, c.imposed_motion, [&repair.hypothesis, other])
    });
    (test, observation)
}

/// The verdict in words, with the phenomena of a whole law.
fn verdict_of(
    c: &ConclusionContext<'_>,
    ranking: &Ranking<'_>,
    decision: &Decision,
    uncertainty: Option<&Uncertainty>,
) -> Verdict {
    let verdict = &decision.verdict;
    let mut in_words = verdict_in_words(c, ranking, &decision.structure, &decision.evidence, verdict, uncertainty);
    if let Some(phenomena) = &decision.phenomena {
        in_words.explanation += &phenomena.description();
        let named = !matches!(verdict.cause, "none" | "unknown");
        let within = causes_within_law(&phenomena.of_other_causes).into_iter().filter(|_| named);
        in_words.also.extend(within.map(str::to_owned));
    }
    in_words
}

fn summary_of(
    c: &ConclusionContext<'_>,
    ranking: &Ranking<'_>,
    decision: &Decision,
    measures: &Measures,
    in_words: &Verdict,
    test: &str,
) -> Summary {
    let (verdict, structure, evidence) = (&decision.verdict, &decision.structure, &decision.evidence);
    let repair = &verdict.repair;
    summary(&SummaryContext {
        study: c.study,
        script: c.text,
        inventory: c.inventory,
        verdict: (verdict.cause, in_words.confidence),
        also: &in_words.also,
        also_possible: &in_words.also_possible,
        variant: &repair.hypothesis.variant,
        values: &repair.fitted.values,
        uncertainty: measures.uncertainty.as_ref(),
        baseline: &measures.baseline,
        corrected: &measures.corrected,
        mismatch: &measures.mismatch,
        tried: c.tried,
        structure: &structure.description,
        memory: evidence.memory_sentence(),
        nearest: nearest_in_words(ranking.ranked, evidence).filter(|_| repair.hypothesis.cause() == "none"),
        unsteady_channels: &structure.unsteady_channels,
        residual_forces: &measures.residual_forces,
        columns: &measures.columns,
        step_error: &c.step_error,
        script_steps: script_steps(c, &ranking.baseline.fitted.values),
        largest_work: c.responses.largest_work(),
        test,
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
pub(super) fn uncertainty_of(c: &ConclusionContext<'_>, repair: &Repair) -> Option<Uncertainty> {
    let (factory, variant) = (c.simulator.factory(), repair.hypothesis.variant.clone());
    let study = variant.study.clone();
    let problem = StudyProblem::new(study, c.threads.max(1), move || variant.simulator(&factory)).ok()?;
    let mut uncertainty = uncertainty(&problem, &repair.fitted.point).ok()?;
    repair.times.iter().for_each(|time| time.correct(&mut uncertainty));
    Some(uncertainty)
}

fn values_by_name(space: &ParameterSpace, values: &[f64]) -> BTreeMap<String, f64> {
    space.parameters.iter().map(|p| p.name.clone()).zip(values.iter().copied()).collect()
}

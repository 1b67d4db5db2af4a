//! Channels and displacements of a model in all runs of a study.

use super::conclusion::ConclusionContext;
use crate::candidate::variant::Variant;
use crate::prior::NEGLIGIBLE_STEP_ERROR;
use hysteron_identify::study::{Role, ScoredRun, simulate_and_score};
use std::sync::Arc;

/// Displacement of each run with its name: recorded, or simulated for the most deformed device under an imposed motion.
pub(super) fn displacements(c: &ConclusionContext<'_>, values: &[f64]) -> Vec<Option<(String, Vec<f64>)>> {
    let simulated = |r: usize| -> Option<(String, Vec<f64>)> {
        let of_run = c.responses.histories.iter().filter(|((run, ..), _)| *run == r && c.imposed_motion);
        let largest = of_run.max_by(|a, b| a.1.range().deformation.total_cmp(&b.1.range().deformation));
        let ((_, tag, _), h) = largest?;
        (h.deformation.len() == c.study.runs[r].recording.times.len())
            .then(|| (format!("deformation of element {tag}, simulated"), h.deformation.clone()))
    };
    let of_run = |r: usize| c.simulator.displacement(r, values).or_else(|| simulated(r));
    (0..c.study.runs.len()).map(of_run).collect()
}

/// Channels of a variant in all runs with the steps of the script; `None` for a run without a result.
pub(super) fn fits_of_all_runs(
    c: &ConclusionContext<'_>,
    variant: &Arc<Variant>,
    values: &[f64],
) -> Vec<Option<ScoredRun>> {
    let mut simulator = variant.simulator(&c.simulator.factory());
    (0..c.study.runs.len()).map(|r| simulate_and_score(&mut simulator, c.study, r, values).ok()).collect()
}

/// Steps that the script makes in the first fitted run, counted only if their error matters.
pub(super) fn script_steps(c: &ConclusionContext<'_>, values: &[f64]) -> Option<usize> {
    let (first, _) = c.study.runs_of(Role::Fit).next().filter(|_| c.step_error.share > NEGLIGIBLE_STEP_ERROR)?;
    let simulator = c.simulator.factory().simulator_of_script(c.study.clone(), c.text);
    usize::try_from(simulator.inspect_model(first, values, |e| e.steps)).ok()
}

//! A parameter of the user's that had another value in one run: a band that was tightened, a valve that was turned.

use super::context::distinguishing_variable;
use super::{AddedParameter, Hypothesis, Proposal, ProposalContext};
use crate::candidate::proposal::TextEdit;
use hysteron_identify::study::{Role, Run, objective};

/// The cause.
pub(crate) const CAUSE: &str = "changed_condition";

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: CAUSE,
    statement: "a parameter of the model had another value in one run",
    refuted_by: "the run, repeated under the condition of the others, differs from them as much",
    look_alikes: &["sensor_gain", "ambient_temperature"],
    needs_clock: false,
    memory: &[],
    propose,
};

/// Runs that are considered at most, those with the largest error.
const MAX_RUNS: usize = 3;
/// Parameters that are considered at most.
const MAX_PARAMETERS: usize = 6;
/// Range of the factor on the parameter. A change beyond it would be known to those who made it.
const FACTORS: [f64; 2] = [0.2, 5.0];

/// The fitted runs that may have another value.
fn runs<'a>(s: &ProposalContext<'a>) -> Vec<&'a Run> {
    let mut fitted: Vec<(&Run, f64)> =
        s.study.runs_of(Role::Fit).zip(s.fits).map(|((_, run), fit)| (run, objective(s.study, &[fit]))).collect();
    if fitted.len() < 2 {
        return vec![];
    }
    // Of two fitted runs either may be the other one, which only runs held out tell.
    if fitted.len() == 2 && s.study.runs_of(Role::Holdout).next().is_none() {
        fitted.remove(0);
    }
    fitted.sort_by(|a, b| b.1.total_cmp(&a.1));
    fitted.into_iter().take(MAX_RUNS).map(|(run, _)| run).collect()
}

fn propose(s: &ProposalContext<'_>) -> Vec<Proposal> {
    let Some(variable) = distinguishing_variable(s.study) else { return vec![] };
    let mut out = vec![];
    for run in runs(s) {
        let Some(text) = run.text(&variable) else { continue };
        for (index, _) in s.study.space.free().take(MAX_PARAMETERS) {
            let name = &s.study.space.parameters[index].name;
            let Some((start, end)) = s.value_spans.get(index).copied().flatten() else { continue };
            let Some(first) = s.text.get(..start).and_then(|before| before.rfind("pset")) else { continue };
            let insertion =
                format!("\nif {{$::{variable} eq {{{text}}}}} {{set {name} [expr {{${name}*$::hy_changed}}]}}");
            let mut factor = AddedParameter::log("changed", FACTORS[0], FACTORS[1], 1.3);
            factor.further_starts = vec![0.75];
            let location = format!("{name} in the run {}", run.name);
            let proposal = Proposal::script_edit(CAUSE, "another value of a parameter", location, vec![], vec![factor]);
            out.push(Proposal {
                option_edits: vec![TextEdit { start: end, end, text: insertion }],
                declared_at: Some(first),
                ..proposal
            });
        }
    }
    out
}

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
/// Parameters that are considered in pairs at most.
const MAX_TOGETHER: usize = 4;
/// Beginning of the name of a factor, in front of that of the parameter.
pub(crate) const FACTOR_ON: &str = "factor_on_";
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

/// A parameter of the user's that is read from the script.
struct Declared<'a> {
    name: &'a str,
    /// First byte of its command, and the byte behind its value.
    command: usize,
    end: usize,
}

/// Free parameters whose value stands in the script.
fn declared<'a>(s: &ProposalContext<'a>) -> Vec<Declared<'a>> {
    let of = |(index, _): (usize, _)| {
        let name = s.study.space.parameters[index].name.as_str();
        let (start, end) = s.value_spans.get(index).copied().flatten()?;
        let command = s.text.get(..start)?.rfind("pset")?;
        let plain = name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
        plain.then_some(Declared { name, command, end })
    };
    s.study.space.free().filter_map(of).take(MAX_PARAMETERS).collect()
}

/// Other values of some parameters in a run that has a value of the variable to itself.
fn proposal(run: &Run, (variable, value): (&str, &str), changed: &[&Declared<'_>]) -> Proposal {
    let names: Vec<&str> = changed.iter().map(|p| p.name).collect();
    let factor = |p: &&Declared<'_>| {
        let mut factor = AddedParameter::log(&factor_name(p.name), FACTORS[0], FACTORS[1], 1.3);
        factor.further_starts = vec![0.75];
        factor
    };
    let edit = |p: &&Declared<'_>| {
        let (name, factor) = (p.name, factor_name(p.name));
        let text = format!("\nif {{$::{variable} eq {{{value}}}}} {{set {name} [expr {{${name}*$::hy_{factor}}}]}}");
        TextEdit { start: p.end, end: p.end, text }
    };
    let form = if changed.len() == 1 { "another value of a parameter" } else { "other values of several parameters" };
    let location = format!("{} in the run {}", names.join(" and "), run.name);
    let parameters = changed.iter().map(factor).collect();
    Proposal {
        option_edits: changed.iter().map(edit).collect(),
        declared_at: changed.iter().map(|p| p.command).min(),
        ..Proposal::script_edit(CAUSE, form, location, vec![], parameters)
    }
}

/// Name of the factor on a parameter, which says what it is.
fn factor_name(parameter: &str) -> String {
    format!("{FACTOR_ON}{parameter}")
}

fn propose(s: &ProposalContext<'_>) -> Vec<Proposal> {
    let Some(variable) = distinguishing_variable(s.study) else { return vec![] };
    let declared = declared(s);
    let mut out = vec![];
    for run in runs(s) {
        // The value stands between braces in the script.
        let Some(value) = run.text(&variable).filter(|v| !v.contains(['{', '}', '\\'])) else { continue };
        let place = (variable.as_str(), value.as_str());
        out.extend(declared.iter().map(|p| proposal(run, place, &[p])));
        // Other values of all parameters in a run are another fit, not a condition.
        let together = if declared.len() > 2 { &declared[..declared.len().min(MAX_TOGETHER)] } else { &[] };
        for (i, first) in together.iter().enumerate() {
            out.extend(together[i + 1..].iter().map(|second| proposal(run, place, &[first, second])));
        }
    }
    out
}

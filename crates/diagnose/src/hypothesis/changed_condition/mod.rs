//! A parameter of the user's that had another value in one run, or for a part of it: a band that was tightened, a valve that
//! was turned.

mod change_points;
mod in_time;
mod runs_held_out;

pub(crate) use runs_held_out::held_in_too;

use super::context::distinguishing_variable;
use super::{AddedParameter, Hypothesis, Proposal, ProposalContext};
use crate::candidate::proposal::{ChangedCondition, TextEdit};
use crate::hypothesis::declaration::{Dimension, Measurement, Quantity};
use crate::prior::{
    CONDITION_FACTORS, MAX_CONDITION_PARAMETERS, MAX_CONDITION_PARAMETERS_IN_PAIRS, MAX_CONDITION_RUNS,
};
use hysteron_identify::study::{Role, Run, objective};

/// The cause.
pub(crate) const CAUSE: &str = "changed_condition";

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: CAUSE,
    statement: "a parameter of the model had another value in one run or for a part of it, or changed slowly",
    refuted_by: "the run, repeated under one and the same condition, differs as much",
    look_alikes: &["sensor_gain", "ambient_temperature"],
    shows: "one run differs from the first cycle on, or from one moment to another, as another value of one parameter of the model makes it",
    parted_by: "`sensor_gain` scales elastic and hysteretic force alike, and every run of the instrument; `cyclic_degradation` and `self_heating` follow the work, without a moment at which they begin, and rest where the motion rests; a ramp goes on",
    place: "up to six parameters with a value in the script, in up to three of at least two fitted runs, where a variable of the study tells the runs apart. A run held out takes the values that it clearly follows",
    forms: "other values of one parameter, or of two of the first four where there are others, in one run. Factors go from 0.05 to 20. Another value of one from a time on, up to a time, or between two times. At most four spans of the scan, in a run that a variable tells apart. A ramp to another value in a run, or back to the usual one. A ramp by the clock of every run",
    needs_clock: false,
    memory: &[],
    materials: &[],
    measurement: Measurement::new(
        "ask what was adjusted, repaired or replaced between the earthquakes",
        "ask what was adjusted between the runs, and repeat one run under the condition of the others",
    ),
    quantities: &[
        Quantity::new("from", "time from which it holds, or changes", Dimension::Time),
        Quantity::new("to", "time up to which it holds, or changes", Dimension::Time),
    ],
    propose,
};

/// Beginning of the name of a factor, in front of that of the parameter.
pub(crate) const FACTOR_ON: &str = "factor_on_";
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
    fitted.into_iter().take(MAX_CONDITION_RUNS).map(|(run, _)| run).collect()
}

/// A parameter of the user's that is read from the script.
struct Declared<'a> {
    name: &'a str,
    /// Number in the study, and among the free parameters.
    index: usize,
    coordinate: usize,
    /// First byte of its command, and the byte behind its value.
    command: usize,
    end: usize,
}

/// Free parameters whose value stands in the script.
fn declared<'a>(s: &ProposalContext<'a>) -> Vec<Declared<'a>> {
    let of = |(coordinate, (index, _)): (usize, (usize, _))| {
        let name = s.study.space.parameters[index].name.as_str();
        let (start, end) = s.value_spans.get(index).copied().flatten()?;
        let command = s.text.get(..start)?.rfind("pset")?;
        let plain = name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
        plain.then_some(Declared { name, index, coordinate, command, end })
    };
    s.study.space.free().enumerate().filter_map(of).take(MAX_CONDITION_PARAMETERS).collect()
}

/// Condition of a script that holds in a run, which has a value of the variable to itself. The value stands between braces in
/// the script: `None` for one that has braces.
fn holds_in(run: &Run, variable: &str) -> Option<String> {
    let value = run.text(variable).filter(|v| !v.contains(['{', '}', '\\']))?;
    Some(format!("$::{variable} eq {{{value}}}"))
}

/// A command that runs only in a run.
fn only_in_run(run: &Run, variable: &str, command: &str) -> Option<String> {
    Some(format!("if {{{}}} {{{command}}}", holds_in(run, variable)?))
}

/// Other values of some parameters in a run.
fn proposal(run: &Run, variable: &str, changed: &[&Declared<'_>]) -> Option<Proposal> {
    let names: Vec<&str> = changed.iter().map(|p| p.name).collect();
    let factor = |p: &&Declared<'_>| {
        let mut factor = AddedParameter::log(&factor_name(p.name), CONDITION_FACTORS[0], CONDITION_FACTORS[1], 1.3);
        factor.further_starts = vec![0.75];
        factor
    };
    let edit = |p: &&Declared<'_>| {
        let (name, factor) = (p.name, factor_name(p.name));
        let command = only_in_run(run, variable, &format!("set {name} [expr {{${name}*$::hy_{factor}}}]"))?;
        Some(TextEdit { start: p.end, end: p.end, text: format!("\n{command}") })
    };
    let form = if changed.len() == 1 { "another value of a parameter" } else { "other values of several parameters" };
    let word = if changed.len() == 1 { "parameter" } else { "parameters" };
    let location = format!("{word} {} in the run {}", names.join(" and "), run.name);
    let parameters: Vec<AddedParameter> = changed.iter().map(factor).collect();
    let factors = changed.iter().zip(&parameters).map(|(p, a)| (p.name.to_owned(), a.name.clone())).collect();
    Some(Proposal {
        option_edits: changed.iter().map(edit).collect::<Option<_>>()?,
        declared_at: changed.iter().map(|p| p.command).min(),
        condition: Some(ChangedCondition { run: Some(run.name.clone()), factors, ..ChangedCondition::default() }),
        ..Proposal::script_edit(CAUSE, form, location, vec![], parameters)
    })
}

/// Name of the factor on a parameter, which says what it is.
fn factor_name(parameter: &str) -> String {
    format!("{FACTOR_ON}{parameter}")
}

fn propose(s: &ProposalContext<'_>) -> Vec<Proposal> {
    let mut out = in_time::proposals(s);
    let Some(variable) = distinguishing_variable(s.study) else { return out };
    let declared = declared(s);
    for run in runs(s) {
        out.extend(declared.iter().filter_map(|p| proposal(run, &variable, &[p])));
        // Other values of all parameters in a run are another fit, not a condition.
        let together =
            if declared.len() > 2 { &declared[..declared.len().min(MAX_CONDITION_PARAMETERS_IN_PAIRS)] } else { &[] };
        for (i, first) in together.iter().enumerate() {
            out.extend(together[i + 1..].iter().filter_map(|second| proposal(run, &variable, &[first, second])));
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::{Declared, only_in_run, proposal};
    use crate::test_support::pad_study;
    use hysteron_identify::study::Setting;

    /// Two parameters of a script `pset Fy 9.0` and `pset k 300.0`, each on its line.
    const DECLARED: [Declared<'_>; 2] = [
        Declared { name: "Fy", index: 0, coordinate: 0, command: 0, end: 11 },
        Declared { name: "k", index: 1, coordinate: 1, command: 12, end: 24 },
    ];

    #[test]
    fn other_values_hold_in_one_run_behind_their_declarations() {
        let mut run = pad_study().runs[0].clone();
        run.set = vec![("motion".into(), Setting::Text("a.dat".into()))];
        let p = proposal(&run, "motion", &[&DECLARED[0], &DECLARED[1]]).expect("a proposal");
        let edit = &p.option_edits[1];
        let told = "\nif {$::motion eq {a.dat}} {set k [expr {$k*$::hy_factor_on_k}]}";
        assert_eq!((edit.start, edit.end, edit.text.as_str()), (24, 24, told));
        // Factors are declared before the first of the parameters.
        assert_eq!((p.declared_at, p.parameters.len(), p.change_points()), (Some(0), 2, 0));
        let condition = p.condition.expect("a condition");
        assert_eq!(condition.run.as_deref(), Some(run.name.as_str()));
        assert_eq!(condition.factors[1], ("k".to_owned(), "hy_factor_on_k".to_owned()));
    }

    /// A value that ends a word between braces cannot tell a run.
    #[test]
    fn values_with_braces_tell_no_run() {
        let mut run = pad_study().runs[0].clone();
        run.set = vec![("motion".into(), Setting::Text("a}.dat".into()))];
        assert!(proposal(&run, "motion", &[&DECLARED[0]]).is_none() && only_in_run(&run, "motion", "x").is_none());
        assert!(only_in_run(&run, "other", "x").is_none());
    }
}

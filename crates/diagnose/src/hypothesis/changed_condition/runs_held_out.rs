//! Other values of the user's parameters in runs that were not fitted: which condition a run was made under has to be known
//! before it is predicted.

use super::super::context::distinguishing_variable;
use super::holds_in;
use crate::candidate::proposal::{ChangedCondition, Proposal};
use hysteron_identify::study::{Run, Study};

/// The proposal whose other values hold in further runs too; `None` where a script cannot tell these, or where the values hold
/// for a part of a run.
pub(crate) fn held_in_too(proposal: &Proposal, study: &Study, further: &[&Run]) -> Option<Proposal> {
    let condition = proposal.condition.as_ref().filter(|c| c.is_of_whole_run())?;
    let variable = distinguishing_variable(study)?;
    let first = study.runs.iter().find(|r| condition.run.as_ref() == Some(&r.name))?;
    let alone = holds_in(first, &variable)?;
    let all: Option<Vec<String>> = further.iter().map(|run| holds_in(run, &variable)).collect();
    let in_all = format!("if {{{alone} || {}}}", all?.join(" || "));
    let mut out = proposal.clone();
    let alone = format!("if {{{alone}}}");
    out.option_edits.iter_mut().for_each(|e| e.text = e.text.replace(&alone, &in_all));
    let also_in = further.iter().map(|run| run.name.clone()).collect();
    out.condition = Some(ChangedCondition { also_in, ..condition.clone() });
    Some(out)
}

#[cfg(test)]
mod tests {
    use super::held_in_too;
    use crate::candidate::proposal::{ChangedCondition, Proposal, TextEdit};
    use crate::test_support::{pad_study, script_edit};
    use hysteron_identify::study::Setting;

    #[test]
    fn other_values_of_a_run_hold_in_a_further_run() {
        let mut study = pad_study();
        for (k, run) in study.runs.iter_mut().enumerate() {
            run.set = vec![("motion".into(), Setting::Text(format!("{k}.dat")))];
        }
        let edit = TextEdit { start: 0, end: 0, text: "\nif {$::motion eq {0.dat}} {set k 2}".into() };
        let condition = ChangedCondition { run: Some(study.runs[0].name.clone()), ..ChangedCondition::default() };
        let proposal = Proposal {
            option_edits: vec![edit],
            condition: Some(condition.clone()),
            ..script_edit("changed_condition", &[])
        };
        let further = study.runs.last().expect("a run");
        let last = study.runs.len() - 1;
        let both = held_in_too(&proposal, &study, &[further]).expect("a proposal");
        let told = format!("\nif {{$::motion eq {{0.dat}} || $::motion eq {{{last}.dat}}}} {{set k 2}}");
        assert_eq!(both.option_edits[0].text, told);
        assert_eq!(both.condition.expect("a condition").also_in, std::slice::from_ref(&further.name));
        // Values that hold from a time on have a time of each run.
        let in_part = ChangedCondition { from: Some("hy_from".into()), ..condition };
        let proposal = Proposal { condition: Some(in_part), ..proposal };
        assert!(held_in_too(&proposal, &study, &[further]).is_none());
    }
}

//! The condition under which a run held out was made, where a repair says that one fitted run was made under another.

use super::all_runs::fits_of_all_runs;
use super::conclusion::ConclusionContext;
use crate::candidate::variant::Variant;
use crate::fit::fitted::FittedHypothesis;
use crate::hypothesis::changed_condition;
use crate::prior::FOLLOWS_OTHER_VALUES;
use hysteron_identify::study::{Role, Run, ScoredRun};
use std::sync::Arc;

/// The repair with its other values in the runs held out that clearly follow them, and the channels of all runs; `None` where no
/// run does. Nothing is fitted: a run takes one of two sets of values.
pub(super) fn with_conditions_of_runs_held_out(
    c: &ConclusionContext<'_>,
    user: &Variant,
    repair: &FittedHypothesis,
    fits: &[Option<ScoredRun>],
) -> Option<(FittedHypothesis, Vec<Option<ScoredRun>>)> {
    let proposal = repair.variant.proposal.as_ref()?;
    let held_out: Vec<(usize, &Run)> = c.study.runs_of(Role::Holdout).collect();
    let changed_in = |runs: &[(usize, &Run)]| {
        let runs: Vec<&Run> = runs.iter().map(|(_, run)| *run).collect();
        let proposal = changed_condition::held_in_too(proposal, c.study, &runs).filter(|_| !runs.is_empty())?;
        user.with_proposal(c.point, &proposal).map(Arc::new)
    };
    let in_all = fits_of_all_runs(c, &changed_in(&held_out)?, &repair.fitted.values);
    let follows = |(i, run): &(usize, &Run)| {
        let nmse = |fits: &[Option<ScoredRun>]| fits[*i].as_ref().map(|fit| fit.nmse(&run.observe));
        follows_other_values(nmse(fits), nmse(&in_all))
    };
    let followers: Vec<(usize, &Run)> = held_out.into_iter().filter(follows).collect();
    let variant = changed_in(&followers)?;
    let mut fits = fits.to_vec();
    followers.iter().for_each(|(i, _)| fits[*i].clone_from(&in_all[*i]));
    Some((FittedHypothesis { variant, ..repair.clone() }, fits))
}

/// Returns true if a run clearly follows the other values, by its errors with the usual and with the other ones.
fn follows_other_values(usual: Option<f64>, other: Option<f64>) -> bool {
    other.is_some_and(|other| usual.is_none_or(|usual| other < FOLLOWS_OTHER_VALUES * usual))
}

#[cfg(test)]
mod tests {
    use super::follows_other_values;

    #[test]
    fn a_run_follows_the_values_that_leave_clearly_less() {
        assert!(follows_other_values(Some(0.4), Some(0.1)));
        assert!(!follows_other_values(Some(0.4), Some(0.3)));
        assert!(follows_other_values(None, Some(0.3)));
        assert!(!follows_other_values(Some(0.4), None));
    }
}

//! Doubts about a study: too few samples, no run held out, values outside of their bounds, parameters without effect.

use super::load::{Study, StudyError};
use super::parameter::ParameterRange;
use super::run::{Role, Run};
use super::script_simulator::ScriptSimulator;
use super::simulator::{SimulationError, Simulator};
use crate::checks::{FEW_SAMPLES, NO_EFFECT, NO_HOLDOUT, OUTSIDE_BOUNDS};
use hysteron_tcl::diagnostic::{Diagnostic, Severity, Span};

/// Samples for each free parameter below which a fit is hardly more than an interpolation.
const MIN_SAMPLES_PER_PARAMETER: usize = 3;

/// Warnings and notes about the runs for a number of free parameters. `at` is the location of the study.
///
/// # Errors
/// There are fewer samples than parameters.
pub(super) fn check_runs(runs: &[Run], free: usize, at: Span) -> Result<Vec<Diagnostic>, StudyError> {
    let mut found = vec![];
    let observed = runs.iter().filter(|r| r.role == Role::Fit).flat_map(|r| &r.observe).filter(|o| o.weight > 0.0);
    let samples: usize = observed.map(|o| o.values.iter().filter(|v| !v.is_nan()).count()).sum();
    let plural = if free == 1 { "" } else { "s" };
    let message = format!("{samples} samples are fitted by {free} parameter{plural}");
    if samples < free {
        return Err(Box::new(Diagnostic::error(message).at(Some(at), "expected more samples than parameters")));
    }
    if samples < MIN_SAMPLES_PER_PARAMETER * free {
        found.push(Diagnostic::warning(&FEW_SAMPLES, message).at(Some(at), "a fit of so few proves nothing"));
    }
    if !runs.iter().any(|r| r.role == Role::Holdout) {
        let note = Diagnostic::warning(&NO_HOLDOUT, "no run is held out, so that nothing judges the fit");
        let note = note.at(Some(at), "give a run the role \"holdout\"");
        found.push(Diagnostic { severity: Severity::Note, ..note });
    }
    Ok(found)
}

/// Warnings of free parameters whose own values in the script are outside of their bounds.
pub(super) fn outside_bounds(study: &Study, values: &[f64]) -> Vec<Diagnostic> {
    let outside = study.space.free().filter(|(i, range)| values[*i] < range.lower || values[*i] > range.upper);
    let warning = |(i, range): (usize, &ParameterRange)| {
        let (name, value) = (&study.space.parameters[i].name, values[i]);
        let message =
            format!("{name} is {value} in the script, outside of its bounds {} to {}", range.lower, range.upper);
        Diagnostic::warning(&OUTSIDE_BOUNDS, message)
            .at(Some(study.spans.names[i]), "the search starts from the nearer bound")
    };
    outside.map(warning).collect()
}

/// Warnings of free parameters that change no observed channel of any fitted run, from the script's own value to either
/// bound. One run of the script a parameter is usual.
pub(super) fn insensitive_parameters(simulator: &mut ScriptSimulator, values: &[f64]) -> Vec<Diagnostic> {
    let study = simulator.study.clone();
    let space = &study.space;
    let own = space.unit_point(values);
    let runs: Vec<usize> = study.runs_of(Role::Fit).map(|(number, _)| number).collect();
    let Ok(initial) = space.values_at(&own) else { return vec![] };
    let mut responses: Vec<Option<Vec<Vec<f64>>>> = vec![None; runs.len()];
    let mut found = vec![];
    for (coordinate, (i, range)) in space.free().enumerate() {
        let bounds = if own[coordinate] < 0.5 { [1.0, 0.0] } else { [0.0, 1.0] };
        let mut depends = false;
        for (response, run) in responses.iter_mut().zip(&runs) {
            if response.is_none() {
                match simulator.simulate(*run, &initial) {
                    Ok(channels) => *response = Some(channels),
                    Err(SimulationError::Interrupted) => return vec![],
                    // Without a response nothing shows that the parameter has no effect.
                    Err(_) => *response = Some(vec![]),
                }
            }
            let Some(before) = response else { continue };
            depends = bounds.iter().any(|bound| {
                let mut point = own.clone();
                point[coordinate] = *bound;
                let Ok(values) = space.values_at(&point) else { return true };
                // A failure is an answer to the parameter too.
                simulator.simulate(*run, &values).map_or(true, |after| differ(before, &after))
            });
            if depends {
                break;
            }
        }
        if !depends {
            let name = &space.parameters[i].name;
            let message = format!("no observed channel depends on {name} from {} to {}", range.lower, range.upper);
            found.push(
                Diagnostic::warning(&NO_EFFECT, message)
                    .at(Some(study.spans.names[i]), "cannot be found: fix its value"),
            );
        }
    }
    found
}

/// Returns true if channels differ in any sample.
fn differ(a: &[Vec<f64>], b: &[Vec<f64>]) -> bool {
    let samples = |channels: &[Vec<f64>]| channels.iter().flatten().map(|x| x.to_bits()).collect::<Vec<u64>>();
    samples(a) != samples(b)
}

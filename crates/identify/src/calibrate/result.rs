//! Result of a calibration, and the script with the calibrated values.

use super::amplitude_groups::{AmplitudeGroup, amplitude_groups};
use super::posterior::Posterior;
use super::problem::StudyProblem;
use super::profile::Profile;
use super::search::SearchResult;
use super::settings::SearchSettings;
use super::uncertainty::Uncertainty;
use crate::preflight::Preflight;
use crate::study::{
    InitialRun, ObservedChannel, ParameterSpace, Role, Run, ScoredRun, SimulationError, Study, objective,
};
use serde::Serialize;
use std::sync::Arc;

/// Result of a calibration.
#[derive(Clone, Debug)]
pub struct CalibrationResult {
    /// The study.
    pub study: Arc<Study>,
    /// Settings of the search.
    pub settings: SearchSettings,
    /// The best unit point.
    pub unit_point: Vec<f64>,
    /// Values of all parameters, in the order of the study.
    pub values: Vec<f64>,
    /// Objective: mean NMSE over the channels of the fitted runs.
    pub objective: f64,
    /// All runs with these values, in the order of the study.
    pub scored_runs: Vec<Result<ScoredRun, SimulationError>>,
    /// The repeats of the search.
    pub search: SearchResult,
    /// Wall-clock time in s.
    pub wall_time: f64,
    /// Uncertainty of the parameters; `None` if the search was interrupted, or there is none.
    pub uncertainty: Option<Uncertainty>,
    /// Profile likelihoods, if they are wanted.
    pub profiles: Option<Vec<Profile>>,
    /// The posterior, if it is wanted.
    pub posterior: Option<Posterior>,
    /// Errors by amplitude, by run and channel; empty for channels without loops.
    pub amplitudes: Vec<Vec<Vec<AmplitudeGroup>>>,
    /// Checks of the channels before the fit, if they were made.
    pub preflight: Option<Preflight>,
}

/// The displacement that forces are plotted over, by run: its label, and samples at the times of the recording.
pub type Displacements = Vec<Option<(String, Vec<f64>)>>;

impl CalibrationResult {
    /// The result for the best point of a search. All runs are simulated again.
    ///
    /// # Errors
    /// No point has a response. The message is that of the most frequent error.
    pub fn new(
        problem: &StudyProblem,
        settings: &SearchSettings,
        search: SearchResult,
        wall_time: f64,
    ) -> Result<Self, String> {
        let study = problem.study().clone();
        let Some(best) = search.best() else {
            let failures = search.failures();
            let most = failures.iter().max_by_key(|(_, n)| **n);
            let message = most.and_then(|(k, _)| search.repeats.iter().find_map(|r| r.failure_messages.get(*k)));
            return Err(match (most, message) {
                (Some((_, n)), Some(message)) => format!("no values have an answer ({n} times: {message})"),
                _ => "nothing was evaluated".into(),
            });
        };
        let unit_point = best.unit_point.clone();
        let values = study.space.values_at(&unit_point).map_err(|e| e.to_string())?;
        let runs: Vec<usize> = (0..study.runs.len()).collect();
        let scored_runs = problem.scored_runs(&runs, &values);
        Ok(Self {
            objective: best.objective,
            unit_point,
            values,
            scored_runs,
            search,
            wall_time,
            settings: settings.clone(),
            study,
            uncertainty: None,
            profiles: None,
            posterior: None,
            amplitudes: vec![],
            preflight: None,
        })
    }

    /// Work out the errors by amplitude of all resisting forces and stresses.
    pub fn add_amplitudes(&mut self, displacements: &Displacements) {
        let of_run = |i: usize, run: &Run| {
            let simulated = self.scored_runs[i].iter().flat_map(|r| &r.channels);
            let u = displacements.get(i).and_then(Option::as_ref);
            let of_channel = |(o, simulated): (&ObservedChannel, &Vec<f64>)| match u {
                Some((_, u)) if o.is_resistance() => amplitude_groups(u, &o.values, simulated),
                _ => vec![],
            };
            run.observe.iter().zip(simulated).map(of_channel).collect()
        };
        self.amplitudes = self.study.runs.iter().enumerate().map(|(i, run)| of_run(i, run)).collect();
    }

    /// Weighted mean NMSE over the channels of all runs of a role. `None` if there is no such run, or one failed.
    pub fn nmse(&self, role: Role) -> Option<f64> {
        let of_role = self.study.runs_of(role).map(|(i, _)| self.scored_runs[i].as_ref().ok());
        let scored: Vec<&ScoredRun> = of_role.collect::<Option<_>>()?;
        if scored.is_empty() {
            return None;
        }
        if role == Role::Fit {
            return Some(objective(&self.study, &scored));
        }
        let channels = self.study.runs_of(role).flat_map(|(_, r)| &r.observe);
        let scores = scored.iter().flat_map(|r| &r.scores);
        let (sum, n) = channels.zip(scores).fold((0.0, 0.0), |(s, n), (o, c)| (s + o.weight * c.nmse, n + 1.0));
        Some(sum / n)
    }

    /// Names of the free parameters at a bound of their range.
    pub fn at_bounds(&self) -> Vec<&str> {
        at_bounds(&self.study.space, &self.unit_point).collect()
    }

    /// Statistics of the objective over the repeats that have ended.
    pub fn repeat_statistics(&self) -> RepeatStatistics {
        let repeats = &self.search.repeats;
        let done = repeats.len() - usize::from(self.search.stopped && repeats.len() > 1);
        let objectives: Vec<f64> = repeats[..done].iter().map(|r| r.objective).collect();
        let n = objectives.len() as f64;
        let mean = objectives.iter().sum::<f64>() / n;
        RepeatStatistics {
            repeats: objectives.len(),
            best: objectives.iter().fold(f64::INFINITY, |m, s| m.min(*s)),
            worst: objectives.iter().fold(f64::NEG_INFINITY, |m, s| m.max(*s)),
            mean,
            deviation: (objectives.iter().map(|s| (s - mean).powi(2)).sum::<f64>() / n).sqrt(),
        }
    }

    /// The script `text` with the calibrated values in its `pset` commands, and the names of the parameters that it does
    /// not set.
    pub fn script(&self, text: &str, initial_run: &InitialRun) -> (String, Vec<&str>) {
        let mut replacements: Vec<((usize, usize), f64)> = vec![];
        let mut missing = vec![];
        for ((p, v), span) in self.study.space.parameters.iter().zip(&self.values).zip(&initial_run.value_spans) {
            match span.filter(|(start, end)| text.get(*start..*end).is_some()) {
                Some(span) => replacements.push((span, *v)),
                None => missing.push(p.name.as_str()),
            }
        }
        // From the end of the text, so that the byte ranges before stay valid.
        replacements.sort_by_key(|r| std::cmp::Reverse(r.0));
        let mut script = text.to_owned();
        for ((start, end), value) in replacements {
            script.replace_range(start..end, &format!("{value:?}"));
        }
        (script, missing)
    }

    /// Information criteria of Akaike and Schwarz, n ln(objective) + 2k and n ln(objective) + k ln n, with n independent
    /// samples and k free parameters.
    pub fn information_criteria(&self) -> Option<(f64, f64)> {
        let n = self.uncertainty.as_ref()?.effective_samples;
        let k = self.study.space.dimension() as f64;
        let misfit = n * self.objective.ln();
        Some((misfit + 2.0 * k, misfit + k * n.ln()))
    }
}

/// Name of a role in a study.
pub(super) fn role_name(role: Role) -> &'static str {
    match role {
        Role::Fit => "fit",
        Role::Holdout => "holdout",
    }
}

/// Statistics of the objective over the repeats of a search.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct RepeatStatistics {
    /// Number of repeats.
    pub repeats: usize,
    /// Least objective.
    pub best: f64,
    /// Greatest objective.
    pub worst: f64,
    /// Mean.
    pub mean: f64,
    /// Standard deviation.
    pub deviation: f64,
}

/// Unit coordinates that are closer to a bound are at it.
const BOUND_TOLERANCE: f64 = 1e-6;

/// Names of the free parameters whose unit coordinate is at a bound.
pub(super) fn at_bounds<'a>(space: &'a ParameterSpace, unit_point: &'a [f64]) -> impl Iterator<Item = &'a str> {
    let is_at_bound = |x: f64| !(BOUND_TOLERANCE..=1.0 - BOUND_TOLERANCE).contains(&x);
    space.free_names().zip(unit_point).filter(move |(_, x)| is_at_bound(**x)).map(|(name, _)| name)
}

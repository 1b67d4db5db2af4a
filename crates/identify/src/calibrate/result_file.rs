//! The result file `calibration.json`.

use super::amplitude_groups::AmplitudeGroup;
use super::judgement::Judgement;
use super::posterior::Posterior;
use super::profile::Profile;
use super::result::{CalibrationResult, RepeatStatistics, role_name};
use super::search::{Repeat, StopReason};
use super::uncertainty::Uncertainty;
use crate::preflight::Preflight;
use crate::study::Role;
use serde::Serialize;
use std::collections::BTreeMap;

#[derive(Serialize)]
struct ResultFile<'a> {
    /// Title of the study, or its script without one.
    study: &'a str,
    parameters: BTreeMap<&'a str, f64>,
    objective: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    holdout: Option<f64>,
    runs: Vec<RunTable<'a>>,
    #[serde(flatten)]
    search: SearchTable<'a>,
    #[serde(skip_serializing_if = "Option::is_none")]
    uncertainty: Option<&'a Uncertainty>,
    #[serde(skip_serializing_if = "Option::is_none")]
    judgement: Option<&'a Judgement>,
    #[serde(skip_serializing_if = "Option::is_none")]
    profiles: Option<&'a [Profile]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    posterior: Option<&'a Posterior>,
    #[serde(skip_serializing_if = "Option::is_none")]
    preflight: Option<&'a Preflight>,
}

#[derive(Serialize)]
struct SearchTable<'a> {
    evaluations: usize,
    wall_s: f64,
    seed: u64,
    method: &'a str,
    polish: bool,
    stopped_because: StopReason,
    interrupted: bool,
    /// Number of failed evaluations, by the kind of error.
    failures: BTreeMap<&'a str, usize>,
    at_bound: Vec<&'a str>,
    repeats: Vec<RepeatTable<'a>>,
    spread: RepeatStatistics,
}

#[derive(Serialize)]
struct RunTable<'a> {
    name: &'a str,
    role: &'a str,
    nmse: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    failure: Option<String>,
    channels: Vec<ChannelTable<'a>>,
}

#[derive(Serialize)]
struct ChannelTable<'a> {
    channel: &'a str,
    nmse: f64,
    /// Number of samples compared.
    samples: usize,
    /// Number of samples after the end of the analysis.
    dropped: usize,
    /// Number of samples missing in the recording.
    missing: usize,
    /// Errors by amplitude.
    #[serde(skip_serializing_if = "<[AmplitudeGroup]>::is_empty")]
    amplitudes: &'a [AmplitudeGroup],
}

#[derive(Serialize)]
struct RepeatTable<'a> {
    seed: u64,
    objective: f64,
    evaluations: usize,
    stopped_because: StopReason,
    parameters: BTreeMap<&'a str, f64>,
    /// Number of evaluations and least objective, at each improvement.
    history: &'a [(usize, f64)],
}

impl CalibrationResult {
    /// The text of `calibration.json`.
    ///
    /// # Errors
    /// The result cannot be written as JSON.
    pub fn json(&self) -> Result<String, serde_json::Error> {
        let study = &self.study;
        let file = ResultFile {
            study: if study.title.is_empty() { &study.model } else { &study.title },
            parameters: self.by_name(&self.values),
            objective: self.objective,
            holdout: self.nmse(Role::Holdout),
            runs: (0..self.study.runs.len()).map(|i| self.run_table(i)).collect(),
            search: SearchTable {
                evaluations: self.search.evaluations(),
                wall_s: self.wall_time,
                seed: self.settings.seed,
                method: self.settings.method.name(),
                polish: self.settings.polish,
                stopped_because: self.search.stopped_because(),
                interrupted: self.search.stopped,
                failures: self.search.failures(),
                at_bound: self.at_bounds(),
                repeats: self.search.repeats.iter().map(|r| self.repeat_table(r)).collect(),
                spread: self.repeat_statistics(),
            },
            uncertainty: self.uncertainty.as_ref(),
            judgement: self.uncertainty.as_ref().map(|u| &u.judgement),
            profiles: self.profiles.as_deref(),
            posterior: self.posterior.as_ref(),
            preflight: self.preflight.as_ref(),
        };
        Ok(serde_json::to_string_pretty(&file)? + "\n")
    }

    /// Values of all parameters by their names.
    fn by_name(&self, values: &[f64]) -> BTreeMap<&str, f64> {
        self.study.space.parameters.iter().map(|p| p.name.as_str()).zip(values.iter().copied()).collect()
    }

    fn run_table(&self, i: usize) -> RunTable<'_> {
        let (run, scored) = (&self.study.runs[i], &self.scored_runs[i]);
        let channels = scored.iter().flat_map(|r| r.scores.iter().zip(&run.observe)).enumerate();
        RunTable {
            name: &run.name,
            role: role_name(run.role),
            nmse: scored.as_ref().ok().map(|r| r.nmse(&run.observe)),
            failure: scored.as_ref().err().map(ToString::to_string),
            channels: channels
                .map(|(k, (s, o))| ChannelTable {
                    channel: &o.channel,
                    nmse: s.nmse,
                    samples: s.samples,
                    dropped: s.dropped,
                    missing: o.values.iter().filter(|v| v.is_nan()).count(),
                    amplitudes: self.amplitudes.get(i).and_then(|r| r.get(k)).map_or(&[], Vec::as_slice),
                })
                .collect(),
        }
    }

    fn repeat_table<'a>(&'a self, repeat: &'a Repeat) -> RepeatTable<'a> {
        let values = self.study.space.values_at(&repeat.unit_point).unwrap_or_default();
        RepeatTable {
            seed: repeat.seed,
            objective: repeat.objective,
            evaluations: repeat.evaluations,
            stopped_because: repeat.stopped_because,
            parameters: self.by_name(&values),
            history: &repeat.history,
        }
    }
}

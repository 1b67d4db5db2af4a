//! What a calibration has found: as `calibration.json`, and as the script with the values in place.

use super::amplitude::{Amplitude, amplitudes};
use super::plan::Plan;
use super::posterior::Posterior;
use super::problem::StudyProblem;
use super::profile::Profile;
use super::search::{Outcome, Repeat};
use super::uncertainty::Uncertainty;
use crate::study::{Fit, Mishap, Observe, Opening, Role, Run, Source, Study, objective};
use serde::Serialize;
use std::collections::BTreeMap;
use std::sync::Arc;

/// What a calibration has found.
#[derive(Clone, Debug)]
pub struct Calibrated {
    /// The study.
    pub study: Arc<Study>,
    /// What was done.
    pub plan: Plan,
    /// The best point of the unit cube.
    pub point: Vec<f64>,
    /// Values of all parameters, in the order of the study.
    pub values: Vec<f64>,
    /// Mean NMSE over the channels of the runs that were fitted.
    pub objective: f64,
    /// All runs with these values, in the order of the study.
    pub fits: Vec<Result<Fit, Mishap>>,
    /// The repeats of the search.
    pub outcome: Outcome,
    /// Time that it took, s.
    pub wall: f64,
    /// What the data determine, where it was asked.
    pub uncertainty: Option<Uncertainty>,
    /// Profile likelihoods, likewise.
    pub profiles: Option<Vec<Profile>>,
    /// The posterior, likewise.
    pub posterior: Option<Posterior>,
    /// Errors by amplitude of each channel of each run; empty where there are no loops.
    pub amplitudes: Vec<Vec<Vec<Amplitude>>>,
}

/// What a force is plotted over, for each run: displacements at the times of its recording and what they are called.
pub type Displacements = Vec<Option<(String, Vec<f64>)>>;

impl Calibrated {
    /// The best of a search, with all runs simulated once more.
    ///
    /// # Errors
    /// Why no point has an answer: the mishap told most often.
    pub fn new(problem: &StudyProblem, plan: &Plan, outcome: Outcome, wall: f64) -> Result<Self, String> {
        let study = problem.study().clone();
        let Some(best) = outcome.best() else {
            let mishaps = outcome.mishaps();
            let most = mishaps.iter().max_by_key(|(_, n)| **n);
            let example = most.and_then(|(k, _)| outcome.repeats.iter().find_map(|r| r.examples.get(*k)));
            return Err(match (most, example) {
                (Some((_, n)), Some(e)) => format!("no values have an answer ({n} times: {e})"),
                _ => "nothing was evaluated".into(),
            });
        };
        let point = best.best.clone();
        let values = study.space.values(&point).map_err(|o| o.to_string())?;
        let runs: Vec<usize> = (0..study.runs.len()).collect();
        let fits = problem.fits(&runs, &values);
        Ok(Self {
            objective: best.score,
            point,
            values,
            fits,
            outcome,
            wall,
            plan: plan.clone(),
            study,
            uncertainty: None,
            profiles: None,
            posterior: None,
            amplitudes: vec![],
        })
    }

    /// Work out the errors by amplitude of all channels that are forces.
    pub fn measure(&mut self, displacements: &Displacements) {
        let of_run = |i: usize, run: &Run| {
            let simulated = self.fits[i].iter().flat_map(|f| &f.channels);
            let u = displacements.get(i).and_then(Option::as_ref);
            let of_channel = |(o, simulated): (&Observe, &Vec<f64>)| match u {
                Some((_, u)) if o.is_resistance() => amplitudes(u, &o.values, simulated),
                _ => vec![],
            };
            run.observe.iter().zip(simulated).map(of_channel).collect()
        };
        self.amplitudes = self.study.runs.iter().enumerate().map(|(i, run)| of_run(i, run)).collect();
    }

    /// Mean NMSE over the channels of the runs of a role, weighted as in the objective; none where there is no such run, or
    /// one of them has no answer.
    pub fn nmse(&self, role: Role) -> Option<f64> {
        let of = self.study.runs_of(role).map(|(i, _)| self.fits[i].as_ref().ok());
        let fits: Vec<&Fit> = of.collect::<Option<_>>()?;
        if fits.is_empty() {
            return None;
        }
        if role == Role::Fit {
            return Some(objective(&self.study, &fits));
        }
        let channels = self.study.runs_of(role).flat_map(|(_, r)| &r.observe);
        let scores = fits.iter().flat_map(|f| &f.scores);
        let (sum, n) = channels.zip(scores).fold((0.0, 0.0), |(s, n), (o, c)| (s + o.weight * c.nmse, n + 1.0));
        Some(sum / n)
    }

    /// The text of `calibration.json`.
    ///
    /// # Errors
    /// It cannot be written as JSON.
    pub fn json(&self) -> Result<String, serde_json::Error> {
        let named = self.study.space.parameters.iter().zip(&self.values);
        let runs = self.study.runs.iter().zip(&self.fits).enumerate().map(|(i, (run, fit))| RunJson {
            name: &run.name,
            role: role_name(run.role),
            nmse: fit.as_ref().ok().map(|f| f.nmse(&run.observe)),
            failure: fit.as_ref().err().map(ToString::to_string),
            channels: fit
                .iter()
                .flat_map(|f| f.scores.iter().zip(&run.observe))
                .enumerate()
                .map(|(k, (s, o))| ChannelJson {
                    channel: &o.channel,
                    nmse: s.nmse,
                    samples: s.samples,
                    dropped: s.dropped,
                    missing: o.values.iter().filter(|v| v.is_nan()).count(),
                    amplitudes: self.amplitudes.get(i).and_then(|r| r.get(k)).map_or(&[], Vec::as_slice),
                })
                .collect(),
        });
        let all = Json {
            parameters: named.map(|(p, v)| (p.name.as_str(), *v)).collect(),
            objective: self.objective,
            holdout: self.nmse(Role::Holdout),
            runs: runs.collect(),
            evaluations: self.outcome.evaluations(),
            wall_s: self.wall,
            seed: self.plan.seed,
            method: self.plan.strategy.name(),
            polish: self.plan.polish,
            interrupted: self.outcome.stopped,
            failures: self.outcome.mishaps(),
            at_bound: self.at_bounds(),
            repeats: self.outcome.repeats.iter().map(|r| self.repeat(r)).collect(),
            spread: self.spread(),
            uncertainty: self.uncertainty.as_ref(),
            profiles: self.profiles.as_deref(),
            posterior: self.posterior.as_ref(),
        };
        Ok(serde_json::to_string_pretty(&all)? + "\n")
    }

    /// Free parameters that ended at a bound.
    pub fn at_bounds(&self) -> Vec<&str> {
        let names = self.study.space.free().map(|(i, _)| self.study.space.parameters[i].name.as_str());
        names.zip(&self.point).filter(|(_, x)| **x < 1e-6 || **x > 1.0 - 1e-6).map(|(n, _)| n).collect()
    }

    fn repeat<'a>(&'a self, r: &'a Repeat) -> RepeatJson<'a> {
        let values = self.study.space.values(&r.best).unwrap_or_default();
        let names = self.study.space.parameters.iter().map(|p| p.name.as_str());
        RepeatJson {
            seed: r.seed,
            objective: r.score,
            evaluations: r.evaluations,
            parameters: names.zip(values).collect(),
            history: &r.history,
        }
    }

    /// Best, worst, mean and standard deviation of the objective over the repeats that have ended.
    pub fn spread(&self) -> Spread {
        let done = self.outcome.repeats.len() - usize::from(self.outcome.stopped && self.outcome.repeats.len() > 1);
        let scores: Vec<f64> = self.outcome.repeats[..done].iter().map(|r| r.score).collect();
        let n = scores.len() as f64;
        let mean = scores.iter().sum::<f64>() / n;
        Spread {
            repeats: scores.len(),
            best: scores.iter().fold(f64::INFINITY, |m, s| m.min(*s)),
            worst: scores.iter().fold(f64::NEG_INFINITY, |m, s| m.max(*s)),
            mean,
            deviation: (scores.iter().map(|s| (s - mean).powi(2)).sum::<f64>() / n).sqrt(),
        }
    }

    /// The script with the values in the place of those that its `pset` commands gave; and the names of the parameters
    /// whose place is not in that script. `text` is the script, `opening` where the values stand.
    pub fn script(&self, text: &str, opening: &Opening) -> (String, Vec<&str>) {
        let mut places: Vec<((usize, usize), f64)> = vec![];
        let mut elsewhere = vec![];
        for ((p, v), place) in self.study.space.parameters.iter().zip(&self.values).zip(&opening.places) {
            match place.filter(|(start, end)| text.get(*start..*end).is_some()) {
                Some(place) => places.push((place, *v)),
                None => elsewhere.push(p.name.as_str()),
            }
        }
        // From the end, so that places stay where they are.
        places.sort_by_key(|p| std::cmp::Reverse(p.0));
        let mut out = text.to_owned();
        for ((start, end), value) in places {
            out.replace_range(start..end, &format!("{value:?}"));
        }
        (out, elsewhere)
    }

    /// Akaike's and Schwarz's criteria, n ln(objective) + 2k and + k ln n, n being the independent samples.
    pub fn information(&self) -> Option<(f64, f64)> {
        let n = self.uncertainty.as_ref()?.effective_samples;
        let k = self.free_parameters() as f64;
        let misfit = n * self.objective.ln();
        Some((misfit + 2.0 * k, misfit + k * n.ln()))
    }

    /// Number of parameters that were free.
    pub fn free_parameters(&self) -> usize {
        self.study.space.parameters.iter().filter(|p| matches!(p.source, Source::Free(_))).count()
    }
}

/// Name of a role in a study.
pub(super) fn role_name(role: Role) -> &'static str {
    match role {
        Role::Fit => "fit",
        Role::Holdout => "holdout",
    }
}

#[derive(Serialize)]
struct Json<'a> {
    parameters: BTreeMap<&'a str, f64>,
    objective: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    holdout: Option<f64>,
    runs: Vec<RunJson<'a>>,
    evaluations: usize,
    wall_s: f64,
    seed: u64,
    method: &'a str,
    polish: bool,
    interrupted: bool,
    /// Points without an answer, by the kind of mishap.
    failures: BTreeMap<&'a str, usize>,
    at_bound: Vec<&'a str>,
    repeats: Vec<RepeatJson<'a>>,
    spread: Spread,
    #[serde(skip_serializing_if = "Option::is_none")]
    uncertainty: Option<&'a Uncertainty>,
    #[serde(skip_serializing_if = "Option::is_none")]
    profiles: Option<&'a [Profile]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    posterior: Option<&'a Posterior>,
}

#[derive(Serialize)]
struct RunJson<'a> {
    name: &'a str,
    role: &'a str,
    nmse: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    failure: Option<String>,
    channels: Vec<ChannelJson<'a>>,
}

#[derive(Serialize)]
struct ChannelJson<'a> {
    channel: &'a str,
    nmse: f64,
    /// Samples compared, left out after the end of the analysis, and missing in the recording.
    samples: usize,
    dropped: usize,
    missing: usize,
    /// Errors by amplitude.
    #[serde(skip_serializing_if = "<[Amplitude]>::is_empty")]
    amplitudes: &'a [Amplitude],
}

#[derive(Serialize)]
struct RepeatJson<'a> {
    seed: u64,
    objective: f64,
    evaluations: usize,
    parameters: BTreeMap<&'a str, f64>,
    /// Evaluations and best objective, whenever that has changed.
    history: &'a [(usize, f64)],
}

/// The objective over the repeats.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Spread {
    /// How many.
    pub repeats: usize,
    /// Least objective.
    pub best: f64,
    /// Greatest.
    pub worst: f64,
    /// Mean.
    pub mean: f64,
    /// Standard deviation.
    pub deviation: f64,
}

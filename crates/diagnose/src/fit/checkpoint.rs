//! What an interrupted diagnosis keeps, and how it is known that it still holds.
//!
//! Every job follows from the answers to those before it, so that the answers alone, in their order, take a diagnosis back
//! to where it was. Each is kept with a number that tells its job from all others, and all of them with one of the study:
//! where either differs, something has changed, and what was worked out is no answer any more.

use crate::fit::evaluator::{Answer, Job, Task};
use hysteron_identify::study::{Opening, ScriptSimulator, fit};
use serde::{Deserialize, Serialize};
use std::hash::{DefaultHasher, Hash as _, Hasher as _};

/// Of an answer what was work.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) enum Told {
    /// Where a search ended.
    Fitted(Vec<f64>),
    /// What a screening says.
    Screened(Option<(f64, Vec<f64>)>),
    /// To be worked out again.
    Again,
}

/// An answer, and of which job it is.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Kept {
    job: u64,
    told: Told,
}

impl Kept {
    pub(crate) fn of(job: u64, answer: Option<&Answer>) -> Self {
        let told = match answer {
            Some(Answer::Fitted(f)) => Told::Fitted(f.point.clone()),
            Some(Answer::Screened(s)) => Told::Screened(s.clone()),
            _ => Told::Again,
        };
        Self { job, told }
    }

    /// What was kept of a job, unless it is of another one.
    pub(crate) fn of_job(&self, job: u64) -> Option<&Told> {
        (self.job == job).then_some(&self.told)
    }
}

/// A number that differs where a job does.
pub(crate) fn number(job: &Job) -> u64 {
    let mut hasher = DefaultHasher::new();
    (&*job.variant.text, format!("{:?}", job.variant.proposal)).hash(&mut hasher);
    let mut points = |kind: u8, points: &[Vec<f64>]| {
        kind.hash(&mut hasher);
        points.iter().flatten().for_each(|x| x.to_bits().hash(&mut hasher));
    };
    match &job.task {
        Task::Fit { start, budget, closely } => {
            points(0, std::slice::from_ref(start));
            (budget, closely).hash(&mut hasher);
        }
        Task::Screen { points: tried, known } => points(if known.is_some() { 1 } else { 5 }, tried),
        Task::Derive { point } => points(2, std::slice::from_ref(point)),
        Task::HoldBack { point } => points(3, std::slice::from_ref(point)),
        Task::Near { point } => points(7, std::slice::from_ref(point)),
        Task::Look { point } => points(6, std::slice::from_ref(point)),
        Task::Told(_) => points(4, &[]),
    }
    hasher.finish()
}

/// A number that differs where a study does: its file, its recordings, its script, the library, and what its model says at
/// the values of the script, which depends on every file that is read and on the program.
pub fn identity(simulator: &ScriptSimulator, opening: &Opening, text: &str, without: &[String]) -> u64 {
    let study = simulator.study();
    let mut hasher = DefaultHasher::new();
    (format!("{study:?}"), text, without, env!("CARGO_PKG_VERSION")).hash(&mut hasher);
    let values = study.space.values(&study.space.point(&opening.values)).unwrap_or_default();
    let mut simulator = simulator.blueprint().simulator_of(study.clone(), text);
    for run in 0..study.runs.len() {
        match fit(&mut simulator, study, run, &values) {
            Ok(f) => f.channels.iter().flatten().for_each(|x| x.to_bits().hash(&mut hasher)),
            Err(mishap) => format!("{mishap:?}").hash(&mut hasher),
        }
    }
    hasher.finish()
}

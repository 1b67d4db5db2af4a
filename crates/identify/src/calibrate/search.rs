//! The search, from its start or from a checkpoint to its end.

use super::method::{MethodState, Trial};
use super::problem::{Evaluation, Problem};
use super::settings::SearchSettings;
use crate::study::SimulationError;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Result of one repeat of the search.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Repeat {
    /// Its seed.
    pub seed: u64,
    /// The best unit point.
    pub unit_point: Vec<f64>,
    /// Its objective.
    pub objective: f64,
    /// Number of evaluations.
    pub evaluations: usize,
    /// Number of evaluations and least objective, at each improvement.
    pub history: Vec<(usize, f64)>,
    /// Number of failed evaluations, by the kind of error.
    pub failures: BTreeMap<String, usize>,
    /// Message of the last error of each kind.
    pub failure_messages: BTreeMap<String, String>,
}

/// State of a search between two evaluations.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Checkpoint {
    /// Settings of the search.
    pub settings: SearchSettings,
    /// Unit point of the script's own values.
    pub initial_unit_point: Vec<f64>,
    /// Repeats that have ended.
    pub done: Vec<Repeat>,
    /// The current repeat.
    pub current: Repeat,
    /// Index of its stage.
    pub stage: usize,
    /// Number of evaluated generations of the stage.
    pub generation: usize,
    /// The method of the stage.
    pub method: MethodState,
}

/// Progress of a search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SearchStatus<'a> {
    /// Number of repeats that have ended, and of all repeats.
    pub repeat: (usize, usize),
    /// Name of the current method.
    pub stage: &'a str,
    /// Number of evaluated generations of the stage.
    pub generation: usize,
    /// Number of evaluations of the repeat.
    pub evaluations: usize,
    /// Least objective of the repeat.
    pub best: f64,
    /// Greatest less least objective of the population.
    pub spread: f64,
    /// Share of the whole search that is done.
    pub progress: f64,
}

/// Receives progress and checkpoints of a search, and can stop it.
pub trait SearchObserver {
    /// Called after each evaluated generation.
    fn status(&mut self, _: &SearchStatus<'_>) {}
    /// Returns true to receive a checkpoint now.
    fn wants_checkpoint(&self) -> bool {
        false
    }
    /// Called with a checkpoint if one is wanted, or if the search was stopped.
    fn checkpoint(&mut self, _: &Checkpoint) {}
    /// Returns true to stop the search.
    fn stopped(&self) -> bool {
        false
    }
}

/// An observer that ignores the progress.
pub struct NoObserver;

impl SearchObserver for NoObserver {}

/// Result of a search.
#[derive(Clone, Debug, PartialEq)]
pub struct SearchResult {
    /// The repeats. The last one is incomplete if the search was stopped.
    pub repeats: Vec<Repeat>,
    /// True if the observer stopped the search.
    pub stopped: bool,
}

impl SearchResult {
    /// The repeat with the least objective; `None` if all evaluations failed.
    pub fn best(&self) -> Option<&Repeat> {
        let successful = self.repeats.iter().filter(|r| r.objective < Trial::FAILED);
        successful.min_by(|a, b| a.objective.total_cmp(&b.objective))
    }

    /// Number of evaluations of all repeats.
    pub fn evaluations(&self) -> usize {
        self.repeats.iter().map(|r| r.evaluations).sum()
    }

    /// Number of failed evaluations of all repeats, by the kind of error.
    pub fn failures(&self) -> BTreeMap<&str, usize> {
        let mut all = BTreeMap::new();
        for (kind, n) in self.repeats.iter().flat_map(|r| &r.failures) {
            *all.entry(kind.as_str()).or_default() += n;
        }
        all
    }
}

impl Checkpoint {
    /// The state before the first evaluation. `initial_unit_point` has the script's own values.
    pub fn new(settings: SearchSettings, initial_unit_point: Vec<f64>) -> Self {
        let method = settings.method_state(0, 0, &initial_unit_point, &initial_unit_point);
        let current = new_repeat(&settings, 0, &initial_unit_point);
        Self { settings, initial_unit_point, done: vec![], current, stage: 0, generation: 0, method }
    }

    /// Go on to the next stage, or to the next repeat. Returns false at the end of the search.
    fn advance(&mut self) -> bool {
        self.stage += 1;
        self.generation = 0;
        if self.stage >= self.settings.stages() {
            let next = new_repeat(&self.settings, self.done.len() + 1, &self.initial_unit_point);
            self.done.push(std::mem::replace(&mut self.current, next));
            self.stage = 0;
            if self.done.len() >= self.settings.repeats {
                return false;
            }
        }
        self.method =
            self.settings.method_state(self.done.len(), self.stage, &self.initial_unit_point, &self.current.unit_point);
        true
    }

    /// Add evaluations to the current repeat.
    fn add(&mut self, unit_points: &[Vec<f64>], evaluations: &[Evaluation]) {
        let repeat = &mut self.current;
        for (unit_point, e) in unit_points.iter().zip(evaluations) {
            repeat.evaluations += 1;
            if let Some(error) = &e.error {
                *repeat.failures.entry(error.kind().to_owned()).or_default() += 1;
                repeat.failure_messages.insert(error.kind().to_owned(), error.to_string());
            }
            if e.trial.objective < repeat.objective {
                repeat.objective = e.trial.objective;
                repeat.unit_point.clone_from(unit_point);
                repeat.history.push((repeat.evaluations, repeat.objective));
            }
        }
    }

    fn status(&mut self) -> SearchStatus<'static> {
        let stages = self.settings.stages() as f64;
        let method = self.method.method();
        let repeat_progress = (self.stage as f64 + method.progress().clamp(0.0, 1.0)) / stages;
        let spread = method.spread();
        let is_least_squares = matches!(self.method, MethodState::LevenbergMarquardt(_));
        SearchStatus {
            repeat: (self.done.len(), self.settings.repeats),
            stage: if is_least_squares { "least squares" } else { self.settings.method.name() },
            generation: self.generation,
            evaluations: self.current.evaluations,
            best: self.current.objective,
            spread,
            progress: (self.done.len() as f64 + repeat_progress) / self.settings.repeats as f64,
        }
    }
}

fn new_repeat(settings: &SearchSettings, repeat: usize, initial_unit_point: &[f64]) -> Repeat {
    Repeat {
        seed: settings.seed.wrapping_add(repeat as u64),
        unit_point: initial_unit_point.to_vec(),
        objective: Trial::FAILED,
        evaluations: 0,
        history: vec![],
        failures: BTreeMap::new(),
        failure_messages: BTreeMap::new(),
    }
}

/// Continue from a checkpoint to the end, or until the observer stops the search.
pub fn search(problem: &dyn Problem, mut at: Checkpoint, observer: &mut dyn SearchObserver) -> SearchResult {
    loop {
        let before = at.method.clone();
        let method = at.method.method();
        let unit_points = method.ask();
        if unit_points.is_empty() {
            if at.advance() {
                continue;
            }
            return SearchResult { repeats: at.done, stopped: false };
        }
        let evaluations =
            if observer.stopped() { vec![] } else { problem.evaluate(&unit_points, method.needs_residuals()) };
        if observer.stopped() || evaluations.iter().any(|e| e.error == Some(SimulationError::Interrupted)) {
            // The checkpoint asks for the same points again.
            at.method = before;
            observer.checkpoint(&at);
            let mut repeats = at.done;
            repeats.push(at.current);
            return SearchResult { repeats, stopped: true };
        }
        at.add(&unit_points, &evaluations);
        let trials: Vec<Trial> = evaluations.into_iter().map(|e| e.trial).collect();
        at.method.method().tell(&unit_points, &trials);
        at.generation += 1;
        observer.status(&at.status());
        if observer.wants_checkpoint() {
            observer.checkpoint(&at);
        }
    }
}

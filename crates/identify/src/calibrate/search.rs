//! The search, from its start or from a checkpoint to its end.

use super::method::{MethodState, Trial};
use super::problem::{Evaluation, Problem};
use super::settings::{SearchMethod, SearchSettings};
use crate::study::SimulationError;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Reason why a search ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum StopReason {
    /// Further searching found nothing better.
    #[serde(rename = "converged")]
    Converged,
    /// The evaluations of the method were used.
    #[serde(rename = "evaluations used")]
    EvaluationsUsed,
    /// All starting points of least squares were used, and led to several minima.
    #[serde(rename = "starting points used")]
    StartingPointsUsed,
    /// The user interrupted it.
    #[serde(rename = "interrupted")]
    Interrupted,
}

impl StopReason {
    /// The reason in a few words.
    pub fn words(self) -> &'static str {
        match self {
            Self::Converged => "converged",
            Self::EvaluationsUsed => "evaluations used",
            Self::StartingPointsUsed => "starting points used",
            Self::Interrupted => "interrupted",
        }
    }
}

/// Part of a repeat of the search.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Stage {
    /// The method of the settings.
    Search,
    /// Least squares from a starting point.
    Start(usize),
    /// Least squares from the best point.
    Polish,
    /// Least squares from a random point, after a polish that converged: they may find a better minimum.
    Confirmation(usize),
    /// An evolution strategy with restarts, which uses the remaining evaluations.
    Restarts,
    /// Least squares from the best point, at the end.
    LastPolish,
}

/// Least squares stop to start over when so many starts have led to the least objective.
const STARTS_TO_BEST: usize = 3;
/// Number of random starts of least squares that confirm what an evolution strategy has found.
const CONFIRMATIONS: usize = 2;
/// Objectives that differ by less, relative to the smaller, are those of one minimum ...
const SAME_OBJECTIVE: f64 = 1e-4;
/// ... or if both are smaller than this.
const ZERO_OBJECTIVE: f64 = 1e-12;
/// A worse fit is not taken for the best one without restarts.
const MAX_CONFIRMED_OBJECTIVE: f64 = 0.05;

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
    /// Reason why it ended.
    pub stopped_because: StopReason,
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
    /// Its stage.
    pub stage: Stage,
    /// Objectives in which its finished stages of least squares have ended.
    pub minima: Vec<f64>,
    /// Its first stage has converged.
    pub first_has_converged: bool,
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

    /// Reason why the best repeat ended.
    pub fn stopped_because(&self) -> StopReason {
        match self.best() {
            _ if self.stopped => StopReason::Interrupted,
            Some(repeat) => repeat.stopped_because,
            None => StopReason::EvaluationsUsed,
        }
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
        let stage = settings.first_stage();
        let method = settings.method_state(0, stage, &initial_unit_point, (&initial_unit_point, 0));
        let current = new_repeat(&settings, 0, &initial_unit_point);
        Self {
            settings,
            initial_unit_point,
            done: vec![],
            current,
            stage,
            minima: vec![],
            first_has_converged: false,
            generation: 0,
            method,
        }
    }

    /// Go on to the next stage, or to the next repeat. Returns false at the end of the search.
    fn advance(&mut self) -> bool {
        let has_converged = self.method.method().has_converged();
        if let MethodState::LevenbergMarquardt(m) = &self.method {
            self.minima.push(m.reached().1);
        }
        if self.stage == Stage::Search {
            self.first_has_converged = has_converged;
        }
        self.stage = match self.next_stage(has_converged) {
            Ok(stage) => stage,
            Err(reason) => {
                self.current.stopped_because = reason;
                let next = new_repeat(&self.settings, self.done.len() + 1, &self.initial_unit_point);
                self.done.push(std::mem::replace(&mut self.current, next));
                self.minima.clear();
                if self.done.len() >= self.settings.repeats {
                    return false;
                }
                self.settings.first_stage()
            }
        };
        self.generation = 0;
        let best = (&self.current.unit_point[..], self.current.evaluations);
        self.method = self.settings.method_state(self.done.len(), self.stage, &self.initial_unit_point, best);
        true
    }

    /// The stage after the current one, or the reason why the repeat ends.
    fn next_stage(&self, has_converged: bool) -> Result<Stage, StopReason> {
        let reason = |converged: bool| if converged { StopReason::Converged } else { StopReason::EvaluationsUsed };
        let is_evolution_strategy = self.settings.method == SearchMethod::CmaEs;
        let used_up = self.current.evaluations >= self.settings.budget(self.initial_unit_point.len());
        let restarts = if used_up { Err(StopReason::EvaluationsUsed) } else { Ok(Stage::Restarts) };
        match self.stage {
            Stage::Search if self.settings.polish => Ok(Stage::Polish),
            Stage::Search => Err(reason(has_converged)),
            Stage::Start(k) if k + 1 < self.settings.starting_points() && !self.is_found_again() => {
                Ok(Stage::Start(k + 1))
            }
            Stage::Start(_) => Ok(Stage::LastPolish),
            Stage::Polish if !is_evolution_strategy => Err(reason(self.first_has_converged)),
            Stage::Polish => {
                let is_confirmed = self.first_has_converged && has_converged;
                let fits = self.current.objective <= MAX_CONFIRMED_OBJECTIVE;
                if is_confirmed && fits { Ok(Stage::Confirmation(0)) } else { restarts }
            }
            // The first minimum is that of the polish.
            Stage::Confirmation(k) => match (self.minima.first(), self.minima.last()) {
                (Some(first), Some(last)) if last < first && !is_same(*first, *last) => restarts,
                _ if k + 1 < CONFIRMATIONS => Ok(Stage::Confirmation(k + 1)),
                _ => Err(StopReason::Converged),
            },
            Stage::Restarts => Ok(Stage::LastPolish),
            Stage::LastPolish if is_evolution_strategy => Err(StopReason::EvaluationsUsed),
            Stage::LastPolish if self.settings.starting_points() == 1 => Err(reason(has_converged)),
            Stage::LastPolish if self.is_found_again() => Err(StopReason::Converged),
            Stage::LastPolish => Err(StopReason::StartingPointsUsed),
        }
    }

    /// Returns true if enough starts of least squares have led to the least objective.
    fn is_found_again(&self) -> bool {
        let starts = self.minima.iter().take(self.settings.starting_points());
        let least = starts.clone().fold(Trial::FAILED, |m, s| m.min(*s));
        least < Trial::FAILED && starts.filter(|s| is_same(least, **s)).count() >= STARTS_TO_BEST
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
        let dimension = self.initial_unit_point.len();
        let greatest = self.settings.budget(dimension) + SearchSettings::polish_budget(dimension);
        let repeat_progress = (self.current.evaluations as f64 / greatest as f64).min(1.0);
        let spread = self.method.method().spread();
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

/// Returns true if two objectives are those of one minimum.
fn is_same(a: f64, b: f64) -> bool {
    (a - b).abs() <= SAME_OBJECTIVE * a.min(b) || a.max(b) < ZERO_OBJECTIVE
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
        stopped_because: StopReason::Interrupted,
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

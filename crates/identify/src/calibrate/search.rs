//! The search from its start, or from a checkpoint, to its end.

use super::method::{Search, Trial};
use super::plan::Plan;
use super::problem::{Evaluated, Problem};
use crate::study::Mishap;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// What one repeat of the search has found.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Repeat {
    /// Its seed.
    pub seed: u64,
    /// The best point.
    pub best: Vec<f64>,
    /// Its score.
    pub score: f64,
    /// Points evaluated.
    pub evaluations: usize,
    /// Evaluations and best score, whenever that has changed.
    pub history: Vec<(usize, f64)>,
    /// Points without an answer, by the kind of mishap.
    pub mishaps: BTreeMap<String, usize>,
    /// The last mishap of each kind, told.
    pub examples: BTreeMap<String, String>,
}

/// Where a search stands, between two askings.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Checkpoint {
    /// What is being done; a checkpoint fits no other plan.
    pub plan: Plan,
    /// Where it began.
    pub start: Vec<f64>,
    /// Repeats that have ended.
    pub done: Vec<Repeat>,
    /// The repeat under way.
    pub current: Repeat,
    /// Which of its searches is under way, and how many times it has asked.
    pub stage: usize,
    /// Askings of this search.
    pub generation: usize,
    /// The search.
    pub search: Search,
}

/// How the search is getting on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Status<'a> {
    /// Repeats that have ended, and all of them.
    pub repeat: (usize, usize),
    /// What is being done, in a word.
    pub stage: &'a str,
    /// Askings of this search.
    pub generation: usize,
    /// Points evaluated in this repeat.
    pub evaluations: usize,
    /// Best score of this repeat.
    pub best: f64,
    /// Greatest less least score of the population.
    pub spread: f64,
    /// How much of all that is to be done is done.
    pub progress: f64,
}

/// Who wants to know how the search is getting on.
pub trait Watch {
    /// Points have been evaluated.
    fn status(&mut self, _: &Status<'_>) {}
    /// Whether a checkpoint is wanted now.
    fn wants_checkpoint(&self) -> bool {
        false
    }
    /// A checkpoint, where one was wanted, or the search was stopped.
    fn checkpoint(&mut self, _: &Checkpoint) {}
    /// Whether to stop.
    fn stopped(&self) -> bool {
        false
    }
}

/// Nobody.
pub struct Silent;

impl Watch for Silent {}

/// What a search has found.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// The repeats, the last of which is not complete if it was stopped.
    pub repeats: Vec<Repeat>,
    /// It was stopped.
    pub stopped: bool,
}

impl Outcome {
    /// The best repeat; none where nothing has been evaluated.
    pub fn best(&self) -> Option<&Repeat> {
        let found = self.repeats.iter().filter(|r| r.score < Trial::FAILED);
        found.min_by(|a, b| a.score.total_cmp(&b.score))
    }

    /// Points evaluated in all repeats.
    pub fn evaluations(&self) -> usize {
        self.repeats.iter().map(|r| r.evaluations).sum()
    }

    /// Points without an answer, by the kind of mishap.
    pub fn mishaps(&self) -> BTreeMap<&str, usize> {
        let mut all = BTreeMap::new();
        for (kind, n) in self.repeats.iter().flat_map(|r| &r.mishaps) {
            *all.entry(kind.as_str()).or_default() += n;
        }
        all
    }
}

impl Checkpoint {
    /// Before anything is done.
    pub fn new(plan: Plan, start: Vec<f64>) -> Self {
        let search = plan.search(0, 0, &start, &start);
        let current = fresh(&plan, 0, &start);
        Self { plan, start, done: vec![], current, stage: 0, generation: 0, search }
    }

    /// Go on to the next search, or the next repeat; `false` where there is none.
    fn advance(&mut self) -> bool {
        self.stage += 1;
        self.generation = 0;
        if self.stage >= self.plan.stages() {
            let next = fresh(&self.plan, self.done.len() + 1, &self.start);
            self.done.push(std::mem::replace(&mut self.current, next));
            self.stage = 0;
            if self.done.len() >= self.plan.repeats {
                return false;
            }
        }
        self.search = self.plan.search(self.done.len(), self.stage, &self.start, &self.current.best);
        true
    }

    /// What points came to.
    fn take(&mut self, points: &[Vec<f64>], evaluated: &[Evaluated]) {
        let now = &mut self.current;
        for (point, e) in points.iter().zip(evaluated) {
            now.evaluations += 1;
            if let Some(m) = &e.mishap {
                *now.mishaps.entry(m.kind().to_owned()).or_default() += 1;
                now.examples.insert(m.kind().to_owned(), m.to_string());
            }
            if e.trial.score < now.score {
                now.score = e.trial.score;
                now.best.clone_from(point);
                now.history.push((now.evaluations, now.score));
            }
        }
    }

    fn status(&mut self) -> Status<'static> {
        let stages = self.plan.stages() as f64;
        let method = self.search.method();
        let here = (self.stage as f64 + method.progress().clamp(0.0, 1.0)) / stages;
        let polishing = matches!(self.search, Search::LevenbergMarquardt(_));
        Status {
            repeat: (self.done.len(), self.plan.repeats),
            stage: if polishing { "least squares" } else { self.plan.strategy.name() },
            generation: self.generation,
            evaluations: self.current.evaluations,
            best: self.current.score,
            spread: self.search.method().spread(),
            progress: (self.done.len() as f64 + here) / self.plan.repeats as f64,
        }
    }
}

fn fresh(plan: &Plan, repeat: usize, start: &[f64]) -> Repeat {
    Repeat {
        seed: plan.seed.wrapping_add(repeat as u64),
        best: start.to_vec(),
        score: Trial::FAILED,
        evaluations: 0,
        history: vec![],
        mishaps: BTreeMap::new(),
        examples: BTreeMap::new(),
    }
}

/// Go on from a checkpoint to the end, or until the watch stops it.
pub fn search(problem: &dyn Problem, mut at: Checkpoint, watch: &mut dyn Watch) -> Outcome {
    loop {
        let before = at.search.clone();
        let method = at.search.method();
        let points = method.ask();
        if points.is_empty() {
            if at.advance() {
                continue;
            }
            return Outcome { repeats: at.done, stopped: false };
        }
        let evaluated = if watch.stopped() { vec![] } else { problem.evaluate(&points, method.wants_residuals()) };
        if watch.stopped() || evaluated.iter().any(|e| e.mishap == Some(Mishap::Interrupted)) {
            // What was asked for last is asked for again when the search goes on.
            at.search = before;
            watch.checkpoint(&at);
            let mut repeats = at.done;
            repeats.push(at.current);
            return Outcome { repeats, stopped: true };
        }
        at.take(&points, &evaluated);
        let trials: Vec<Trial> = evaluated.into_iter().map(|e| e.trial).collect();
        at.search.method().tell(&points, &trials);
        at.generation += 1;
        watch.status(&at.status());
        if watch.wants_checkpoint() {
            watch.checkpoint(&at);
        }
    }
}

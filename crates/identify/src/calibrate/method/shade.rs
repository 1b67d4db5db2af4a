//! Differential evolution that learns its constants and lets its population shrink: L-SHADE (Tanabe and Fukunaga, 2014)
//! and jSO (Brest, Maučec and Bošković, 2017).

use super::{Method, Trial, anywhere, inside, normal, spread_of};
use rand::{RngExt as _, SeedableRng as _};
use rand_pcg::Pcg32;
use serde::{Deserialize, Serialize};

/// Which of the two.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Variant {
    /// L-SHADE.
    LShade,
    /// jSO: a larger population at first, a weight on the way to the best that grows, constants held back at first.
    Jso,
}

/// L-SHADE or jSO. Mutation is current-to-pbest/1 with an archive of beaten members; F and CR are drawn about values that
/// worked (a memory of weighted means); the population shrinks linearly with the evaluations, from `largest` to four.
/// Coordinates outside of the cube are put half way between the member and the side, as in both papers.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Shade {
    variant: Variant,
    largest: usize,
    /// Evaluations that it may use, and has used.
    budget: usize,
    used: usize,
    rng: Pcg32,
    members: Vec<Vec<f64>>,
    scores: Vec<f64>,
    archive: Vec<Vec<f64>>,
    memory_f: Vec<f64>,
    memory_cr: Vec<f64>,
    /// Entry of the memory that is written next.
    next: usize,
    /// F and CR of the points asked for.
    drawn: Vec<(f64, f64)>,
}

const SMALLEST: usize = 4;

impl Shade {
    /// A search in some dimensions with a number of evaluations; `population` of the first generation, where it is not to
    /// be the papers' (18 n; 25 ln n √n).
    pub fn new(variant: Variant, dimension: usize, budget: usize, population: Option<usize>, seed: u64) -> Self {
        let mut rng = Pcg32::seed_from_u64(seed);
        let n = dimension as f64;
        let usual = match variant {
            Variant::LShade => 18.0 * n,
            // Meant for ten dimensions and more: ln 1 is no population.
            Variant::Jso => 25.0 * n.max(2.0).ln() * n.max(2.0).sqrt(),
        };
        let largest = population.unwrap_or(usual.round() as usize).clamp(SMALLEST, budget.max(SMALLEST));
        let members = (0..largest).map(|_| anywhere(&mut rng, dimension)).collect();
        let (size, f, cr) = match variant {
            Variant::LShade => (6, 0.5, 0.5),
            Variant::Jso => (5, 0.3, 0.8),
        };
        Self {
            variant,
            largest,
            budget,
            used: 0,
            rng,
            members,
            scores: vec![],
            archive: vec![],
            memory_f: vec![f; size],
            memory_cr: vec![cr; size],
            next: 0,
            drawn: vec![],
        }
    }

    fn gone(&self) -> f64 {
        self.used as f64 / self.budget as f64
    }

    /// F and CR about a random entry of the memory. A CR that has come to nothing stays there.
    fn draw(&mut self) -> (f64, f64) {
        let size = self.memory_f.len();
        let k = self.rng.random_range(0..size);
        let (mut about_f, mut about_cr) = (self.memory_f[k], self.memory_cr[k]);
        if self.variant == Variant::Jso && k == size - 1 {
            (about_f, about_cr) = (0.9, 0.9);
        }
        let mut cr = if about_cr < 0.0 { 0.0 } else { (about_cr + 0.1 * normal(&mut self.rng)).clamp(0.0, 1.0) };
        // Cauchy distributed, above 0, not more than 1.
        let mut f = loop {
            let angle = std::f64::consts::PI * (self.rng.random::<f64>() - 0.5);
            let f = about_f + 0.1 * angle.tan();
            if f > 0.0 {
                break f.min(1.0);
            }
        };
        if self.variant == Variant::Jso {
            let gone = self.gone();
            cr = match gone {
                g if g < 0.25 => cr.max(0.7),
                g if g < 0.5 => cr.max(0.6),
                _ => cr,
            };
            f = if gone < 0.6 { f.min(0.7) } else { f };
        }
        (f, cr)
    }

    /// Members from the best to the worst.
    fn ranking(&self) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.members.len()).collect();
        order.sort_by(|a, b| self.scores[*a].total_cmp(&self.scores[*b]));
        order
    }

    /// The mutant of a member, crossed with it.
    fn offspring(&mut self, i: usize, ranking: &[usize], f: f64, cr: f64) -> Vec<f64> {
        let (n, gone) = (self.members.len(), self.gone());
        let (share, weight) = match self.variant {
            Variant::LShade => (0.11, f),
            Variant::Jso => {
                let growth = match gone {
                    g if g < 0.2 => 0.7,
                    g if g < 0.4 => 0.8,
                    _ => 1.2,
                };
                (0.25 * (1.0 - 0.5 * gone), growth * f)
            }
        };
        let leaders = ((share * n as f64).round() as usize).clamp(2, n);
        let best = ranking[self.rng.random_range(0..leaders)];
        let r1 = loop {
            let r = self.rng.random_range(0..n);
            if r != i {
                break r;
            }
        };
        let r2 = loop {
            let r = self.rng.random_range(0..n + self.archive.len());
            if r != i && r != r1 {
                break r;
            }
        };
        let forced = self.rng.random_range(0..self.members[i].len());
        let mut u = self.members[i].clone();
        let second = self.members.get(r2).unwrap_or_else(|| &self.archive[r2 - n]);
        for (j, x) in u.iter_mut().enumerate() {
            if self.rng.random::<f64>() < cr || j == forced {
                let step = weight * (self.members[best][j] - *x) + f * (self.members[r1][j] - second[j]);
                *x = inside(*x + step, *x);
            }
        }
        u
    }

    /// Take the F and CR that worked into the memory: Lehmer means, weighted by what they gained.
    fn learn(&mut self, worked: &[(f64, f64, f64)]) {
        let total: f64 = worked.iter().map(|w| w.2).sum();
        if worked.is_empty() || total <= 0.0 || !total.is_finite() {
            return;
        }
        let lehmer = |of: fn(&(f64, f64, f64)) -> f64| {
            let (squares, sum) = worked.iter().fold((0.0, 0.0), |(s, t), w| (s + w.2 * of(w) * of(w), t + w.2 * of(w)));
            if sum > 0.0 { squares / sum } else { 0.0 }
        };
        let (mean_f, mean_cr) = (lehmer(|w| w.0), lehmer(|w| w.1));
        let k = self.next;
        match self.variant {
            Variant::LShade => {
                self.memory_f[k] = mean_f;
                // A negative entry stands for CR = 0 from now on.
                self.memory_cr[k] = if self.memory_cr[k] < 0.0 || mean_cr == 0.0 { -1.0 } else { mean_cr };
            }
            Variant::Jso => {
                self.memory_f[k] = 0.5 * (self.memory_f[k] + mean_f);
                self.memory_cr[k] = 0.5 * (self.memory_cr[k] + mean_cr);
            }
        }
        // jSO never writes the last entry.
        let size = self.memory_f.len() - usize::from(self.variant == Variant::Jso);
        self.next = (k + 1) % size;
    }

    /// Let the population shrink to the size that belongs to the evaluations used.
    fn shrink(&mut self) {
        let range = self.largest as f64 - SMALLEST as f64;
        let size = (self.largest as f64 - range * self.gone()).round().max(SMALLEST as f64) as usize;
        while self.members.len() > size {
            let Some(worst) = (0..self.scores.len()).max_by(|a, b| self.scores[*a].total_cmp(&self.scores[*b])) else {
                return;
            };
            self.members.remove(worst);
            self.scores.remove(worst);
        }
        let room = match self.variant {
            Variant::LShade => (2.6 * size as f64) as usize,
            Variant::Jso => size,
        };
        while self.archive.len() > room {
            let any = self.rng.random_range(0..self.archive.len());
            self.archive.swap_remove(any);
        }
    }
}

impl Method for Shade {
    fn ask(&mut self) -> Vec<Vec<f64>> {
        if self.scores.is_empty() {
            return self.members.clone();
        }
        // Members that have come to the same point cannot leave it.
        if self.used >= self.budget || self.members.iter().all(|m| *m == self.members[0]) {
            return vec![];
        }
        let ranking = self.ranking();
        self.drawn.clear();
        let count = self.members.len().min(self.budget - self.used);
        let mut out = vec![];
        for i in 0..count {
            let (f, cr) = self.draw();
            self.drawn.push((f, cr));
            out.push(self.offspring(i, &ranking, f, cr));
        }
        out
    }

    fn tell(&mut self, points: &[Vec<f64>], trials: &[Trial]) {
        self.used += points.len();
        if self.scores.is_empty() {
            self.scores = trials.iter().map(|t| t.score).collect();
            return;
        }
        let mut worked = vec![];
        for (i, (point, trial)) in points.iter().zip(trials).enumerate() {
            let old = self.scores[i];
            if trial.score > old {
                continue;
            }
            if trial.score < old {
                let (f, cr) = self.drawn[i];
                worked.push((f, cr, if old < Trial::FAILED { old - trial.score } else { trial.score.abs() }));
                self.archive.push(self.members[i].clone());
            }
            self.members[i].clone_from(point);
            self.scores[i] = trial.score;
        }
        self.learn(&worked);
        self.shrink();
    }

    fn spread(&self) -> f64 {
        spread_of(&self.scores)
    }

    fn progress(&self) -> f64 {
        self.gone()
    }
}

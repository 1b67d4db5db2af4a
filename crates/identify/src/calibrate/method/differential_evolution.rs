//! Differential evolution `rand/1/bin` (Storn and Price, 1997), Eqs 8 to 11 of the calibration paper.

use super::{Method, Trial, halfway_to_bound, objective_spread, random_point};
use rand::{RngExt as _, SeedableRng as _};
use rand_pcg::Pcg32;
use serde::{Deserialize, Serialize};

/// Rule by which coordinates of a mutant go into the trial point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Crossover {
    /// Rule of Storn and Price: each with probability CR, and one random coordinate in any case. r1, r2, r3 and the member
    /// are mutually different.
    Forced,
    /// Eqs 9 and 10 of the paper as printed: each with probability CR, so that a trial point may equal the member.
    /// r1, r2, r3 are mutually different, and one may be the member.
    AsPrinted,
}

/// Constants of differential evolution.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct EvolutionSettings {
    /// Population size N.
    pub population: usize,
    /// Number of generations P after the first population.
    pub generations: usize,
    /// Mutation constant F.
    pub f: f64,
    /// Crossover constant CR (k in the paper).
    pub cr: f64,
    /// Crossover rule.
    pub crossover: Crossover,
}

/// Differential evolution: the mutant v = θ_r1 + F (θ_r2 - θ_r3) (Eq 9) is crossed with the member (Eq 10), which it
/// replaces if it is better (Eq 11). Coordinates of v outside of the cube are put half way between member and bound.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct DifferentialEvolution {
    settings: EvolutionSettings,
    rng: Pcg32,
    members: Vec<Vec<f64>>,
    objectives: Vec<f64>,
    generation: usize,
}

impl DifferentialEvolution {
    /// A search with a random first population.
    pub fn new(settings: EvolutionSettings, dimension: usize, seed: u64) -> Self {
        let mut rng = Pcg32::seed_from_u64(seed);
        let members = (0..settings.population).map(|_| random_point(&mut rng, dimension)).collect();
        Self { settings, rng, members, objectives: vec![], generation: 0 }
    }

    /// Indices of three mutually different members, which differ from `i` under [`Crossover::Forced`].
    fn random_members(&mut self, i: usize) -> [usize; 3] {
        let n = self.members.len();
        let mut taken = [usize::MAX; 4];
        if self.settings.crossover == Crossover::Forced {
            taken[3] = i;
        }
        for k in 0..3 {
            taken[k] = loop {
                let r = self.rng.random_range(0..n);
                if !taken.contains(&r) {
                    break r;
                }
            };
        }
        [taken[0], taken[1], taken[2]]
    }
}

impl Method for DifferentialEvolution {
    fn ask(&mut self) -> Vec<Vec<f64>> {
        if self.objectives.is_empty() {
            return self.members.clone();
        }
        if self.generation >= self.settings.generations {
            return vec![];
        }
        let EvolutionSettings { f, cr, crossover, .. } = self.settings;
        let mut trials = vec![];
        for i in 0..self.members.len() {
            let [r1, r2, r3] = self.random_members(i);
            let n = self.members[i].len();
            let forced = match crossover {
                Crossover::Forced => self.rng.random_range(0..n),
                Crossover::AsPrinted => n,
            };
            let mut u = self.members[i].clone();
            for (j, x) in u.iter_mut().enumerate() {
                if self.rng.random::<f64>() <= cr || j == forced {
                    let m = &self.members;
                    *x = halfway_to_bound(m[r1][j] + f * (m[r2][j] - m[r3][j]), *x);
                }
            }
            trials.push(u);
        }
        trials
    }

    fn tell(&mut self, unit_points: &[Vec<f64>], trials: &[Trial]) {
        if self.objectives.is_empty() {
            self.objectives = trials.iter().map(|t| t.objective).collect();
            return;
        }
        for (i, (unit_point, trial)) in unit_points.iter().zip(trials).enumerate() {
            if trial.objective < self.objectives[i] {
                self.members[i].clone_from(unit_point);
                self.objectives[i] = trial.objective;
            }
        }
        self.generation += 1;
    }

    fn spread(&self) -> f64 {
        objective_spread(&self.objectives)
    }

    fn progress(&self) -> f64 {
        self.generation as f64 / self.settings.generations as f64
    }
}

//! Differential evolution `rand/1/bin` (Storn and Price, 1997), Eqs 8 to 11 of the calibration paper.

use super::{Method, Trial, anywhere, inside, spread_of};
use rand::{RngExt as _, SeedableRng as _};
use rand_pcg::Pcg32;
use serde::{Deserialize, Serialize};

/// Which coordinates of a mutant go into the trial point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Crossover {
    /// Each with probability CR, and one drawn at random in any case, as Storn and Price have it; r1, r2, r3 and the member
    /// itself are four different ones.
    Forced,
    /// Each with probability CR, so that a trial point may be the member itself again, and r1, r2, r3 mutually different
    /// but any members: Eqs 9 and 10 of the paper as they are printed.
    Printed,
}

/// The constants of the method.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Differential {
    /// Members N.
    pub population: usize,
    /// Generations P after the first population.
    pub generations: usize,
    /// Mutation constant F.
    pub f: f64,
    /// Crossover constant CR (k in the paper).
    pub cr: f64,
    /// Crossover rule.
    pub crossover: Crossover,
}

/// Differential evolution: v = θ_r1 + F (θ_r2 - θ_r3) (Eq 9), crossed with the member (Eq 10), which it replaces where
/// it is better (Eq 11). Coordinates of v outside of the cube are put half way between the member and the side.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Evolution {
    constants: Differential,
    rng: Pcg32,
    members: Vec<Vec<f64>>,
    scores: Vec<f64>,
    generation: usize,
}

impl Evolution {
    /// A search in some dimensions. The population is made with the first asking.
    pub fn new(constants: Differential, dimension: usize, seed: u64) -> Self {
        let mut rng = Pcg32::seed_from_u64(seed);
        let members = (0..constants.population).map(|_| anywhere(&mut rng, dimension)).collect();
        Self { constants, rng, members, scores: vec![], generation: 0 }
    }

    /// Three members, mutually different, and different from `i` where that is a rule.
    fn three(&mut self, i: usize) -> [usize; 3] {
        let n = self.members.len();
        let mut taken = [usize::MAX; 4];
        if self.constants.crossover == Crossover::Forced {
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

impl Method for Evolution {
    fn ask(&mut self) -> Vec<Vec<f64>> {
        if self.scores.is_empty() {
            return self.members.clone();
        }
        if self.generation >= self.constants.generations {
            return vec![];
        }
        let Differential { f, cr, crossover, .. } = self.constants;
        let mut out = vec![];
        for i in 0..self.members.len() {
            let [r1, r2, r3] = self.three(i);
            let n = self.members[i].len();
            let forced = match crossover {
                Crossover::Forced => self.rng.random_range(0..n),
                Crossover::Printed => n,
            };
            let mut u = self.members[i].clone();
            for (j, x) in u.iter_mut().enumerate() {
                if self.rng.random::<f64>() <= cr || j == forced {
                    let m = &self.members;
                    *x = inside(m[r1][j] + f * (m[r2][j] - m[r3][j]), *x);
                }
            }
            out.push(u);
        }
        out
    }

    fn tell(&mut self, points: &[Vec<f64>], trials: &[Trial]) {
        if self.scores.is_empty() {
            self.scores = trials.iter().map(|t| t.score).collect();
            return;
        }
        for (i, (point, trial)) in points.iter().zip(trials).enumerate() {
            if trial.score < self.scores[i] {
                self.members[i].clone_from(point);
                self.scores[i] = trial.score;
            }
        }
        self.generation += 1;
    }

    fn spread(&self) -> f64 {
        spread_of(&self.scores)
    }

    fn progress(&self) -> f64 {
        self.generation as f64 / self.constants.generations as f64
    }
}

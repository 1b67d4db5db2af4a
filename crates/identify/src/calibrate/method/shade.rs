//! Differential evolution with adaptive constants and linear population size reduction: L-SHADE (Tanabe and Fukunaga,
//! 2014) and jSO (Brest, Maučec and Bošković, 2017).

use super::{Method, Trial, halfway_to_bound, objective_spread, random_point, standard_normal};
use rand::{RngExt as _, SeedableRng as _};
use rand_pcg::Pcg32;
use serde::{Deserialize, Serialize};

/// Variant of the method.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum ShadeVariant {
    /// L-SHADE.
    LShade,
    /// jSO: a larger first population, a growing weight on the step to the best, and bounds on F and CR at first.
    Jso,
}

/// L-SHADE or jSO. Mutation is current-to-pbest/1 with an archive of replaced members. F and CR are drawn about a memory
/// of weighted means of successful values. The population shrinks linearly with the evaluations to four. Coordinates
/// outside of the cube are put half way between member and bound, as in both papers.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Shade {
    variant: ShadeVariant,
    initial_population: usize,
    /// Greatest number of evaluations, and the number so far.
    budget: usize,
    used: usize,
    rng: Pcg32,
    members: Vec<Vec<f64>>,
    objectives: Vec<f64>,
    archive: Vec<Vec<f64>>,
    memory_f: Vec<f64>,
    memory_cr: Vec<f64>,
    /// Entry of the memory that is written next.
    memory_index: usize,
    /// F and CR of the current trial points.
    trial_constants: Vec<(f64, f64)>,
}

/// Population size at the end, as in both papers.
const MIN_POPULATION: usize = 4;

impl Shade {
    /// A search with at most `budget` evaluations. The default of the first population is that of the papers: 18 n, and
    /// 25 ln n √n.
    pub fn new(variant: ShadeVariant, dimension: usize, budget: usize, population: Option<usize>, seed: u64) -> Self {
        let mut rng = Pcg32::seed_from_u64(seed);
        let n = dimension as f64;
        let default_population = match variant {
            ShadeVariant::LShade => 18.0 * n,
            // In one dimension ln n would give an empty population.
            ShadeVariant::Jso => 25.0 * n.max(2.0).ln() * n.max(2.0).sqrt(),
        };
        let initial_population =
            population.unwrap_or(default_population.round() as usize).clamp(MIN_POPULATION, budget.max(MIN_POPULATION));
        let members = (0..initial_population).map(|_| random_point(&mut rng, dimension)).collect();
        let (size, f, cr) = match variant {
            ShadeVariant::LShade => (6, 0.5, 0.5),
            ShadeVariant::Jso => (5, 0.3, 0.8),
        };
        Self {
            variant,
            initial_population,
            budget,
            used: 0,
            rng,
            members,
            objectives: vec![],
            archive: vec![],
            memory_f: vec![f; size],
            memory_cr: vec![cr; size],
            memory_index: 0,
            trial_constants: vec![],
        }
    }

    /// Share of the evaluations that are used.
    fn used_share(&self) -> f64 {
        self.used as f64 / self.budget as f64
    }

    /// F and CR drawn about a random entry of the memory. A negative entry of CR stands for zero.
    fn draw_constants(&mut self) -> (f64, f64) {
        let size = self.memory_f.len();
        let k = self.rng.random_range(0..size);
        let (mut mean_f, mut mean_cr) = (self.memory_f[k], self.memory_cr[k]);
        if self.variant == ShadeVariant::Jso && k == size - 1 {
            (mean_f, mean_cr) = (0.9, 0.9);
        }
        let mut cr = if mean_cr < 0.0 { 0.0 } else { (mean_cr + 0.1 * standard_normal(&mut self.rng)).clamp(0.0, 1.0) };
        // Cauchy distribution, truncated to (0, 1].
        let mut f = loop {
            let angle = std::f64::consts::PI * (self.rng.random::<f64>() - 0.5);
            let f = mean_f + 0.1 * angle.tan();
            if f > 0.0 {
                break f.min(1.0);
            }
        };
        if self.variant == ShadeVariant::Jso {
            let used = self.used_share();
            cr = match used {
                x if x < 0.25 => cr.max(0.7),
                x if x < 0.5 => cr.max(0.6),
                _ => cr,
            };
            f = if used < 0.6 { f.min(0.7) } else { f };
        }
        (f, cr)
    }

    /// Indices of the members from the best to the worst.
    fn ranking(&self) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.members.len()).collect();
        order.sort_by(|a, b| self.objectives[*a].total_cmp(&self.objectives[*b]));
        order
    }

    /// The trial point of a member: its mutant, crossed with it.
    fn trial_point(&mut self, i: usize, ranking: &[usize], f: f64, cr: f64) -> Vec<f64> {
        let (n, used) = (self.members.len(), self.used_share());
        let (share, weight) = match self.variant {
            ShadeVariant::LShade => (0.11, f),
            ShadeVariant::Jso => {
                let growth = match used {
                    x if x < 0.2 => 0.7,
                    x if x < 0.4 => 0.8,
                    _ => 1.2,
                };
                (0.25 * (1.0 - 0.5 * used), growth * f)
            }
        };
        let best_count = ((share * n as f64).round() as usize).clamp(2, n);
        let best = ranking[self.rng.random_range(0..best_count)];
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
                *x = halfway_to_bound(*x + step, *x);
            }
        }
        u
    }

    /// Put the weighted Lehmer means of successful F and CR into the memory. `successes` are F, CR and the improvement
    /// of the objective, which is the weight.
    fn update_memory(&mut self, successes: &[(f64, f64, f64)]) {
        let total: f64 = successes.iter().map(|w| w.2).sum();
        if successes.is_empty() || total <= 0.0 || !total.is_finite() {
            return;
        }
        let lehmer = |of: fn(&(f64, f64, f64)) -> f64| {
            let (squares, sum) =
                successes.iter().fold((0.0, 0.0), |(s, t), w| (s + w.2 * of(w) * of(w), t + w.2 * of(w)));
            if sum > 0.0 { squares / sum } else { 0.0 }
        };
        let (mean_f, mean_cr) = (lehmer(|w| w.0), lehmer(|w| w.1));
        let k = self.memory_index;
        match self.variant {
            ShadeVariant::LShade => {
                self.memory_f[k] = mean_f;
                // From here on the entry stands for CR = 0.
                self.memory_cr[k] = if self.memory_cr[k] < 0.0 || mean_cr == 0.0 { -1.0 } else { mean_cr };
            }
            ShadeVariant::Jso => {
                self.memory_f[k] = 0.5 * (self.memory_f[k] + mean_f);
                self.memory_cr[k] = 0.5 * (self.memory_cr[k] + mean_cr);
            }
        }
        // jSO never writes the last entry.
        let size = self.memory_f.len() - usize::from(self.variant == ShadeVariant::Jso);
        self.memory_index = (k + 1) % size;
    }

    /// Reduce population and archive to the sizes for the evaluations used.
    fn reduce_population(&mut self) {
        let range = self.initial_population as f64 - MIN_POPULATION as f64;
        let size =
            (self.initial_population as f64 - range * self.used_share()).round().max(MIN_POPULATION as f64) as usize;
        while self.members.len() > size {
            let Some(worst) =
                (0..self.objectives.len()).max_by(|a, b| self.objectives[*a].total_cmp(&self.objectives[*b]))
            else {
                return;
            };
            self.members.remove(worst);
            self.objectives.remove(worst);
        }
        let archive_size = match self.variant {
            ShadeVariant::LShade => (2.6 * size as f64) as usize,
            ShadeVariant::Jso => size,
        };
        while self.archive.len() > archive_size {
            let random = self.rng.random_range(0..self.archive.len());
            self.archive.swap_remove(random);
        }
    }
}

impl Method for Shade {
    fn ask(&mut self) -> Vec<Vec<f64>> {
        if self.objectives.is_empty() {
            return self.members.clone();
        }
        // Mutation cannot leave a point that all members share.
        if self.used >= self.budget || self.has_converged() {
            return vec![];
        }
        let ranking = self.ranking();
        self.trial_constants.clear();
        let count = self.members.len().min(self.budget - self.used);
        let mut trials = vec![];
        for i in 0..count {
            let (f, cr) = self.draw_constants();
            self.trial_constants.push((f, cr));
            trials.push(self.trial_point(i, &ranking, f, cr));
        }
        trials
    }

    fn tell(&mut self, unit_points: &[Vec<f64>], trials: &[Trial]) {
        self.used += unit_points.len();
        if self.objectives.is_empty() {
            self.objectives = trials.iter().map(|t| t.objective).collect();
            return;
        }
        let mut successes = vec![];
        for (i, (unit_point, trial)) in unit_points.iter().zip(trials).enumerate() {
            let old = self.objectives[i];
            if trial.objective > old {
                continue;
            }
            if trial.objective < old {
                let (f, cr) = self.trial_constants[i];
                let improvement = if old < Trial::FAILED { old - trial.objective } else { trial.objective.abs() };
                successes.push((f, cr, improvement));
                self.archive.push(self.members[i].clone());
            }
            self.members[i].clone_from(unit_point);
            self.objectives[i] = trial.objective;
        }
        self.update_memory(&successes);
        self.reduce_population();
    }

    fn spread(&self) -> f64 {
        objective_spread(&self.objectives)
    }

    fn progress(&self) -> f64 {
        self.used_share()
    }

    fn has_converged(&self) -> bool {
        self.members.iter().all(|m| *m == self.members[0])
    }
}

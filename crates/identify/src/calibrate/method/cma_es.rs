//! Evolution strategy with covariance matrix adaptation (Hansen, "The CMA Evolution Strategy: A Tutorial", 2016). It
//! restarts with twice the population when it stagnates (Auger and Hansen, 2005).

use super::{Method, Trial, objective_spread, random_point, standard_normal};
use nalgebra::{DMatrix, DVector, SymmetricEigen};
use rand::SeedableRng as _;
use rand_pcg::Pcg32;
use serde::{Deserialize, Serialize};

/// CMA-ES. Samples outside of the cube are reflected into it for evaluation.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct CmaEs {
    dimension: usize,
    /// Greatest number of evaluations, and the number so far.
    budget: usize,
    used: usize,
    rng: Pcg32,
    /// Population size λ.
    population: usize,
    distribution: Distribution,
    generation: usize,
    /// Samples of the current generation, not reflected.
    samples: Vec<Vec<f64>>,
    objectives: Vec<f64>,
    /// Least objective of each generation since the last restart.
    best_objectives: Vec<f64>,
    /// The search ends where its first descent has settled, and does not restart.
    is_single_descent: bool,
}

/// The normal distribution N(m, σ² C), with its evolution paths.
#[derive(Clone, Debug, Serialize, Deserialize)]
struct Distribution {
    mean: Vec<f64>,
    /// Step size σ.
    step_size: f64,
    /// Covariance matrix C, by columns.
    covariance: Vec<f64>,
    /// Evolution path of the covariance matrix.
    covariance_path: Vec<f64>,
    /// Evolution path of the step size.
    step_size_path: Vec<f64>,
    /// C = B D² Bᵀ: B by columns.
    eigenvectors: Vec<f64>,
    /// C = B D² Bᵀ: diagonal of D.
    deviations: Vec<f64>,
}

/// First step size, in sides of the cube.
const INITIAL_STEP_SIZE: f64 = 0.3;
/// A search stagnates if its best objective changes by less than this fraction over the last generations.
const STAGNATION_TOLERANCE: f64 = 1e-10;
/// A descent has settled if the objectives of a generation differ by less than this fraction of the least one ...
const SETTLED_SPREAD: f64 = 0.05;
/// ... or if its distribution is narrower than this, in sides of the cube: least squares then find the minimum.
const SETTLED_WIDTH: f64 = 0.01;
/// Fewer generations do not settle a descent.
const MIN_GENERATIONS: usize = 10;

impl Distribution {
    /// The distribution with C = 1.
    fn isotropic(mean: Vec<f64>) -> Self {
        let n = mean.len();
        let unit = DMatrix::<f64>::identity(n, n);
        Self {
            mean,
            step_size: INITIAL_STEP_SIZE,
            covariance: unit.as_slice().to_vec(),
            covariance_path: vec![0.0; n],
            step_size_path: vec![0.0; n],
            eigenvectors: unit.as_slice().to_vec(),
            deviations: vec![1.0; n],
        }
    }
}

impl CmaEs {
    /// A search with at most `budget` evaluations, from the middle of the cube.
    pub fn new(dimension: usize, budget: usize, population: Option<usize>, seed: u64) -> Self {
        Self {
            dimension,
            budget,
            used: 0,
            rng: Pcg32::seed_from_u64(seed),
            population: Self::population(dimension, population),
            distribution: Distribution::isotropic(vec![0.5; dimension]),
            generation: 0,
            samples: vec![],
            objectives: vec![],
            best_objectives: vec![],
            is_single_descent: false,
        }
    }

    /// Population size λ, by default 4 + 3 ln n.
    pub fn population(dimension: usize, population: Option<usize>) -> usize {
        population.unwrap_or(4 + (3.0 * (dimension as f64).ln()) as usize).max(4)
    }

    /// End the search where its first descent has settled.
    #[must_use]
    pub fn with_single_descent(mut self) -> Self {
        self.is_single_descent = true;
        self
    }

    /// Returns true if the descent has settled: objective and spread are below their tolerances.
    fn has_settled(&self) -> bool {
        let least = self.objectives.iter().fold(Trial::FAILED, |m, s| m.min(*s));
        if self.best_objectives.len() < MIN_GENERATIONS || least >= Trial::FAILED {
            return false;
        }
        let Distribution { step_size, deviations, .. } = &self.distribution;
        let longest = deviations.iter().fold(0.0f64, |m, d| m.max(*d));
        objective_spread(&self.objectives) <= SETTLED_SPREAD * least || step_size * longest < SETTLED_WIDTH
    }

    /// Start again from a random mean, with twice the population.
    fn restart(&mut self) {
        self.population *= 2;
        self.distribution = Distribution::isotropic(random_point(&mut self.rng, self.dimension));
        self.generation = 0;
        self.best_objectives.clear();
    }

    /// Returns true if the objective does not change any more, or the distribution has degenerated.
    fn stagnates(&self) -> bool {
        let window = 10 + (30 * self.dimension).div_ceil(self.population);
        let last = &self.best_objectives[self.best_objectives.len().saturating_sub(window)..];
        let least = last.iter().fold(f64::INFINITY, |m, s| m.min(*s));
        let is_flat = last.len() == window && objective_spread(last) <= STAGNATION_TOLERANCE * least.abs();
        let Distribution { step_size, deviations, .. } = &self.distribution;
        let longest = deviations.iter().fold(0.0f64, |m, d| m.max(*d));
        let shortest = deviations.iter().fold(f64::INFINITY, |m, d| m.min(*d));
        is_flat || step_size * longest < 1e-9 || longest > 1e7 * shortest || !step_size.is_finite()
    }

    /// Update the distribution with the better half of a generation; `ranking` has its indices from the best.
    /// Symbols and equations are those of the tutorial.
    fn update_distribution(&mut self, ranking: &[usize]) {
        let n = self.dimension;
        let nf = n as f64;
        let mu = self.population / 2;
        let raw: Vec<f64> =
            (0..mu).map(|i| (0.5 * (self.population as f64 + 1.0)).ln() - (i as f64 + 1.0).ln()).collect();
        let total: f64 = raw.iter().sum();
        let weights: Vec<f64> = raw.iter().map(|w| w / total).collect();
        let mu_eff = 1.0 / weights.iter().map(|w| w * w).sum::<f64>();
        let c_c = (4.0 + mu_eff / nf) / (nf + 4.0 + 2.0 * mu_eff / nf);
        let c_s = (mu_eff + 2.0) / (nf + mu_eff + 5.0);
        let c_1 = 2.0 / ((nf + 1.3).powi(2) + mu_eff);
        let c_mu = (2.0 * (mu_eff - 2.0 + 1.0 / mu_eff) / ((nf + 2.0).powi(2) + mu_eff)).min(1.0 - c_1);
        let damping = 1.0 + 2.0 * (((mu_eff - 1.0) / (nf + 1.0)).sqrt() - 1.0).max(0.0) + c_s;
        let expected = nf.sqrt() * (1.0 - 1.0 / (4.0 * nf) + 1.0 / (21.0 * nf * nf));

        let d = &mut self.distribution;
        let steps: Vec<DVector<f64>> = ranking[..mu]
            .iter()
            .map(|i| {
                DVector::from_iterator(n, self.samples[*i].iter().zip(&d.mean).map(|(x, m)| (x - m) / d.step_size))
            })
            .collect();
        let step = steps.iter().zip(&weights).fold(DVector::zeros(n), |sum: DVector<f64>, (y, w)| sum + y * *w);
        for (m, s) in d.mean.iter_mut().zip(step.iter()) {
            *m += d.step_size * s;
        }
        let eigenvectors = DMatrix::from_column_slice(n, n, &d.eigenvectors);
        let mut white = eigenvectors.transpose() * &step;
        white.iter_mut().zip(&d.deviations).for_each(|(w, d)| *w /= d);
        let white = &eigenvectors * white;
        let path_s =
            DVector::from_column_slice(&d.step_size_path) * (1.0 - c_s) + white * (c_s * (2.0 - c_s) * mu_eff).sqrt();
        self.generation += 1;
        let fade = 1.0 - (1.0 - c_s).powi(2 * self.generation as i32);
        let is_moderate = path_s.norm() / fade.sqrt() < (1.4 + 2.0 / (nf + 1.0)) * expected;
        let h = f64::from(u8::from(is_moderate));
        let path_c = DVector::from_column_slice(&d.covariance_path) * (1.0 - c_c)
            + step * (h * (c_c * (2.0 - c_c) * mu_eff).sqrt());
        let mut c = DMatrix::from_column_slice(n, n, &d.covariance);
        c *= 1.0 - c_1 - c_mu + (1.0 - h) * c_1 * c_c * (2.0 - c_c);
        c += &path_c * path_c.transpose() * c_1;
        for (y, w) in steps.iter().zip(&weights) {
            c += y * y.transpose() * (c_mu * w);
        }
        d.step_size *= ((path_s.norm() / expected - 1.0) * c_s / damping).exp();
        let c = (&c + c.transpose()) * 0.5;
        d.covariance = c.as_slice().to_vec();
        let eigen = SymmetricEigen::new(c);
        d.deviations = eigen.eigenvalues.iter().map(|l| l.max(1e-30).sqrt()).collect();
        d.eigenvectors = eigen.eigenvectors.as_slice().to_vec();
        d.step_size_path = path_s.as_slice().to_vec();
        d.covariance_path = path_c.as_slice().to_vec();
    }
}

/// A coordinate reflected into 0..1.
fn reflected(x: f64) -> f64 {
    let r = x.rem_euclid(2.0);
    if r > 1.0 { 2.0 - r } else { r }
}

impl Method for CmaEs {
    fn ask(&mut self) -> Vec<Vec<f64>> {
        if self.used >= self.budget || self.has_converged() {
            return vec![];
        }
        if self.stagnates() {
            self.restart();
        }
        let n = self.dimension;
        let Distribution { mean, step_size, eigenvectors, deviations, .. } = &self.distribution;
        let eigenvectors = DMatrix::from_column_slice(n, n, eigenvectors);
        self.samples.clear();
        for _ in 0..self.population {
            let z = DVector::from_iterator(n, deviations.iter().map(|d| d * standard_normal(&mut self.rng)));
            let y = &eigenvectors * z;
            self.samples.push(mean.iter().zip(y.iter()).map(|(m, y)| m + step_size * y).collect());
        }
        self.samples.iter().map(|p| p.iter().map(|x| reflected(*x)).collect()).collect()
    }

    fn tell(&mut self, unit_points: &[Vec<f64>], trials: &[Trial]) {
        self.used += unit_points.len();
        self.objectives = trials.iter().map(|t| t.objective).collect();
        let mut ranking: Vec<usize> = (0..unit_points.len()).collect();
        ranking.sort_by(|a, b| self.objectives[*a].total_cmp(&self.objectives[*b]));
        self.best_objectives.push(self.objectives[ranking[0]]);
        self.update_distribution(&ranking);
    }

    fn spread(&self) -> f64 {
        objective_spread(&self.objectives)
    }

    fn progress(&self) -> f64 {
        self.used as f64 / self.budget as f64
    }

    fn has_converged(&self) -> bool {
        self.is_single_descent && (self.has_settled() || self.stagnates())
    }
}

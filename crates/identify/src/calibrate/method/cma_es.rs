//! Evolution strategy with adaptation of the covariance matrix (Hansen, "The CMA Evolution Strategy: A Tutorial", 2016),
//! started again with twice the population when it gets stuck (Auger and Hansen, 2005).

use super::{Method, Trial, anywhere, normal, spread_of};
use nalgebra::{DMatrix, DVector, SymmetricEigen};
use rand::SeedableRng as _;
use rand_pcg::Pcg32;
use serde::{Deserialize, Serialize};

/// CMA-ES. Points outside of the cube are evaluated where they are reflected into it.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct CmaEs {
    dimension: usize,
    budget: usize,
    used: usize,
    rng: Pcg32,
    /// Points of a generation λ.
    population: usize,
    mean: Vec<f64>,
    sigma: f64,
    /// Covariance matrix C, by columns.
    covariance: Vec<f64>,
    path_c: Vec<f64>,
    path_s: Vec<f64>,
    /// C = B D² Bᵀ: B by columns, and D.
    axes: Vec<f64>,
    lengths: Vec<f64>,
    generation: usize,
    /// The generation asked for, before it was reflected.
    asked: Vec<Vec<f64>>,
    scores: Vec<f64>,
    /// Best scores of the last generations.
    recent: Vec<f64>,
}

/// First step size, in sides of the cube.
const SIGMA: f64 = 0.3;
/// A generation whose best has not changed by more than this fraction over the last ones is stuck.
const STUCK: f64 = 1e-10;

impl CmaEs {
    /// A search in some dimensions with a number of evaluations, from the middle of the cube.
    pub fn new(dimension: usize, budget: usize, population: Option<usize>, seed: u64) -> Self {
        let usual = 4 + (3.0 * (dimension as f64).ln()) as usize;
        let mut new = Self {
            dimension,
            budget,
            used: 0,
            rng: Pcg32::seed_from_u64(seed),
            population: population.unwrap_or(usual).max(4),
            mean: vec![0.5; dimension],
            sigma: SIGMA,
            covariance: vec![],
            path_c: vec![],
            path_s: vec![],
            axes: vec![],
            lengths: vec![],
            generation: 0,
            asked: vec![],
            scores: vec![],
            recent: vec![],
        };
        new.restart();
        new
    }

    /// A round distribution about the mean.
    fn restart(&mut self) {
        let n = self.dimension;
        let unit = DMatrix::<f64>::identity(n, n);
        self.sigma = SIGMA;
        self.covariance = unit.as_slice().to_vec();
        self.axes = unit.as_slice().to_vec();
        self.lengths = vec![1.0; n];
        self.path_c = vec![0.0; n];
        self.path_s = vec![0.0; n];
        self.generation = 0;
        self.recent.clear();
    }

    fn is_stuck(&self) -> bool {
        let window = 10 + (30 * self.dimension).div_ceil(self.population);
        let tail = &self.recent[self.recent.len().saturating_sub(window)..];
        let least = tail.iter().fold(f64::INFINITY, |m, s| m.min(*s));
        let flat = tail.len() == window && spread_of(tail) <= STUCK * least.abs();
        let longest = self.lengths.iter().fold(0.0f64, |m, d| m.max(*d));
        let shortest = self.lengths.iter().fold(f64::INFINITY, |m, d| m.min(*d));
        flat || self.sigma * longest < 1e-9 || longest > 1e7 * shortest || !self.sigma.is_finite()
    }

    /// Move the distribution towards the better half of a generation.
    fn adapt(&mut self, order: &[usize]) {
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

        let steps: Vec<DVector<f64>> = order[..mu]
            .iter()
            .map(|i| {
                DVector::from_iterator(n, self.asked[*i].iter().zip(&self.mean).map(|(x, m)| (x - m) / self.sigma))
            })
            .collect();
        let step = steps.iter().zip(&weights).fold(DVector::zeros(n), |sum: DVector<f64>, (y, w)| sum + y * *w);
        for (m, s) in self.mean.iter_mut().zip(step.iter()) {
            *m += self.sigma * s;
        }
        let axes = DMatrix::from_column_slice(n, n, &self.axes);
        let mut white = axes.transpose() * &step;
        white.iter_mut().zip(&self.lengths).for_each(|(w, d)| *w /= d);
        let white = &axes * white;
        let path_s =
            DVector::from_column_slice(&self.path_s) * (1.0 - c_s) + white * (c_s * (2.0 - c_s) * mu_eff).sqrt();
        self.generation += 1;
        let fade = 1.0 - (1.0 - c_s).powi(2 * self.generation as i32);
        let moves = path_s.norm() / fade.sqrt() < (1.4 + 2.0 / (nf + 1.0)) * expected;
        let h = f64::from(u8::from(moves));
        let path_c =
            DVector::from_column_slice(&self.path_c) * (1.0 - c_c) + step * (h * (c_c * (2.0 - c_c) * mu_eff).sqrt());
        let mut c = DMatrix::from_column_slice(n, n, &self.covariance);
        c *= 1.0 - c_1 - c_mu + (1.0 - h) * c_1 * c_c * (2.0 - c_c);
        c += &path_c * path_c.transpose() * c_1;
        for (y, w) in steps.iter().zip(&weights) {
            c += y * y.transpose() * (c_mu * w);
        }
        self.sigma *= ((path_s.norm() / expected - 1.0) * c_s / damping).exp();
        let c = (&c + c.transpose()) * 0.5;
        self.covariance = c.as_slice().to_vec();
        let eigen = SymmetricEigen::new(c);
        self.lengths = eigen.eigenvalues.iter().map(|l| l.max(1e-30).sqrt()).collect();
        self.axes = eigen.eigenvectors.as_slice().to_vec();
        self.path_s = path_s.as_slice().to_vec();
        self.path_c = path_c.as_slice().to_vec();
    }
}

/// A coordinate reflected into 0..1.
fn reflected(x: f64) -> f64 {
    let r = x.rem_euclid(2.0);
    if r > 1.0 { 2.0 - r } else { r }
}

impl Method for CmaEs {
    fn ask(&mut self) -> Vec<Vec<f64>> {
        if self.used >= self.budget {
            return vec![];
        }
        if self.is_stuck() {
            self.population *= 2;
            self.mean = anywhere(&mut self.rng, self.dimension);
            self.restart();
        }
        let n = self.dimension;
        let axes = DMatrix::from_column_slice(n, n, &self.axes);
        self.asked.clear();
        for _ in 0..self.population {
            let z = DVector::from_iterator(n, self.lengths.iter().map(|d| d * normal(&mut self.rng)));
            let y = &axes * z;
            self.asked.push(self.mean.iter().zip(y.iter()).map(|(m, y)| m + self.sigma * y).collect());
        }
        self.asked.iter().map(|p| p.iter().map(|x| reflected(*x)).collect()).collect()
    }

    fn tell(&mut self, points: &[Vec<f64>], trials: &[Trial]) {
        self.used += points.len();
        self.scores = trials.iter().map(|t| t.score).collect();
        let mut order: Vec<usize> = (0..points.len()).collect();
        order.sort_by(|a, b| self.scores[*a].total_cmp(&self.scores[*b]));
        self.recent.push(self.scores[order[0]]);
        self.adapt(&order);
    }

    fn spread(&self) -> f64 {
        spread_of(&self.scores)
    }

    fn progress(&self) -> f64 {
        self.used as f64 / self.budget as f64
    }
}

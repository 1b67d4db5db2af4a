//! Samples of the posterior by an affine-invariant ensemble (Goodman and Weare, 2010: the stretch move).
//!
//! The prior is uniform over the unit cube. The noise has an unknown variance with Jeffreys' prior, and autocorrelation
//! leaves n independent samples. The likelihood is then S^(-n/2), with the objective S.

use super::method::{Trial, standard_normal};
use super::problem::{Problem, StudyProblem};
use super::uncertainty::{Uncertainty, autocorrelation_time};
use crate::study::{ParameterRange, ParameterSpace, SimulationError};
use rand::{RngExt as _, SeedableRng as _};
use rand_pcg::Pcg32;
use serde::Serialize;

/// Quantiles of a parameter.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Quantiles {
    /// Name.
    pub name: String,
    /// 2.5 % quantile.
    pub lower: f64,
    /// Median.
    pub median: f64,
    /// 97.5 % quantile.
    pub upper: f64,
}

/// A sample of the posterior.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Posterior {
    /// Number of walkers.
    pub walkers: usize,
    /// Number of sweeps over the ensemble after the burn-in, which has half as many.
    pub sweeps: usize,
    /// Share of accepted moves.
    pub acceptance: f64,
    /// Number of independent draws, by the parameter with the longest autocorrelation.
    pub effective_draws: f64,
    /// Quantiles of the free parameters.
    pub quantiles: Vec<Quantiles>,
    /// At most a thousand draws: values of the free parameters, in the order of the quantiles.
    pub draws: Vec<Vec<f64>>,
}

/// Greatest stretch a of a move.
const STRETCH: f64 = 2.0;
/// Greatest number of draws that are kept.
const MAX_DRAWS: usize = 1000;

/// The ensemble of walkers.
struct Ensemble<'a> {
    problem: &'a StudyProblem,
    rng: Pcg32,
    /// Half of the independent samples: the exponent n/2 of the likelihood.
    exponent: f64,
    /// Unit points and their log likelihoods.
    walkers: Vec<Vec<f64>>,
    log_likelihoods: Vec<f64>,
    accepted: usize,
    proposed: usize,
}

impl<'a> Ensemble<'a> {
    /// Walkers about the best unit point, spread by the standard errors.
    fn new(problem: &'a StudyProblem, best: &[f64], uncertainty: &Uncertainty, seed: u64) -> Self {
        let mut rng = Pcg32::seed_from_u64(seed);
        let half = (2 * best.len()).max(8);
        let mut walker = || {
            let near = |(i, x): (usize, &f64)| {
                let width = uncertainty.intervals[i].standard_error.clamp(1e-4, 0.1);
                (x + width * standard_normal(&mut rng)).clamp(0.0, 1.0)
            };
            best.iter().enumerate().map(near).collect()
        };
        let walkers: Vec<Vec<f64>> = (0..2 * half).map(|_| walker()).collect();
        let exponent = 0.5 * uncertainty.effective_samples;
        let mut new = Self { problem, rng, exponent, walkers, log_likelihoods: vec![], accepted: 0, proposed: 0 };
        let evaluations = problem.evaluate(&new.walkers, false);
        new.log_likelihoods = evaluations.iter().map(|e| new.log_likelihood(&e.trial)).collect();
        new
    }

    fn log_likelihood(&self, trial: &Trial) -> f64 {
        if trial.objective < Trial::FAILED { -self.exponent * trial.objective.ln() } else { f64::NEG_INFINITY }
    }

    /// Move all walkers once: the first half along the second, then the second along the first.
    ///
    /// # Errors
    /// The search was interrupted.
    fn sweep(&mut self) -> Result<(), String> {
        let half = self.walkers.len() / 2;
        self.move_half(0, half)?;
        self.move_half(half, 0)
    }

    /// Move the walkers of the half that starts at index `moving`, along walkers of the other half.
    fn move_half(&mut self, moving: usize, other: usize) -> Result<(), String> {
        let half = self.walkers.len() / 2;
        let proposals: Vec<(f64, Vec<f64>)> = (moving..moving + half)
            .map(|k| {
                // Density of the stretch: 1/√z between 1/a and a.
                let z = ((STRETCH - 1.0) * self.rng.random::<f64>() + 1.0).powi(2) / STRETCH;
                let j = other + self.rng.random_range(0..half);
                let pairs = self.walkers[j].iter().zip(&self.walkers[k]);
                (z, pairs.map(|(a, b)| a + z * (b - a)).collect())
            })
            .collect();
        let is_inside = |p: &[f64]| p.iter().all(|x| (0.0..=1.0).contains(x));
        let inside: Vec<Vec<f64>> = proposals.iter().filter(|(_, p)| is_inside(p)).map(|(_, p)| p.clone()).collect();
        let mut evaluations = self.problem.evaluate(&inside, false).into_iter();
        for (k, (z, proposal)) in (moving..moving + half).zip(proposals) {
            self.proposed += 1;
            let uniform: f64 = self.rng.random();
            if !is_inside(&proposal) {
                continue;
            }
            let Some(e) = evaluations.next() else { continue };
            if e.error == Some(SimulationError::Interrupted) {
                return Err("interrupted".into());
            }
            let new = self.log_likelihood(&e.trial);
            let n = proposal.len() as f64;
            if uniform.ln() < (n - 1.0) * z.ln() + new - self.log_likelihoods[k] {
                self.walkers[k] = proposal;
                self.log_likelihoods[k] = new;
                self.accepted += 1;
            }
        }
        Ok(())
    }
}

/// Sample the posterior about the best unit point, with `sweeps` sweeps after the burn-in.
///
/// # Errors
/// No move was accepted, or the search was interrupted.
pub fn posterior(
    problem: &StudyProblem,
    best: &[f64],
    uncertainty: &Uncertainty,
    sweeps: usize,
    seed: u64,
) -> Result<Posterior, String> {
    let mut ensemble = Ensemble::new(problem, best, uncertainty, seed);
    let burn_in = sweeps / 2;
    let mut draws: Vec<Vec<f64>> = vec![];
    // Mean of the ensemble after each sweep, for the autocorrelation.
    let mut means: Vec<Vec<f64>> = vec![vec![]; best.len()];
    for sweep in 0..burn_in + sweeps {
        ensemble.sweep()?;
        if sweep >= burn_in {
            draws.extend(ensemble.walkers.iter().cloned());
            for (i, m) in means.iter_mut().enumerate() {
                m.push(ensemble.walkers.iter().map(|w| w[i]).sum::<f64>() / ensemble.walkers.len() as f64);
            }
        }
    }
    if ensemble.accepted == 0 {
        return Err("no move was taken".into());
    }
    let longest_time = means.iter().map(|m| autocorrelation_time(m)).fold(1.0, f64::max);
    Ok(Posterior {
        walkers: ensemble.walkers.len(),
        sweeps,
        acceptance: ensemble.accepted as f64 / ensemble.proposed as f64,
        effective_draws: draws.len() as f64 / longest_time,
        quantiles: quantiles(&problem.study().space, &draws),
        draws: thinned(&problem.study().space, &draws),
    })
}

/// Quantiles of all free parameters from unit points.
fn quantiles(space: &ParameterSpace, draws: &[Vec<f64>]) -> Vec<Quantiles> {
    let parameters = space.free_names().zip(space.free()).enumerate();
    let quantiles = |i: usize, name: &str, range: &ParameterRange| {
        let mut all: Vec<f64> = draws.iter().map(|p| p[i]).collect();
        all.sort_by(f64::total_cmp);
        let at = |q: f64| range.value(all[((all.len() - 1) as f64 * q).round() as usize]);
        Quantiles { name: name.to_owned(), lower: at(0.025), median: at(0.5), upper: at(0.975) }
    };
    parameters.map(|(i, (name, (_, range)))| quantiles(i, name, range)).collect()
}

/// Values of the free parameters at every k-th unit point.
fn thinned(space: &ParameterSpace, draws: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let every = draws.len().div_ceil(MAX_DRAWS).max(1);
    let values = |p: &Vec<f64>| space.free().zip(p).map(|((_, range), x)| range.value(*x)).collect();
    draws.iter().step_by(every).map(values).collect()
}

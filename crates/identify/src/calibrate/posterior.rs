//! The posterior of the parameters by an ensemble that samples it (Goodman and Weare, 2010: the stretch move).
//!
//! The prior is even over the unit cube. The noise has an unknown size with Jeffreys' prior, and the samples are worth
//! fewer independent ones for their autocorrelation: the likelihood is S^(-n/2), S the objective and n those samples.

use super::method::Trial;
use super::problem::{Problem, StudyProblem};
use super::uncertainty::{Uncertainty, autocorrelation_time};
use rand::{RngExt as _, SeedableRng as _};
use rand_pcg::Pcg32;
use serde::Serialize;

/// Quantiles of a parameter.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Quantiles {
    /// Name.
    pub name: String,
    /// 2.5 %.
    pub lower: f64,
    /// 50 %.
    pub median: f64,
    /// 97.5 %.
    pub upper: f64,
}

/// A sample of the posterior.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Posterior {
    /// Members of the ensemble.
    pub walkers: usize,
    /// Sweeps over the ensemble that count, after as many as half of them that do not.
    pub sweeps: usize,
    /// Share of the moves that were taken.
    pub acceptance: f64,
    /// Independent draws that the sample is worth, by the slowest parameter.
    pub effective_draws: f64,
    /// Quantiles of the free parameters.
    pub quantiles: Vec<Quantiles>,
    /// Draws, values of the free parameters, at most a thousand of them.
    #[serde(skip)]
    pub draws: Vec<Vec<f64>>,
}

/// Greatest stretch a of a move.
const STRETCH: f64 = 2.0;

/// Sample the posterior about the best point, with some sweeps.
///
/// # Errors
/// The walkers never moved, or the search was interrupted.
pub fn posterior(
    problem: &StudyProblem,
    best: &[f64],
    sure: &Uncertainty,
    sweeps: usize,
    seed: u64,
) -> Result<Posterior, String> {
    let n = best.len();
    let half = (2 * n).max(8);
    let mut rng = Pcg32::seed_from_u64(seed);
    let weight = 0.5 * sure.effective_samples;
    let likelihood = |t: &Trial| if t.score < Trial::FAILED { -weight * t.score.ln() } else { f64::NEG_INFINITY };
    let mut walkers: Vec<Vec<f64>> = (0..2 * half)
        .map(|_| {
            let near = |(i, x): (usize, &f64)| {
                let width = sure.intervals[i].relative.clamp(1e-4, 0.1);
                (x + width * super::method::normal(&mut rng)).clamp(0.0, 1.0)
            };
            best.iter().enumerate().map(near).collect()
        })
        .collect();
    let mut level: Vec<f64> = problem.evaluate(&walkers, false).iter().map(|e| likelihood(&e.trial)).collect();
    let (mut taken, mut tried) = (0usize, 0usize);
    let burn = sweeps / 2;
    let mut kept: Vec<Vec<f64>> = vec![];
    // Mean of the ensemble after each sweep, for the autocorrelation.
    let mut means: Vec<Vec<f64>> = vec![vec![]; n];
    for sweep in 0..burn + sweeps {
        for side in [0, half] {
            let other = half - side;
            let moves: Vec<(f64, Vec<f64>)> = (side..side + half)
                .map(|k| {
                    // Density of the stretch: 1/√z between 1/a and a.
                    let z = ((STRETCH - 1.0) * rng.random::<f64>() + 1.0).powi(2) / STRETCH;
                    let j = other + rng.random_range(0..half);
                    let p = walkers[j].iter().zip(&walkers[k]).map(|(a, b)| a + z * (b - a)).collect();
                    (z, p)
                })
                .collect();
            let inside = |p: &[f64]| p.iter().all(|x| (0.0..=1.0).contains(x));
            let wanted: Vec<Vec<f64>> = moves.iter().filter(|(_, p)| inside(p)).map(|(_, p)| p.clone()).collect();
            let mut answers = problem.evaluate(&wanted, false).into_iter();
            for (k, (z, p)) in (side..side + half).zip(moves) {
                tried += 1;
                let chance: f64 = rng.random();
                if !inside(&p) {
                    continue;
                }
                let Some(e) = answers.next() else { continue };
                if e.mishap == Some(crate::study::Mishap::Interrupted) {
                    return Err("interrupted".into());
                }
                let new = likelihood(&e.trial);
                if chance.ln() < (n as f64 - 1.0) * z.ln() + new - level[k] {
                    walkers[k] = p;
                    level[k] = new;
                    taken += 1;
                }
            }
        }
        if sweep >= burn {
            kept.extend(walkers.iter().cloned());
            for (i, m) in means.iter_mut().enumerate() {
                m.push(walkers.iter().map(|w| w[i]).sum::<f64>() / walkers.len() as f64);
            }
        }
    }
    if taken == 0 {
        return Err("no move was taken".into());
    }
    let slowest = means.iter().map(|m| autocorrelation_time(m)).fold(1.0, f64::max);
    let space = &problem.study().space;
    let value = |i: usize, place: f64| space.free().nth(i).map_or(f64::NAN, |(_, range)| range.value(place));
    let quantiles = (0..n)
        .map(|i| {
            let mut all: Vec<f64> = kept.iter().map(|p| p[i]).collect();
            all.sort_by(f64::total_cmp);
            let at = |q: f64| value(i, all[((all.len() - 1) as f64 * q).round() as usize]);
            Quantiles { name: space.free_name(i).to_owned(), lower: at(0.025), median: at(0.5), upper: at(0.975) }
        })
        .collect();
    let thin = kept.len().div_ceil(1000).max(1);
    let draws = kept.iter().step_by(thin).map(|p| p.iter().enumerate().map(|(i, x)| value(i, *x)).collect());
    Ok(Posterior {
        walkers: 2 * half,
        sweeps,
        acceptance: taken as f64 / tried as f64,
        effective_draws: kept.len() as f64 / slowest,
        quantiles,
        draws: draws.collect(),
    })
}

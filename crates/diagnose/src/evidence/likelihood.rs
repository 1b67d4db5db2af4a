//! How much the recordings speak for one explanation against another.
//!
//! Residuals of a repaired model are not white noise: sensors have coloured noise, and no law of the library is the one
//! of nature. Three things keep a long record from making a small difference look like a certainty. Residuals are
//! averaged to at most [`POINTS`] points a channel, since mechanisms live in the motion and not between two samples.
//! They are whitened by the autoregressive noise of the best explanation before they are compared, so that slow noise
//! does not speak for whatever follows it slowly; the memory of the noise is bounded by [`MEMORY`], since an effect may be
//! slow as well. And a channel counts as [`INDEPENDENT`] samples however long it is, C channels, which see the same
//! motion, as √C times as many.
//! With the mean square E of the whitened residual of a channel, an explanation with k parameters has the log evidence
//!
//! -½ Σ N_c ln E_c - ½ k ln N
//!
//! (Schwarz, Ann. Stat. 6 (1978), for unknown noise levels), N_c the share of the channel in N.

use crate::residual::noise::{averaged, burg, power, whiten};

/// Independent samples that one channel counts for: chosen so that confidence is as often right as it says on
/// simulated cases, not from the length of the records.
pub const INDEPENDENT: f64 = 40.0;

/// Log odds for what a recording shows by itself, over what only the misfit of a model tells: a choice, more than any structure that is
/// left can say for `unknown`.
pub(crate) const SEEN: f64 = 15.0;

/// Objective with a price for so many parameters and log odds for what else is known, as a logarithm: a score for a first sorting,
/// the less the better.
pub(crate) fn priced(objective: f64, dimension: usize, known: f64) -> f64 {
    objective.ln() + (dimension as f64 * INDEPENDENT.ln() - 2.0 * known) / INDEPENDENT
}

/// Log evidence of one score over another, about.
pub(crate) fn ahead(score: f64, over: f64) -> f64 {
    0.5 * INDEPENDENT * (over - score)
}

/// Points that the residual of a channel is averaged to.
pub(crate) const POINTS: usize = 400;

/// Order of the noise.
const ORDER: usize = 2;

/// Largest root of the noise: what it remembers after a fortieth of the record is a third.
const MEMORY: f64 = 0.9;

/// Residuals of the fitted runs, channel after channel; missing samples left out.
pub type Residuals = Vec<Vec<f64>>;

/// The noise of each channel, from the residuals of the best explanation.
pub struct Noise(Vec<Vec<f64>>);

impl Noise {
    /// Of the residuals of the best explanation.
    pub fn of(best: &Residuals) -> Self {
        let of = |r: &Vec<f64>| -> Vec<f64> {
            let a = burg(&averaged(r, POINTS), ORDER);
            a.iter().zip(1..).map(|(a, k)| a * MEMORY.powi(k)).collect()
        };
        Self(best.iter().map(of).collect())
    }

    /// Log evidence of an explanation with `k` parameters to be found.
    pub fn evidence(&self, residuals: &Residuals, k: usize) -> f64 {
        let channels = residuals.len().max(1) as f64;
        let share = INDEPENDENT / channels.sqrt();
        let fit: f64 = residuals
            .iter()
            .zip(&self.0)
            .map(|(r, a)| share * power(&whiten(&averaged(r, POINTS), a)).max(f64::MIN_POSITIVE).ln())
            .sum();
        -0.5 * (fit + k as f64 * (share * channels).ln())
    }
}

/// Probabilities from log evidences.
pub fn probabilities(evidence: &[f64]) -> Vec<f64> {
    let most = evidence.iter().fold(f64::NEG_INFINITY, |m, e| m.max(*e));
    let raw: Vec<f64> = evidence.iter().map(|e| (e - most).exp()).collect();
    let sum: f64 = raw.iter().sum();
    raw.iter().map(|p| p / sum).collect()
}

//! Log evidence of hypotheses from residuals.
//!
//! Residuals of a repaired model are not white: sensors have coloured noise, and no law of the library is exact. Three measures
//! keep a long record from turning a small difference into certainty.
//!
//! - Residuals are averaged to [`LIKELIHOOD_POINTS`] points a channel, because mechanisms act on the scale of the motion.
//! - They are whitened by the autoregressive noise of the best hypothesis, so that slow noise supports no slow effect. Its
//!   largest root is [`MAX_NOISE_ROOT`], because an effect may be slow as well.
//! - A channel counts as N₁ = [`EFFECTIVE_SAMPLES`] samples. C channels see one motion, and count as N = √C N₁ together.
//!
//! A hypothesis with k parameters and mean squares E_c of its whitened residuals has the log evidence
//!
//! -½ Σ_c N_c ln E_c - ½ k ln N,  N_c = N / C
//!
//! (Schwarz 1978, Ann. Stat. 6, 461-464, for unknown noise levels).

use crate::fit::job::ChannelResiduals;
use crate::prior::{EFFECTIVE_SAMPLES, LIKELIHOOD_NOISE_ORDER, LIKELIHOOD_POINTS, MAX_NOISE_ROOT};
use crate::series::{averaged, power};
use hysteron_identify::autoregressive::{burg, whiten};

/// Autoregressive noise of each channel.
pub(crate) struct NoiseModel(Vec<Vec<f64>>);

impl NoiseModel {
    /// Noise in the residuals of the best hypothesis.
    pub(crate) fn of(best: &ChannelResiduals) -> Self {
        let coefficients = |r: &Vec<f64>| -> Vec<f64> {
            let a = burg(&averaged(r, LIKELIHOOD_POINTS), LIKELIHOOD_NOISE_ORDER);
            // Scales all roots.
            a.iter().zip(1..).map(|(a, k)| a * MAX_NOISE_ROOT.powi(k)).collect()
        };
        Self(best.iter().map(coefficients).collect())
    }

    /// Log evidence of a hypothesis with `k` parameters, nats.
    pub(crate) fn log_evidence(&self, residuals: &ChannelResiduals, k: usize) -> f64 {
        let channels = residuals.len().max(1) as f64;
        let samples_per_channel = EFFECTIVE_SAMPLES / channels.sqrt();
        let whitened_power =
            |r: &Vec<f64>, a: &Vec<f64>| power(&whiten(&averaged(r, LIKELIHOOD_POINTS), a)).max(f64::MIN_POSITIVE);
        let misfit: f64 =
            residuals.iter().zip(&self.0).map(|(r, a)| samples_per_channel * whitened_power(r, a).ln()).sum();
        -0.5 * (misfit + k as f64 * (samples_per_channel * channels).ln())
    }
}

/// Probabilities exp(Lᵢ) / Σ exp(Lⱼ) from log evidences L.
pub(crate) fn normalised_probabilities(log_evidence: &[f64]) -> Vec<f64> {
    let most = log_evidence.iter().fold(f64::NEG_INFINITY, |m, e| m.max(*e));
    let ratios: Vec<f64> = log_evidence.iter().map(|e| (e - most).exp()).collect();
    let sum: f64 = ratios.iter().sum();
    ratios.iter().map(|p| p / sum).collect()
}

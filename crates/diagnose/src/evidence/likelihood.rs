//! Log evidence of hypotheses from residuals.
//!
//! Residuals of a repaired model are not white: sensors have coloured noise, and no law of the library is exact. Three measures
//! keep a long record from turning a small difference into certainty.
//!
//! - Residuals are averaged to [`LIKELIHOOD_POINTS`] points a channel, because mechanisms act on the scale of the motion. More
//!   samples of the same record change nothing.
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
use crate::series::{power, resampled};
use hysteron_identify::autoregressive::{burg, whiten};

/// Autoregressive noise of each channel.
pub(crate) struct NoiseModel(Vec<Vec<f64>>);

impl NoiseModel {
    /// Noise in the residuals of the best hypothesis.
    pub(crate) fn of(best: &ChannelResiduals) -> Self {
        let coefficients = |r: &Vec<f64>| -> Vec<f64> {
            let points = resampled(r, LIKELIHOOD_POINTS);
            // Scales all roots. Of fewer points each stands for a longer part of the record.
            let root = MAX_NOISE_ROOT.powf(LIKELIHOOD_POINTS as f64 / points.len().max(1) as f64);
            burg(&points, LIKELIHOOD_NOISE_ORDER).iter().zip(1..).map(|(a, k)| a * root.powi(k)).collect()
        };
        Self(best.iter().map(coefficients).collect())
    }

    /// Log evidence of a hypothesis with `k` parameters, nats.
    pub(crate) fn log_evidence(&self, residuals: &ChannelResiduals, k: usize) -> f64 {
        let channels = residuals.len().max(1) as f64;
        let samples_per_channel = EFFECTIVE_SAMPLES / channels.sqrt();
        let whitened_power =
            |r: &Vec<f64>, a: &Vec<f64>| power(&whiten(&resampled(r, LIKELIHOOD_POINTS), a)).max(f64::MIN_POSITIVE);
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

#[cfg(test)]
mod tests {
    use super::NoiseModel;

    /// Two hypotheses are as far apart whether their residuals have hundreds of samples or thousands.
    #[test]
    fn evidence_is_the_same_from_any_sampling() {
        let gain = |n: usize| {
            let at = |i: usize| 40.0 * (i as f64 + 0.5) / n as f64;
            let noise = |t: f64| 0.3 * (11.0 * t).sin() + 0.2 * (17.3 * t).cos();
            let series = |effect: f64| -> Vec<f64> {
                (0..n).map(at).map(|t| noise(t) + effect * (1.3 * t).sin().powi(3)).collect()
            };
            let (best, other) = (vec![series(0.0)], vec![series(0.5)]);
            let model = NoiseModel::of(&best);
            model.log_evidence(&best, 3) - model.log_evidence(&other, 3)
        };
        let all: Vec<f64> = [401, 600, 1000, 4000].into_iter().map(gain).collect();
        let (low, high) = all.iter().fold((f64::MAX, f64::MIN), |(a, b), x| (a.min(*x), b.max(*x)));
        assert!(low > 1.0 && high - low < 0.1 * high, "{all:?}");
    }
}

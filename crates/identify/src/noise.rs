//! Noise of the recordings, estimated without the residual of a model.
//!
//! What a fit leaves contains the physics that the model lacks, so that it says nothing about the noise. The recordings do,
//! by what does not repeat, by their stretches at rest, and by what their own past does not predict.

use crate::autoregressive::{burg, whiten};
use crate::study::{Run, Study};
use serde::Serialize;

/// Evidence from which the noise of a channel was estimated, the best first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum NoiseEvidence {
    /// Another run with the same input: half of the variance of their difference.
    RepeatedRuns,
    /// The next cycle of the same run: half of the variance of their difference.
    RepeatedCycles,
    /// Stretches in which the motion is at rest.
    Rest,
    /// Innovations of a long autoregression. Noise slower than the samples is not in them: a lower limit.
    Innovations,
}

/// Noise of a channel.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct RecordedNoise {
    /// Variance of the noise over that of the channel.
    pub nmse: f64,
    /// Its evidence.
    pub evidence: NoiseEvidence,
}

/// Order of the autoregression.
const ORDER: usize = 40;
/// Fewest samples of a channel.
const MIN_SAMPLES: usize = 60;
/// Fewest samples of a cycle.
const MIN_CYCLE: usize = 16;
/// Correlation of neighbouring cycles from which they are repetitions of one motion.
const MIN_REPETITION: f64 = 0.98;
/// Relative difference of the deviations of cycles of one amplitude, at most: cycles that grow repeat nothing.
const SAME_AMPLITUDE: f64 = 0.02;
/// Points of a series at which its period is sought, at most.
const MAX_POINTS: usize = 4000;
/// Number of stretches of a record, and their share that must be at rest.
const STRETCHES: usize = 40;
const MIN_REST: usize = 3;
/// Variance of the simulated channel in a stretch at rest, over that of the whole.
const MAX_REST_MOTION: f64 = 1e-5;

/// Noise of each channel of a run, by the best evidence that there is; none where the channel is too short.
///
/// `simulated` are the channels of any model of the run. They tell only where the motion is at rest.
pub fn recorded_noise(study: &Study, run: usize, simulated: &[Vec<f64>]) -> Vec<Option<RecordedNoise>> {
    let of = &study.runs[run];
    let channel = |(c, o): (usize, &crate::study::ObservedChannel)| {
        let finite: Vec<usize> =
            (0..o.values.len()).filter(|i| o.values[*i].is_finite() && simulated[c][*i].is_finite()).collect();
        let values: Vec<f64> = finite.iter().map(|i| o.values[*i]).collect();
        let model: Vec<f64> = finite.iter().map(|i| simulated[c][*i]).collect();
        if values.len() < MIN_SAMPLES || o.variance <= 0.0 {
            return None;
        }
        let found = [
            (NoiseEvidence::RepeatedRuns, repeated_runs(study, of, &o.channel)),
            (NoiseEvidence::RepeatedCycles, repeated_cycles(&values)),
            (NoiseEvidence::Rest, at_rest(&values, &model)),
            (NoiseEvidence::Innovations, innovation_variance(&values)),
        ];
        // Innovations are a lower limit of all others.
        let least = innovation_variance(&values)?;
        let (evidence, variance) = found.into_iter().find_map(|(e, v)| Some((e, v?)))?;
        Some(RecordedNoise { nmse: variance.max(least) / o.variance, evidence })
    };
    of.observe.iter().enumerate().map(channel).collect()
}

/// Half of the least mean squared difference from a run with the same input.
fn repeated_runs(study: &Study, run: &Run, channel: &str) -> Option<f64> {
    let same_input = |r: &&Run| r.name != run.name && r.set == run.set && r.recording.times == run.recording.times;
    let values = |r: &Run| r.observe.iter().find(|o| o.channel == channel).map(|o| o.values.clone());
    let own = values(run)?;
    let halves = study.runs.iter().filter(same_input).filter_map(|r| half_difference(&own, &values(r)?));
    halves.min_by(f64::total_cmp)
}

/// Half of the mean squared difference of two series.
fn half_difference(a: &[f64], b: &[f64]) -> Option<f64> {
    let squares: Vec<f64> = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).filter(|x| x.is_finite()).collect();
    (!squares.is_empty()).then(|| 0.5 * squares.iter().sum::<f64>() / squares.len() as f64)
}

/// Half of the mean squared difference of the two neighbouring cycles that are most alike. The first cycles of rubber differ
/// from the next for physical reasons, so that the mean over all pairs is no noise.
fn repeated_cycles(x: &[f64]) -> Option<f64> {
    let period = period(x)?;
    let pairs = (0..x.len() / period).filter_map(|k| {
        let (a, b) = (x.get(k * period..(k + 1) * period)?, x.get((k + 1) * period..(k + 2) * period)?);
        let is_repeated = (deviation(a) / deviation(b) - 1.0).abs() <= SAME_AMPLITUDE;
        is_repeated.then(|| half_difference(a, b)).flatten()
    });
    pairs.min_by(f64::total_cmp)
}

/// Standard deviation.
fn deviation(x: &[f64]) -> f64 {
    let mean = x.iter().sum::<f64>() / x.len() as f64;
    (x.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / x.len() as f64).sqrt()
}

/// Period in samples at which a series repeats; none if it does not.
fn period(x: &[f64]) -> Option<usize> {
    let stride = x.len().div_ceil(MAX_POINTS);
    let thinned: Vec<f64> = x.iter().copied().step_by(stride).collect();
    let r: Vec<f64> = (0..=thinned.len() / 2).map(|lag| correlation(&thinned, lag)).collect();
    // Beyond the first fall of the correlation.
    let fallen = r.iter().position(|r| *r < 0.0)?;
    let is_peak = |i: &usize| *i + 1 < r.len() && r[*i] >= r[*i - 1] && r[*i] >= r[*i + 1];
    let found = (fallen.max(MIN_CYCLE)..r.len()).filter(is_peak).find(|i| r[*i] >= MIN_REPETITION)?;
    let near = (found - 1) * stride + 1..(found + 1) * stride;
    near.max_by(|a, b| correlation(x, *a).total_cmp(&correlation(x, *b)))
}

/// Correlation of a series with itself at a lag, about its mean.
fn correlation(x: &[f64], lag: usize) -> f64 {
    let mean = x.iter().sum::<f64>() / x.len() as f64;
    let (mut product, mut first, mut second) = (0.0, 0.0, 0.0);
    for (a, b) in x.iter().zip(x.get(lag..).unwrap_or_default()) {
        product += (a - mean) * (b - mean);
        first += (a - mean) * (a - mean);
        second += (b - mean) * (b - mean);
    }
    product / (first * second).sqrt()
}

/// Mean variance about their own lines of the stretches in which the model does not move.
fn at_rest(values: &[f64], model: &[f64]) -> Option<f64> {
    let length = (values.len() / STRETCHES).max(8);
    let total = variance_about_line(model);
    let still: Vec<f64> = values
        .chunks_exact(length)
        .zip(model.chunks_exact(length))
        .filter(|(_, y)| variance_about_line(y) <= MAX_REST_MOTION * total)
        .map(|(v, _)| variance_about_line(v))
        .collect();
    (still.len() >= MIN_REST).then(|| still.iter().sum::<f64>() / still.len() as f64)
}

/// Variance about the least-squares line over the index.
fn variance_about_line(x: &[f64]) -> f64 {
    let n = x.len() as f64;
    let (middle, mean) = (0.5 * (n - 1.0), x.iter().sum::<f64>() / n);
    let along = |i: usize| i as f64 - middle;
    let square: f64 = (0..x.len()).map(|i| along(i) * along(i)).sum();
    let slope = x.iter().enumerate().map(|(i, x)| along(i) * (x - mean)).sum::<f64>() / square.max(f64::MIN_POSITIVE);
    let squares: f64 = x.iter().enumerate().map(|(i, x)| (x - mean - slope * along(i)).powi(2)).sum();
    squares / (n - 2.0).max(1.0)
}

/// Variance of what the past of a series does not predict, by a long autoregression; `None` for a series that is too short.
pub fn innovation_variance(x: &[f64]) -> Option<f64> {
    let mean = x.iter().sum::<f64>() / x.len() as f64;
    let centred: Vec<f64> = x.iter().map(|x| x - mean).collect();
    let coefficients = burg(&centred, ORDER);
    let left = whiten(&centred, &coefficients);
    let free = (x.len() - coefficients.len()) as f64 - coefficients.len() as f64;
    (free > 0.0).then(|| left.iter().map(|e| e * e).sum::<f64>() / free)
}

#[cfg(test)]
mod tests {
    use super::{at_rest, innovation_variance, repeated_cycles};
    use rand::{RngExt as _, SeedableRng as _};
    use rand_pcg::Pcg32;

    /// A signal of 50 samples a second with white noise of a standard deviation.
    fn noisy(signal: impl Fn(f64) -> f64, deviation: f64) -> Vec<f64> {
        let mut rng = Pcg32::seed_from_u64(3);
        let mut normal = || (0..12).map(|_| rng.random::<f64>()).sum::<f64>() - 6.0;
        (0..1500).map(|i| signal(0.02 * f64::from(i)) + deviation * normal()).collect()
    }

    /// Ratio of an estimate to the variance of the noise.
    fn ratio(estimate: Option<f64>, deviation: f64) -> f64 {
        estimate.expect("an estimate") / (deviation * deviation)
    }

    #[test]
    fn noise_is_found_whatever_its_size() {
        let sine = |t: f64| (1.7 * t).sin() + 0.3 * (5.1 * t).sin();
        let growing = |t: f64| 0.05 * t * (1.7 * t).sin();
        for deviation in [0.003, 0.03] {
            assert!((0.7..1.5).contains(&ratio(innovation_variance(&noisy(sine, deviation)), deviation)));
            assert!((0.7..1.5).contains(&ratio(innovation_variance(&noisy(growing, deviation)), deviation)));
        }
    }

    #[test]
    fn cycles_repeat_where_the_motion_does() {
        // A cycle of 200 samples.
        let cycle = |t: f64| (std::f64::consts::PI * 0.5 * t).sin();
        let found = ratio(repeated_cycles(&noisy(cycle, 0.03)), 0.03);
        assert!((0.6..1.4).contains(&found), "{found}");
        assert!(repeated_cycles(&noisy(|t| (1.7 * t).sin() * (0.31 * t).sin(), 0.03)).is_none());
    }

    #[test]
    fn stretches_at_rest_show_slow_noise_as_well() {
        let motion = |t: f64| if t < 10.0 { (3.0 * t).sin() } else { 0.0 };
        let model = noisy(motion, 0.0);
        let found = ratio(at_rest(&noisy(motion, 0.03), &model), 0.03);
        assert!((0.7..1.4).contains(&found), "{found}");
        let moving = |t: f64| (3.0 * t).sin();
        assert_eq!(at_rest(&noisy(moving, 0.03), &noisy(moving, 0.0)), None);
    }
}

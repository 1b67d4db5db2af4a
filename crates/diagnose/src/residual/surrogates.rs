//! Tests of a residual against steady noise of its spectrum.
//!
//! Sensor noise is steady, white or coloured, and independent of the motion. A missing effect follows the motion or acts at
//! some times only. Surrogates show how much of that steady noise does by chance. They have the amplitudes of the residual's
//! Fourier transform and random phases (Theiler et al. 1992, Physica D 58, 77-94).

use super::recurrence::StrokeCells;
use super::regression::Regression;
use crate::prior::{
    MIN_STEADINESS_SAMPLES, QUIETEST_DIVISOR, STEADINESS_STRETCHES, SURROGATE_Z, SURROGATES, TAPER_DIVISOR,
};
use crate::series::power;
use hysteron_identify::fourier::{Complex, Fft, forward, inverse};
use rand::{RngExt as _, SeedableRng as _};
use rand_pcg::Pcg32;
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// Excess of a measure of a residual over its mean for surrogates, largest over the measures.
///
/// A measure has an excess if it exceeds all surrogates and their mean by [`SURROGATE_Z`] standard deviations; else 0.
fn excess_over_surrogates<M: Fn(&[f64]) -> f64>(x: &[f64], measures: &[M]) -> f64 {
    let n = x.len();
    if n == 0 || measures.is_empty() || power(x) <= 0.0 {
        return 0.0;
    }
    let mean = x.iter().sum::<f64>() / n as f64;
    // A short taper keeps the step between both ends out of the spectrum.
    let taper_length = (n / TAPER_DIVISOR).max(1) as f64;
    let taper = |t: usize| {
        let from_end = (t.min(n - 1 - t) as f64 + 0.5) / taper_length;
        if from_end < 1.0 { 0.5 - 0.5 * (PI * from_end).cos() } else { 1.0 }
    };
    let x: Vec<f64> = x.iter().enumerate().map(|(t, v)| (v - mean) * taper(t)).collect();
    let mut surrogates = Surrogates::of(&x);
    let mut by_chance: Vec<Vec<f64>> = vec![vec![]; measures.len()];
    for _ in 0..SURROGATES {
        let mut y = surrogates.draw();
        // The residual is tapered as well.
        y.iter_mut().enumerate().for_each(|(t, v)| *v *= taper(t));
        by_chance.iter_mut().zip(measures).for_each(|(all, measure)| all.push(measure(&y)));
    }
    let excess = |(measure, all): (&M, &Vec<f64>)| {
        let value = measure(&x);
        let mean = all.iter().sum::<f64>() / all.len() as f64;
        let deviation = power(&all.iter().map(|s| s - mean).collect::<Vec<f64>>()).sqrt();
        let most = all.iter().fold(0.0, |m: f64, s| m.max(*s));
        if value > most && value - mean > SURROGATE_Z * deviation { value - mean } else { 0.0 }
    };
    measures.iter().zip(&by_chance).map(excess).fold(0.0, f64::max)
}

/// Lengths of the stretches in which steadiness is measured.
fn stretch_lengths(samples: usize) -> impl Iterator<Item = usize> {
    STEADINESS_STRETCHES.iter().map(move |s| samples / s).filter(|length| *length >= MIN_STEADINESS_SAMPLES)
}

/// Share of a residual's power that stands above the mean in stretches of the record, beyond that of steady noise.
pub(crate) fn unsteady_share(x: &[f64]) -> f64 {
    let measures: Vec<_> =
        stretch_lengths(x.len()).map(|length| move |x: &[f64]| share_above_mean(x, length)).collect();
    excess_over_surrogates(x, &measures)
}

/// Share of a residual's power that regressors predict by cross-validation over blocks, beyond that of steady noise.
pub(crate) fn follows_motion(x: &[f64], columns: Vec<Vec<f64>>, blocks: usize) -> f64 {
    let Some(regression) = Regression::new(columns, blocks) else { return 0.0 };
    excess_over_surrogates(x, &[|x: &[f64]| regression.explained_share(x)])
}

/// Share of a residual's power that recurs at equal deformation, beyond that of steady noise.
pub(crate) fn recurs_along(x: &[f64], strokes: &[StrokeCells], measure: fn(&StrokeCells, &[f64]) -> f64) -> f64 {
    excess_over_surrogates(x, &strokes.iter().map(|s| move |x: &[f64]| measure(s, x)).collect::<Vec<_>>())
}

/// Share of a residual's power that its quietest stretches lack, beyond that of steady noise.
///
/// An event leaves silence before and after it, even where it hardly stands out while it lasts.
pub(crate) fn silent_share(x: &[f64]) -> f64 {
    let measures: Vec<_> =
        stretch_lengths(x.len()).map(|length| move |x: &[f64]| log_power_over_quietest(x, length)).collect();
    1.0 - (-excess_over_surrogates(x, &measures)).exp()
}

/// Logarithm of the mean power of all stretches over that of the quietest quarter.
fn log_power_over_quietest(x: &[f64], length: usize) -> f64 {
    let mut powers: Vec<f64> = x.chunks_exact(length).map(power).collect();
    powers.sort_by(f64::total_cmp);
    let mean = |p: &[f64]| (p.iter().sum::<f64>() / p.len().max(1) as f64).max(f64::MIN_POSITIVE);
    (mean(&powers) / mean(&powers[..powers.len().div_ceil(QUIETEST_DIVISOR)])).ln()
}

/// Share of the power above the mean of all stretches.
fn share_above_mean(x: &[f64], length: usize) -> f64 {
    let powers: Vec<f64> = x.chunks_exact(length).map(power).collect();
    let total: f64 = powers.iter().sum();
    let mean = total / powers.len() as f64;
    if total > 0.0 { powers.iter().map(|p| (p - mean).max(0.0)).sum::<f64>() / total } else { 0.0 }
}

/// Generator of series with the spectrum of a given one.
pub(crate) struct Surrogates {
    amplitudes: Vec<f64>,
    inverse: Arc<dyn Fft<f64>>,
    random: Pcg32,
}

impl Surrogates {
    /// Surrogates of a series.
    pub(crate) fn of(x: &[f64]) -> Self {
        Self::with_seed(x, 0)
    }

    /// Surrogates with phases of their own for each seed.
    pub(crate) fn with_seed(x: &[f64], seed: u64) -> Self {
        let mut buffer: Vec<Complex<f64>> = x.iter().map(|x| Complex { re: *x, im: 0.0 }).collect();
        forward(x.len()).process(&mut buffer);
        // Seeded by the length, so that a diagnosis repeats to the bit.
        Self {
            amplitudes: buffer.iter().map(|c| c.norm() / x.len() as f64).collect(),
            inverse: inverse(x.len()),
            random: Pcg32::seed_from_u64(x.len() as u64 + (seed << 32)),
        }
    }

    /// The next series, as long as the given one.
    pub(crate) fn draw(&mut self) -> Vec<f64> {
        let n = self.amplitudes.len();
        let mut buffer = vec![Complex { re: 0.0, im: 0.0 }; n];
        for k in 1..n.div_ceil(2) {
            let z = Complex::from_polar(self.amplitudes[k], TAU * self.random.random::<f64>());
            buffer[k] = z;
            buffer[n - k] = z.conj();
        }
        self.inverse.process(&mut buffer);
        buffer.iter().map(|c| c.re).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::{follows_motion, silent_share, unsteady_share};
    use crate::test_support::white_noise;

    #[test]
    fn steady_noise_of_any_colour_is_steady() {
        for seed in 1..40 {
            let white = white_noise(seed, 1200);
            let mut slow = white.clone();
            (1..slow.len()).for_each(|t| slow[t] += 0.97 * slow[t - 1]);
            let hum: Vec<f64> = white.iter().enumerate().map(|(t, x)| x + 2.0 * (0.3 * t as f64).sin()).collect();
            for x in [&white, &slow, &hum] {
                assert!(unsteady_share(x) < 0.02, "{seed} {}", unsteady_share(x));
                assert!(silent_share(x) < 0.02, "{seed} {}", silent_share(x));
            }
        }
    }

    #[test]
    fn ringing_and_growing_noise_are_unsteady() {
        let quiet = white_noise(3, 1500);
        let rung = |t: usize| if t > 600 { (0.4 * t as f64).sin() * (-0.01 * (t - 600) as f64).exp() } else { 0.0 };
        let struck: Vec<f64> = quiet.iter().enumerate().map(|(t, x)| x + 8.0 * rung(t)).collect();
        assert!(unsteady_share(&struck) > 0.2, "{}", unsteady_share(&struck));
        let grows: Vec<f64> = quiet.iter().enumerate().map(|(t, x)| x * (1.0 + 3.0 * t as f64 / 1500.0)).collect();
        assert!(unsteady_share(&grows) > 0.08, "{}", unsteady_share(&grows));
    }

    #[test]
    fn silence_before_and_after_an_event_is_found() {
        // Narrow-band noise has strong stretches by chance, but no silence.
        let quiet = white_noise(4, 260);
        let starts = [60usize, 110, 150];
        let rung = |t: usize| {
            let since = starts.iter().filter(|s| **s <= t).map(|s| (t - s) as f64);
            since.map(|u| (0.55 * u).sin() * (-0.05 * u).exp()).sum::<f64>()
        };
        let struck: Vec<f64> = quiet.iter().enumerate().map(|(t, x)| 0.03 * x + rung(t)).collect();
        assert!(silent_share(&struck) > 0.3, "{}", silent_share(&struck));
    }

    #[test]
    fn slow_noise_does_not_follow_a_slow_motion() {
        // Several tones with random phases are another motion; a single tone would only be delayed.
        let at = |t: f64| (0.02 * t).sin() + 0.7 * (0.0347 * t + 1.0).sin() + 0.5 * (0.0533 * t + 2.0).sin();
        let motion: Vec<f64> = (0..1200).map(|t| at(f64::from(t))).collect();
        let columns: Vec<Vec<f64>> = (1..6).map(|k| motion.iter().map(|e| e.powi(k)).collect()).collect();
        for seed in 1..20 {
            let mut slow = white_noise(seed, 1200);
            (1..slow.len()).for_each(|t| slow[t] += 0.97 * slow[t - 1]);
            assert!(follows_motion(&slow, columns.clone(), 6) < 0.02);
            let cubic: Vec<f64> = slow.iter().zip(&motion).map(|(x, e)| 0.2 * x + 6.0 * (e * e - 0.3) * e).collect();
            assert!(
                follows_motion(&cubic, columns.clone(), 6) > 0.3,
                "{seed} {}",
                follows_motion(&cubic, columns.clone(), 6)
            );
        }
    }
}

//! Whether a residual is what a steady noise of its spectrum would be.
//!
//! What a sensor adds is steady, white or coloured, and knows nothing of the motion. What a model lacks follows the motion, or
//! comes and goes with a machine or a blow that the model knows nothing of. How much a steady noise does so by chance
//! follows from its spectrum, and is seen on surrogates: series with the amplitudes of the residual's Fourier transform and
//! phases drawn at random (Theiler, Eubank, Longtin, Galdrikian and Farmer, Physica D 58 (1992)).

use crate::residual::noise::power;
use crate::residual::recurrence::Stroke;
use crate::residual::regression::Regression;
use rand::{RngExt as _, SeedableRng as _};
use rand_pcg::Pcg32;
use rustfft::num_complex::Complex;
use rustfft::{Fft, FftPlanner};
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// Stretches that a record is cut into, coarse and fine.
const STRETCHES: [usize; 4] = [6, 12, 24, 48];
/// Points that a stretch must have.
const SHORTEST: usize = 8;
/// Surrogates: a residual that none of them comes near to is no steady noise.
const SURROGATES: usize = 99;
/// Deviations of the surrogates that it must be above their mean.
const FAR: f64 = 5.0;

/// How far a measure of a residual is above what steady noise of its spectrum has, by the one of some measures that is farthest;
/// 0 where it may be such noise.
fn beyond_chance<M: Fn(&[f64]) -> f64>(x: &[f64], measures: &[M]) -> f64 {
    let n = x.len();
    if n == 0 || measures.is_empty() || power(x) <= 0.0 {
        return 0.0;
    }
    let mean = x.iter().sum::<f64>() / n as f64;
    // The ends do not meet: a short taper keeps the step between them out of the spectrum.
    let rim = (n / 20).max(1) as f64;
    let taper = |t: usize| {
        let near = (t.min(n - 1 - t) as f64 + 0.5) / rim;
        if near < 1.0 { 0.5 - 0.5 * (PI * near).cos() } else { 1.0 }
    };
    let x: Vec<f64> = x.iter().enumerate().map(|(t, v)| (v - mean) * taper(t)).collect();
    let mut maker = Surrogates::of(&x);
    let mut by_chance: Vec<Vec<f64>> = vec![vec![]; measures.len()];
    for _ in 0..SURROGATES {
        let mut y = maker.draw();
        // The taper belongs to both.
        y.iter_mut().enumerate().for_each(|(t, v)| *v *= taper(t));
        by_chance.iter_mut().zip(measures).for_each(|(all, measure)| all.push(measure(&y)));
    }
    let beyond = |(measure, all): (&M, &Vec<f64>)| {
        let seen = measure(&x);
        let mean = all.iter().sum::<f64>() / all.len() as f64;
        let deviation = power(&all.iter().map(|s| s - mean).collect::<Vec<f64>>()).sqrt();
        let most = all.iter().fold(0.0, |m: f64, s| m.max(*s));
        if seen > most && seen - mean > FAR * deviation { seen - mean } else { 0.0 }
    };
    measures.iter().zip(&by_chance).map(beyond).fold(0.0, f64::max)
}

/// Part of the power of a residual that stands above its mean in stretches of the record, beyond what a steady noise of its
/// spectrum has there.
pub(crate) fn unsteady(x: &[f64]) -> f64 {
    let cuts = STRETCHES.iter().map(|s| x.len() / s).filter(|length| *length >= SHORTEST);
    let measures: Vec<_> = cuts.map(|length| move |x: &[f64]| standing_out(x, length)).collect();
    beyond_chance(x, &measures)
}

/// Part of the power of a residual that regressors tell on times that they were not fitted to, beyond what they tell of a
/// steady noise of its spectrum.
pub(crate) fn follows(x: &[f64], columns: Vec<Vec<f64>>, blocks: usize) -> f64 {
    let Some(regression) = Regression::new(columns, blocks) else { return 0.0 };
    beyond_chance(x, &[|x: &[f64]| regression.explained(x)])
}

/// Part of the power of a residual that comes again where devices are deformed as much, in a measure of their strokes, beyond what
/// of a steady noise of its spectrum does.
pub(crate) fn comes_again(x: &[f64], strokes: &[Stroke], measure: fn(&Stroke, &[f64]) -> f64) -> f64 {
    beyond_chance(x, &strokes.iter().map(|s| move |x: &[f64]| measure(s, x)).collect::<Vec<_>>())
}

/// Part of the power of a residual that its quietest stretches do not have, beyond what those of a steady noise of its spectrum lack:
/// something that starts and ends leaves silence before and after it, however little it stands out while it lasts.
pub(crate) fn silent(x: &[f64]) -> f64 {
    let cuts = STRETCHES.iter().map(|s| x.len() / s).filter(|length| *length >= SHORTEST);
    let measures: Vec<_> = cuts.map(|length| move |x: &[f64]| silence(x, length)).collect();
    1.0 - (-beyond_chance(x, &measures)).exp()
}

/// Logarithm of the power of all stretches over that of the quietest quarter of them.
fn silence(x: &[f64], length: usize) -> f64 {
    let mut powers: Vec<f64> = x.chunks_exact(length).map(power).collect();
    powers.sort_by(f64::total_cmp);
    let mean = |p: &[f64]| (p.iter().sum::<f64>() / p.len().max(1) as f64).max(f64::MIN_POSITIVE);
    (mean(&powers) / mean(&powers[..powers.len().div_ceil(4)])).ln()
}

/// Part of the power that stands above the mean of all stretches.
fn standing_out(x: &[f64], length: usize) -> f64 {
    let powers: Vec<f64> = x.chunks_exact(length).map(power).collect();
    let total: f64 = powers.iter().sum();
    let mean = total / powers.len() as f64;
    if total > 0.0 { powers.iter().map(|p| (p - mean).max(0.0)).sum::<f64>() / total } else { 0.0 }
}

/// Makes series with the spectrum of another one.
pub(crate) struct Surrogates {
    amplitudes: Vec<f64>,
    back: Arc<dyn Fft<f64>>,
    random: Pcg32,
}

impl Surrogates {
    /// Of one.
    pub(crate) fn of(x: &[f64]) -> Self {
        Self::seeded(x, 0)
    }

    /// Of one, with phases that others do not have.
    pub(crate) fn seeded(x: &[f64], seed: u64) -> Self {
        let mut planner = FftPlanner::new();
        let mut buffer: Vec<Complex<f64>> = x.iter().map(|x| Complex { re: *x, im: 0.0 }).collect();
        planner.plan_fft_forward(x.len()).process(&mut buffer);
        // The same noise for the same data.
        Self {
            amplitudes: buffer.iter().map(|c| c.norm() / x.len() as f64).collect(),
            back: planner.plan_fft_inverse(x.len()),
            random: Pcg32::seed_from_u64(x.len() as u64 + (seed << 32)),
        }
    }

    /// Another one.
    pub(crate) fn draw(&mut self) -> Vec<f64> {
        let n = self.amplitudes.len();
        let mut buffer = vec![Complex { re: 0.0, im: 0.0 }; n];
        for k in 1..n.div_ceil(2) {
            let z = Complex::from_polar(self.amplitudes[k], TAU * self.random.random::<f64>());
            buffer[k] = z;
            buffer[n - k] = z.conj();
        }
        self.back.process(&mut buffer);
        buffer.iter().map(|c| c.re).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::{follows, silent, unsteady};
    use crate::residual::noise::tests::noise;

    #[test]
    fn steady_noise_of_any_colour_is_steady() {
        for seed in 1..40 {
            let white = noise(seed, 1200);
            let mut slow = white.clone();
            (1..slow.len()).for_each(|t| slow[t] += 0.97 * slow[t - 1]);
            let hum: Vec<f64> = white.iter().enumerate().map(|(t, x)| x + 2.0 * (0.3 * t as f64).sin()).collect();
            for x in [&white, &slow, &hum] {
                assert!(unsteady(x) < 0.02, "{seed} {}", unsteady(x));
                assert!(silent(x) < 0.02, "{seed} {}", silent(x));
            }
        }
    }

    #[test]
    fn what_comes_and_goes_is_not() {
        let quiet = noise(3, 1500);
        let rung = |t: usize| if t > 600 { (0.4 * t as f64).sin() * (-0.01 * (t - 600) as f64).exp() } else { 0.0 };
        let struck: Vec<f64> = quiet.iter().enumerate().map(|(t, x)| x + 8.0 * rung(t)).collect();
        assert!(unsteady(&struck) > 0.2, "{}", unsteady(&struck));
        let grows: Vec<f64> = quiet.iter().enumerate().map(|(t, x)| x * (1.0 + 3.0 * t as f64 / 1500.0)).collect();
        assert!(unsteady(&grows) > 0.08, "{}", unsteady(&grows));
    }

    #[test]
    fn silence_before_and_after_is_seen() {
        // A narrow band has stretches that stand out by chance as well; what it does not have is silence.
        let quiet = noise(4, 260);
        let starts = [60usize, 110, 150];
        let rung = |t: usize| {
            let since = starts.iter().filter(|s| **s <= t).map(|s| (t - s) as f64);
            since.map(|u| (0.55 * u).sin() * (-0.05 * u).exp()).sum::<f64>()
        };
        let struck: Vec<f64> = quiet.iter().enumerate().map(|(t, x)| 0.03 * x + rung(t)).collect();
        assert!(silent(&struck) > 0.3, "{}", silent(&struck));
    }

    #[test]
    fn slow_noise_does_not_follow_a_slow_motion() {
        // Of several cycles a phase at random is another motion; of a single sine it would be the same one later.
        let at = |t: f64| (0.02 * t).sin() + 0.7 * (0.0347 * t + 1.0).sin() + 0.5 * (0.0533 * t + 2.0).sin();
        let motion: Vec<f64> = (0..1200).map(|t| at(f64::from(t))).collect();
        let columns: Vec<Vec<f64>> = (1..6).map(|k| motion.iter().map(|e| e.powi(k)).collect()).collect();
        for seed in 1..20 {
            let mut slow = noise(seed, 1200);
            (1..slow.len()).for_each(|t| slow[t] += 0.97 * slow[t - 1]);
            assert!(follows(&slow, columns.clone(), 6) < 0.02);
            let cubic: Vec<f64> = slow.iter().zip(&motion).map(|(x, e)| 0.2 * x + 6.0 * (e * e - 0.3) * e).collect();
            assert!(follows(&cubic, columns.clone(), 6) > 0.3, "{seed} {}", follows(&cubic, columns.clone(), 6));
        }
    }
}

//! Whether a drift of a channel is more than slow noise does by chance.
//!
//! Slow noise wanders, and a zero that may wander as well follows it: of every recording with such noise a line, a jump or some
//! knots take much. A drift is believed where it takes much more of the residual than of noise of the same
//! spectrum with phases at random, or where the zero is further off than the mean of such noise.

use crate::candidate::sensor_fault::Correction;
use crate::fit::scheduler::Explained;
use crate::hypothesis::KNOTS;
use crate::residual::noise::{averaged, power};
use crate::residual::surrogates::Surrogates;
use hysteron_identify::study::{Role, Study};
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;

/// Points that a residual is averaged to.
const POINTS: usize = 512;
/// Places at which a jump is looked for.
const PLACES: usize = 40;
/// Surrogates.
const SURROGATES: usize = 99;
/// Deviations of the surrogates that it must be above their mean: a drift is sought in every channel and run.
const FAR: f64 = 4.0;
/// Lowest frequencies whose power says how far the mean of slow noise is from zero, and deviations of it that are too many.
const LOWEST: usize = 6;
const OFF: f64 = 5.0;

/// Whether the drift in an explanation may be noise; not where it has none.
pub(crate) fn may_be_noise(study: &Study, e: &Explained) -> bool {
    let corrections = e.variant.corrections(&e.fitted.values);
    let drifting: Vec<&Correction> = corrections.iter().filter(|c| !c.drift.is_empty()).collect();
    let runs = study.runs.iter().filter(|r| r.role == Role::Fit);
    // The channel and run that it moves most.
    let mut most: Option<(f64, Vec<f64>, bool)> = None;
    for (run, fit) in runs.zip(&e.fitted.fits) {
        for (o, y) in run.observe.iter().zip(&fit.channels) {
            let here: Vec<&&Correction> = drifting.iter().filter(|c| c.concerns(&run.name, &o.channel)).collect();
            let times = &run.recording.times;
            let drift: Vec<f64> = times.iter().map(|t| here.iter().map(|c| c.drift_at(*t)).sum()).collect();
            let part = power(&drift) / o.variance;
            if here.is_empty() || most.as_ref().is_some_and(|(p, ..)| part <= *p) {
                continue;
            }
            let without = |((y, v), d): ((&f64, &f64), &f64)| y - v - d;
            let residual = y.iter().zip(&o.values).zip(&drift).map(without).filter(|x| x.is_finite()).collect();
            most = Some((part, residual, here.iter().any(|c| c.drift.len() > 2)));
        }
    }
    most.is_some_and(|(_, residual, knotted)| by_chance(&residual, knotted))
}

/// Whether noise of the spectrum of a residual loses as much by a line and a jump, or by knots.
fn by_chance(residual: &[f64], knotted: bool) -> bool {
    let mut x = averaged(residual, POINTS);
    let n = x.len();
    if n < 16 || power(&x) <= 0.0 {
        return true;
    }
    let mean = x.iter().sum::<f64>() / n as f64;
    x.iter_mut().for_each(|x| *x -= mean);
    if mean.abs() > OFF * deviation_of_mean(&x) {
        return false;
    }
    let shapes = if knotted { vec![knots(n)] } else { (1..PLACES).map(|p| jump(n, p * n / PLACES)).collect() };
    // What is left, in its logarithm: near the whole of a residual a little more means much.
    let taken = |x: &[f64]| {
        let series = DVector::from_column_slice(x);
        let part = shapes.iter().map(|basis| basis.tr_mul(&series).norm_squared()).fold(0.0, f64::max);
        -(1.0 - part / power(x).max(f64::MIN_POSITIVE) / n as f64).max(1e-12).ln()
    };
    let mut surrogates = Surrogates::of(&x);
    let chance: Vec<f64> = (0..SURROGATES).map(|_| taken(&surrogates.draw())).collect();
    let mean = chance.iter().sum::<f64>() / chance.len() as f64;
    let deviation = power(&chance.iter().map(|c| c - mean).collect::<Vec<f64>>()).sqrt();
    taken(&x) - mean < FAR * deviation
}

/// Deviation of the mean of noise with this spectrum: that of white noise as strong as it is at the lowest frequencies.
fn deviation_of_mean(x: &[f64]) -> f64 {
    let n = x.len() as f64;
    let periodogram = |k: usize| {
        let wave = |t: usize| (TAU * (k * t) as f64 / n).sin_cos();
        let [s, c] = x.iter().enumerate().fold([0.0; 2], |[s, c], (t, x)| [s + x * wave(t).0, c + x * wave(t).1]);
        (s * s + c * c) / n
    };
    let power = (1..=LOWEST).map(periodogram).sum::<f64>() / LOWEST as f64;
    (power / n).sqrt()
}

/// A line and a jump, as orthonormal series without mean.
fn jump(n: usize, at: usize) -> DMatrix<f64> {
    let jump = |t, _| f64::from(u8::from(t >= at));
    basis(vec![DVector::from_fn(n, |t, _| t as f64), DVector::from_fn(n, jump)])
}

/// Hats at the knots but the last, which is the mean less the others, likewise.
fn knots(n: usize) -> DMatrix<f64> {
    let hat = |k: usize| {
        let at = move |t: usize| (t as f64 / (n - 1) as f64 * (KNOTS - 1) as f64 - k as f64).abs();
        DVector::from_fn(n, |t, _| (1.0 - at(t)).max(0.0))
    };
    basis((0..KNOTS - 1).map(hat).collect())
}

/// An orthonormal basis of series whose means are taken off.
fn basis(mut columns: Vec<DVector<f64>>) -> DMatrix<f64> {
    columns.iter_mut().for_each(|c| c.add_scalar_mut(-c.mean()));
    DMatrix::from_columns(&columns).qr().q()
}

#[cfg(test)]
mod tests {
    use super::by_chance;
    use crate::residual::noise::tests::noise;

    #[test]
    fn slow_noise_is_no_drift_and_a_drift_is_no_noise() {
        let mut taken = 0;
        for seed in 1..60 {
            let white = noise(seed, 900);
            let mut slow = white.clone();
            (1..slow.len()).for_each(|t| slow[t] += 0.97 * slow[t - 1]);
            for knotted in [false, true] {
                taken += usize::from(!by_chance(&slow, knotted)) + usize::from(!by_chance(&white, knotted));
            }
            let jumped: Vec<f64> = white.iter().enumerate().map(|(t, x)| x + if t > 300 { 3.0 } else { 0.0 }).collect();
            let off: Vec<f64> = white.iter().map(|x| x + 0.5).collect();
            assert!(!by_chance(&off, false), "{seed}");
            let risen: Vec<f64> = white.iter().enumerate().map(|(t, x)| x + 8.0 * t as f64 / 900.0).collect();
            assert!(!by_chance(&jumped, false) && !by_chance(&risen, false), "{seed}");
        }
        assert!(taken <= 2, "{taken} of 236");
    }
}

//! Test of a channel's drift against slow noise.
//!
//! A drifting zero follows slow noise as well, so that a line, a jump or a polyline removes much of every noisy recording. A
//! drift is accepted if it removes much more of the residual than of surrogates with the same spectrum. It is also accepted
//! if the mean of the residual is further from zero than that of such noise.

use super::surrogates::Surrogates;
use crate::candidate::channel_fault::ChannelFault;
use crate::hypothesis::sensor::DRIFT_KNOTS;
use crate::prior::{
    DRIFT_POINTS, DRIFT_Z, JUMP_PLACES, MEAN_DEVIATION_FREQUENCIES, MIN_DRIFT_POINTS, MIN_REMAINING_SHARE, OFFSET_Z,
    SURROGATES,
};
use crate::series::{averaged, power};
use hysteron_identify::study::{Role, ScoredRun, Study};
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;

/// Returns true if the strongest drift among channel faults may be slow noise; false if no channel drifts.
///
/// `fits` are the fitted runs with these faults, in their order.
pub(crate) fn drift_may_be_noise(study: &Study, faults: &[ChannelFault], fits: &[ScoredRun]) -> bool {
    let drifting: Vec<&ChannelFault> = faults.iter().filter(|c| !c.drift.is_empty()).collect();
    let runs = study.runs.iter().filter(|r| r.role == Role::Fit);
    // Power of the drift over the variance of its channel, residual without it, and true if the drift is a polyline.
    let mut strongest: Option<(f64, Vec<f64>, bool)> = None;
    for (run, fit) in runs.zip(fits) {
        for (o, y) in run.observe.iter().zip(&fit.channels) {
            let here: Vec<&&ChannelFault> = drifting.iter().filter(|c| c.affects(&run.name, &o.channel)).collect();
            let times = &run.recording.times;
            let drift: Vec<f64> = times.iter().map(|t| here.iter().map(|c| c.drift_at(*t)).sum()).collect();
            let share = power(&drift) / o.variance;
            if here.is_empty() || strongest.as_ref().is_some_and(|(s, ..)| share <= *s) {
                continue;
            }
            let without_drift = |((y, v), d): ((&f64, &f64), &f64)| y - v - d;
            let residual = y.iter().zip(&o.values).zip(&drift).map(without_drift).filter(|x| x.is_finite()).collect();
            strongest = Some((share, residual, here.iter().any(|c| c.drift.len() > 2)));
        }
    }
    strongest.is_some_and(|(_, residual, polyline)| noise_explains_drift(&residual, polyline))
}

/// Returns true if noise of a residual's spectrum loses as much by a line with a jump, or by a polyline.
fn noise_explains_drift(residual: &[f64], polyline: bool) -> bool {
    let mut x = averaged(residual, DRIFT_POINTS);
    let n = x.len();
    if n < MIN_DRIFT_POINTS || power(&x) <= 0.0 {
        return true;
    }
    let mean = x.iter().sum::<f64>() / n as f64;
    x.iter_mut().for_each(|x| *x -= mean);
    if mean.abs() > OFFSET_Z * deviation_of_mean(&x) {
        return false;
    }
    let shapes = if polyline {
        vec![polyline_basis(n)]
    } else {
        (1..JUMP_PLACES).map(|p| jump_basis(n, p * n / JUMP_PLACES)).collect()
    };
    // The logarithm of the remaining share resolves small differences where nearly all is removed.
    let removed = |x: &[f64]| {
        let series = DVector::from_column_slice(x);
        let part = shapes.iter().map(|basis| basis.tr_mul(&series).norm_squared()).fold(0.0, f64::max);
        -(1.0 - part / power(x).max(f64::MIN_POSITIVE) / n as f64).max(MIN_REMAINING_SHARE).ln()
    };
    let mut surrogates = Surrogates::of(&x);
    let by_chance: Vec<f64> = (0..SURROGATES).map(|_| removed(&surrogates.draw())).collect();
    let mean = by_chance.iter().sum::<f64>() / by_chance.len() as f64;
    let deviation = power(&by_chance.iter().map(|c| c - mean).collect::<Vec<f64>>()).sqrt();
    removed(&x) - mean < DRIFT_Z * deviation
}

/// Standard deviation of the mean of noise with the power that a series has at its lowest frequencies.
fn deviation_of_mean(x: &[f64]) -> f64 {
    let n = x.len() as f64;
    let periodogram = |k: usize| {
        let wave = |t: usize| (TAU * (k * t) as f64 / n).sin_cos();
        let [s, c] = x.iter().enumerate().fold([0.0; 2], |[s, c], (t, x)| [s + x * wave(t).0, c + x * wave(t).1]);
        (s * s + c * c) / n
    };
    let frequencies = 1..=MEAN_DEVIATION_FREQUENCIES;
    let power = frequencies.map(periodogram).sum::<f64>() / MEAN_DEVIATION_FREQUENCIES as f64;
    (power / n).sqrt()
}

/// Orthonormal basis of a line and a jump, without means; n x 2.
fn jump_basis(n: usize, at: usize) -> DMatrix<f64> {
    let jump = |t, _| f64::from(u8::from(t >= at));
    orthonormal(vec![DVector::from_fn(n, |t, _| t as f64), DVector::from_fn(n, jump)])
}

/// Orthonormal basis of polylines over equal intervals, without means; n x (knots - 1). The last hat function depends on the
/// mean and the others.
fn polyline_basis(n: usize) -> DMatrix<f64> {
    let hat = |k: usize| {
        let distance = move |t: usize| (t as f64 / (n - 1) as f64 * (DRIFT_KNOTS - 1) as f64 - k as f64).abs();
        DVector::from_fn(n, |t, _| (1.0 - distance(t)).max(0.0))
    };
    orthonormal((0..DRIFT_KNOTS - 1).map(hat).collect())
}

/// Orthonormal basis of series without their means.
fn orthonormal(mut columns: Vec<DVector<f64>>) -> DMatrix<f64> {
    columns.iter_mut().for_each(|c| c.add_scalar_mut(-c.mean()));
    DMatrix::from_columns(&columns).qr().q()
}

#[cfg(test)]
mod tests {
    use super::noise_explains_drift;
    use crate::test_support::white_noise;

    #[test]
    fn slow_noise_and_drift_are_distinguished() {
        let mut taken = 0;
        for seed in 1..60 {
            let white = white_noise(seed, 900);
            let mut slow = white.clone();
            (1..slow.len()).for_each(|t| slow[t] += 0.97 * slow[t - 1]);
            for knotted in [false, true] {
                taken += usize::from(!noise_explains_drift(&slow, knotted))
                    + usize::from(!noise_explains_drift(&white, knotted));
            }
            let jumped: Vec<f64> = white.iter().enumerate().map(|(t, x)| x + if t > 300 { 3.0 } else { 0.0 }).collect();
            let off: Vec<f64> = white.iter().map(|x| x + 0.5).collect();
            assert!(!noise_explains_drift(&off, false), "{seed}");
            let risen: Vec<f64> = white.iter().enumerate().map(|(t, x)| x + 8.0 * t as f64 / 900.0).collect();
            assert!(!noise_explains_drift(&jumped, false) && !noise_explains_drift(&risen, false), "{seed}");
        }
        assert!(taken <= 2, "{taken} of 236");
    }
}

//! Noise of sensors that is not white and steady: noise that grows with the reading, and rounding.

use crate::prior::{MIN_CONSTANT_VARIANCE, SINGULAR_VARIANCE_FIT, VARIANCE_FIT_STEPS};
use crate::series::power;

/// Differences of samples over their range that are round-off.
const ROUND_OFF: f64 = 1e-9;
/// Difference from a whole number of steps that counts as none.
const STEP_TOLERANCE: f64 = 0.01;

/// A residual divided by the standard deviation of noise with the variance a + b y² at a channel reading y.
///
/// Reweighted least squares on the squared residual give the most likely a and b that are not negative.
pub(super) fn variance_normalised(residual: &[f64], channel: &[f64]) -> Vec<f64> {
    let (mean, size) = (power(residual), power(channel));
    if mean <= 0.0 || size <= 0.0 {
        return residual.to_vec();
    }
    let squares: Vec<f64> = channel.iter().map(|y| y * y / size).collect();
    let (mut a, mut b) = (mean, 0.0);
    for _ in 0..VARIANCE_FIT_STEPS {
        let (mut normal, mut gradient) = ([[0.0; 2]; 2], [0.0; 2]);
        for (r, g) in residual.iter().zip(&squares) {
            let w = (a + b * g).powi(-2);
            normal = [[normal[0][0] + w, normal[0][1] + w * g], [normal[1][0] + w * g, normal[1][1] + w * g * g]];
            gradient = [gradient[0] + w * r * r, gradient[1] + w * g * r * r];
        }
        let [[aa, ab], [_, bb]] = normal;
        let determinant = aa * bb - ab * ab;
        if determinant <= SINGULAR_VARIANCE_FIT * aa * bb {
            break;
        }
        a = (bb * gradient[0] - ab * gradient[1]) / determinant;
        b = (aa * gradient[1] - ab * gradient[0]) / determinant;
        if b < 0.0 {
            (a, b) = (gradient[0] / aa, 0.0);
        } else if a < MIN_CONSTANT_VARIANCE * mean {
            a = MIN_CONSTANT_VARIANCE * mean;
            b = ((gradient[1] - ab * a) / bb).max(0.0);
        }
    }
    residual.iter().zip(&squares).map(|(r, g)| r / (a + b * g).sqrt()).collect()
}

/// Step of which all samples are multiples, beside one of them: the least difference of two samples. 0 without such a step.
pub(super) fn sample_step(samples: &[f64]) -> f64 {
    let mut sorted: Vec<f64> = samples.iter().copied().filter(|x| x.is_finite()).collect();
    sorted.sort_by(f64::total_cmp);
    let (Some(low), Some(high)) = (sorted.first().copied(), sorted.last().copied()) else { return 0.0 };
    let differences = sorted.windows(2).map(|w| w[1] - w[0]).filter(|d| *d > ROUND_OFF * (high - low));
    let step = differences.fold(f64::INFINITY, f64::min);
    let is_multiple = |x: &f64| {
        let steps = (x - low) / step;
        (steps - steps.round()).abs() < STEP_TOLERANCE
    };
    if step.is_finite() && sorted.iter().all(is_multiple) { step } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::{sample_step, variance_normalised};
    use crate::residual::surrogates::{silent_share, unsteady_share};
    use crate::test_support::white_noise;

    /// Noise that grows with the reading is neither silent nor unsteady; an event of its own is.
    #[test]
    fn noise_may_grow_with_the_reading() {
        let n = 1200;
        let channel: Vec<f64> = (0..n).map(|t| (t as f64 / n as f64) * (0.05 * t as f64).sin()).collect();
        let mut flagged = 0;
        for seed in 1..20 {
            let grows: Vec<f64> =
                white_noise(seed, n).iter().zip(&channel).map(|(x, y)| x * (0.1f64 + y * y).sqrt()).collect();
            let steady = variance_normalised(&grows, &channel);
            assert!(silent_share(&grows) > 0.3, "{seed} {}", silent_share(&grows));
            flagged += usize::from(silent_share(&steady).max(unsteady_share(&steady)) > 0.05);
            let rung = |t: usize| if t % 500 > 400 { 8.0 * (0.4 * t as f64).sin() } else { 0.0 };
            let struck: Vec<f64> = white_noise(seed, n).iter().enumerate().map(|(t, x)| x + rung(t)).collect();
            assert!(silent_share(&variance_normalised(&struck, &channel)) > 0.3);
        }
        assert!(flagged < 3, "{flagged}");
    }

    #[test]
    fn the_step_of_samples_is_that_of_all() {
        let numbers: Vec<f64> = white_noise(1, 200).iter().map(|x| 0.7 + 0.25 * (x / 0.25).round()).collect();
        assert!((sample_step(&numbers) - 0.25).abs() < 1e-12);
        assert_eq!(sample_step(&white_noise(1, 200)), 0.0);
        assert_eq!((sample_step(&[]), sample_step(&[1.0, 1.0])), (0.0, 0.0));
    }
}

//! Bursts: stretches of a record with excess power.

use crate::prior::{BURST_POWER_RATIO, BURST_STRETCHES, MIN_BURST_SAMPLES};
use crate::series::{median, power};

/// Share of the power of innovations that lies in bursts.
///
/// A stretch is a burst if its power exceeds the median and the power that the motion of the `model` accounts for. Errors of
/// a law grow with the motion; other machines do not.
pub(crate) fn burst_share(innovations: &[f64], model: &[f64]) -> f64 {
    let length = innovations.len() / BURST_STRETCHES;
    if length < MIN_BURST_SAMPLES {
        return 0.0;
    }
    let powers = |x: &[f64]| x.chunks_exact(length).map(power).collect::<Vec<f64>>();
    let (powers, motion) = (powers(innovations), powers(model));
    let (level, usual_motion) = (median(powers.clone()), median(motion.clone()));
    // Median excess power per motion power. Bursts are too few to change it.
    let pairs = || powers.iter().zip(&motion);
    let excess = pairs().filter(|(_, m)| **m > usual_motion).map(|(p, m)| (p - level).max(0.0) / m);
    let by_motion = median(excess.collect());
    let total: f64 = powers.iter().sum();
    let expected = pairs().map(|(p, m)| (p, level + by_motion * m));
    let over = expected.filter(|(p, expected)| **p > BURST_POWER_RATIO * expected);
    let in_bursts: f64 = over.map(|(p, expected)| p - expected).sum();
    if total > 0.0 { in_bursts / total } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::burst_share;
    use crate::test_support::white_noise;

    #[test]
    fn power_that_follows_the_motion_is_no_burst() {
        let (quiet, strong) = (white_noise(0, 8000), |t: usize| if (3000..5000).contains(&t) { 5.0 } else { 1.0 });
        let motion: Vec<f64> = white_noise(0, 9000)[1000..].iter().enumerate().map(|(t, m)| m * strong(t)).collect();
        let follows: Vec<f64> = quiet.iter().enumerate().map(|(t, x)| x * strong(t)).collect();
        assert!(burst_share(&quiet, &motion) < 0.02 && burst_share(&follows, &motion) < 0.02);
        let blow = |t: usize| if (3600..3700).contains(&t) { 12.0 } else { 1.0 };
        let blown: Vec<f64> = quiet.iter().enumerate().map(|(t, x)| x * blow(t)).collect();
        assert!(burst_share(&blown, &motion) > 0.5);
    }
}

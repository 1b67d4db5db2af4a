//! What a residual is made of: noise that remembers itself, lines of its spectrum, bursts.

use rustfft::FftPlanner;
use rustfft::num_complex::Complex;

/// Coefficients of an autoregressive noise, x_t = Σ a_k x_{t-k} + ε, by Burg's method (Burg, 1967): stable whatever the
/// data.
pub fn burg(x: &[f64], order: usize) -> Vec<f64> {
    let n = x.len();
    let mut a: Vec<f64> = vec![];
    let (mut forward, mut backward) = (x.to_vec(), x.to_vec());
    for m in 0..order.min(n.saturating_sub(2) / 3) {
        let (mut product, mut power) = (0.0, 0.0);
        for t in m + 1..n {
            product += forward[t] * backward[t - 1];
            power += forward[t] * forward[t] + backward[t - 1] * backward[t - 1];
        }
        if power <= 0.0 {
            break;
        }
        let k = 2.0 * product / power;
        let old = a.clone();
        a.push(k);
        for i in 0..m {
            a[i] = old[i] - k * old[m - 1 - i];
        }
        for t in (m + 1..n).rev() {
            let (f, b) = (forward[t], backward[t - 1]);
            forward[t] = f - k * b;
            backward[t] = b - k * f;
        }
    }
    a
}

/// Innovations of a series under an autoregressive noise: what its past does not tell.
pub fn whiten(x: &[f64], a: &[f64]) -> Vec<f64> {
    let at = |t: usize| x[t] - a.iter().enumerate().map(|(k, a)| a * x[t - 1 - k]).sum::<f64>();
    (a.len().min(x.len())..x.len()).map(at).collect()
}

/// A series averaged to at most so many points.
pub fn averaged(x: &[f64], points: usize) -> Vec<f64> {
    let block = x.len().div_ceil(points).max(1);
    x.chunks(block).map(|c| c.iter().sum::<f64>() / c.len() as f64).collect()
}

/// Part of the power of innovations that comes in stretches much louder than the rest, and louder than what the motion of
/// the model accounts for there: errors grow with the motion, another machine does not ask for it.
pub fn bursts(x: &[f64], model: &[f64]) -> f64 {
    /// Stretches of a record; noise of one level passes four times its median power in none of them.
    const STRETCHES: usize = 40;
    const LOUD: f64 = 4.0;
    let length = x.len() / STRETCHES;
    if length < 8 {
        return 0.0;
    }
    let powers = |x: &[f64]| x.chunks_exact(length).map(power).collect::<Vec<f64>>();
    let (powers, motion) = (powers(x), powers(model));
    let (level, usual) = (median(powers.clone()), median(motion.clone()));
    // What stretches with more motion than usual have more, of the usual one of them: a burst is in few.
    let pairs = || powers.iter().zip(&motion);
    let excess = pairs().filter(|(_, m)| **m > usual).map(|(p, m)| (p - level).max(0.0) / m);
    let by_motion = median(excess.collect());
    let total: f64 = powers.iter().sum();
    let over = pairs().map(|(p, m)| (p, level + by_motion * m)).filter(|(p, expected)| **p > LOUD * expected);
    let loud: f64 = over.map(|(p, expected)| p - expected).sum();
    if total > 0.0 { loud / total } else { 0.0 }
}

/// Median; 0 of nothing.
fn median(mut x: Vec<f64>) -> f64 {
    let middle = x.len() / 2;
    if x.is_empty() { 0.0 } else { *x.select_nth_unstable_by(middle, f64::total_cmp).1 }
}

/// Mean square.
pub fn power(x: &[f64]) -> f64 {
    if x.is_empty() { 0.0 } else { x.iter().map(|v| v * v).sum::<f64>() / x.len() as f64 }
}

/// Part of the power of a series that stands in a few lines of its spectrum, which no broad noise has: hum, a machine. Lines
/// that are weaker than what the model has there do not count: they are errors of its motion.
/// The frequency of the strongest comes with it, in cycles per sample.
pub fn lines(x: &[f64], model: &[f64]) -> (f64, f64) {
    let n = x.len().min(8192);
    if n < 64 {
        return (0.0, 0.0);
    }
    let spectrum_of = |x: &[f64]| {
        let mean = x[..n].iter().sum::<f64>() / n as f64;
        // A Hann window keeps the skirts of a line narrow.
        let windowed: Vec<f64> =
            (0..n).map(|t| (x[t] - mean) * (std::f64::consts::PI * t as f64 / n as f64).sin().powi(2)).collect();
        periodogram(&windowed)
    };
    let (spectrum, motion) = (spectrum_of(x), spectrum_of(model));
    let m = spectrum.len();
    let total: f64 = spectrum.iter().sum();
    if total <= 0.0 {
        return (0.0, 0.0);
    }
    let (mut share, mut strongest) = (0.0, (0.0, 0.0));
    for (i, p) in spectrum.iter().enumerate().skip(SLOWEST) {
        // Over an octave on both sides: noise that falls with the frequency has no line where it begins. And beside its skirts:
        // noise of a narrow band stands above the octave around it, but is no line.
        let wide = (i / 2).max(6);
        let near = wide.min(NEAR);
        let beside = (i - near.min(i)..i - SKIRT.min(i)).chain(i + SKIRT + 1..i + near + 1).filter(|k| *k < m);
        let octave = (i - wide.min(i)..i + wide).filter(|k| *k < m);
        let level = median(octave.map(|k| spectrum[k]).collect()).max(median(beside.map(|k| spectrum[k]).collect()));
        let own = motion[i - SKIRT.min(i)..(i + SKIRT + 1).min(m)].iter().fold(0.0, |a: f64, p| a.max(*p));
        // Noise passes 25 times its median once in 3e7.
        if *p > 25.0 * level && *p > own {
            share += p / total;
            if *p > strongest.0 {
                strongest = (*p, i as f64 / n as f64);
            }
        }
    }
    (share, strongest.1)
}

/// Frequencies on both sides that a line stands above, beside those to which it reaches.
const NEAR: usize = 24;
/// Frequencies on both sides to which a line reaches.
const SKIRT: usize = 2;

/// Cycles in the record below which nothing is called a line.
const SLOWEST: usize = 8;

/// |DFT|² at the positive frequencies below a half.
fn periodogram(x: &[f64]) -> Vec<f64> {
    let mut buffer: Vec<Complex<f64>> = x.iter().map(|x| Complex { re: *x, im: 0.0 }).collect();
    FftPlanner::new().plan_fft_forward(buffer.len()).process(&mut buffer);
    buffer[..x.len() / 2].iter().map(Complex::norm_sqr).collect()
}

#[cfg(test)]
pub(crate) mod tests {
    use super::{burg, bursts, lines, power, whiten};

    /// White noise of variance one.
    pub(crate) fn noise(seed: u64, n: usize) -> Vec<f64> {
        let mut x = 88172645463325252u64 ^ (seed << 32);
        let mut uniform = || {
            x ^= x << 13;
            x ^= x >> 7;
            x ^= x << 17;
            (x >> 11) as f64 / (1u64 << 53) as f64
        };
        (0..n).map(|_| (0..12).map(|_| uniform()).sum::<f64>() - 6.0).collect()
    }

    #[test]
    fn coloured_noise_is_whitened() {
        let mut x = noise(0, 4000);
        for t in 2..x.len() {
            x[t] += 1.2 * x[t - 1] - 0.4 * x[t - 2];
        }
        let a = burg(&x, 2);
        assert!((a[0] - 1.2).abs() < 0.05 && (a[1] + 0.4).abs() < 0.05, "{a:?}");
        assert!((power(&whiten(&x, &a)) - 1.0).abs() < 0.1);
    }

    #[test]
    fn lines_are_told_from_noise() {
        let mut x = noise(0, 4000);
        let still = vec![0.0; x.len()];
        assert!(lines(&x, &still).0 < 0.02);
        x.iter_mut().enumerate().for_each(|(t, x)| *x += 1.5 * (0.7 * t as f64).sin());
        let (share, frequency) = lines(&x, &still);
        let moving: Vec<f64> = (0..x.len()).map(|t| 3.0 * (0.7 * t as f64).cos()).collect();
        assert!(lines(&x, &moving).0 < 0.02);
        assert!(share > 0.4 && (frequency - 0.7 / std::f64::consts::TAU).abs() < 1e-3, "{share} {frequency}");
    }

    #[test]
    fn noise_of_a_narrow_band_has_no_line() {
        let still = vec![0.0; 3000];
        let mut flagged = 0;
        for seed in 1..40 {
            let mut x = noise(seed, 3000);
            let band = 2.0 * 0.98 * 0.2f64.cos();
            (2..x.len()).for_each(|t| x[t] += band * x[t - 1] - 0.98 * 0.98 * x[t - 2]);
            let without = lines(&x, &still).0;
            flagged += usize::from(without > 0.01);
            // A machine that goes on and off beside it is seen all the same.
            let size = power(&x).sqrt();
            let hum = |t: usize| if t % 800 < 400 { (0.9 * t as f64).sin() } else { 0.0 };
            x.iter_mut().enumerate().for_each(|(t, x)| *x += size * hum(t));
            let with = lines(&x, &still).0;
            assert!(with - without > 0.05, "{seed} {with} {without}");
        }
        assert!(flagged < 5, "{flagged}");
    }

    #[test]
    fn bursts_are_those_that_the_motion_does_not_account_for() {
        let (quiet, loud) = (noise(0, 8000), |t: usize| if (3000..5000).contains(&t) { 5.0 } else { 1.0 });
        let motion: Vec<f64> = noise(0, 9000)[1000..].iter().enumerate().map(|(t, m)| m * loud(t)).collect();
        let follows: Vec<f64> = quiet.iter().enumerate().map(|(t, x)| x * loud(t)).collect();
        assert!(bursts(&quiet, &motion) < 0.02 && bursts(&follows, &motion) < 0.02);
        let blow = |t: usize| if (3600..3700).contains(&t) { 12.0 } else { 1.0 };
        let blown: Vec<f64> = quiet.iter().enumerate().map(|(t, x)| x * blow(t)).collect();
        assert!(bursts(&blown, &motion) > 0.5);
    }
}

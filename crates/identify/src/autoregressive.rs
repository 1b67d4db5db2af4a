//! Autoregressive noise x_t = Σ_k a_k x_{t-k} + ε_t.

/// Samples per coefficient that a series needs at least.
const SAMPLES_PER_COEFFICIENT: usize = 3;

/// Coefficients a_1, ..., a_order by Burg's method (Burg 1967, 37th Meeting of the Society of Exploration Geophysicists).
/// The process is stable for every series. A short series gives fewer coefficients.
pub fn burg(x: &[f64], order: usize) -> Vec<f64> {
    let n = x.len();
    let mut a: Vec<f64> = vec![];
    let (mut forward, mut backward) = (x.to_vec(), x.to_vec());
    for m in 0..order.min(n.saturating_sub(2) / SAMPLES_PER_COEFFICIENT) {
        let (mut product, mut power) = (0.0, 0.0);
        for t in m + 1..n {
            product += forward[t] * backward[t - 1];
            power += forward[t] * forward[t] + backward[t - 1] * backward[t - 1];
        }
        if power <= 0.0 {
            break;
        }
        let reflection = 2.0 * product / power;
        let old = a.clone();
        a.push(reflection);
        for i in 0..m {
            a[i] = old[i] - reflection * old[m - 1 - i];
        }
        for t in (m + 1..n).rev() {
            let (f, b) = (forward[t], backward[t - 1]);
            forward[t] = f - reflection * b;
            backward[t] = b - reflection * f;
        }
    }
    a
}

/// Innovations ε_t of a series under an autoregressive noise; shorter than the series by the order.
pub fn whiten(x: &[f64], a: &[f64]) -> Vec<f64> {
    let at = |t: usize| x[t] - a.iter().enumerate().map(|(k, a)| a * x[t - 1 - k]).sum::<f64>();
    (a.len().min(x.len())..x.len()).map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::{burg, whiten};
    use rand::{RngExt as _, SeedableRng as _};
    use rand_pcg::Pcg32;

    #[test]
    fn coloured_noise_is_whitened() {
        let mut rng = Pcg32::seed_from_u64(1);
        // White noise of variance one: sums of twelve uniform numbers.
        let mut x: Vec<f64> = (0..4000).map(|_| (0..12).map(|_| rng.random::<f64>()).sum::<f64>() - 6.0).collect();
        for t in 2..x.len() {
            x[t] += 1.2 * x[t - 1] - 0.4 * x[t - 2];
        }
        let a = burg(&x, 2);
        assert!((a[0] - 1.2).abs() < 0.05 && (a[1] + 0.4).abs() < 0.05, "{a:?}");
        let innovations = whiten(&x, &a);
        let power = innovations.iter().map(|x| x * x).sum::<f64>() / innovations.len() as f64;
        assert!((power - 1.0).abs() < 0.1);
    }
}

//! Test of a residual: noise, or something that follows the motion.
//!
//! The residual r of a channel is projected onto functions of the simulated response and of its history. For noise, the part
//! R² of its squared sum that they explain is that of noise of the same colour and size: blocks of r with random signs (the
//! wild bootstrap of Wu, 1986, in blocks) keep both, and lose their relation to the motion. Beyond that part,
//!
//! share = (R² - E R²_b) / (1 - E R²_b)
//!
//! of the squared sum follows the motion. It is taken for real if R² exceeds all R²_b.
//!
//! The blocks of noise slower than a sixtieth of the record are too short. It is taken for structure more often: 3 of 40
//! series with the autocorrelation 0.97 and 1500 samples.

use super::uncertainty::autocorrelation_time;
use rand::{RngExt as _, SeedableRng as _};
use rand_pcg::Pcg32;

/// Number of residuals with random signs: one of a hundred residuals that are noise exceeds all of them.
const SURROGATES: usize = 99;
/// Length of a block in autocorrelation times.
const BLOCK_TIMES: f64 = 3.0;
/// A shorter residual is not tested.
const MIN_SAMPLES: usize = 60;
/// Fewest blocks of a residual.
const MIN_BLOCKS: usize = 20;
/// A function with a smaller part that is new to those before it is left out.
const MIN_NEW_PART: f64 = 1e-6;
/// Derivatives by more parameters add no functions: too many explain noise as well.
const MAX_PARAMETERS: usize = 6;
/// A smaller share is no finding.
const MIN_SHARE: f64 = 0.05;

/// A simulated channel where it is compared with a recording.
pub(super) struct ComparedChannel<'a> {
    /// Times.
    pub(super) times: &'a [f64],
    /// Simulated values.
    pub(super) simulated: &'a [f64],
    /// Simulated less recorded values, in any unit.
    pub(super) residual: &'a [f64],
    /// Derivatives of the residual by each parameter.
    pub(super) derivatives: &'a [&'a [f64]],
}

/// Share of the squared sum of a residual that follows the motion; zero if it is noise as far as one can tell.
pub(super) fn structured_share(channel: &ComparedChannel<'_>) -> f64 {
    let r = channel.residual;
    let n = r.len();
    let total: f64 = r.iter().map(|x| x * x).sum();
    if n < MIN_SAMPLES || total <= 0.0 {
        return 0.0;
    }
    let functions = orthonormal(functions(channel));
    let length = (BLOCK_TIMES * autocorrelation_time(r)).round().clamp(4.0, (n / MIN_BLOCKS).max(4) as f64) as usize;
    // Projections of each block, whose sum with signs is that of a residual.
    let blocks: Vec<Vec<f64>> = (0..n)
        .step_by(length)
        .map(|start| {
            let end = (start + length).min(n);
            functions.iter().map(|f| f[start..end].iter().zip(&r[start..end]).map(|(a, b)| a * b).sum()).collect()
        })
        .collect();
    let explained = |mut sign: Box<dyn FnMut() -> f64 + '_>| -> f64 {
        let mut projections = vec![0.0; functions.len()];
        for block in &blocks {
            let s = sign();
            projections.iter_mut().zip(block).for_each(|(p, b)| *p += s * b);
        }
        projections.iter().map(|p| p * p).sum::<f64>() / total
    };
    let found = explained(Box::new(|| 1.0));
    let mut rng = Pcg32::seed_from_u64(1);
    let mut of_noise = vec![];
    for _ in 0..SURROGATES {
        of_noise.push(explained(Box::new(|| if rng.random::<bool>() { 1.0 } else { -1.0 })));
    }
    let mean = of_noise.iter().sum::<f64>() / SURROGATES as f64;
    let share = (found - mean) / (1.0 - mean).max(f64::MIN_POSITIVE);
    if share >= MIN_SHARE && of_noise.iter().all(|x| found > *x) { share.min(1.0) } else { 0.0 }
}

/// A residual without its projection onto some columns.
pub(super) fn without(mut residual: Vec<f64>, columns: Vec<Vec<f64>>) -> Vec<f64> {
    for b in orthonormal(columns) {
        let p: f64 = residual.iter().zip(&b).map(|(x, b)| x * b).sum();
        residual.iter_mut().zip(&b).for_each(|(x, b)| *x -= p * b);
    }
    residual
}

/// Functions of the response y, its rate v, and their history: the greatest |y| so far (m), and the path so far (w).
fn functions(channel: &ComparedChannel<'_>) -> Vec<Vec<f64>> {
    let y = scaled(channel.simulated.to_vec());
    let v = scaled(rates(channel.times, channel.simulated));
    let m = accumulated(&y, |m, y| f64::max(m, y.abs()));
    let w = scaled(accumulated(&v, |w, v| w + v.abs()));
    let integral = scaled(accumulated(&y, |s, y| s + y));
    let of = |f: &dyn Fn(usize) -> f64| -> Vec<f64> { (0..y.len()).map(f).collect() };
    let mut all = vec![
        y.clone(),
        v.clone(),
        integral,
        of(&|i| y[i].powi(3)),
        of(&|i| y[i] * y[i].abs()),
        of(&|i| v[i] * v[i].abs()),
        of(&|i| v[i].signum() * v[i].abs().powf(0.3)),
        of(&|i| v[i].signum() * y[i].abs()),
        of(&|i| m[i] * y[i]),
        of(&|i| m[i] * v[i]),
        of(&|i| w[i] * y[i]),
        of(&|i| w[i] * v[i]),
    ];
    if channel.derivatives.len() <= MAX_PARAMETERS {
        // A parameter that changes with the amplitude or along the path.
        for d in channel.derivatives.iter().map(|d| scaled(d.to_vec())) {
            all.push(of(&|i| d[i] * y[i].abs()));
            all.push(of(&|i| d[i] * w[i]));
        }
    }
    all
}

/// A series over its greatest magnitude.
fn scaled(mut x: Vec<f64>) -> Vec<f64> {
    let greatest = x.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    if greatest > 0.0 {
        x.iter_mut().for_each(|x| *x /= greatest);
    }
    x
}

/// A series accumulated from zero.
fn accumulated(x: &[f64], mut add: impl FnMut(f64, f64) -> f64) -> Vec<f64> {
    let mut sum = 0.0;
    x.iter()
        .map(|x| {
            sum = add(sum, *x);
            sum
        })
        .collect()
}

/// Rates by central differences, one-sided at the ends.
fn rates(times: &[f64], x: &[f64]) -> Vec<f64> {
    let n = x.len();
    let rate = |i: usize| {
        let (a, b) = (i.saturating_sub(1), (i + 1).min(n - 1));
        let dt = times[b] - times[a];
        if dt > 0.0 { (x[b] - x[a]) / dt } else { 0.0 }
    };
    (0..n).map(rate).collect()
}

/// Orthonormal functions that span the same space, by the modified method of Gram and Schmidt.
fn orthonormal(functions: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
    let mut basis: Vec<Vec<f64>> = vec![];
    for mut f in functions {
        let before = dot(&f, &f).sqrt();
        for b in &basis {
            let p = dot(&f, b);
            f.iter_mut().zip(b).for_each(|(x, b)| *x -= p * b);
        }
        let after = dot(&f, &f).sqrt();
        if after > MIN_NEW_PART * before && after.is_finite() {
            f.iter_mut().for_each(|x| *x /= after);
            basis.push(f);
        }
    }
    basis
}

#[cfg(test)]
mod tests {
    use super::super::method::standard_normal;
    use super::{ComparedChannel, structured_share};
    use rand::SeedableRng as _;
    use rand_pcg::Pcg32;

    /// Share of a residual beside a growing oscillation of 1500 samples.
    fn share(residual: impl Fn(f64, f64, f64) -> f64, noise: f64, colour: f64, seed: u64) -> f64 {
        let mut rng = Pcg32::seed_from_u64(seed);
        let times: Vec<f64> = (0..1500).map(|i| 0.02 * f64::from(i)).collect();
        let amplitude = |t: f64| 0.2 + 0.8 * t / 30.0;
        let y: Vec<f64> = times.iter().map(|t| amplitude(*t) * (1.9 * t).sin()).collect();
        let mut e = 0.0;
        let r: Vec<f64> = times
            .iter()
            .zip(&y)
            .map(|(t, y)| {
                e = colour * e + (1.0 - colour * colour).sqrt() * standard_normal(&mut rng);
                residual(*t, *y, amplitude(*t) * 1.9 * (1.9 * t).cos()) + noise * e
            })
            .collect();
        structured_share(&ComparedChannel { times: &times, simulated: &y, residual: &r, derivatives: &[] })
    }

    #[test]
    fn noise_has_no_structure() {
        for colour in [0.0, 0.8, 0.9] {
            let found = (0..40).filter(|seed| share(|_, _, _| 0.0, 1.0, colour, *seed) > 0.0).count();
            assert!(found <= 2, "{found} of 40 with colour {colour}");
        }
        // Noise that grows with what is measured.
        let found = (0..40).filter(|seed| {
            let mut rng = Pcg32::seed_from_u64(1000 + seed);
            let draws: Vec<f64> = (0..1500).map(|_| standard_normal(&mut rng)).collect();
            share(|t, y, _| 0.1 * y * draws[(t / 0.02).round() as usize], 0.0, 0.0, *seed) > 0.0
        });
        assert!(found.count() <= 2);
    }

    #[test]
    fn missing_physics_has_structure() {
        for seed in 0..10 {
            assert!(share(|_, y, _| y * y * y, 0.3, 0.0, seed) > 0.3);
            assert!(share(|_, _, v| 0.3 * v.signum(), 0.3, 0.8, seed) > 0.2);
            assert!(share(|t, y, _| 0.02 * t * y, 0.1, 0.0, seed) > 0.3);
        }
    }
}

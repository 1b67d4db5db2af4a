//! Scatter of the properties over the cycles of tests, handed on to isolation studies.

use super::trends::is_same;
use super::{Nominal, PrototypeTest, TestCycle};
use rand::RngExt as _;
use rand_pcg::Pcg32;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// Two lognormal properties of one isolator: Q_d and K_d over their nominal values.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Posterior {
    /// Medians of Q_d and K_d over nominal.
    pub median: [f64; 2],
    /// Standard deviations of their logarithms.
    pub dispersion: [f64; 2],
    /// Correlation of the logarithms.
    pub correlation: f64,
    /// Cycles that it was found from.
    pub cycles: usize,
}

/// Percentiles of a bound: 5 and 95 %.
const NORMAL_95: f64 = 1.644_853_626_951_472_7;

impl Posterior {
    /// Of the cycles at the nominal displacement: the scatter over cycles, specimens and velocities.
    ///
    /// # Errors
    /// There are fewer than three cycles with a bilinear loop.
    pub fn of(tests: &[PrototypeTest], nominal: &Nominal) -> Result<Self, String> {
        let fits = |c: &&TestCycle| is_same(c.amplitude, nominal.amplitude) && c.q_d > 0.0 && c.k_d > 0.0;
        let logs: Vec<[f64; 2]> = tests
            .iter()
            .flat_map(|t| &t.cycles)
            .filter(fits)
            .map(|c| [(c.q_d / nominal.q_d).ln(), (c.k_d / nominal.k_d).ln()])
            .collect();
        let n = logs.len();
        if n < 3 {
            return Err(format!(
                "{n} cycles at the displacement {} have a bilinear loop: expected 3",
                nominal.amplitude
            ));
        }
        let mean = [0, 1].map(|k| logs.iter().map(|l| l[k]).sum::<f64>() / n as f64);
        let covariance =
            |a: usize, b: usize| logs.iter().map(|l| (l[a] - mean[a]) * (l[b] - mean[b])).sum::<f64>() / (n - 1) as f64;
        let dispersion = [0, 1].map(|k| covariance(k, k).sqrt());
        let both = dispersion[0] * dispersion[1];
        let correlation = if both > 0.0 { (covariance(0, 1) / both).clamp(-1.0, 1.0) } else { 0.0 };
        Ok(Self { median: mean.map(f64::exp), dispersion, correlation, cycles: n })
    }

    /// Check the numbers of a file.
    ///
    /// # Errors
    /// One of them has no meaning. The message names it.
    pub fn check(&self) -> Result<(), String> {
        if self.median.iter().any(|m| !(*m > 0.0 && m.is_finite())) {
            return Err(format!("median = {:?}: expected numbers above 0", self.median));
        }
        if self.dispersion.iter().any(|d| !(*d >= 0.0 && d.is_finite())) {
            return Err(format!("dispersion = {:?}: expected numbers, not negative", self.dispersion));
        }
        if !(-1.0..=1.0).contains(&self.correlation) {
            return Err(format!("correlation = {}: expected -1 to 1", self.correlation));
        }
        Ok(())
    }

    /// Percentiles 5 and 95 of Q_d (0) or K_d (1) over nominal.
    pub fn range(&self, of: usize) -> [f64; 2] {
        [-1.0, 1.0].map(|side| self.median[of] * (side * NORMAL_95 * self.dispersion[of]).exp())
    }

    /// Factors on Q_d and K_d of one draw.
    pub fn draw(&self, random: &mut Pcg32) -> [f64; 2] {
        // Box and Muller (1958); 1 - u is above 0.
        let (u, v): (f64, f64) = (random.random(), random.random());
        let radius = (-2.0 * libm::log(1.0 - u)).sqrt();
        let (a, b) = (radius * libm::cos(TAU * v), radius * libm::sin(TAU * v));
        let r = self.correlation;
        let normal = [a, r * a + (1.0 - r * r).sqrt() * b];
        [0, 1].map(|k| self.median[k] * libm::exp(self.dispersion[k] * normal[k]))
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Nominal, PrototypeTest, TestCycle};
    use super::Posterior;
    use rand::SeedableRng as _;
    use rand_pcg::Pcg32;

    #[test]
    fn scatter_of_cycles_is_that_of_its_draws() {
        let cycle = |q: f64, k: f64| TestCycle { amplitude: 0.2, q_d: 10.0 * q, k_d: 50.0 * k, ..TestCycle::default() };
        let nominal = Nominal { amplitude: 0.2, q_d: 10.0, k_d: 50.0, k_eff: 100.0, tests: 1 };
        let cycles = vec![cycle(1.2, 1.05), cycle(1.0, 1.0), cycle(0.8, 0.97), cycle(0.9, 0.99)];
        let p = Posterior::of(&[PrototypeTest { name: "t".into(), cycles }], &nominal).expect("a posterior");
        let median = (1.2f64 * 1.0 * 0.8 * 0.9).powf(0.25);
        assert!((p.median[0] - median).abs() < 1e-12 && p.correlation > 0.9 && p.cycles == 4, "{p:?}");
        let mut random = Pcg32::seed_from_u64(1);
        let draws: Vec<[f64; 2]> = (0..40_000).map(|_| p.draw(&mut random).map(f64::ln)).collect();
        let n = draws.len() as f64;
        let mean = [0, 1].map(|k| draws.iter().map(|d| d[k]).sum::<f64>() / n);
        let moment = |a: usize, b: usize| draws.iter().map(|d| (d[a] - mean[a]) * (d[b] - mean[b])).sum::<f64>() / n;
        for k in [0, 1] {
            assert!((mean[k] - p.median[k].ln()).abs() < 0.03 * p.dispersion[k], "{mean:?}");
            assert!((moment(k, k).sqrt() / p.dispersion[k] - 1.0).abs() < 0.02);
        }
        assert!((moment(0, 1) / (moment(0, 0) * moment(1, 1)).sqrt() - p.correlation).abs() < 0.01);
        let below = draws.iter().filter(|d| d[0].exp() < p.range(0)[0]).count() as f64;
        assert!((below / n - 0.05).abs() < 0.005);
        assert!(p.check().is_ok() && Posterior { correlation: 2.0, ..p }.check().is_err());
    }
}

//! `frictionModel VelNormalFrcDep`.

use super::{Coefficient, FrictionLaw};

/// A coefficient that depends on speed and normal force N: μ_slow = a_slow N^(n_slow-1), μ_fast = a_fast N^(n_fast-1),
/// and the rate r = α₀ + α₁ N + α₂ N².
#[derive(Clone, Debug, PartialEq)]
pub struct VelNormalFrcDep {
    /// Factor of the slow friction force a_slow.
    pub a_slow: f64,
    /// Exponent of the slow friction force n_slow.
    pub n_slow: f64,
    /// Factor of the fast friction force a_fast.
    pub a_fast: f64,
    /// Exponent of the fast friction force n_fast.
    pub n_fast: f64,
    /// Coefficients α₀, α₁, α₂ of the rate; r has the unit time/length.
    pub alpha: [f64; 3],
    /// Largest coefficient as a multiple of the fast one.
    pub max_factor: f64,
}

impl FrictionLaw for VelNormalFrcDep {
    fn name(&self) -> &'static str {
        "VelNormalFrcDep"
    }
    fn coefficient(&self, normal: f64, speed: f64) -> Coefficient {
        let power = |a: f64, n: f64| [a * normal.powf(n - 1.0), a * (n - 1.0) * normal.powf(n - 2.0)];
        let (slow, fast) = (power(self.a_slow, self.n_slow), power(self.a_fast, self.n_fast));
        let [a0, a1, a2] = self.alpha;
        let rate = [a0 + a1 * normal + a2 * normal * normal, a1 + 2.0 * a2 * normal];
        let c = Coefficient::between(slow, fast, rate, speed);
        if c.mu > self.max_factor * fast[0] {
            let [mu, by_normal] = fast.map(|f| self.max_factor * f);
            return Coefficient { mu, by_normal, by_speed: 0.0 };
        }
        c
    }
}

//! `frictionModel VelPressureDep`.

use super::{Coefficient, FrictionLaw};

/// A coefficient that changes with the speed, and at high speed with the pressure N/A:
/// μ_fast = μ_fast0 - Δμ tanh(α N/A). Constantinou et al. (1996).
#[derive(Clone, Debug, PartialEq)]
pub struct VelPressureDep {
    /// Coefficient at rest μ_slow.
    pub slow: f64,
    /// Coefficient at high speed without pressure μ_fast0.
    pub fast: f64,
    /// Nominal contact area A.
    pub area: f64,
    /// Loss of the fast coefficient under high pressure Δμ.
    pub delta: f64,
    /// How fast it is lost with the pressure α, in 1/pressure.
    pub alpha: f64,
    /// Rate of the transition with the speed r, in time/length.
    pub rate: f64,
}

impl FrictionLaw for VelPressureDep {
    fn name(&self) -> &'static str {
        "VelPressureDep"
    }
    fn coefficient(&self, normal: f64, speed: f64) -> Coefficient {
        let t = (self.alpha * normal / self.area).tanh();
        let fast = [self.fast - self.delta * t, -self.delta * self.alpha / self.area * (1.0 - t * t)];
        Coefficient::between([self.slow, 0.0], fast, [self.rate, 0.0], speed)
    }
}

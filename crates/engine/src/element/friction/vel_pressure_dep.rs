//! `frictionModel VelPressureDep`.

use super::{Coefficient, FrictionLaw};

/// A coefficient that depends on the speed and, at high speed, on the pressure N/A: μ_fast = μ_fast0 - Δμ tanh(α N/A).
/// Source: Constantinou et al. (1996).
#[derive(Clone, Debug, PartialEq)]
pub struct VelPressureDep {
    /// Coefficient at zero speed μ_slow.
    pub slow: f64,
    /// Coefficient at high speed and zero pressure μ_fast0.
    pub fast: f64,
    /// Nominal contact area A.
    pub area: f64,
    /// Decrease Δμ of μ_fast at high pressure.
    pub delta: f64,
    /// Coefficient α of the pressure, 1/pressure.
    pub alpha: f64,
    /// Rate r of the speed, time/length.
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

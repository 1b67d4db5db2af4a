//! `frictionModel VelDependent`.

use super::{Coefficient, FrictionLaw};

/// A coefficient that depends on the speed v: μ = μ_fast - (μ_fast - μ_slow) exp(-r |v|). Source: Constantinou, Mokha
/// and Reinhorn (1990).
#[derive(Clone, Debug, PartialEq)]
pub struct VelDependent {
    /// Coefficient at zero speed μ_slow.
    pub slow: f64,
    /// Coefficient at high speed μ_fast.
    pub fast: f64,
    /// Rate r, time/length.
    pub rate: f64,
}

impl FrictionLaw for VelDependent {
    fn name(&self) -> &'static str {
        "VelDependent"
    }
    fn coefficient(&self, _: f64, speed: f64) -> Coefficient {
        Coefficient::between([self.slow, 0.0], [self.fast, 0.0], [self.rate, 0.0], speed)
    }
}

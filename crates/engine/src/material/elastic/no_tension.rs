//! Elastic no-tension material.

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw};

/// σ = E ε in compression, and σ = a E tanh(b ε) in tension (zero for a = 0).
#[derive(Clone, Debug, PartialEq)]
pub struct NoTension {
    /// Modulus in compression.
    pub e: f64,
    /// Largest tensile stress divided by the modulus, a.
    pub a: f64,
    /// Rate b of the tensile stress with the strain.
    pub b: f64,
}

impl UniaxialLaw for NoTension {
    type State = ();
    const NAME: &'static str = "ENT";

    #[inline]
    fn update(&self, _: &(), strain: Strain) -> MaterialResult<(Stress, ())> {
        let (e, x) = (self.e, strain.value);
        let tanh = if self.a == 0.0 { 0.0 } else { (x * self.b).tanh() };
        let value = if x < 0.0 { e * x } else { self.a * e * tanh };
        let tangent = if x <= 0.0 { e } else { self.a * e * self.b * (1.0 - tanh * tanh) };
        Ok((Stress { value, tangent, damping: 0.0 }, ()))
    }

    fn initial_tangent(&self) -> f64 {
        self.e
    }
}

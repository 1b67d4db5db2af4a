//! Elastic without tension.

use super::{MaterialError, Strain, Stress, UniaxialLaw};

/// σ = E ε in compression; in tension none, or a E tanh(b ε).
#[derive(Clone, Debug, PartialEq)]
pub struct NoTension {
    /// Modulus in compression.
    pub e: f64,
    /// Largest stress in tension as a part of the modulus.
    pub a: f64,
    /// How fast the stress in tension grows with the strain.
    pub b: f64,
}

impl UniaxialLaw for NoTension {
    type State = ();
    const NAME: &'static str = "ENT";

    #[inline]
    fn update(&self, _: &(), strain: Strain) -> Result<(Stress, ()), MaterialError> {
        let (e, x) = (self.e, strain.value);
        let tanh = if self.a == 0.0 { 0.0 } else { (x * self.b).tanh() };
        let value = if x < 0.0 { e * x } else { self.a * e * tanh };
        let tangent = if x <= 0.0 { e } else { self.a * e * self.b * (1.0 - tanh * tanh) };
        Ok((Stress { value, tangent, damping: 0.0 }, ()))
    }

    fn set_parameter(&mut self, name: &str, value: f64) -> Option<f64> {
        let place = match name {
            "E" => &mut self.e,
            "a" => &mut self.a,
            "b" => &mut self.b,
            _ => return None,
        };
        Some(std::mem::replace(place, value))
    }

    fn initial_tangent(&self) -> f64 {
        self.e
    }
}

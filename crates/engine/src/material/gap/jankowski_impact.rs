//! Pounding: Hertz contact with damping during approach.

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw};

/// Force K_h δⁿ + 2 ξ sqrt(K_h δⁿ⁻¹ m) δ̇ in compression while the contact depth δ increases. Otherwise the force is
/// K_h δⁿ (Jankowski, 2005, <https://doi.org/10.1002/eqe.434>). There is no damping without nodal velocities.
#[derive(Clone, Debug, PartialEq)]
pub struct JankowskiImpact {
    /// Contact stiffness K_h, force over displacement to the power of n.
    pub kh: f64,
    /// Impact damping ratio ξ.
    pub xi: f64,
    /// Effective mass m of the colliding bodies.
    pub mass: f64,
    /// Displacement at contact, negative or zero.
    pub gap: f64,
    /// Exponent n.
    pub n: f64,
    /// As in OpenSees, the tangent has the wrong sign and there is no damping tangent.
    pub compat: bool,
}

impl UniaxialLaw for JankowskiImpact {
    type State = ();
    const NAME: &'static str = "JankowskiImpact";

    fn update(&self, _: &(), strain: Strain) -> MaterialResult<(Stress, ())> {
        let depth = self.gap - strain.value;
        if depth <= 0.0 {
            return Ok(Default::default());
        }
        let power = depth.powf(self.n - 1.0);
        let mut s = Stress { value: -self.kh * power * depth, tangent: self.n * self.kh * power, damping: 0.0 };
        if strain.rate < 0.0 {
            s.damping = 2.0 * self.xi * (self.kh * power * self.mass).sqrt();
            s.value += s.damping * strain.rate;
            s.tangent -= 0.5 * (self.n - 1.0) * s.damping / depth * strain.rate;
        }
        if self.compat {
            (s.tangent, s.damping) = (-s.tangent, 0.0);
        }
        Ok((s, ()))
    }

    fn initial_tangent(&self) -> f64 {
        0.0
    }

    fn is_viscous(&self) -> bool {
        true
    }
}

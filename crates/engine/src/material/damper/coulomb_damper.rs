//! Spring and Coulomb friction side by side, the friction regularised by the rate.

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw};

/// Friction of constant size against the rate of deformation, and a spring.
#[derive(Clone, Debug, PartialEq)]
pub struct CoulombDamper {
    /// Stiffness of the spring.
    pub k: f64,
    /// Friction force.
    pub friction: f64,
    /// Rate below which the friction is proportional to the rate.
    pub slow: f64,
}

impl UniaxialLaw for CoulombDamper {
    type State = ();
    const NAME: &'static str = "CoulombDamper";

    fn update(&self, _: &(), strain: Strain) -> MaterialResult<(Stress, ())> {
        let (slope, rate) = (self.friction / self.slow, strain.rate);
        let (force, damping) =
            if rate.abs() < self.slow { (slope * rate, slope) } else { (self.friction.copysign(rate), 0.0) };
        Ok((Stress { value: self.k * strain.value + force, tangent: self.k, damping }, ()))
    }

    fn initial_tangent(&self) -> f64 {
        self.k
    }

    fn is_viscous(&self) -> bool {
        true
    }
}

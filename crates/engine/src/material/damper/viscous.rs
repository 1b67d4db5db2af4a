//! Nonlinear dashpot.

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw};

/// σ = C |ε̇|^α sign ε̇. There is no stiffness, and no force if the nodal velocities are zero (static analyses).
#[derive(Clone, Debug, PartialEq)]
pub struct Viscous {
    /// Damping coefficient C.
    pub c: f64,
    /// Velocity exponent α.
    pub alpha: f64,
    /// Rate below which the damping tangent is constant, since it is infinite at zero for α < 1.
    pub min_rate: f64,
}

impl UniaxialLaw for Viscous {
    type State = ();
    const NAME: &'static str = "Viscous";

    #[inline]
    fn update(&self, _: &(), strain: Strain) -> MaterialResult<(Stress, ())> {
        if self.alpha == 1.0 {
            // A shortcut without powers that gives the bits of the general case.
            return Ok((Stress { value: self.c * strain.rate, tangent: 0.0, damping: self.c }, ()));
        }
        let rate = strain.rate.abs();
        let value = (self.c * rate.powf(self.alpha)).copysign(self.c * strain.rate);
        let damping = self.alpha * self.c * rate.max(self.min_rate).powf(self.alpha - 1.0);
        Ok((Stress { value, tangent: 0.0, damping }, ()))
    }

    fn initial_tangent(&self) -> f64 {
        0.0
    }

    fn is_viscous(&self) -> bool {
        true
    }
}

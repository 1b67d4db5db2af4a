//! Viscous damping in parallel.

use super::{AmendedForce, AmendmentLaw, DeformationState};
use crate::element::ElementResult;

/// A dashpot f = c |ė|ⁿ sign(ė) in each direction. The rate ė is Δe over the increment of domain time, in static
/// analyses too. The force is 0 if no time passes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Damping {
    /// Coefficient c.
    pub coefficient: f64,
    /// Exponent n.
    pub power: f64,
}

/// Half width of the band of rates with a linear dashpot, length/time. Exponents below 1 have an infinite slope at zero
/// rate.
const LINEAR_RATE: f64 = 1e-9;

impl AmendmentLaw for Damping {
    type State = ();
    const NAME: &'static str = "damping";

    fn amend(&self, (): &(), d: &DeformationState) -> ElementResult<(AmendedForce, ())> {
        let mut v = AmendedForce::unchanged(d.q);
        if d.dt <= 0.0 {
            return Ok((v, ()));
        }
        for (i, de) in d.increment().into_iter().enumerate() {
            let rate = de / d.dt;
            // The linear band keeps the slope finite at zero rate.
            let speed = rate.abs().max(LINEAR_RATE);
            let secant = self.coefficient * speed.powf(self.power - 1.0);
            v.q[i] += secant * rate;
            let slope = if rate.abs() > LINEAR_RATE { self.power * secant } else { secant };
            v.by_deformation[i][i] = slope / d.dt;
        }
        Ok((v, ()))
    }

    fn depends_on_time(&self) -> bool {
        true
    }
}

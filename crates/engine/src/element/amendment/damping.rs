//! Viscous damping in parallel.

use super::{AmendedForce, AmendmentLaw, DeformationState};
use crate::element::ElementError;

/// A dashpot f = c |ė|ⁿ sign(ė) in each direction, with the rate of the deformation over domain time, in static
/// analyses too. Where no time passes there is no force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Damping {
    /// Coefficient c.
    pub coefficient: f64,
    /// Exponent n.
    pub power: f64,
}

/// Half width of the band of rates in which the dashpot is linear, length over time: a power below 1 has no slope at
/// rest.
const STILL: f64 = 1e-9;

impl AmendmentLaw for Damping {
    type State = ();
    const NAME: &'static str = "damping";

    fn amend(&self, (): &(), d: &DeformationState) -> Result<(AmendedForce, ()), ElementError> {
        let mut v = AmendedForce::unchanged(d.q);
        if d.dt <= 0.0 {
            return Ok((v, ()));
        }
        for (i, de) in d.increment().into_iter().enumerate() {
            let rate = de / d.dt;
            // Linear within a narrow band, so that there is a slope at rest.
            let speed = rate.abs().max(STILL);
            let secant = self.coefficient * speed.powf(self.power - 1.0);
            v.q[i] += secant * rate;
            let slope = if rate.abs() > STILL { self.power * secant } else { secant };
            v.by_deformation[i][i] = slope / d.dt;
        }
        Ok((v, ()))
    }

    fn depends_on_time(&self) -> bool {
        true
    }
}

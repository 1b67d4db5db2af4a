//! Temperature that differs from the reference temperature of the parameters.

use super::{AmendedForce, AmendmentLaw, DeformationState, Share, Weakening};
use crate::element::ElementResult;

/// s = exp(-b (T - T₀)). Stiffness and strength of rubber and lead fall about exponentially with the temperature. The
/// form is that of the temperature factors of the AASHTO guide specifications. For lead it is also that of Kalpakidis
/// and Constantinou, J. Struct. Eng. 135 (2009).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Temperature {
    /// Coefficient b, 1/temperature.
    pub softening: f64,
    /// Temperature T.
    pub at: f64,
    /// Reference temperature T₀ of the element's parameters.
    pub reference: f64,
    /// Parts of the force that s multiplies.
    pub share: Share,
}

impl Temperature {
    fn factor(&self) -> f64 {
        (-self.softening * (self.at - self.reference)).exp()
    }
}

impl AmendmentLaw for Temperature {
    type State = ();
    const NAME: &'static str = "temperature";

    fn amend(&self, (): &(), d: &DeformationState) -> ElementResult<(AmendedForce, ())> {
        Ok((self.share.scale(d, self.factor(), [0.0; 2], 0.0), ()))
    }

    fn weakening(&self, (): &()) -> Option<Weakening> {
        self.share.weakening(self.factor())
    }
}

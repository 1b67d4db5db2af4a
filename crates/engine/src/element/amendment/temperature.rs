//! Another temperature than the one that the parameters were found at.

use super::{AmendedForce, AmendmentLaw, DeformationState, Share, Weakening};
use crate::element::ElementError;

/// s = exp(-b (T - T₀)): stiffness and strength of rubber and lead fall about exponentially with the temperature
/// (the form of the temperature factors of the AASHTO guide specifications, and of Kalpakidis and Constantinou,
/// J. Struct. Eng. 135 (2009), for lead).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Temperature {
    /// Softening b per degree.
    pub softening: f64,
    /// Temperature T of the test.
    pub at: f64,
    /// Temperature T₀ that the parameters of the element belong to.
    pub reference: f64,
    /// What it acts on.
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

    fn amend(&self, (): &(), d: &DeformationState) -> Result<(AmendedForce, ()), ElementError> {
        Ok((self.share.scale(d, self.factor(), [0.0; 2], 0.0), ()))
    }

    fn weakening(&self, (): &()) -> Option<Weakening> {
        self.share.weakening(self.factor())
    }
}

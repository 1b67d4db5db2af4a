//! Another temperature than the one that the parameters were found at.

use super::{AmendmentLaw, Demand, Share, Verdict};
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

impl AmendmentLaw for Temperature {
    type State = ();
    const NAME: &'static str = "temperature";

    fn amend(&self, (): &(), d: &Demand) -> Result<(Verdict, ()), ElementError> {
        let s = (-self.softening * (self.at - self.reference)).exp();
        Ok((self.share.scale(d, s, [0.0; 2], 0.0), ()))
    }
}

//! Strength that follows the axial force, as that of a slider does.

use super::{AmendmentLaw, Demand, Share, Verdict};
use crate::element::ElementError;

/// s = (P / P₀)ᵖ with the compression P of the element; no force is left in tension. With the hysteretic part alone
/// ([`Share`]) and p = 1 this is Coulomb's law for the strength.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pressure {
    /// Compression P₀ that the parameters of the element belong to.
    pub reference: f64,
    /// Exponent p.
    pub power: f64,
    /// What it acts on.
    pub share: Share,
}

impl AmendmentLaw for Pressure {
    type State = ();
    const NAME: &'static str = "pressure";

    fn amend(&self, (): &(), d: &Demand) -> Result<(Verdict, ()), ElementError> {
        let ratio = d.axial / self.reference;
        if ratio <= 0.0 {
            return Ok((self.share.scale(d, 0.0, [0.0; 2], 0.0), ()));
        }
        let s = ratio.powf(self.power);
        Ok((self.share.scale(d, s, [0.0; 2], self.power * s / d.axial), ()))
    }
}

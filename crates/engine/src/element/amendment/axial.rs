//! Loss of lateral stiffness under axial load.

use super::{AmendedForce, AmendmentLaw, DeformationState, Share};
use crate::element::ElementError;

/// s = 1 - (P / P_cr)ᵖ with P_cr falling with the overlap of the plates, P_cr = P_cr0 (1 - |e| / D): the stiffness of
/// Koh and Kelly, Int. J. Mech. Sci. 29 (1987), near the critical load, with the reduced area as a share of the
/// plates that still overlap. A tensile force changes nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axial {
    /// Critical load P_cr0 at rest.
    pub critical: f64,
    /// Exponent p; 2 in the theory.
    pub power: f64,
    /// Width D of the plates; infinite where the critical load does not fall.
    pub width: f64,
    /// Compression, where the model does not carry it: `None` for the axial force of the element.
    pub load: Option<f64>,
    /// Compression at which the parameters of the element were found: s = 1 there, at rest.
    pub reference: f64,
    /// What it acts on.
    pub share: Share,
}

/// The factor stays above this: past the critical load, what is left is for the rest of the model to say.
const FLOOR: f64 = -1.0;

impl AmendmentLaw for Axial {
    type State = ();
    const NAME: &'static str = "axial";

    fn amend(&self, (): &(), d: &DeformationState) -> Result<(AmendedForce, ()), ElementError> {
        let p = self.load.unwrap_or(d.axial).max(0.0);
        let overlap = (1.0 - d.amplitude() / self.width).max(0.05);
        let ratio = p / (self.critical * overlap);
        let loss = ratio.powf(self.power);
        let at_reference = 1.0 - (self.reference / self.critical).powf(self.power);
        let s = (1.0 - loss) / at_reference;
        if s < FLOOR {
            return Ok((self.share.scale(d, FLOOR, [0.0; 2], 0.0), ()));
        }
        let by_amplitude =
            if overlap > 0.05 { -self.power * loss / (overlap * self.width * at_reference) } else { 0.0 };
        let by_axial = if self.load.is_none() && p > 0.0 { -self.power * loss / (p * at_reference) } else { 0.0 };
        Ok((self.share.scale(d, s, d.radial().map(|n| by_amplitude * n), by_axial), ()))
    }
}

//! Loss of lateral stiffness under axial load.

use super::{AmendedForce, AmendmentLaw, DeformationState, Share};
use crate::element::ElementResult;

/// s = (1 - (P / P_cr)ᵖ) / (1 - (P_ref / P_cr0)ᵖ) with the compression P. The critical load P_cr = P_cr0 (1 - |e| / D)
/// falls with the overlap of the plates. P = 0 in tension.
///
/// The stiffness near the critical load is that of Koh and Kelly, Int. J. Mech. Sci. 29 (1987). The reduced area is a
/// share of the overlapping part of the plates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axial {
    /// Critical load P_cr0 at zero deformation.
    pub critical: f64,
    /// Exponent p; 2 in the theory.
    pub power: f64,
    /// Width D of the plates; infinite for a constant critical load.
    pub width: f64,
    /// Prescribed compression; `None` for the axial force of the element.
    pub load: Option<f64>,
    /// Compression P_ref for which the parameters of the element were identified.
    pub reference: f64,
    /// Parts of the force that s multiplies.
    pub share: Share,
}

/// Lower bound of the factor. Beyond the critical load the response depends on the rest of the model.
const MIN_FACTOR: f64 = -1.0;
/// Lower bound of the overlap 1 - |e| / D, which keeps the critical load positive.
const MIN_OVERLAP: f64 = 0.05;

impl AmendmentLaw for Axial {
    type State = ();
    const NAME: &'static str = "axial";

    fn amend(&self, (): &(), d: &DeformationState) -> ElementResult<(AmendedForce, ())> {
        let p = self.load.unwrap_or(d.axial).max(0.0);
        let overlap = (1.0 - d.amplitude() / self.width).max(MIN_OVERLAP);
        let ratio = p / (self.critical * overlap);
        let loss = ratio.powf(self.power);
        let at_reference = 1.0 - (self.reference / self.critical).powf(self.power);
        let s = (1.0 - loss) / at_reference;
        if s < MIN_FACTOR {
            return Ok((self.share.scale(d, MIN_FACTOR, [0.0; 2], 0.0), ()));
        }
        let by_amplitude =
            if overlap > MIN_OVERLAP { -self.power * loss / (overlap * self.width * at_reference) } else { 0.0 };
        let by_axial = if self.load.is_none() && p > 0.0 { -self.power * loss / (p * at_reference) } else { 0.0 };
        Ok((self.share.scale(d, s, d.radial().map(|n| by_amplitude * n), by_axial), ()))
    }
}

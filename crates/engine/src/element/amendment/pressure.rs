//! Strength that follows the axial force, as that of a slider does.

use super::{AmendedForce, AmendmentLaw, DeformationState, Share};
use crate::element::ElementError;

/// s = (P / P₀)ᵖ with the compression P = N + c e of the element; no force is left in tension. With the hysteretic part alone
/// ([`Share`]) and p = 1 this is Coulomb's law for the strength. c is what the overturning that goes with the lateral motion adds to
/// the axial force N of the model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pressure {
    /// Compression P₀ that the parameters of the element belong to.
    pub reference: f64,
    /// Exponent p.
    pub power: f64,
    /// Compression c per deformation of the first direction, which the model does not have.
    pub lever: f64,
    /// Compression, where the model does not carry it: `None` for the axial force of the element.
    pub load: Option<f64>,
    /// What it acts on.
    pub share: Share,
}

impl AmendmentLaw for Pressure {
    type State = ();
    const NAME: &'static str = "pressure";

    fn amend(&self, (): &(), d: &DeformationState) -> Result<(AmendedForce, ()), ElementError> {
        let compression = self.load.unwrap_or(d.axial) + self.lever * d.e[0];
        if compression <= 0.0 {
            return Ok((self.share.scale(d, 0.0, [0.0; 2], 0.0), ()));
        }
        let s = (compression / self.reference).powf(self.power);
        let slope = self.power * s / compression;
        let by_axial = if self.load.is_none() { slope } else { 0.0 };
        Ok((self.share.scale(d, s, [self.lever * slope, 0.0], by_axial), ()))
    }
}

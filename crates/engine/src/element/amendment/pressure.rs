//! Strength proportional to a power of the axial force, as of a slider.

use super::{AmendedForce, AmendmentLaw, DeformationState, Share};
use crate::element::ElementResult;

/// s = (P / P₀)ᵖ with the compression P = N + c e; s = 0 in tension. With the hysteretic part alone ([`Share`]) and p =
/// 1, the strength obeys Coulomb's law. The term c e is the axial force from overturning, which N, the axial force of
/// the model, may lack.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pressure {
    /// Compression P₀ for which the parameters of the element were identified.
    pub reference: f64,
    /// Exponent p.
    pub power: f64,
    /// Axial force c per deformation of the first direction, from overturning.
    pub lever: f64,
    /// Prescribed compression N; `None` for the axial force of the element.
    pub load: Option<f64>,
    /// Parts of the force that s multiplies.
    pub share: Share,
}

impl AmendmentLaw for Pressure {
    type State = ();
    const NAME: &'static str = "pressure";

    fn amend(&self, (): &(), d: &DeformationState) -> ElementResult<(AmendedForce, ())> {
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

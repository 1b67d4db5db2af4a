//! Pinching: slip or crack closing narrows the loops close to zero deformation.

use super::{AmendedForce, AmendmentLaw, DeformationState, Share};
use crate::element::ElementResult;

/// s = 1 - depth exp(-(|e| / (width (e_max - onset)))²) for e_max > onset, otherwise 1. The largest deformation e_max
/// is that of the committed state. The shape is that of the slip-lock element of Baber and Noori, J. Eng. Mech. 111
/// (1985), as a factor of the force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pinching {
    /// Part of the force that is lost at zero deformation, 0 to 1.
    pub depth: f64,
    /// Width of the pinched range, as a part of e_max - onset.
    pub width: f64,
    /// Deformation beyond which pinching begins.
    pub onset: f64,
    /// Parts of the force that s multiplies.
    pub share: Share,
}

crate::state_struct! {
    /// State variables.
    pub struct PinchingState {
        /// Largest deformation so far.
        largest: f64,
    }
}

impl AmendmentLaw for Pinching {
    type State = PinchingState;
    const NAME: &'static str = "pinching";

    fn amend(&self, committed: &PinchingState, d: &DeformationState) -> ElementResult<(AmendedForce, PinchingState)> {
        let r = d.amplitude();
        let largest = committed.largest.max(r);
        // Pinching depends on earlier damage, so the committed peak is used.
        let peak_beyond_onset = committed.largest - self.onset;
        if peak_beyond_onset <= 0.0 {
            return Ok((AmendedForce::unchanged(d.q), PinchingState { largest }));
        }
        let width = self.width * peak_beyond_onset;
        let reduction = self.depth * (-(r / width).powi(2)).exp();
        let slope = 2.0 * r / (width * width) * reduction;
        Ok((self.share.scale(d, 1.0 - reduction, d.radial().map(|n| slope * n), 0.0), PinchingState { largest }))
    }
}

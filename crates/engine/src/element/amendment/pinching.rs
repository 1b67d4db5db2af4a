//! Pinching: slip or crack closing thins the loops near zero.

use super::{AmendedForce, AmendmentLaw, DeformationState, Share};
use crate::element::ElementError;

/// s = 1 - depth exp(-(|e| / (width e_max))²), once the deformation has been larger than `onset`: the slip-lock shape
/// of Baber and Noori, J. Eng. Mech. 111 (1985), as a factor of the force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pinching {
    /// Part of the force that is missing at zero deformation, 0 to 1.
    pub depth: f64,
    /// Width of the slack, as a part of the largest deformation so far.
    pub width: f64,
    /// Deformation from which there is slack.
    pub onset: f64,
    /// What it acts on.
    pub share: Share,
}

crate::state_struct! {
    /// History.
    pub struct Slack {
        /// Largest deformation so far.
        largest: f64,
    }
}

impl AmendmentLaw for Pinching {
    type State = Slack;
    const NAME: &'static str = "pinching";

    fn amend(&self, committed: &Slack, d: &DeformationState) -> Result<(AmendedForce, Slack), ElementError> {
        let r = d.amplitude();
        let largest = committed.largest.max(r);
        // Slack is what was opened before: the committed deformation counts.
        let opened = committed.largest - self.onset;
        if opened <= 0.0 {
            return Ok((AmendedForce::unchanged(d.q), Slack { largest }));
        }
        let width = self.width * opened;
        let missing = self.depth * (-(r / width).powi(2)).exp();
        let slope = 2.0 * r / (width * width) * missing;
        Ok((self.share.scale(d, 1.0 - missing, d.radial().map(|n| slope * n), 0.0), Slack { largest }))
    }
}

//! Strength lost with accumulated damage.

use super::{AmendedForce, AmendmentLaw, DeformationState, Share, Weakening};
use crate::element::ElementResult;

/// s = 1 - loss (1 - exp(-E / E₀)), where E is the absolute work of the hysteretic part. The damage index of Park and
/// Ang, J. Struct. Eng. 111 (1985), also sums the energy without sign.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Degradation {
    /// Part of the force that is lost for E → ∞.
    pub loss: f64,
    /// Energy E₀ at which 63 % of `loss` is reached.
    pub energy: f64,
    /// Parts of the force that s multiplies.
    pub share: Share,
}

crate::state_struct! {
    /// State variables.
    pub struct DegradationState {
        /// Accumulated energy E.
        energy: f64,
    }
}

impl Degradation {
    /// Factor s at the energy E.
    fn factor(&self, energy: f64) -> f64 {
        1.0 - self.loss * (1.0 - (-energy / self.energy).exp())
    }
}

impl AmendmentLaw for Degradation {
    type State = DegradationState;
    const NAME: &'static str = "degradation";

    fn amend(
        &self,
        committed: &DegradationState,
        d: &DeformationState,
    ) -> ElementResult<(AmendedForce, DegradationState)> {
        let work = self.share.work(d);
        let energy = committed.energy + work.abs();
        let slope = -self.loss * (-energy / self.energy).exp() / self.energy * work.signum();
        Ok((self.share.scale_by_work(d, self.factor(energy), slope, [0.0; 2]), DegradationState { energy }))
    }

    fn weakening(&self, committed: &DegradationState) -> Option<Weakening> {
        self.share.weakening(self.factor(committed.energy))
    }
}

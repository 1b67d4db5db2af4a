//! Mullins softening (scragging): rubber is stiffer at first loading to a strain than at reloading.

use super::{AmendedForce, AmendmentLaw, DeformationState, Share};
use crate::element::ElementResult;
use crate::material::{Peak, Softening};
use crate::numeric::Dual;

/// The softening of the material `Mullins` around an element, as a function of |e|. Parameters of a model usually
/// belong to the scragged state; first loading is stiffer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mullins {
    /// The law, with deformations in place of strains.
    pub softening: Softening,
    /// Parts of the force that the law multiplies.
    pub share: Share,
}

crate::state_struct! {
    /// State variables.
    pub struct MullinsState {
        /// Largest deformation, less the recovered part.
        largest: f64,
        /// Largest deformation without recovery.
        ever: f64,
    }
}

impl AmendmentLaw for Mullins {
    type State = MullinsState;
    const NAME: &'static str = "mullins";

    fn amend(&self, committed: &MullinsState, d: &DeformationState) -> ElementResult<(AmendedForce, MullinsState)> {
        let size = Dual { value: d.amplitude(), slope: 1.0 };
        let old = Peak { now: Dual::constant(committed.largest), ever: committed.ever };
        let peak = self.softening.advance(old, size, d.dt.abs());
        let factor = self.softening.factor_at(peak.now, size);
        let slopes = d.radial().map(|n| factor.slope * n);
        let memory = MullinsState { largest: peak.now.value, ever: peak.ever };
        Ok((self.share.scale(d, factor.value, slopes, 0.0), memory))
    }

    fn depends_on_time(&self) -> bool {
        self.softening.healed > 0.0
    }
}

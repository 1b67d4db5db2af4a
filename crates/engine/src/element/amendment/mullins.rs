//! Mullins softening (scragging): rubber is stiffer on its first way to a strain than on the next.

use super::{AmendedForce, AmendmentLaw, DeformationState, Share};
use crate::element::ElementError;
use crate::material::{Peak, Softening};
use crate::numeric::Dual;

/// The softening of the material `Mullins` by the size of the deformation, around an element. The parameters of a model
/// are usually those of the scragged state; the virgin path is stiffer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mullins {
    /// The law, with deformations for strains.
    pub softening: Softening,
    /// What it acts on.
    pub share: Share,
}

crate::state_struct! {
    /// History.
    pub struct Memory {
        /// Largest deformation so far, less what has healed.
        largest: f64,
        /// Largest deformation ever.
        ever: f64,
    }
}

impl AmendmentLaw for Mullins {
    type State = Memory;
    const NAME: &'static str = "mullins";

    fn amend(&self, committed: &Memory, d: &DeformationState) -> Result<(AmendedForce, Memory), ElementError> {
        let size = Dual { value: d.amplitude(), slope: 1.0 };
        let old = Peak { now: Dual::constant(committed.largest), ever: committed.ever };
        let peak = self.softening.advance(old, size, d.dt.abs());
        let factor = self.softening.factor_at(peak.now, size);
        let slopes = d.radial().map(|n| factor.slope * n);
        let memory = Memory { largest: peak.now.value, ever: peak.ever };
        Ok((self.share.scale(d, factor.value, slopes, 0.0), memory))
    }

    fn depends_on_time(&self) -> bool {
        self.softening.healed > 0.0
    }
}

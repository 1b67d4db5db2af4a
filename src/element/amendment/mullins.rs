//! Mullins softening (scragging): rubber is stiffer on its first way to a strain than on the next.

use super::{AmendmentLaw, Demand, Share, Verdict};
use crate::element::ElementError;

/// Pseudo-elastic softening below the largest deformation so far, after Ogden and Roxburgh, Proc. R. Soc. A 455
/// (1999), in terms of the amplitude: with x = |e| / e_max,
///
/// s = 1 + virgin (1 - (1 - exp(-e_max / e₀)) (1 - xᵖ)) below e_max, 1 + virgin on the virgin path.
///
/// The parameters of a model are usually those of the scragged state; the virgin path is then stiffer by the factor
/// 1 + `virgin`, and a path below the largest deformation so far loses this excess as xᵖ. The largest deformation
/// heals with the time constant `healing`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mullins {
    /// Excess of the virgin force over the scragged one, as a part of it.
    pub virgin: f64,
    /// Exponent p of the way back to the virgin path.
    pub power: f64,
    /// Deformation e₀ by which softening has begun: below it rubber does not soften.
    pub onset: f64,
    /// Time constant of healing; infinite where it does not heal.
    pub healing: f64,
    /// What it acts on.
    pub share: Share,
}

crate::words! {
    /// History.
    pub struct Memory {
        /// Largest deformation so far, less what has healed.
        largest: f64,
    }
}

impl AmendmentLaw for Mullins {
    type State = Memory;
    const NAME: &'static str = "mullins";

    fn amend(&self, committed: &Memory, d: &Demand) -> Result<(Verdict, Memory), ElementError> {
        let r = d.amplitude();
        let remembered = committed.largest / (1.0 + d.dt / self.healing);
        if r >= remembered {
            return Ok((self.share.scale(d, 1.0 + self.virgin, [0.0; 2], 0.0), Memory { largest: r }));
        }
        // How far softening has come at this largest deformation: none of it in rubber that has hardly moved.
        let begun = 1.0 - (-remembered / self.onset).exp();
        let x = r / remembered;
        let back = x.powf(self.power);
        let s = 1.0 + self.virgin * (1.0 - begun * (1.0 - back));
        let slope = if r > 0.0 { self.virgin * begun * self.power * back / r } else { 0.0 };
        Ok((self.share.scale(d, s, d.radial().map(|n| slope * n), 0.0), Memory { largest: remembered }))
    }

    fn depends_on_time(&self) -> bool {
        self.healing.is_finite()
    }
}

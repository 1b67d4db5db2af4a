//! Self-heating: dissipated work warms the device and softens it.

use super::{AmendmentLaw, Demand, Share, Verdict};
use crate::element::ElementError;

/// Temperature rise θ by the work of the hysteretic part, dθ = dW / C - θ dt / τ, and the factor s = exp(-b θ):
/// a lumped form of Kalpakidis and Constantinou, J. Struct. Eng. 135 (2009).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Heating {
    /// Softening b per degree.
    pub softening: f64,
    /// Heat capacity C, work per degree.
    pub capacity: f64,
    /// Cooling time τ; infinite where no heat is lost.
    pub cooling: f64,
    /// What it acts on.
    pub share: Share,
}

crate::words! {
    /// History.
    pub struct Warmth {
        /// Temperature rise θ.
        rise: f64,
    }
}

impl AmendmentLaw for Heating {
    type State = Warmth;
    const NAME: &'static str = "heating";

    fn amend(&self, committed: &Warmth, d: &Demand) -> Result<(Verdict, Warmth), ElementError> {
        // Cooling implicitly: stable for any step. The work is that of the softened force of the step before, so that
        // the energy account closes to first order in the step.
        let keep = 1.0 / (1.0 + d.dt / self.cooling);
        let now = (-self.softening * committed.rise).exp();
        let heated = committed.rise + now * self.share.work(d) / self.capacity;
        // Unloading gives work back: below the surroundings it never gets.
        let (rise, slope) = if heated > 0.0 { (keep * heated, keep * now / self.capacity) } else { (0.0, 0.0) };
        let s = (-self.softening * rise).exp();
        let verdict = self.share.scale_by_work(d, s, -self.softening * s * slope);
        Ok((verdict, Warmth { rise }))
    }

    fn depends_on_time(&self) -> bool {
        self.cooling.is_finite()
    }
}

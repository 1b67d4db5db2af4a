//! Tensile cavitation of rubber and its damage.

use super::{AmendmentLaw, Demand, Verdict};
use crate::element::ElementError;

/// Tension of the axial direction is limited to the cavitation strength F_c; each larger extension lowers the
/// strength of the next pull, F_cn = F_c (1 - φ), φ = φ_max (1 - exp(-a (u_max - u_c) / u_c)): Kumar, Whittaker and
/// Constantinou, Earthquake Eng. Struct. Dyn. 43 (2014), without the hardening after cavitation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cavitation {
    /// Cavitation strength F_c.
    pub strength: f64,
    /// Extension u_c at which it is reached first.
    pub extension: f64,
    /// Part φ_max of the strength that is lost in the end.
    pub damage: f64,
    /// Rate a of the loss.
    pub rate: f64,
}

crate::words! {
    /// History.
    pub struct Cavities {
        /// Largest extension so far.
        largest: f64,
    }
}

impl AmendmentLaw for Cavitation {
    type State = Cavities;
    const NAME: &'static str = "cavitation";

    fn amend(&self, committed: &Cavities, d: &Demand) -> Result<(Verdict, Cavities), ElementError> {
        let u = d.e[0];
        let largest = committed.largest.max(u);
        let past = ((committed.largest - self.extension) / self.extension).max(0.0);
        let lost = self.strength * self.damage * (1.0 - (-self.rate * past).exp());
        // Beyond the largest extension the strength comes back to that of whole rubber, over one u_c.
        let new = ((u - committed.largest) / self.extension).clamp(0.0, 1.0);
        let limit = self.strength - lost * (1.0 - new);
        let mut v = Verdict::unchanged(d.q);
        if d.q[0] > limit {
            v.q[0] = limit;
            v.by_force[0][0] = 0.0;
            v.by_deformation[0][0] = if (0.0..1.0).contains(&new) && new > 0.0 { lost / self.extension } else { 0.0 };
        }
        Ok((v, Cavities { largest }))
    }
}

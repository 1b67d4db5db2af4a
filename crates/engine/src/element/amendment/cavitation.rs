//! Tensile cavitation of rubber and its damage.

use super::{AmendedForce, AmendmentLaw, DeformationState, Share};
use crate::element::ElementError;

/// Tension of a direction follows an envelope beyond the cavitation strength F_c, reached at the extension u_c,
///
/// F = F_c (1 + rise (1 - exp(-(u - u_c) / reach))),
///
/// and each larger extension lowers the strength of the next pull, F_cn = F_c (1 - φ) at u_cn = u_c (1 - φ) with
/// φ = φ_max (1 - exp(-a (u_max - u_c) / u_c)); from there it goes straight to the envelope at u_max: Kumar, Whittaker
/// and Constantinou, Earthquake Eng. Struct. Dyn. 43 (2014), with `rise` for their 1 / (k T_r) and `reach` for 1 / k.
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
    /// What the envelope gains far beyond u_c, as a part of F_c.
    pub rise: f64,
    /// Extension over which it gains 63 % of that.
    pub reach: f64,
    /// Sign of the deformation that is tension.
    pub sign: f64,
    /// The limit concerns the elastic part, where there is one; otherwise the whole force.
    pub share: Share,
}

impl Cavitation {
    /// The envelope and its slope.
    fn envelope(&self, u: f64) -> (f64, f64) {
        let left = (-(u - self.extension).max(0.0) / self.reach).exp();
        let slope = if u > self.extension { self.strength * self.rise * left / self.reach } else { 0.0 };
        (self.strength * (1.0 + self.rise * (1.0 - left)), slope)
    }

    /// Limit of the tension at an extension, and its slope, after a largest one.
    fn limit(&self, u: f64, largest: f64) -> (f64, f64) {
        if u >= largest || largest <= self.extension {
            return self.envelope(u);
        }
        let past = (largest - self.extension) / self.extension;
        let kept = 1.0 - self.damage * (1.0 - (-self.rate * past).exp());
        let (from, to) = (kept * self.extension, self.envelope(largest).0);
        let slope = (to - kept * self.strength) / (largest - from);
        if u > from { (kept * self.strength + slope * (u - from), slope) } else { (f64::INFINITY, 0.0) }
    }
}

crate::state_struct! {
    /// History.
    pub struct Cavities {
        /// Largest extension so far.
        largest: f64,
    }
}

impl AmendmentLaw for Cavitation {
    type State = Cavities;
    const NAME: &'static str = "cavitation";

    fn amend(&self, committed: &Cavities, d: &DeformationState) -> Result<(AmendedForce, Cavities), ElementError> {
        let u = self.sign * d.e[0];
        let (limit, slope) = self.limit(u, committed.largest);
        let mut v = AmendedForce::unchanged(d.q);
        let k = self.share.stiffness;
        if k > 0.0 {
            if k * u > limit {
                v.q[0] += self.sign * (limit - k * u);
                v.by_deformation[0][0] = slope - k;
            }
        } else if self.sign * d.q[0] > limit {
            v.q[0] = self.sign * limit;
            v.by_force[0][0] = 0.0;
            v.by_deformation[0][0] = slope;
        }
        Ok((v, Cavities { largest: committed.largest.max(u) }))
    }
}

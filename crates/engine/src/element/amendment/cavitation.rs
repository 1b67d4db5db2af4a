//! Tensile cavitation of rubber and its damage.

use super::{AmendedForce, AmendmentLaw, DeformationState, Share};
use crate::element::ElementResult;

/// In tension the force of a direction has an envelope beyond the cavitation strength F_c, which is reached at the
/// extension u_c,
///
/// F = F_c (1 + rise (1 - exp(-(u - u_c) / reach))).
///
/// Damage φ = φ_max (1 - exp(-a (u_max - u_c) / u_c)) grows with the largest extension u_max. The strength of the next
/// tensile cycle is F_cn = F_c (1 - φ), at the extension u_cn = u_c (1 - φ). From there the force is linear up to the
/// envelope at u_max. Source: Kumar, Whittaker and Constantinou, Earthquake Eng. Struct. Dyn. 43 (2014), with `rise`
/// for their 1 / (k T_r) and `reach` for 1 / k.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cavitation {
    /// Cavitation strength F_c.
    pub strength: f64,
    /// Extension u_c at the cavitation strength.
    pub extension: f64,
    /// Largest damage φ_max, as a part of the strength.
    pub damage: f64,
    /// Rate a of the damage.
    pub rate: f64,
    /// Increase of the envelope from u_c to infinity, as a part of F_c.
    pub rise: f64,
    /// Extension over which the envelope gains 63 % of `rise`.
    pub reach: f64,
    /// Sign of a tensile deformation.
    pub sign: f64,
    /// Split of the force: the strength limits the elastic part if there is one, otherwise the whole force.
    pub share: Share,
}

impl Cavitation {
    /// Envelope and its slope at the extension `u`.
    fn envelope(&self, u: f64) -> (f64, f64) {
        let decay = (-(u - self.extension).max(0.0) / self.reach).exp();
        let slope = if u > self.extension { self.strength * self.rise * decay / self.reach } else { 0.0 };
        (self.strength * (1.0 + self.rise * (1.0 - decay)), slope)
    }

    /// Largest tensile force at the extension `u`, and its slope, after the extension `largest`.
    fn limit(&self, u: f64, largest: f64) -> (f64, f64) {
        if u >= largest || largest <= self.extension {
            return self.envelope(u);
        }
        let beyond_cavitation = (largest - self.extension) / self.extension;
        let strength_ratio = 1.0 - self.damage * (1.0 - (-self.rate * beyond_cavitation).exp());
        let (from, to) = (strength_ratio * self.extension, self.envelope(largest).0);
        let slope = (to - strength_ratio * self.strength) / (largest - from);
        if u > from { (strength_ratio * self.strength + slope * (u - from), slope) } else { (f64::INFINITY, 0.0) }
    }
}

crate::state_struct! {
    /// State variables.
    pub struct CavitationState {
        /// Largest extension so far.
        largest: f64,
    }
}

impl AmendmentLaw for Cavitation {
    type State = CavitationState;
    const NAME: &'static str = "cavitation";

    fn amend(
        &self,
        committed: &CavitationState,
        d: &DeformationState,
    ) -> ElementResult<(AmendedForce, CavitationState)> {
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
        Ok((v, CavitationState { largest: committed.largest.max(u) }))
    }
}

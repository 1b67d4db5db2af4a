//! Elastic-plastic gap spring.

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw};

/// A spring that acts in one direction after a gap has closed. Plastic deformation widens the gap. Without
/// accumulated damage, unloading through the open gap restores it.
#[derive(Clone, Debug, PartialEq)]
pub struct ElasticPPGap {
    /// Modulus.
    pub e: f64,
    /// Yield stress: positive for a spring in tension, negative in compression.
    pub fy: f64,
    /// Strain at which the gap closes.
    pub gap: f64,
    /// Hardening ratio, less than 1.
    pub eta: f64,
    /// Accumulated damage: the widened gap stays open.
    pub damage: bool,
}

crate::state_struct! {
    /// History of [`ElasticPPGap`].
    pub struct Shift {
        /// Shift of the strain at yield.
        yielding: f64,
        /// Shift of the strain at which the gap closes.
        contact: f64,
    }
}

impl UniaxialLaw for ElasticPPGap {
    type State = Shift;
    const NAME: &'static str = "ElasticPPGap";

    fn update(&self, c: &Shift, strain: Strain) -> MaterialResult<(Stress, Shift)> {
        let (e, fy, gap, eta, x) = (self.e, self.fy, self.gap, self.eta, strain.value);
        let s = if fy >= 0.0 { 1.0 } else { -1.0 };
        let (first_yield, contact) = (fy / e + gap, gap + c.contact);
        let mut t = *c;
        let (value, tangent) = if s * x > s * (first_yield + c.yielding) {
            let value = fy + (x - gap - fy / e) * eta * e;
            t.yielding = x - first_yield;
            t.contact = x - value / e - gap;
            (value, eta * e)
        } else if s * x < s * contact {
            if s * x > s * gap && !self.damage {
                t.yielding = (x - eta * gap) / (1.0 - eta) + fy / e - first_yield;
                t.contact = x - gap;
            }
            (0.0, 0.0)
        } else {
            (e * (x - contact), e)
        };
        Ok((Stress { value, tangent, damping: 0.0 }, t))
    }

    fn initial_tangent(&self) -> f64 {
        let open = if self.fy >= 0.0 { self.gap > 0.0 } else { self.gap < 0.0 };
        if open { 0.0 } else { self.e }
    }
}

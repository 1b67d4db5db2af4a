//! Hardening at large deformation.

use super::{AmendedForce, AmendmentLaw, DeformationState, Pair};
use crate::element::ElementResult;

/// An elastic force in parallel: factor (|e| - from)ᵖ along e, if |e| > `from`. Filled rubber stiffens by the finite
/// extensibility of its chains.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stiffening {
    /// Force at a deformation of `from` plus one unit of length.
    pub factor: f64,
    /// Deformation at which stiffening begins.
    pub from: f64,
    /// Exponent p, at least 1.
    pub power: f64,
}

impl AmendmentLaw for Stiffening {
    type State = ();
    const NAME: &'static str = "stiffening";

    fn amend(&self, (): &(), d: &DeformationState) -> ElementResult<(AmendedForce, ())> {
        let r = d.amplitude();
        let beyond = r - self.from;
        let mut v = AmendedForce::unchanged(d.q);
        if beyond > 0.0 {
            let force = self.factor * beyond.powf(self.power);
            let slope = self.factor * self.power * beyond.powf(self.power - 1.0);
            v = add_radial(v, d.radial(), force, slope, r);
        }
        Ok((v, ()))
    }
}

/// Adds a force along the deformation of size r, with the slope d(force)/d|e|.
fn add_radial(mut v: AmendedForce, n: Pair, force: f64, slope: f64, r: f64) -> AmendedForce {
    for i in 0..2 {
        v.q[i] += force * n[i];
        for j in 0..2 {
            let unit = f64::from(u8::from(i == j));
            v.by_deformation[i][j] += slope * n[i] * n[j] + force / r * (unit - n[i] * n[j]);
        }
    }
    v
}

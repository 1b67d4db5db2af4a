//! A member taken as elastic yields, and reloads towards its largest deformation, as reinforced concrete does.

use super::{AmendedForce, AmendmentLaw, DeformationState};
use crate::element::ElementError;

/// Elastic with stiffness k up to the yield force F_y, then b k; unloading with k (e_y/e_max)^a, where e_max is the largest
/// deformation on the side that it comes from; where the force has passed zero, towards the largest deformation on the side
/// that it goes to. Clough and Johnston (2nd Japan Earthquake Engineering Symposium, 1966) for a = 0, with the unloading stiffness of
/// Takeda, Sozen and Nielsen (J. Struct. Div. 96, 1970). The force k e of the element is replaced, each direction by itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PeakOriented {
    /// Yield force F_y.
    pub force: f64,
    /// Elastic stiffness k of the element in this direction.
    pub stiffness: f64,
    /// Hardening ratio b, 0 to below 1.
    pub hardening: f64,
    /// Exponent a of the unloading stiffness.
    pub unloading: f64,
}

crate::state_struct! {
    /// History.
    pub struct Reached {
        /// Force in the place of k e.
        force: [f64; 2],
        /// Largest deformation so far.
        most: [f64; 2],
        /// Smallest one.
        least: [f64; 2],
    }
}

impl PeakOriented {
    /// Deformation e_y at which it yields.
    fn yields_at(&self) -> f64 {
        self.force / self.stiffness
    }

    /// Force on the virgin path beyond e_y.
    fn envelope(&self, e: f64) -> f64 {
        self.force + self.hardening * self.stiffness * (e - self.yields_at())
    }

    /// Force and its derivative at a larger deformation `e`, from `start` with the force `f`; `most` is the largest
    /// deformation so far, `behind` the distance of the largest on the other side.
    fn onward(&self, e: f64, start: f64, f: f64, most: f64, behind: f64) -> (f64, f64) {
        let k = self.stiffness;
        let (mut x, mut y) = (start, f);
        if y < 0.0 {
            let unloading = k * (self.yields_at() / behind.max(self.yields_at())).powf(self.unloading);
            let zero = x - y / unloading;
            if e <= zero {
                return (y + unloading * (e - x), unloading);
            }
            (x, y) = (zero, 0.0);
        }
        let top = most.max(self.yields_at());
        let secant = if top > x { (self.envelope(top) - y) / (top - x) } else { k };
        let slope = secant.min(k);
        let along = y + slope * (e - x);
        // Not stiffer than elastic, where the largest deformation is near.
        if e >= top && along >= self.envelope(e) { (self.envelope(e), self.hardening * k) } else { (along, slope) }
    }
}

impl AmendmentLaw for PeakOriented {
    type State = Reached;
    const NAME: &'static str = "peakOriented";

    fn amend(&self, c: &Reached, d: &DeformationState) -> Result<(AmendedForce, Reached), ElementError> {
        let (mut v, mut next) = (AmendedForce::unchanged(d.q), *c);
        for i in 0..2 {
            let (e, before) = (d.e[i], d.before[i]);
            let (force, slope) = if e >= before {
                self.onward(e, before, c.force[i], c.most[i], -c.least[i])
            } else {
                let (force, slope) = self.onward(-e, -before, -c.force[i], -c.least[i], c.most[i]);
                (-force, slope)
            };
            v.q[i] += force - self.stiffness * e;
            v.by_deformation[i][i] = slope - self.stiffness;
            (next.force[i], next.most[i], next.least[i]) = (force, c.most[i].max(e), c.least[i].min(e));
        }
        Ok((v, next))
    }

    fn with_stiffness(&self, stiffness: f64) -> Option<Self> {
        Some(Self { stiffness, ..*self })
    }
}

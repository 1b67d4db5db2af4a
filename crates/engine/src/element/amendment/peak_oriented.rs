//! Yielding of an elastic member with peak-oriented reloading, as in reinforced concrete.

use super::{AmendedForce, AmendmentLaw, DeformationState};
use crate::element::ElementResult;

/// Stiffness k up to the yield force F_y, then b k. The unloading stiffness is k (e_y/e_max)^a, where e_max is the
/// largest deformation on the side of unloading. After the force has changed its sign, reloading aims at the largest
/// deformation on the other side. The law replaces the force k e of the element, separately in each direction.
///
/// Sources: Clough and Johnston (2nd Japan Earthquake Engineering Symposium, 1966) for a = 0; unloading stiffness by
/// Takeda, Sozen and Nielsen (J. Struct. Div. 96, 1970).
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
    /// State variables.
    pub struct PeakOrientedState {
        /// Force that replaces k e.
        force: [f64; 2],
        /// Largest deformation.
        peak: [f64; 2],
        /// Smallest deformation.
        trough: [f64; 2],
    }
}

impl PeakOriented {
    /// Yield deformation e_y.
    fn yield_deformation(&self) -> f64 {
        self.force / self.stiffness
    }

    /// Force at first loading beyond e_y.
    fn envelope(&self, e: f64) -> f64 {
        self.force + self.hardening * self.stiffness * (e - self.yield_deformation())
    }

    /// Force and its derivative at a larger deformation `e`, from `start` with the force `f`. `peak` is the largest
    /// deformation so far, `opposite` the size of the largest one of the other sign.
    fn reload(&self, e: f64, start: f64, f: f64, peak: f64, opposite: f64) -> (f64, f64) {
        let k = self.stiffness;
        let (mut x, mut y) = (start, f);
        if y < 0.0 {
            let unloading =
                k * (self.yield_deformation() / opposite.max(self.yield_deformation())).powf(self.unloading);
            let zero = x - y / unloading;
            if e <= zero {
                return (y + unloading * (e - x), unloading);
            }
            (x, y) = (zero, 0.0);
        }
        let target = peak.max(self.yield_deformation());
        let secant = if target > x { (self.envelope(target) - y) / (target - x) } else { k };
        let slope = secant.min(k);
        let reloading = y + slope * (e - x);
        // The reloading stiffness is at most k, also close to the peak.
        if e >= target && reloading >= self.envelope(e) {
            (self.envelope(e), self.hardening * k)
        } else {
            (reloading, slope)
        }
    }
}

impl AmendmentLaw for PeakOriented {
    type State = PeakOrientedState;
    const NAME: &'static str = "peakOriented";

    fn amend(&self, c: &PeakOrientedState, d: &DeformationState) -> ElementResult<(AmendedForce, PeakOrientedState)> {
        let (mut v, mut next) = (AmendedForce::unchanged(d.q), *c);
        for i in 0..2 {
            let (e, before) = (d.e[i], d.before[i]);
            let (force, slope) = if e >= before {
                self.reload(e, before, c.force[i], c.peak[i], -c.trough[i])
            } else {
                let (force, slope) = self.reload(-e, -before, -c.force[i], -c.trough[i], c.peak[i]);
                (-force, slope)
            };
            v.q[i] += force - self.stiffness * e;
            v.by_deformation[i][i] = slope - self.stiffness;
            (next.force[i], next.peak[i], next.trough[i]) = (force, c.peak[i].max(e), c.trough[i].min(e));
        }
        Ok((v, next))
    }

    fn with_stiffness(&self, stiffness: f64) -> Option<Self> {
        Some(Self { stiffness, ..*self })
    }
}

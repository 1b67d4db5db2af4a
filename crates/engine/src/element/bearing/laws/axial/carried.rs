//! The axial law short of cavitation, of one bearing or of several side by side.

use super::{Axial, AxialStep, BUCKLED_STIFFNESS_RATIO};
use crate::element::bearing::kinematics::overlap::overlap;
use crate::numeric::real::Real;

/// Least ratio of the critical load to that at zero shear displacement.
const MIN_CRITICAL_RATIO: f64 = 0.2;

/// Numbers of the law.
#[derive(Debug)]
pub(super) struct Numbers<T = f64> {
    /// Axial stiffness without shear.
    pub(super) axial: T,
    /// Critical load without shear.
    pub(super) critical: T,
    /// Cavitation strength.
    pub(super) cavitation: T,
    /// Diameter of the overlap.
    pub(super) diameter: T,
    /// Factor of u_h² in the softening, 3 / (π r)².
    pub(super) softening: T,
}

/// Effects that the law has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Effects {
    pub(super) cavitates: bool,
    pub(super) buckles: bool,
    pub(super) softens: bool,
    /// Factor of the area of the overlap.
    pub(super) area: f64,
}

/// Properties at a shear displacement, with derivatives.
pub(super) struct Sheared<T = f64> {
    pub(super) kv: T,
    pub(super) dkv: T,
    pub(super) fcrn: T,
    pub(super) dfcrn: T,
}

impl<T: Real> Numbers<T> {
    /// Properties at the shear displacement `uh`.
    #[inline(always)]
    pub(super) fn sheared(&self, effects: &Effects, uh: T) -> Sheared<T> {
        let (mut kv, mut dkv) = (self.axial, T::ZERO);
        if effects.softens {
            let a = self.softening;
            let soft = T::ONE / (T::ONE + a * uh * uh);
            kv = kv * soft;
            dkv = a * -2.0 * uh * soft * kv;
        }
        let (mut fcrn, mut dfcrn) = (-self.critical, T::ZERO);
        if effects.buckles {
            let (share, slope) = overlap(uh / self.diameter);
            let (share, least) = (share * effects.area, T::of(MIN_CRITICAL_RATIO));
            dfcrn = least.where_greater(share, T::ZERO, fcrn * slope / self.diameter);
            fcrn = fcrn * least.where_greater(share, least, share);
        }
        Sheared { kv, dkv, fcrn, dfcrn }
    }

    /// Response to the axial displacement `u`, elastic or buckled, and the bearings that are beyond cavitation.
    #[inline(always)]
    pub(super) fn step(&self, effects: &Effects, s: &Sheared<T>, c: &Axial<T>, u: T) -> (AxialStep<T>, T::Flags) {
        let linear = s.kv * u;
        let uc = self.cavitation / s.kv;
        let next = Axial { force: linear, kv: s.kv, uc, fcrn: s.fcrn, fcrmin: c.fcrmin.larger(s.fcrn), ..*c };
        let mut step = AxialStep { next, k: s.kv, k_shear: s.dkv * u, critical: s.fcrn, d_critical: s.dfcrn };
        let mut stable = T::ALL;
        if effects.buckles {
            let end = s.fcrn / s.kv;
            stable = u.exceeds(end);
            if stable != T::ALL {
                let k = self.axial * BUCKLED_STIFFNESS_RATIO;
                let k_shear = s.dfcrn - k * (s.dfcrn - s.fcrn * s.dkv / s.kv) / s.kv;
                step.k = u.where_greater(end, s.kv, k);
                step.next.force = u.where_greater(end, linear, s.fcrn + k * (u - end));
                step.k_shear = u.where_greater(end, step.k_shear, k_shear);
            }
        }
        (step, if effects.cavitates { stable & linear.exceeds(c.fcn) } else { T::NONE })
    }
}

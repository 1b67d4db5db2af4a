//! The axial law of several bearings side by side.

// Loops over vectors: the compiler makes vector instructions of them, which it does not of some iterators.
#![allow(clippy::needless_range_loop)]

use super::{Axial, AxialLaw, AxialStep, BUCKLED_STIFFNESS_RATIO, MIN_CRITICAL_RATIO, Sheared};
use crate::element::bearing::kinematics::overlap::overlap_lockstep;
use crate::numeric::wide::{ALL, Flags, WIDTH, Wide, is_set};

/// Laws with the same effects.
#[derive(Debug)]
pub(in crate::element::bearing) struct AxialLockstep {
    laws: [AxialLaw; WIDTH],
    axial: Wide,
    critical: Wide,
    cavitation: Wide,
    diameter: Wide,
    softening: Wide,
    cavitates: bool,
    buckles: bool,
    softens: bool,
}

impl AxialLockstep {
    /// `None` where the effects differ, or follow OpenSees.
    pub(in crate::element::bearing) fn new(laws: [AxialLaw; WIDTH]) -> Option<Self> {
        let AxialLaw { cavitates, buckles, softens, .. } = laws[0];
        let effects = |law: &AxialLaw| (law.cavitates, law.buckles, law.softens, law.compat);
        let same = laws.iter().all(|law| effects(law) == (cavitates, buckles, softens, false));
        same.then(|| Self {
            axial: Wide(laws.map(|law| law.rubber.axial)),
            critical: Wide(laws.map(|law| law.rubber.critical)),
            cavitation: Wide(laws.map(|law| law.rubber.cavitation)),
            diameter: Wide(laws.map(|law| law.rubber.diameter)),
            softening: Wide(laws.map(|law| law.softening())),
            laws,
            cavitates,
            buckles,
            softens,
        })
    }

    /// As [`AxialLaw::sheared`].
    #[inline(always)]
    fn sheared(&self, uh: Wide) -> Sheared<Wide> {
        let zero = Wide::all(0.0);
        let (mut kv, mut dkv) = (self.axial, zero);
        if self.softens {
            let a = self.softening;
            let one = Wide::all(1.0);
            let soft = one / (one + a * uh * uh);
            kv = kv * soft;
            dkv = a * -2.0 * uh * soft * kv;
        }
        let (mut fcrn, mut dfcrn) = (-self.critical, zero);
        if self.buckles {
            let (share, slope) = overlap_lockstep(uh / self.diameter);
            let least = Wide::all(MIN_CRITICAL_RATIO);
            dfcrn = least.where_greater(share, zero, fcrn * slope / self.diameter);
            fcrn = fcrn * least.where_greater(share, least, share);
        }
        Sheared { kv, dkv, fcrn, dfcrn }
    }

    /// As [`AxialLaw::step`], in models that want it.
    #[inline(always)]
    pub(in crate::element::bearing) fn step(
        &self,
        c: &Axial<Wide>,
        u: Wide,
        uh: Wide,
        wanted: Flags,
    ) -> AxialStep<Wide> {
        let s = self.sheared(uh);
        let linear = s.kv * u;
        let uc = self.cavitation / s.kv;
        let next = Axial { force: linear, kv: s.kv, uc, fcrn: s.fcrn, fcrmin: c.fcrmin.max(s.fcrn), ..*c };
        let mut step = AxialStep { next, k: s.kv, k_shear: s.dkv * u, critical: s.fcrn, d_critical: s.dfcrn };
        let mut stable = ALL;
        if self.buckles {
            let end = s.fcrn / s.kv;
            stable = !u.at_most(end);
            if stable != ALL {
                let k = self.axial * BUCKLED_STIFFNESS_RATIO;
                let k_shear = s.dfcrn - k * (s.dfcrn - s.fcrn * s.dkv / s.kv) / s.kv;
                step.k = u.where_greater(end, s.kv, k);
                step.next.force = u.where_greater(end, linear, s.fcrn + k * (u - end));
                step.k_shear = u.where_greater(end, step.k_shear, k_shear);
            }
        }
        if self.cavitates {
            let beyond = stable & !linear.at_most(c.fcn) & wanted;
            if beyond != 0 {
                self.cavitate(beyond, c, (u, uh), &mut step);
            }
        }
        step
    }

    /// Set the steps of bearings beyond cavitation, one by one.
    #[cold]
    #[inline(never)]
    fn cavitate(&self, beyond: Flags, c: &Axial<Wide>, (u, uh): (Wide, Wide), step: &mut AxialStep<Wide>) {
        for i in (0..WIDTH).filter(|i| is_set(beyond, *i)) {
            let own = |x: Wide| x.0[i];
            let committed = Axial {
                force: own(c.force),
                kv: own(c.kv),
                uc: own(c.uc),
                fcn: own(c.fcn),
                umax: own(c.umax),
                fcrn: own(c.fcrn),
                fcrmin: own(c.fcrmin),
            };
            let s = self.laws[i].step(&committed, own(u), own(uh));
            let next = &mut step.next;
            for (all, own) in [
                (&mut next.force, s.next.force),
                (&mut next.fcn, s.next.fcn),
                (&mut next.umax, s.next.umax),
                (&mut step.k, s.k),
                (&mut step.k_shear, s.k_shear),
            ] {
                all.0[i] = own;
            }
        }
    }
}

//! The axial law of several bearings side by side.

use super::{Axial, AxialLaw, AxialStep, Effects, Numbers};
use crate::numeric::wide::{Flags, WIDTH, Wide, is_set};

/// Laws with the same effects.
#[derive(Debug)]
pub(in crate::element::bearing) struct AxialLockstep {
    laws: [AxialLaw; WIDTH],
    numbers: Numbers<Wide>,
    effects: Effects,
}

impl AxialLockstep {
    /// `None` where the effects differ, or follow OpenSees.
    pub(in crate::element::bearing) fn new(laws: [AxialLaw; WIDTH]) -> Option<Self> {
        let effects = laws[0].effects();
        let same = laws.iter().all(|law| law.effects() == effects && !law.compat);
        let numbers = laws.map(|law| law.numbers());
        let each = |number: fn(&Numbers) -> f64| Wide(std::array::from_fn(|i| number(&numbers[i])));
        same.then(|| Self {
            numbers: Numbers {
                axial: each(|n| n.axial),
                critical: each(|n| n.critical),
                cavitation: each(|n| n.cavitation),
                diameter: each(|n| n.diameter),
                softening: each(|n| n.softening),
            },
            laws,
            effects,
        })
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
        let s = self.numbers.sheared(&self.effects, uh);
        let (mut step, beyond) = self.numbers.step(&self.effects, &s, c, u);
        if beyond & wanted != 0 {
            self.cavitate(beyond & wanted, c, (u, uh), &mut step);
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

//! `AxialSp` and `AxialSpHD` by OpenSees' rules.
//!
//! A step from cavitation to compression ends on a branch that it has left. A spring that has just begun to harden
//! closes beyond (u_cr, f_cr) or stays on the hardening line. A spring without stiffness in tension does not leave
//! compression after yield.

use super::{AxialSpring, Branch, History, Rules};
use crate::material::Stress;
use crate::rules::OpenSees;

impl Rules for OpenSees {
    const FOLLOWS_TRIALS: bool = true;

    #[inline]
    fn hardened(u: f64, uth: f64) -> bool {
        u > uth
    }

    #[inline]
    fn jump(u: f64, ucr: f64, ucy: f64) -> Option<Branch> {
        (u <= ucr).then_some(if u > ucy { Branch::Yielded } else { Branch::Cavitated })
    }

    #[inline]
    fn end_of_closing(ucr: f64, uth: f64, passes: impl FnOnce() -> f64) -> f64 {
        if uth < f64::MAX { ucr.min(passes()) } else { ucr }
    }

    #[inline]
    fn stays_compressed(ste: f64) -> bool {
        ste == 0.0
    }
}

impl<const HD: bool, R: Rules> AxialSpring<HD, R> {
    /// As `step`, but as in OpenSees, where the branch continues from the last call, committed or not. Only
    /// displacement and force come from the committed state. `slope` then holds the displacement at which a shifted
    /// spring yields again.
    #[inline]
    pub(super) fn step_on(&self, c: &History, last: &History, u: f64) -> (Stress, History) {
        let from = History { u: c.u, ..*last };
        let mut t = History { u, ..from };
        let next = self.follow(&from, || self.response(c).value, u, &mut t);
        t.branch = match (from.branch, next) {
            (Branch::Shifted, _) if u <= from.slope => Branch::Yielded,
            (Branch::Shifted, Branch::Yielded) => Branch::Shifted,
            _ => next,
        };
        match from.branch {
            Branch::Yielded if u > c.u => t.slope = c.u,
            Branch::Flowing if u < c.u => {
                t.slope = (self.sce * t.from - self.scy * self.ucy + self.fcy) / (self.sce - self.scy);
            }
            _ => {}
        }
        (self.response(&t), t)
    }
}

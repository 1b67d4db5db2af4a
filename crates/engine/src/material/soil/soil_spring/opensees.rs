//! Distribution of a step among the springs, as in OpenSees.

use super::{History, Soil, SoilSpring, SpringState, TOLERANCE, bounded};

/// Maximum number of iterations per substep, as in OpenSees; the residual then remains.
const MAX_ITERATIONS: usize = 19;
/// Maximum number of substeps, as in OpenSees.
const MAX_SUBSTEPS: f64 = 100.0;

/// Displacement increments of one spring: present and previous iteration.
#[derive(Clone, Copy, Debug)]
pub struct SpringIncrement {
    /// Present increment.
    pub dy: f64,
    /// Previous increment.
    pub old: f64,
}

impl SpringIncrement {
    /// The increment, limited to half the previous one if it alternates without decreasing.
    pub(super) fn steady(self) -> f64 {
        if self.dy * self.old < 0.0 && (self.dy / self.old).abs() > 0.5 { -0.5 * self.old } else { self.dy }
    }
}

impl<S: Soil> SoilSpring<S> {
    /// State at the displacement `y`, from the trial state `t` of the step.
    pub(super) fn iterated(&self, c: &History, mut t: History, y: f64) -> History {
        let (ultimate_force, dy) = (self.soil.ultimate_force(), y - t.total.y);
        // A large step across an increase of stiffness would diverge, so it is divided.
        let by_force = match (t.total.tangent * dy / ultimate_force).abs() {
            f if f > 0.5 => 1.0 + (2.0 * f).floor(),
            _ => 1.0,
        };
        let parts = match (dy / self.soil.y50()).abs() {
            f if f > 1.0 => 1.0 + f.floor(),
            _ => by_force,
        };
        let parts = parts.min(MAX_SUBSTEPS);
        for _ in 0..parts as usize {
            self.advance(c, &mut t, dy / parts);
        }
        t
    }

    /// Sum of the differences between the spring forces and the total force.
    fn unbalance(h: &History) -> f64 {
        let opens = h.gap.spring.tangent.is_finite();
        let of = |spring: &SpringState| (h.total.p - spring.p).abs();
        of(&h.near.spring) + of(&h.far) + if opens { of(&h.gap.spring) } else { 0.0 }
    }

    fn advance(&self, c: &History, t: &mut History, dy: f64) {
        t.total.y += dy;
        let mut dp = t.total.tangent * dy;
        let increment = |p: f64, spring: &SpringState| (p - spring.p) / spring.tangent;
        let mut near = SpringIncrement { dy: 0.0, old: increment(t.total.p + dp, &t.near.spring) };
        let mut gap = SpringIncrement { dy: 0.0, old: increment(t.total.p + dp, &t.gap.spring) };
        for _ in 0..MAX_ITERATIONS {
            t.total.p += dp;
            if S::BOUNDED {
                t.total.p = bounded(t.total.p, self.soil.ultimate_force());
            }
            let p = t.total.p;
            near.dy = increment(p, &t.near.spring);
            self.soil.advance_near_field(&c.near, &mut t.near, near);
            gap.dy = increment(p, &t.gap.spring);
            self.soil.advance_gap(&c.gap, &mut t.gap, t.near.spring.y, gap);
            (near.old, gap.old) = (near.dy, gap.dy);
            t.far.y += increment(p, &t.far);
            t.far.p = t.far.tangent * t.far.y;
            t.total.tangent = Self::tangent(t);
            let required = |spring: &SpringState| spring.y + increment(p, spring);
            dp = t.total.tangent * (t.total.y - required(&t.gap.spring) - required(&t.near.spring) - required(&t.far));
            if Self::unbalance(t) < TOLERANCE * self.soil.ultimate_force() {
                return;
            }
        }
    }
}

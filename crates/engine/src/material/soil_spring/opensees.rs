//! How OpenSees distributes a step among the springs.

use super::{History, Part, Soil, SoilSpring, TOLERANCE, below};

/// Times that the force is distributed in a part of a step; what has not come to one force then stays as it is.
const ROUNDS: usize = 19;
/// Parts of a step at most.
const PARTS: f64 = 100.0;

/// A step of one of the springs: what the force asks for, and what it asked for the last time.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    /// Displacement.
    pub dy: f64,
    /// Displacement before.
    pub old: f64,
}

impl Step {
    /// Where it changes its sign and does not shrink, half of the last one.
    pub(super) fn steady(self) -> f64 {
        if self.dy * self.old < 0.0 && (self.dy / self.old).abs() > 0.5 { -0.5 * self.old } else { self.dy }
    }
}

impl<S: Soil> SoilSpring<S> {
    /// From a trial state of the step to another one.
    pub(super) fn from_trial(&self, c: &History, mut t: History, y: f64) -> History {
        let (ultimate, dy) = (self.soil.ultimate(), y - t.whole.y);
        // Where a soft branch turns into a stiff one the whole step would go astray.
        let by_force = match (t.whole.tangent * dy / ultimate).abs() {
            f if f > 0.5 => 1.0 + (2.0 * f).floor(),
            _ => 1.0,
        };
        let parts = match (dy / self.soil.y50()).abs() {
            f if f > 1.0 => 1.0 + f.floor(),
            _ => by_force,
        };
        let parts = parts.min(PARTS);
        for _ in 0..parts as usize {
            self.go_on(c, &mut t, dy / parts);
        }
        t
    }

    /// How far the forces of the springs are from that of the whole, in all.
    fn unbalance(h: &History) -> f64 {
        let opens = h.gap.spring.tangent.is_finite();
        let of = |spring: &Part| (h.whole.p - spring.p).abs();
        of(&h.near.spring) + of(&h.far) + if opens { of(&h.gap.spring) } else { 0.0 }
    }

    fn go_on(&self, c: &History, t: &mut History, dy: f64) {
        t.whole.y += dy;
        let mut dp = t.whole.tangent * dy;
        let asked = |p: f64, spring: &Part| (p - spring.p) / spring.tangent;
        let mut near = Step { dy: 0.0, old: asked(t.whole.p + dp, &t.near.spring) };
        let mut gap = Step { dy: 0.0, old: asked(t.whole.p + dp, &t.gap.spring) };
        for _ in 0..ROUNDS {
            t.whole.p += dp;
            if S::BOUNDED {
                t.whole.p = below(t.whole.p, self.soil.ultimate());
            }
            let p = t.whole.p;
            near.dy = asked(p, &t.near.spring);
            self.soil.yields_on(&c.near, &mut t.near, near);
            gap.dy = asked(p, &t.gap.spring);
            self.soil.opens_on(&c.gap, &mut t.gap, t.near.spring.y, gap);
            (near.old, gap.old) = (near.dy, gap.dy);
            t.far.y += asked(p, &t.far);
            t.far.p = t.far.tangent * t.far.y;
            t.whole.tangent = Self::tangent(t);
            let left = |spring: &Part| spring.y + asked(p, spring);
            dp = t.whole.tangent * (t.whole.y - left(&t.gap.spring) - left(&t.near.spring) - left(&t.far));
            if Self::unbalance(t) < TOLERANCE * self.soil.ultimate() {
                return;
            }
        }
    }
}

//! A spring that is all but rigid in a zone of forces, which moves along where it yields.

use super::branch::{Branch, Turn};
use super::{Near, Part, Step, below};

/// How the elastic zone goes on where the loading turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Grows {
    /// As high as at first, but so far beyond zero at least, as a part of the ultimate force.
    AtLeast(f64),
    /// As high as from one turn to the other, to this part of the ultimate force.
    UpTo(f64),
}

/// A rigid-plastic spring: stiffness in its zone, and a branch from its bounds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Zone {
    /// Beyond the zone.
    pub(super) branch: Branch,
    /// Stiffness within it.
    pub(super) rigid: f64,
    /// Half its height at first, as a part of the ultimate force.
    pub(super) elastic: f64,
    /// What it does where the loading turns.
    pub(super) grows: Grows,
    /// Displacement at half the ultimate force of the soil.
    pub(super) y50: f64,
}

impl Zone {
    /// Before anything has happened.
    pub(super) fn virgin(&self) -> Near {
        let p = self.elastic * self.branch.limit;
        let spring = Part { tangent: self.rigid, ..Part::default() };
        let turns = [1.0, -1.0].map(|s| Turn { p: s * p, y: s * p / self.rigid });
        Near { spring, turns, elastic: self.elastic }
    }

    /// The longest step where the loading turns.
    fn longest(&self, elastic: f64) -> f64 {
        let part = match self.grows {
            Grows::AtLeast(part) => part,
            Grows::UpTo(_) => elastic,
        };
        part * self.branch.limit / self.rigid
    }

    /// Turn round in the sense `s`: -1 where the force has been growing.
    fn turn(&self, c: &Near, t: &mut Near, s: f64) {
        let limit = self.branch.limit;
        let (here, there) = if s < 0.0 { (0, 1) } else { (1, 0) };
        let mut from = c.spring.p;
        match self.grows {
            Grows::AtLeast(_) => from = below(from, limit * (1.0 - super::TOLERANCE)),
            Grows::UpTo(most) => {
                t.elastic = t.elastic.max((from - c.turns[there].p).abs() / (2.0 * limit)).min(0.5 * most);
            }
        }
        let mut to = from + s * 2.0 * limit * t.elastic;
        if let Grows::AtLeast(part) = self.grows {
            to = s * (s * to).max(part * limit);
        }
        t.turns[here] = Turn { p: from, y: c.spring.y };
        t.turns[there] = Turn { p: to, y: c.spring.y + (to - from) / self.rigid };
    }

    /// From the committed state to a force.
    pub(super) fn to(&self, c: &Near, p: f64) -> Near {
        let s = if p >= c.spring.p { 1.0 } else { -1.0 };
        let mut t = *c;
        self.turn_round(c, &mut t, s);
        let (ahead, behind) = if s > 0.0 { (&t.turns[0], &t.turns[1]) } else { (&t.turns[1], &t.turns[0]) };
        let (y, tangent) = if s * p <= s * ahead.p {
            (behind.y + (p - behind.p) / self.rigid, self.rigid)
        } else {
            self.branch.from(ahead, s, p)
        };
        t.spring = Part { y, p, tangent };
        t
    }

    /// Turn round where the committed state is on a branch and the loading goes on in the other sense.
    fn turn_round(&self, c: &Near, t: &mut Near, s: f64) -> bool {
        let turns = if s < 0.0 { c.spring.p > c.turns[0].p } else { c.spring.p < c.turns[1].p };
        if turns {
            self.turn(c, t, s);
        }
        turns
    }

    /// A step from the trial state, as in OpenSees.
    pub(super) fn go_on(&self, c: &Near, t: &mut Near, step: Step) {
        let from = t.spring.y;
        let mut dy = step.steady();
        if dy * step.old < -self.y50 * self.y50 {
            dy = 0.5 * (t.turns[0].y + t.turns[1].y) - from;
        }
        let way = from + dy - c.spring.y;
        if (way * t.spring.tangent).abs() < self.branch.elastic {
            t.spring.y = from + dy;
            t.spring.p = below(t.spring.p + dy * t.spring.tangent, self.branch.limit);
            return;
        }
        t.turns = c.turns;
        let s = if way >= 0.0 { 1.0 } else { -1.0 };
        if way != 0.0 && self.turn_round(c, t, s) {
            let longest = self.longest(t.elastic);
            dy = dy.clamp(-longest, longest);
        }
        let y = from + dy;
        let (ahead, behind) = if s > 0.0 { (&t.turns[0], &t.turns[1]) } else { (&t.turns[1], &t.turns[0]) };
        let (p, tangent) = if s * y <= s * ahead.y {
            (behind.p + (y - behind.y) * self.rigid, self.rigid)
        } else {
            self.branch.on(ahead, s, y)
        };
        let limited = below(p, self.branch.limit);
        let least = matches!(self.grows, Grows::UpTo(_)) && limited != p;
        let tangent = if least { self.branch.least } else { tangent.max(self.branch.least) };
        t.spring = Part { y, p: limited, tangent };
    }
}

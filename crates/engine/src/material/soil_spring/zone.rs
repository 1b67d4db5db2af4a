//! A rigid-plastic spring with an elastic zone that follows plastic flow.

use super::branch::{Branch, Turn};
use super::{Near, Part, Step, below};

/// Size of the elastic zone after a reversal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Grows {
    /// The initial height, with a bound at least this fraction of the ultimate force beyond zero.
    AtLeast(f64),
    /// The distance between reversals, up to this fraction of the ultimate force.
    UpTo(f64),
}

/// A rigid-plastic spring: a stiffness in the zone and a branch from its bounds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Zone {
    /// Branch beyond the zone.
    pub(super) branch: Branch,
    /// Stiffness in the zone.
    pub(super) rigid: f64,
    /// Initial half height divided by the ultimate force.
    pub(super) elastic: f64,
    /// Rule for the size after a reversal.
    pub(super) grows: Grows,
    /// Displacement at half the ultimate force of the soil.
    pub(super) y50: f64,
}

impl Zone {
    /// The virgin state.
    pub(super) fn virgin(&self) -> Near {
        let p = self.elastic * self.branch.limit;
        let spring = Part { tangent: self.rigid, ..Part::default() };
        let turns = [1.0, -1.0].map(|s| Turn { p: s * p, y: s * p / self.rigid });
        Near { spring, turns, elastic: self.elastic }
    }

    /// Largest displacement increment after a reversal.
    fn longest(&self, elastic: f64) -> f64 {
        let part = match self.grows {
            Grows::AtLeast(part) => part,
            Grows::UpTo(_) => elastic,
        };
        part * self.branch.limit / self.rigid
    }

    /// Reverses to the direction `s`, which is -1 if the force has been increasing.
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

    /// State at the force `p`, from the committed state.
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

    /// Reverses if the committed state is on a branch and the loading opposes it; returns true if it did.
    fn turn_round(&self, c: &Near, t: &mut Near, s: f64) -> bool {
        let turns = if s < 0.0 { c.spring.p > c.turns[0].p } else { c.spring.p < c.turns[1].p };
        if turns {
            self.turn(c, t, s);
        }
        turns
    }

    /// Advances the trial state by a step, as in OpenSees.
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

//! A rigid-plastic spring with an elastic zone that follows plastic flow.

use super::branch::{Branch, Reversal};
use super::{NearField, SpringIncrement, SpringState, bounded};

/// Size of the elastic zone after a reversal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum ZoneGrowth {
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
    pub(super) grows: ZoneGrowth,
    /// Displacement at half the ultimate force of the soil.
    pub(super) y50: f64,
}

impl Zone {
    /// The virgin state.
    pub(super) fn virgin(&self) -> NearField {
        let p = self.elastic * self.branch.limit;
        let spring = SpringState { tangent: self.rigid, ..SpringState::default() };
        let reversals = [1.0, -1.0].map(|s| Reversal { p: s * p, y: s * p / self.rigid });
        NearField { spring, reversals, elastic: self.elastic }
    }

    /// Largest displacement increment after a reversal.
    fn longest(&self, elastic: f64) -> f64 {
        let part = match self.grows {
            ZoneGrowth::AtLeast(part) => part,
            ZoneGrowth::UpTo(_) => elastic,
        };
        part * self.branch.limit / self.rigid
    }

    /// Reverses to the direction `s`, which is -1 if the force has been increasing.
    fn reverse(&self, c: &NearField, t: &mut NearField, s: f64) {
        let limit = self.branch.limit;
        let (here, there) = if s < 0.0 { (0, 1) } else { (1, 0) };
        let mut from = c.spring.p;
        match self.grows {
            ZoneGrowth::AtLeast(_) => from = bounded(from, limit * (1.0 - super::TOLERANCE)),
            ZoneGrowth::UpTo(most) => {
                t.elastic = t.elastic.max((from - c.reversals[there].p).abs() / (2.0 * limit)).min(0.5 * most);
            }
        }
        let mut to = from + s * 2.0 * limit * t.elastic;
        if let ZoneGrowth::AtLeast(part) = self.grows {
            to = s * (s * to).max(part * limit);
        }
        t.reversals[here] = Reversal { p: from, y: c.spring.y };
        t.reversals[there] = Reversal { p: to, y: c.spring.y + (to - from) / self.rigid };
    }

    /// State at the force `p`, from the committed state.
    pub(super) fn step_to_force(&self, c: &NearField, p: f64) -> NearField {
        let s = if p >= c.spring.p { 1.0 } else { -1.0 };
        let mut t = *c;
        self.detect_reversal(c, &mut t, s);
        let (ahead, behind) =
            if s > 0.0 { (&t.reversals[0], &t.reversals[1]) } else { (&t.reversals[1], &t.reversals[0]) };
        let (y, tangent) = if s * p <= s * ahead.p {
            (behind.y + (p - behind.p) / self.rigid, self.rigid)
        } else {
            self.branch.at_force(ahead, s, p)
        };
        t.spring = SpringState { y, p, tangent };
        t
    }

    /// Reverses if the committed state is on a branch and the loading opposes it; returns true if it did.
    fn detect_reversal(&self, c: &NearField, t: &mut NearField, s: f64) -> bool {
        let reverses = if s < 0.0 { c.spring.p > c.reversals[0].p } else { c.spring.p < c.reversals[1].p };
        if reverses {
            self.reverse(c, t, s);
        }
        reverses
    }

    /// Advances the trial state by a step, as in OpenSees.
    pub(super) fn advance(&self, c: &NearField, t: &mut NearField, step: SpringIncrement) {
        let from = t.spring.y;
        let mut dy = step.steady();
        if dy * step.old < -self.y50 * self.y50 {
            dy = 0.5 * (t.reversals[0].y + t.reversals[1].y) - from;
        }
        let way = from + dy - c.spring.y;
        if (way * t.spring.tangent).abs() < self.branch.elastic {
            t.spring.y = from + dy;
            t.spring.p = bounded(t.spring.p + dy * t.spring.tangent, self.branch.limit);
            return;
        }
        t.reversals = c.reversals;
        let s = if way >= 0.0 { 1.0 } else { -1.0 };
        if way != 0.0 && self.detect_reversal(c, t, s) {
            let longest = self.longest(t.elastic);
            dy = dy.clamp(-longest, longest);
        }
        let y = from + dy;
        let (ahead, behind) =
            if s > 0.0 { (&t.reversals[0], &t.reversals[1]) } else { (&t.reversals[1], &t.reversals[0]) };
        let (p, tangent) = if s * y <= s * ahead.y {
            (behind.p + (y - behind.y) * self.rigid, self.rigid)
        } else {
            self.branch.at_displacement(ahead, s, y)
        };
        let limited = bounded(p, self.branch.limit);
        let smallest = matches!(self.grows, ZoneGrowth::UpTo(_)) && limited != p;
        let tangent = if smallest { self.branch.smallest } else { tangent.max(self.branch.smallest) };
        t.spring = SpringState { y, p: limited, tangent };
    }
}

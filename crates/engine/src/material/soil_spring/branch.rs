//! A hyperbola of some power from where the loading has turned to the ultimate force.

use super::{Part, TOLERANCE, below};

crate::state_struct! {
    /// Where loading has turned.
    pub struct Turn {
        /// Force.
        p: f64,
        /// Displacement.
        y: f64,
    }
}

/// p = p_max - (p_max - p₀) (y_r / (y_r + y - y₀))ⁿ going up from a turn at (y₀, p₀), and the same going down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Branch {
    /// Its ultimate force p_max.
    pub(super) limit: f64,
    /// Displacement y_r that the curvature is measured by.
    pub(super) reference: f64,
    /// Power n.
    pub(super) n: f64,
    /// The least tangent.
    pub(super) least: f64,
    /// Force below which a step is elastic.
    pub(super) elastic: f64,
}

impl Branch {
    /// With a least tangent, and steps that are elastic below some tolerances, as parts of the ultimate force of the soil.
    pub(super) fn new([limit, reference, n]: [f64; 3], least: f64, ultimate: f64, tolerances: f64) -> Self {
        Self { limit, reference, n, least, elastic: tolerances * TOLERANCE * ultimate }
    }

    /// Tangent before anything has happened.
    pub(super) fn initial(&self) -> f64 {
        self.n * self.limit / self.reference
    }

    /// Force and tangent on the way from a turn, in the sense `s`.
    pub(super) fn on(&self, turn: &Turn, s: f64, y: f64) -> (f64, f64) {
        let (ahead, x) = (self.limit - s * turn.p, self.reference + s * (y - turn.y));
        let left = ahead * (self.reference / x).powf(self.n);
        (s * (self.limit - left), self.n * left / x)
    }

    /// From the committed state to a force.
    pub(super) fn to(&self, c: &Part, turn: &mut Turn, p: f64) -> Part {
        let s = if p >= c.p { 1.0 } else { -1.0 };
        self.turn_round(c, turn, s);
        let (y, tangent) = self.from(turn, s, p);
        Part { y, p, tangent }
    }

    /// Displacement and tangent at a force on the way from a turn, in the sense `s`.
    pub(super) fn from(&self, turn: &Turn, s: f64, p: f64) -> (f64, f64) {
        let (ahead, left) = (self.limit - s * turn.p, self.limit - s * p);
        let x = self.reference * (ahead / left).powf(1.0 / self.n);
        (turn.y + s * (x - self.reference), self.n * left / x)
    }

    /// The committed state is a turn where it was come to in the other sense.
    pub(super) fn turn_round(&self, c: &Part, turn: &mut Turn, s: f64) {
        if (c.y - turn.y) * s < 0.0 {
            *turn = Turn { p: c.p, y: c.y };
        }
    }

    /// A step from the trial state, as in OpenSees.
    pub(super) fn go_on(&self, (c, turned): (&Part, &Turn), (t, turn): (&mut Part, &mut Turn), dy: f64) {
        t.y += dy;
        let way = t.y - c.y;
        if (way * t.tangent).abs() < self.elastic {
            t.p = below(t.p + dy * t.tangent, self.limit);
            return;
        }
        let s = if way >= 0.0 { 1.0 } else { -1.0 };
        *turn = *turned;
        self.turn_round(c, turn, s);
        let (p, tangent) = self.on(turn, s, t.y);
        (t.p, t.tangent) = (below(p, self.limit), tangent.max(self.least));
    }
}

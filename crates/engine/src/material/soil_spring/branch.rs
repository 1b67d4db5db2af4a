//! A hyperbolic branch from a reversal to the ultimate force.

use super::{Part, TOLERANCE, below};

crate::state_struct! {
    /// A reversal of loading.
    pub struct Turn {
        /// Force.
        p: f64,
        /// Displacement.
        y: f64,
    }
}

/// p = p_max - (p_max - p₀) (y_r / (y_r + y - y₀))ⁿ upwards from a reversal at (y₀, p₀), and mirrored downwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Branch {
    /// Ultimate force p_max.
    pub(super) limit: f64,
    /// Reference displacement y_r of the curvature.
    pub(super) reference: f64,
    /// Exponent n.
    pub(super) n: f64,
    /// Smallest tangent.
    pub(super) least: f64,
    /// Force increment below which a step is elastic.
    pub(super) elastic: f64,
}

impl Branch {
    /// From p_max, y_r and n, and the smallest tangent. Steps are elastic below `tolerances` times the tolerance of
    /// the soil's ultimate force.
    pub(super) fn new([limit, reference, n]: [f64; 3], least: f64, ultimate: f64, tolerances: f64) -> Self {
        Self { limit, reference, n, least, elastic: tolerances * TOLERANCE * ultimate }
    }

    /// Tangent of the virgin branch.
    pub(super) fn initial(&self) -> f64 {
        self.n * self.limit / self.reference
    }

    /// Force and tangent at a displacement on the branch from a reversal in the direction `s`.
    pub(super) fn on(&self, turn: &Turn, s: f64, y: f64) -> (f64, f64) {
        let (ahead, x) = (self.limit - s * turn.p, self.reference + s * (y - turn.y));
        let left = ahead * (self.reference / x).powf(self.n);
        (s * (self.limit - left), self.n * left / x)
    }

    /// State at the force `p`, from the committed state.
    pub(super) fn to(&self, c: &Part, turn: &mut Turn, p: f64) -> Part {
        let s = if p >= c.p { 1.0 } else { -1.0 };
        self.turn_round(c, turn, s);
        let (y, tangent) = self.from(turn, s, p);
        Part { y, p, tangent }
    }

    /// Displacement and tangent at a force on the branch from a reversal in the direction `s`.
    pub(super) fn from(&self, turn: &Turn, s: f64, p: f64) -> (f64, f64) {
        let (ahead, left) = (self.limit - s * turn.p, self.limit - s * p);
        let x = self.reference * (ahead / left).powf(1.0 / self.n);
        (turn.y + s * (x - self.reference), self.n * left / x)
    }

    /// Makes the committed state a reversal if it was reached in the other direction.
    pub(super) fn turn_round(&self, c: &Part, turn: &mut Turn, s: f64) {
        if (c.y - turn.y) * s < 0.0 {
            *turn = Turn { p: c.p, y: c.y };
        }
    }

    /// Advances the trial state by a step, as in OpenSees.
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

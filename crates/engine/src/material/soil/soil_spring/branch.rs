//! A hyperbolic branch from a reversal to the ultimate force.

use super::{SpringState, TOLERANCE, bounded};

crate::state_struct! {
    /// A reversal of loading.
    pub struct Reversal {
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
    pub(super) smallest: f64,
    /// Force increment below which a step is elastic.
    pub(super) elastic: f64,
}

impl Branch {
    /// From p_max, y_r and n, and the smallest tangent. Steps are elastic below `tolerances` times the tolerance of
    /// the soil's ultimate force.
    pub(super) fn new([limit, reference, n]: [f64; 3], smallest: f64, ultimate_force: f64, tolerances: f64) -> Self {
        Self { limit, reference, n, smallest, elastic: tolerances * TOLERANCE * ultimate_force }
    }

    /// Tangent of the virgin branch.
    pub(super) fn initial(&self) -> f64 {
        self.n * self.limit / self.reference
    }

    /// Force and tangent at a displacement on the branch from a reversal in the direction `s`.
    pub(super) fn at_displacement(&self, reversal: &Reversal, s: f64, y: f64) -> (f64, f64) {
        let (ahead, x) = (self.limit - s * reversal.p, self.reference + s * (y - reversal.y));
        let remaining = ahead * (self.reference / x).powf(self.n);
        (s * (self.limit - remaining), self.n * remaining / x)
    }

    /// State at the force `p`, from the committed state.
    pub(super) fn step_to_force(&self, c: &SpringState, reversal: &mut Reversal, p: f64) -> SpringState {
        let s = if p >= c.p { 1.0 } else { -1.0 };
        self.detect_reversal(c, reversal, s);
        let (y, tangent) = self.at_force(reversal, s, p);
        SpringState { y, p, tangent }
    }

    /// Displacement and tangent at a force on the branch from a reversal in the direction `s`.
    pub(super) fn at_force(&self, reversal: &Reversal, s: f64, p: f64) -> (f64, f64) {
        let (ahead, remaining) = (self.limit - s * reversal.p, self.limit - s * p);
        let x = self.reference * (ahead / remaining).powf(1.0 / self.n);
        (reversal.y + s * (x - self.reference), self.n * remaining / x)
    }

    /// Makes the committed state a reversal if it was reached in the other direction.
    pub(super) fn detect_reversal(&self, c: &SpringState, reversal: &mut Reversal, s: f64) {
        if (c.y - reversal.y) * s < 0.0 {
            *reversal = Reversal { p: c.p, y: c.y };
        }
    }

    /// Advances the trial state by a step, as in OpenSees.
    pub(super) fn advance(
        &self,
        (c, last_reversal): (&SpringState, &Reversal),
        (t, reversal): (&mut SpringState, &mut Reversal),
        dy: f64,
    ) {
        t.y += dy;
        let way = t.y - c.y;
        if (way * t.tangent).abs() < self.elastic {
            t.p = bounded(t.p + dy * t.tangent, self.limit);
            return;
        }
        let s = if way >= 0.0 { 1.0 } else { -1.0 };
        *reversal = *last_reversal;
        self.detect_reversal(c, reversal, s);
        let (p, tangent) = self.at_displacement(reversal, s, t.y);
        (t.p, t.tangent) = (bounded(p, self.limit), tangent.max(self.smallest));
    }
}

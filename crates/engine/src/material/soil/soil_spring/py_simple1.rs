//! Lateral resistance of a pile in soil, with a gap behind it (p-y spring).

use super::branch::{Branch, Reversal};
use super::zone::{Zone, ZoneGrowth};
use super::{Gap, MAX_ITERATIONS, NearField, Soil, SpringIncrement, SpringState, bounded};
use crate::numeric::bracketed_root;

/// Smallest elastic zone on each side divided by the ultimate force, as in OpenSees.
const MIN_ELASTIC_RATIO: f64 = 0.25;
/// Elastic limit of a step in multiples of the force tolerance, as in OpenSees.
const ELASTIC: f64 = 10.0;

/// Backbone of a p-y spring.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PyBackbone {
    /// Soft clay (Matlock, 1970).
    Clay,
    /// Sand (API, 1993).
    Sand,
}

/// A p-y spring.
#[derive(Clone, Debug, PartialEq)]
pub struct PySimple1 {
    backbone: PyBackbone,
    pult: f64,
    y50: f64,
    drag: f64,
    near: Zone,
    drag_spring: Branch,
}

impl PySimple1 {
    /// From the ultimate resistance, the displacement at half of it, and the drag in the gap divided by the ultimate
    /// resistance.
    pub fn new(backbone: PyBackbone, pult: f64, y50: f64, drag: f64) -> Self {
        let drag = drag.max(super::TOLERANCE);
        let smallest = 1e-2 * pult / y50;
        let branch = |curve| Branch::new(curve, smallest, pult, ELASTIC);
        let (reference, n, elastic) = match backbone {
            PyBackbone::Clay => (10.0 * y50, 5.0, 0.35),
            PyBackbone::Sand => (0.5 * y50, 2.0, 0.2),
        };
        let near = Zone {
            branch: branch([pult, reference, n]),
            rigid: 50.0 * pult / y50,
            elastic,
            grows: ZoneGrowth::AtLeast(MIN_ELASTIC_RATIO),
            y50,
        };
        Self { backbone, pult, y50, drag, near, drag_spring: branch([drag * pult, 0.5 * y50, 1.0]) }
    }

    /// Displacement that the soil recovers.
    fn rebound(&self) -> f64 {
        1.5 * self.y50
    }

    /// Bounds of the gap after a near-field displacement `y`.
    fn widened(&self, [left, right]: [f64; 2], y: f64) -> [f64; 2] {
        [left.min(self.rebound() - y), right.max(-self.rebound() - y)]
    }

    /// Force and tangent of the contact with both sides of the gap.
    fn closure(&self, [left, right]: [f64; 2], y: f64) -> (f64, f64) {
        let small = self.y50 / 50.0;
        let (k, to_right, to_left) = (1.8 * self.pult * small, small + right - y, small + y - left);
        let tangent = k * (to_right.powi(-2) + to_left.powi(-2));
        (k * (1.0 / to_right - 1.0 / to_left), tangent.max(self.drag_spring.smallest))
    }
}

impl Soil for PySimple1 {
    const NAME: &'static str = "PySimple1";
    const BOUNDED: bool = false;

    fn ultimate_force(&self) -> f64 {
        self.pult
    }

    fn y50(&self) -> f64 {
        self.y50
    }

    fn far_stiffness(&self) -> f64 {
        match self.backbone {
            PyBackbone::Clay => self.pult / (8.0 * self.near.elastic.powi(2) * self.y50),
            PyBackbone::Sand => 0.542 * self.pult / self.y50,
        }
    }

    fn virgin(&self) -> (NearField, Gap) {
        let closed = [-self.y50 / 100.0, self.y50 / 100.0];
        let drag_spring = SpringState { tangent: self.drag_spring.initial(), ..SpringState::default() };
        let tangent = self.closure(closed, 0.0).1 + drag_spring.tangent;
        let spring = SpringState { tangent, ..SpringState::default() };
        (self.near.virgin(), Gap { spring, drag_spring, reversal: Reversal::default(), closed })
    }

    fn near_field_at(&self, c: &NearField, p: f64) -> NearField {
        self.near.step_to_force(c, p)
    }

    fn gap_at(&self, c: &Gap, near: f64, p: f64) -> (Gap, f64) {
        // The contact force is infinite at the bounds of the gap, so the root lies between them; a bound may move
        // with `y`.
        let small = self.y50 / 50.0;
        let ends = [
            (c.closed[0] - small).min(0.5 * (self.rebound() - near - small)),
            (c.closed[1] + small).max(0.5 * (small - self.rebound() - near)),
        ];
        let mut t = *c;
        let at = |y: f64, t: &mut Gap| {
            t.closed = self.widened(c.closed, near + y);
            let [left, right] = [0, 1].map(|i| f64::from(u8::from(t.closed[i] != c.closed[i])));
            let (to_right, to_left) = (small + t.closed[1] - y, small + y - t.closed[0]);
            let k = 1.8 * self.pult * small;
            let [by_right, by_left] = [k / (to_right * to_right), k / (to_left * to_left)];
            t.drag_spring.y = y;
            t.reversal = c.reversal;
            let s = if y >= c.drag_spring.y { 1.0 } else { -1.0 };
            self.drag_spring.detect_reversal(&c.drag_spring, &mut t.reversal, s);
            (t.drag_spring.p, t.drag_spring.tangent) = self.drag_spring.at_displacement(&t.reversal, s, y);
            let force = k / to_right - k / to_left + t.drag_spring.p;
            let tangent = (1.0 + right) * by_right + (1.0 + left) * by_left + t.drag_spring.tangent;
            (force, tangent, right * by_right + left * by_left)
        };
        let excess = |y: f64| {
            let (force, tangent, _) = at(y, &mut t);
            (force - p, tangent)
        };
        let y =
            bracketed_root(excess, (ends[0], ends[1]), c.spring.y.clamp(ends[0], ends[1]), self.y50, MAX_ITERATIONS);
        let y = y.unwrap_or(f64::NAN);
        let (_, tangent, by_near) = at(y, &mut t);
        t.spring = SpringState { y, p, tangent };
        (t, -by_near / tangent)
    }

    fn advance_near_field(&self, c: &NearField, t: &mut NearField, step: SpringIncrement) {
        self.near.advance(c, t, step);
    }

    fn advance_gap(&self, c: &Gap, t: &mut Gap, near: f64, step: SpringIncrement) {
        let from = t.spring.y;
        // A step must not cross the side of the gap.
        let dy = match from + step.dy {
            y if y < t.closed[0] => 0.75 * (t.closed[0] - from),
            y if y > t.closed[1] => 0.75 * (t.closed[1] - from),
            _ => step.dy,
        };
        let dy = SpringIncrement { dy, ..step }.steady();
        let y = from + dy;
        t.closed = self.widened(c.closed, near + y);
        let (p, tangent) = self.closure(t.closed, y);
        self.drag_spring.advance((&c.drag_spring, &c.reversal), (&mut t.drag_spring, &mut t.reversal), dy);
        t.spring =
            SpringState { y, p: bounded(p + t.drag_spring.p, self.pult), tangent: tangent + t.drag_spring.tangent };
    }
}

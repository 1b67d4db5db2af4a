//! End bearing of a pile with uplift (q-z spring).

use super::branch::{Branch, Reversal};
use super::zone::{Zone, ZoneGrowth};
use super::{Gap, MAX_ITERATIONS, NearField, Soil, SpringIncrement, SpringState, TOLERANCE};
use crate::numeric::bracketed_root;

/// Elastic limit of a step in multiples of the force tolerance, as in OpenSees.
const ELASTIC: f64 = 3.0;
/// Largest height of the elastic zone divided by the ultimate force, as in OpenSees.
const MAX_ELASTIC_RATIO: f64 = 0.7;
/// Stiffness of the closed, the open and the virgin gap, in multiples of ultimate force over `z50`; values of
/// OpenSees.
const CLOSED: f64 = 1000.0;
const OPEN: f64 = 1e-6;
const VIRGIN: f64 = 100.0;

/// Backbone of a q-z spring.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum QzBackbone {
    /// Drilled shafts in clay (Reese and O'Neill, 1987).
    Clay,
    /// Piles in sand (Vijayvergiya, 1977).
    Sand,
}

/// A q-z spring.
#[derive(Clone, Debug, PartialEq)]
pub struct QzSimple1 {
    backbone: QzBackbone,
    qult: f64,
    z50: f64,
    near: Zone,
    suction: Branch,
}

impl QzSimple1 {
    /// Largest suction divided by the ultimate resistance.
    pub const MAX_SUCTION_RATIO: f64 = 0.1;

    /// From the ultimate resistance, the displacement at half of it, and the uplift resistance divided by the
    /// ultimate resistance.
    pub fn new(backbone: QzBackbone, qult: f64, z50: f64, suction: f64) -> Self {
        let suction = suction.clamp(TOLERANCE, Self::MAX_SUCTION_RATIO);
        let branch = |curve| Branch::new(curve, 1e-4 * qult / z50, qult, ELASTIC);
        let (reference, n, elastic) = match backbone {
            QzBackbone::Clay => (0.35 * z50, 1.2, 0.2),
            QzBackbone::Sand => (12.3 * z50, 5.5, 0.3),
        };
        let near = Zone {
            branch: branch([qult, reference, n]),
            rigid: 1e4 * qult / z50,
            elastic,
            grows: ZoneGrowth::UpTo(MAX_ELASTIC_RATIO),
            y50: z50,
        };
        Self { backbone, qult, z50, near, suction: branch([suction * qult, 0.5 * z50, 1.0]) }
    }

    fn stiffness(&self, part: f64) -> f64 {
        part * self.qult / self.z50
    }
}

impl Soil for QzSimple1 {
    const NAME: &'static str = "QzSimple1";
    const BOUNDED: bool = true;

    fn ultimate_force(&self) -> f64 {
        self.qult
    }

    fn y50(&self) -> f64 {
        self.z50
    }

    fn far_stiffness(&self) -> f64 {
        self.stiffness(match self.backbone {
            QzBackbone::Clay => 0.525,
            QzBackbone::Sand => 1.39,
        })
    }

    fn virgin(&self) -> (NearField, Gap) {
        let drag_spring = SpringState { tangent: self.suction.initial(), ..SpringState::default() };
        let spring = SpringState { tangent: self.stiffness(VIRGIN) + drag_spring.tangent, ..SpringState::default() };
        (self.near.virgin(), Gap { spring, drag_spring, reversal: Reversal::default(), closed: [0.0; 2] })
    }

    fn near_field_at(&self, c: &NearField, p: f64) -> NearField {
        self.near.step_to_force(c, p)
    }

    fn gap_at(&self, c: &Gap, _: f64, p: f64) -> (Gap, f64) {
        let mut t = *c;
        let at = |y: f64, t: &mut Gap| {
            t.reversal = c.reversal;
            let s = if y >= c.drag_spring.y { 1.0 } else { -1.0 };
            self.suction.detect_reversal(&c.drag_spring, &mut t.reversal, s);
            let k = self.stiffness(if y <= 0.0 { CLOSED } else { OPEN });
            let (p, tangent) = self.suction.at_displacement(&t.reversal, s, y);
            t.drag_spring = SpringState { y, p, tangent };
            (k * y + p, k + tangent)
        };
        let excess = |y: f64| {
            let (force, tangent) = at(y, &mut t);
            (force - p, tangent)
        };
        // The bounds follow from the largest suction in either direction.
        let ends = [(p - self.suction.limit).min(0.0), (p + self.suction.limit).max(0.0)];
        let ends = (ends[0] / self.stiffness(CLOSED), ends[1] / self.stiffness(OPEN));
        let y = bracketed_root(excess, ends, c.spring.y.clamp(ends.0, ends.1), self.z50, MAX_ITERATIONS);
        let y = y.unwrap_or(f64::NAN);
        let (_, tangent) = at(y, &mut t);
        t.spring = SpringState { y, p, tangent };
        (t, 0.0)
    }

    fn advance_near_field(&self, c: &NearField, t: &mut NearField, step: SpringIncrement) {
        self.near.advance(c, t, step);
    }

    fn advance_gap(&self, c: &Gap, t: &mut Gap, _: f64, step: SpringIncrement) {
        let from = t.spring.y;
        // A step that crosses the contact point first stops there.
        let dy = match from + step.dy {
            y if from > 0.0 && y < -TOLERANCE => -TOLERANCE - from,
            y if from < 0.0 && y > TOLERANCE => TOLERANCE - from,
            _ => step.dy,
        };
        let y = from + dy;
        let k = self.stiffness(if y <= 0.0 { CLOSED } else { OPEN });
        self.suction.advance((&c.drag_spring, &c.reversal), (&mut t.drag_spring, &mut t.reversal), dy);
        t.spring = SpringState { y, p: k * y + t.drag_spring.p, tangent: k + t.drag_spring.tangent };
    }
}

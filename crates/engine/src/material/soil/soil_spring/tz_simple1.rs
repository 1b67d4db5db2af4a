//! Shaft friction of a pile (t-z spring).

use super::branch::Branch;
use super::{Gap, NearField, Soil, SpringIncrement, SpringState};

/// Elastic limit of a step in multiples of the force tolerance, as in OpenSees.
const ELASTIC: f64 = 10.0;

/// Backbone of a t-z spring.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TzBackbone {
    /// Reese and O'Neill (1987).
    ReeseONeill,
    /// Mosher (1984).
    Mosher,
}

/// A t-z spring.
#[derive(Clone, Debug, PartialEq)]
pub struct TzSimple1 {
    backbone: TzBackbone,
    tult: f64,
    z50: f64,
    near: Branch,
}

impl TzSimple1 {
    /// From the ultimate resistance and the displacement at half of it.
    pub fn new(backbone: TzBackbone, tult: f64, z50: f64) -> Self {
        let (reference, n) = match backbone {
            TzBackbone::ReeseONeill => (0.5 * z50, 1.5),
            TzBackbone::Mosher => (0.6 * z50, 0.85),
        };
        Self { backbone, tult, z50, near: Branch::new([tult, reference, n], 1e-4 * tult / z50, tult, ELASTIC) }
    }
}

impl Soil for TzSimple1 {
    const NAME: &'static str = "TzSimple1";
    const BOUNDED: bool = true;

    fn ultimate_force(&self) -> f64 {
        self.tult
    }

    fn y50(&self) -> f64 {
        self.z50
    }

    fn far_stiffness(&self) -> f64 {
        let part = match self.backbone {
            TzBackbone::ReeseONeill => 0.70791,
            TzBackbone::Mosher => 2.0504,
        };
        part * self.tult / self.z50
    }

    fn virgin(&self) -> (NearField, Gap) {
        let rigid = SpringState { tangent: f64::INFINITY, ..SpringState::default() };
        let spring = SpringState { tangent: self.near.initial(), ..SpringState::default() };
        (NearField { spring, ..NearField::default() }, Gap { spring: rigid, ..Gap::default() })
    }

    fn near_field_at(&self, c: &NearField, p: f64) -> NearField {
        let mut t = *c;
        t.spring = self.near.step_to_force(&c.spring, &mut t.reversals[0], p);
        t
    }

    fn gap_at(&self, c: &Gap, _: f64, _: f64) -> (Gap, f64) {
        (*c, 0.0)
    }

    fn advance_near_field(&self, c: &NearField, t: &mut NearField, step: SpringIncrement) {
        self.near.advance((&c.spring, &c.reversals[0]), (&mut t.spring, &mut t.reversals[0]), step.steady());
    }

    fn advance_gap(&self, _: &Gap, _: &mut Gap, _: f64, _: SpringIncrement) {}
}

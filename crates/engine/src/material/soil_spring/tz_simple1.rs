//! Shaft friction of a pile (t-z spring).

use super::branch::Branch;
use super::{Gap, Near, Part, Soil, Step};

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

    fn ultimate(&self) -> f64 {
        self.tult
    }

    fn y50(&self) -> f64 {
        self.z50
    }

    fn far(&self) -> f64 {
        let part = match self.backbone {
            TzBackbone::ReeseONeill => 0.70791,
            TzBackbone::Mosher => 2.0504,
        };
        part * self.tult / self.z50
    }

    fn virgin(&self) -> (Near, Gap) {
        let rigid = Part { tangent: f64::INFINITY, ..Part::default() };
        let spring = Part { tangent: self.near.initial(), ..Part::default() };
        (Near { spring, ..Near::default() }, Gap { spring: rigid, ..Gap::default() })
    }

    fn yields(&self, c: &Near, p: f64) -> Near {
        let mut t = *c;
        t.spring = self.near.to(&c.spring, &mut t.turns[0], p);
        t
    }

    fn opens(&self, c: &Gap, _: f64, _: f64) -> (Gap, f64) {
        (*c, 0.0)
    }

    fn yields_on(&self, c: &Near, t: &mut Near, step: Step) {
        self.near.go_on((&c.spring, &c.turns[0]), (&mut t.spring, &mut t.turns[0]), step.steady());
    }

    fn opens_on(&self, _: &Gap, _: &mut Gap, _: f64, _: Step) {}
}

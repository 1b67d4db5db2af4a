//! Contact after a gap closes: pounding, moat wall, stopper.

use super::{AmendedForce, AmendmentLaw, DeformationState};
use crate::element::ElementResult;

/// Contact beyond the deformation `at`, separately in each direction: f = k d^p (1 + c ḋ) ≥ 0 with the penetration d.
/// The rate ḋ is Δd over the increment of domain time.
///
/// The law is that of Hunt and Crossley, J. Appl. Mech. 42 (1975); p = 1.5 for Hertz' contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gap {
    /// Deformation at which contact begins, for either sign.
    pub at: f64,
    /// Contact stiffness k, force/length^p.
    pub stiffness: f64,
    /// Exponent p, at least 1.
    pub power: f64,
    /// Damping c, time/length.
    pub damping: f64,
    /// Sides with a wall.
    pub sides: Sides,
}

/// Sides with a wall.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sides {
    /// Both signs of the deformation.
    Both,
    /// Positive deformation.
    Positive,
    /// Negative deformation.
    Negative,
}

impl Gap {
    /// Contact force of a wall on the positive side, and its derivative with respect to `e`.
    fn contact(&self, e: f64, before: f64, dt: f64) -> (f64, f64) {
        let d = e - self.at;
        if d <= 0.0 {
            return (0.0, 0.0);
        }
        let elastic = self.stiffness * d.powf(self.power);
        let slope = self.stiffness * self.power * d.powf(self.power - 1.0);
        if dt <= 0.0 {
            return (elastic, slope);
        }
        let damped = 1.0 + self.damping * (e - before.max(self.at)) / dt;
        if damped <= 0.0 {
            return (0.0, 0.0);
        }
        (elastic * damped, slope * damped + elastic * self.damping / dt)
    }
}

impl AmendmentLaw for Gap {
    type State = ();
    const NAME: &'static str = "gap";

    fn amend(&self, (): &(), d: &DeformationState) -> ElementResult<(AmendedForce, ())> {
        let mut v = AmendedForce::unchanged(d.q);
        for i in 0..2 {
            let mut add = |sign: f64| {
                let (force, slope) = self.contact(sign * d.e[i], sign * d.before[i], d.dt);
                v.q[i] += sign * force;
                v.by_deformation[i][i] += slope;
            };
            if self.sides != Sides::Negative {
                add(1.0);
            }
            if self.sides != Sides::Positive {
                add(-1.0);
            }
        }
        Ok((v, ()))
    }

    fn depends_on_time(&self) -> bool {
        self.damping > 0.0
    }
}

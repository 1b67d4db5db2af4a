//! Ratchet: a strut that follows the closing of its ends without force, and resists their opening.

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw};

/// Teeth of a ratchet at equal distances, or a ratchet without teeth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Teeth {
    /// The point of engagement moves by whole distances.
    Spaced,
    /// The point of engagement stays one distance ahead of the smallest strain.
    Continuous,
}

/// σ = E (ε - ε_e) above the strain of engagement ε_e, 0 below. ε_e moves down when a step ends a free travel below it.
#[derive(Clone, Debug, PartialEq)]
pub struct Ratchet {
    /// Stiffness E.
    pub e: f64,
    /// Free travel between teeth.
    pub travel: f64,
    /// Strain of engagement at the beginning.
    pub first: f64,
    /// Kind.
    pub teeth: Teeth,
}

/// Share of the free travel that counts as engaged, as in OpenSees.
const PRECISION: f64 = 1e-7;

crate::state_struct! {
    /// History of [`Ratchet`].
    pub struct History {
        /// Strain.
        strain: f64,
        /// Strain of engagement less that at the beginning.
        moved: f64,
    }
}

impl Ratchet {
    /// Strain of engagement after a step that ends at a strain.
    fn engagement(&self, c: &History, strain: f64) -> f64 {
        let at = self.first + c.moved;
        if strain > c.strain || strain > at - self.travel {
            return at;
        }
        match self.teeth {
            Teeth::Continuous => strain + self.travel,
            Teeth::Spaced => {
                let over = at - self.travel * (1.0 - PRECISION) - strain;
                at - self.travel * ((over / self.travel).floor() + 1.0)
            }
        }
    }
}

impl UniaxialLaw for Ratchet {
    type State = History;
    const NAME: &'static str = "Ratchet";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let x = strain.value;
        let at = self.first + c.moved;
        let engaged = x >= at - PRECISION * self.travel;
        let (value, tangent) = if engaged { (self.e * (x - at), self.e) } else { (0.0, 0.0) };
        let next = History { strain: x, moved: self.engagement(c, x) - self.first };
        Ok((Stress { value, tangent, damping: 0.0 }, next))
    }

    fn initial_tangent(&self) -> f64 {
        if self.first - PRECISION * self.travel > 0.0 { 0.0 } else { self.e }
    }
}

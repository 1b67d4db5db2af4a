//! Superelastic shape-memory alloy with linear transformations (Auricchio, Taylor and Lubliner, 1997).

use super::{MaterialError, Strain, Stress, UniaxialLaw};

/// σ = E (ε - ξ ε_L) with the martensite fraction ξ, alike in tension and compression. Each transformation ends at its
/// finish stress, on a straight line from the stress at which it starts or at which it is resumed.
#[derive(Clone, Debug, PartialEq)]
pub struct Sma {
    /// Elastic modulus E.
    pub e: f64,
    /// Largest strain of transformation ε_L.
    pub eps_l: f64,
    /// Stresses at the start and finish of austenite to martensite.
    pub forward: [f64; 2],
    /// Stresses at the start and finish of martensite to austenite.
    pub reverse: [f64; 2],
}

crate::state_struct! {
    /// History of [`Sma`].
    pub struct History {
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
        /// Martensite fraction ξ.
        martensite: f64,
        /// Tangent minus the elastic modulus.
        softening: f64,
    }
}

impl Sma {
    /// Fraction and its slope at a strain on one side (both positive there), while it grows.
    fn load(&self, x: f64, stress: f64, m: f64) -> (f64, f64) {
        let ([start, finish], full) = (self.forward, self.e * self.eps_l);
        if x <= start / self.e + m * self.eps_l {
            (m, 0.0)
        } else if x < finish / self.e + self.eps_l {
            let from = stress.max(start);
            let over = (1.0 - m) * full + finish - from;
            (((1.0 - m) * self.e * x + m * finish - from) / over, (1.0 - m) * self.e / over)
        } else {
            (1.0, 0.0)
        }
    }

    /// The same while the strain decreases.
    fn unload(&self, x: f64, stress: f64, m: f64) -> (f64, f64) {
        let ([start, finish], full) = (self.reverse, self.e * self.eps_l);
        if x >= start / self.e + m * self.eps_l {
            (m, 0.0)
        } else if x >= finish / self.e {
            let over = m * full + stress.min(start) - finish;
            (m * (self.e * x - finish) / over, m * self.e / over)
        } else {
            (0.0, 0.0)
        }
    }
}

impl UniaxialLaw for Sma {
    type State = History;
    const NAME: &'static str = "SMA";

    fn update(&self, c: &History, strain: Strain) -> Result<(Stress, History), MaterialError> {
        let x = strain.value;
        if x == c.strain {
            // The direction of the next step is unknown at rest, so the tangent of the last step is kept.
            return Ok((Stress { value: c.stress, tangent: self.e + c.softening, damping: 0.0 }, *c));
        }
        let side = if x < 0.0 { -1.0 } else { 1.0 };
        let (size, stress) = (x.abs(), side * c.stress);
        let grows = side * (x - c.strain) > 0.0;
        let (m, slope) =
            if grows { self.load(size, stress, c.martensite) } else { self.unload(size, stress, c.martensite) };
        let tangent = self.e * (1.0 - self.eps_l * slope);
        let value = side * self.e * (size - m * self.eps_l);
        let next = History { strain: x, stress: value, martensite: m, softening: tangent - self.e };
        Ok((Stress { value, tangent, damping: 0.0 }, next))
    }

    fn initial_tangent(&self) -> f64 {
        self.e
    }
}

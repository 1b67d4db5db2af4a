//! Concrete as by Yassin (1994), with a modulus of its own: Popovics' curve up to the strength.

use crate::material::concrete::popovics;
use crate::material::{MaterialError, Strain, Stress, UniaxialLaw, finite};

/// Stress and tangent of a branch without stress; a positive value keeps the stiffness matrix regular.
const FLAT: f64 = 1.0e-10;

/// [`crate::material::Concrete02`] with an initial modulus.
#[derive(Clone, Debug, PartialEq)]
pub struct Concrete02Is {
    /// Initial modulus.
    pub e0: f64,
    /// Compressive strength, negative.
    pub fc: f64,
    /// Strain at the strength, negative.
    pub epsc0: f64,
    /// Crushing strength, not positive.
    pub fcu: f64,
    /// Strain at the crushing strength, negative.
    pub epscu: f64,
    /// Unloading slope at the crushing strain divided by the initial modulus.
    pub ratio: f64,
    /// Tensile strength.
    pub ft: f64,
    /// Tension softening modulus.
    pub ets: f64,
}

crate::state_struct! {
    /// History of [`Concrete02Is`].
    pub struct History {
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
        /// Initial modulus minus the tangent.
        softening: f64,
        /// Smallest strain.
        min: f64,
        /// Largest tensile strain, measured from the end of unloading.
        tension: f64,
    }
}

impl Concrete02Is {
    fn compression(&self, e: f64) -> (f64, f64) {
        if e >= self.epsc0 {
            return popovics::compression([self.fc, self.epsc0], self.e0, e);
        }
        if e > self.epscu {
            let slope = (self.fcu - self.fc) / (self.epscu - self.epsc0);
            return (slope * (e - self.epsc0) + self.fc, slope);
        }
        (self.fcu, FLAT)
    }

    fn tension(&self, e: f64) -> (f64, f64) {
        let peak = self.ft / self.e0;
        if e <= peak {
            return (e * self.e0, self.e0);
        }
        if e <= self.ft * (1.0 / self.ets + 1.0 / self.e0) {
            return (self.ft - self.ets * (e - peak), -self.ets);
        }
        (FLAT, FLAT)
    }
}

impl UniaxialLaw for Concrete02Is {
    type State = History;
    const NAME: &'static str = "Concrete02IS";

    fn update(&self, c: &History, strain: Strain) -> Result<(Stress, History), MaterialError> {
        let e = strain.value;
        let step = e - c.strain;
        if step.abs() < f64::EPSILON {
            return Ok((Stress { value: c.stress, tangent: self.e0 - c.softening, damping: 0.0 }, *c));
        }
        let mut t = History { strain: e, ..*c };
        let (value, tangent) = if e < c.min {
            t.min = e;
            self.compression(e)
        } else {
            // All reloading branches meet in R (equations 2.31 and 2.32).
            let r = (self.fcu - self.ratio * self.e0 * self.epscu) / (self.e0 * (1.0 - self.ratio));
            let low = self.compression(c.min).0;
            let slope = (low - self.e0 * r) / (c.min - r);
            let end = c.min - low / slope;
            if e <= end {
                let (lower, upper) = (low + slope * (e - c.min), 0.5 * slope * (e - end));
                let elastic = c.stress + self.e0 * step;
                let (f, k) = if elastic <= lower { (lower, slope) } else { (elastic, self.e0) };
                if f >= upper { (upper, 0.5 * slope) } else { (f, k) }
            } else if e <= end + c.tension {
                let k = if c.tension == 0.0 { self.e0 } else { self.tension(c.tension).0 / c.tension };
                (k * (e - end), k)
            } else {
                t.tension = e - end;
                self.tension(e - end)
            }
        };
        (t.stress, t.softening) = (value, self.e0 - tangent);
        finite(Self::NAME, e, value, tangent, t)
    }

    fn initial_tangent(&self) -> f64 {
        self.e0
    }
}

//! Concrete as by Yassin (1994), with a modulus of its own: Popovics' curve up to the strength.

use crate::material::concrete::popovics;
use crate::material::concrete::yassin::{Crushing, History, Yassin};
use crate::material::{MaterialError, Strain, Stress, UniaxialLaw, finite};
use crate::state_struct::StateStruct;

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

impl Yassin for Concrete02Is {
    fn modulus(&self) -> f64 {
        self.e0
    }

    fn crushing(&self) -> Crushing {
        Crushing { fcu: self.fcu, epscu: self.epscu, ratio: self.ratio }
    }

    fn unloading(&self, _: f64, through: f64) -> f64 {
        through
    }

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
        let mut words = [0.0; History::LEN];
        c.write(&mut words);
        let branch = if e < c.min { self.crushes(words, e) } else { self.inside(words, e) };
        let (next, value, tangent) = self.step(words, e, &branch);
        finite(Self::NAME, e, value, tangent, History::read(&next))
    }

    fn initial_tangent(&self) -> f64 {
        self.e0
    }
}

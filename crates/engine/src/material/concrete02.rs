//! Concrete with tension softening: Yassin.

use super::{MaterialError, Strain, Stress, UniaxialLaw};

/// The envelope of Kent, Scott and Park in compression, and linear softening in tension. The unloading and reloading
/// branches are linear and intersect in one point (Yassin, 1994, section 2.3).
#[derive(Clone, Debug, PartialEq)]
pub struct Concrete02 {
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

/// Tangent of the branches with constant stress; a positive value keeps the stiffness matrix regular.
const FLAT_TANGENT: f64 = 1.0e-10;

crate::state_struct! {
    /// History of [`Concrete02`].
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

impl Concrete02 {
    fn modulus(&self) -> f64 {
        2.0 * self.fc / self.epsc0
    }

    /// Stress and slope of the envelope in compression.
    fn compression(&self, eps: f64) -> (f64, f64) {
        if eps >= self.epsc0 {
            let eta = eps / self.epsc0;
            (self.fc * eta * (2.0 - eta), self.modulus() * (1.0 - eta))
        } else if eps > self.epscu {
            let slope = (self.fcu - self.fc) / (self.epscu - self.epsc0);
            (self.fc + slope * (eps - self.epsc0), slope)
        } else {
            (self.fcu, FLAT_TANGENT)
        }
    }

    /// Stress and slope of the envelope in tension.
    fn tension(&self, eps: f64) -> (f64, f64) {
        let modulus = self.modulus();
        let peak = self.ft / modulus;
        if eps <= peak {
            (modulus * eps, modulus)
        } else if eps <= self.ft * (1.0 / self.ets + 1.0 / modulus) {
            (self.ft - self.ets * (eps - peak), -self.ets)
        } else {
            (0.0, FLAT_TANGENT)
        }
    }
}

impl UniaxialLaw for Concrete02 {
    type State = History;
    const NAME: &'static str = "Concrete02";

    #[inline]
    fn update(&self, c: &History, strain: Strain) -> Result<(Stress, History), MaterialError> {
        let (eps, modulus) = (strain.value, self.modulus());
        let step = eps - c.strain;
        if step.abs() < f64::EPSILON {
            return Ok((Stress { value: c.stress, tangent: modulus - c.softening, damping: 0.0 }, *c));
        }
        let mut t = History { strain: eps, ..*c };
        let (value, tangent) = if eps < c.min {
            t.min = eps;
            self.compression(eps)
        } else {
            // All reloading branches intersect in R (equations 2.31 and 2.32); slope 2.35, end of unloading 2.36.
            let eps_r = (self.fcu - self.ratio * modulus * self.epscu) / (modulus * (1.0 - self.ratio));
            let (sig_min, _) = self.compression(c.min);
            let slope = if c.min == 0.0 { modulus } else { (sig_min - modulus * eps_r) / (c.min - eps_r) };
            let end = c.min - sig_min / slope;
            if eps <= end {
                let (lower, upper) = (sig_min + slope * (eps - c.min), 0.5 * slope * (eps - end));
                let elastic = c.stress + modulus * step;
                if elastic.max(lower) >= upper {
                    (upper, 0.5 * slope)
                } else if elastic <= lower {
                    (lower, slope)
                } else {
                    (elastic, modulus)
                }
            } else if eps <= end + c.tension {
                // Reloading to the largest tensile strain is linear, because the path is not stored (equation 2.43).
                let slope = if c.tension == 0.0 { modulus } else { self.tension(c.tension).0 / c.tension };
                (slope * (eps - end), slope)
            } else {
                t.tension = eps - end;
                self.tension(t.tension)
            }
        };
        (t.stress, t.softening) = (value, modulus - tangent);
        Ok((Stress { value, tangent, damping: 0.0 }, t))
    }

    fn initial_tangent(&self) -> f64 {
        self.modulus()
    }
}

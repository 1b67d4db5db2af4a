//! Concrete without tension: Kent, Scott and Park.

use super::{MaterialError, Strain, Stress, UniaxialLaw};

/// Parabola up to the strength, a straight line to the crushing strength, and constant stress beyond; no tension.
/// Unloading is linear, with a slope that degrades with the largest compressive strain (Kent and Park, 1971; Karsan
/// and Jirsa, 1969).
#[derive(Clone, Debug, PartialEq)]
pub struct Concrete01 {
    /// Compressive strength, negative.
    pub fpc: f64,
    /// Strain at the strength, negative.
    pub epsc0: f64,
    /// Crushing strength, not positive.
    pub fpcu: f64,
    /// Strain at the crushing strength, negative.
    pub epscu: f64,
}

crate::state_struct! {
    /// History of [`Concrete01`].
    pub struct History {
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
        /// Initial modulus minus the tangent.
        softening: f64,
        /// Smallest strain.
        min: f64,
        /// Strain of zero stress on the unloading line from the smallest strain.
        end: f64,
        /// Initial modulus minus the unloading slope.
        unloading: f64,
    }
}

impl Concrete01 {
    fn modulus(&self) -> f64 {
        2.0 * self.fpc / self.epsc0
    }

    /// Stress and slope of the envelope.
    fn envelope(&self, eps: f64) -> (f64, f64) {
        if eps > self.epsc0 {
            let eta = eps / self.epsc0;
            (self.fpc * (2.0 * eta - eta * eta), self.modulus() * (1.0 - eta))
        } else if eps > self.epscu {
            let slope = (self.fpc - self.fpcu) / (self.epsc0 - self.epscu);
            (self.fpc + slope * (eps - self.epsc0), slope)
        } else {
            (self.fpcu, 0.0)
        }
    }

    /// Strain of zero stress and slope of the unloading line from a point of the envelope.
    fn unload(&self, min: f64, stress: f64) -> (f64, f64) {
        let eta = min.max(self.epscu) / self.epsc0;
        let ratio = if eta < 2.0 { 0.145 * eta * eta + 0.13 * eta } else { 0.707 * (eta - 2.0) + 0.834 };
        let length = min - ratio * self.epsc0;
        let elastic = stress / self.modulus();
        if length > -f64::EPSILON {
            (ratio * self.epsc0, self.modulus())
        } else if length <= elastic {
            (min - length, stress / length)
        } else {
            (min - elastic, self.modulus())
        }
    }
}

impl UniaxialLaw for Concrete01 {
    type State = History;
    const NAME: &'static str = "Concrete01";

    #[inline]
    fn update(&self, c: &History, strain: Strain) -> Result<(Stress, History), MaterialError> {
        let eps = strain.value;
        let modulus = self.modulus();
        if (eps - c.strain).abs() < f64::EPSILON {
            return Ok((Stress { value: c.stress, tangent: modulus - c.softening, damping: 0.0 }, *c));
        }
        let mut t = History { strain: eps, ..*c };
        let slope = modulus - c.unloading;
        let straight = c.stress + slope * (eps - c.strain);
        let (value, tangent) = if eps > 0.0 {
            (0.0, 0.0)
        } else if eps >= c.strain {
            if straight <= 0.0 { (straight, slope) } else { (0.0, 0.0) }
        } else {
            let (stress, tangent) = if eps <= c.min {
                let (stress, tangent) = self.envelope(eps);
                let (end, slope) = self.unload(eps, stress);
                (t.min, t.end, t.unloading) = (eps, end, modulus - slope);
                (stress, tangent)
            } else if eps <= c.end {
                (slope * (eps - c.end), slope)
            } else {
                (0.0, 0.0)
            };
            // The unloading slope of the present step applies if unloading begins on the envelope.
            if straight > stress { (straight, modulus - t.unloading) } else { (stress, tangent) }
        };
        (t.stress, t.softening) = (value, modulus - tangent);
        Ok((Stress { value, tangent, damping: 0.0 }, t))
    }

    fn set_parameter(&mut self, name: &str, value: f64) -> Option<f64> {
        let place = match name {
            "fc" => &mut self.fpc,
            "epsco" => &mut self.epsc0,
            "fcu" => &mut self.fpcu,
            "epscu" => &mut self.epscu,
            _ => return None,
        };
        Some(std::mem::replace(place, value))
    }

    fn initial_tangent(&self) -> f64 {
        self.modulus()
    }
}

//! Concrete by Popovics' curve, with linear unloading and exponential softening in tension (Popovics, 1973; Karsan and Jirsa, 1969).

use crate::material::concrete::karsan_jirsa::{permanent_strain, unloading_line};
use crate::material::concrete::popovics;
use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw};

/// Concrete in compression and tension.
#[derive(Clone, Debug, PartialEq)]
pub struct Concrete04 {
    /// Compressive strength, negative.
    pub fc: f64,
    /// Strain at the strength, negative.
    pub epsc0: f64,
    /// Crushing strain, negative.
    pub epscu: f64,
    /// Initial modulus.
    pub ec0: f64,
    /// Tensile strength; zero for none.
    pub ft: f64,
    /// Ultimate strain in tension.
    pub etu: f64,
    /// Stress at the ultimate strain in tension divided by the tensile strength.
    pub beta: f64,
}

crate::state_struct! {
    /// History of [`Concrete04`].
    pub struct History {
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
        /// Tangent minus the initial modulus.
        softening: f64,
        /// Smallest strain.
        least: f64,
        /// Largest strain.
        largest: f64,
        /// Strain of zero stress after compression.
        end: f64,
        /// Slope of unloading in compression minus the initial modulus.
        unloading: f64,
        /// Slope of unloading in tension.
        tension: f64,
    }
}

impl Concrete04 {
    /// Stress and slope on the envelope in compression.
    fn compression(&self, x: f64) -> (f64, f64) {
        if x < self.epscu {
            return (0.0, 0.0);
        }
        let (stress, slope) = popovics::compression([self.fc, self.epsc0], self.ec0, x);
        // The power may overflow far beyond the strength.
        (stress, if slope.is_finite() { slope } else { 0.0 })
    }

    /// Stress and slope on the envelope in tension.
    fn tension(&self, x: f64) -> (f64, f64) {
        let cracking = self.ft / self.ec0;
        if x <= cracking {
            (x * self.ec0, self.ec0)
        } else if x > self.etu || self.beta <= 0.0 {
            (0.0, 0.0)
        } else {
            let stress = self.ft * self.beta.powf((x - cracking) / (self.etu - cracking));
            (stress, stress * self.beta.ln() / (self.etu - cracking))
        }
    }

    /// Stress and tangent at a trial strain.
    fn respond(&self, d: f64, c: &History, t: &mut History) -> (f64, f64) {
        let (x, slope) = (t.strain, self.ec0 + c.unloading);
        if x > 0.0 || (x == 0.0 && d > 0.0) {
            if d <= 0.0 || x < c.largest {
                return (x * c.tension, c.tension);
            }
            t.largest = x;
            let (stress, slope) = self.tension(x);
            t.tension = if x > 0.0 { stress / x } else { self.ec0 };
            (stress, slope)
        } else if d <= 0.0 && x <= c.least {
            t.least = x;
            let (stress, slope) = self.compression(x);
            let permanent = permanent_strain(x, self.epsc0, self.epscu);
            let (end, unloading) = unloading_line([x, stress], permanent, self.ec0);
            (t.end, t.unloading) = (end, unloading - self.ec0);
            (stress, slope)
        } else if x <= c.end {
            (slope * (x - c.end), slope)
        } else {
            (0.0, 0.0)
        }
    }
}

impl UniaxialLaw for Concrete04 {
    type State = History;
    const NAME: &'static str = "Concrete04";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let d = strain.value - c.strain;
        let mut t = *c;
        let (value, tangent) = if self.ft == 0.0 && strain.value > 0.0 {
            (t.strain, t.tension) = (strain.value, 0.0);
            (0.0, 0.0)
        } else if d.abs() < f64::EPSILON {
            (c.stress, self.ec0 + c.softening)
        } else {
            t.strain = strain.value;
            self.respond(d, c, &mut t)
        };
        (t.stress, t.softening) = (value, tangent - self.ec0);
        Ok((Stress { value, tangent, damping: 0.0 }, t))
    }

    fn initial_tangent(&self) -> f64 {
        self.ec0
    }
}

//! Concrete with Thorenfeldt's curve in compression and tension stiffening after Belarbi and Hsu, with reloading of
//! Palermo and Vecchio (2003, <https://doi.org/10.14359/12804>).

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw, finite};

/// Largest slope of the upper line of reloading, over the initial modulus (Seckin, 1981).
const UPPER_SLOPE: f64 = 0.071;
/// Smallest strain of compression that counts.
const FIRST_STRAIN: f64 = -1e-8;

/// Concrete with damage of strain on either side.
#[derive(Clone, Debug, PartialEq)]
pub struct Concrete06 {
    /// Compressive strength, negative.
    pub fc: f64,
    /// Strain at the strength, negative.
    pub eo: f64,
    /// Shape of the curve in compression, greater than 1.
    pub r: f64,
    /// Steepness after the strength.
    pub k: f64,
    /// Rate of the plastic strain in compression.
    pub alpha_c: f64,
    /// Tensile strength.
    pub fcr: f64,
    /// Strain at the tensile strength.
    pub ecr: f64,
    /// Exponent of tension stiffening.
    pub b: f64,
    /// Rate of the plastic strain in tension.
    pub alpha_t: f64,
}

crate::state_struct! {
    /// History of [`Concrete06`].
    pub struct History {
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
        /// 1 after the first strain: the variables below are set.
        begun: f64,
        /// Smallest strain, and its stress.
        low: [f64; 2],
        /// Largest stress on the envelope in tension.
        high: f64,
        /// Strain of zero stress, that after tension, and their sum over the cracks.
        zero: f64,
        /// Strain of zero stress after tension.
        zero_tension: f64,
        /// Strain that earlier cracks have left.
        shift: f64,
        /// Modulus of unloading from tension.
        tension_slope: f64,
        /// Lower slope of reloading after compression, and after tension.
        reloading: [f64; 2],
    }
}

impl Concrete06 {
    fn modulus(&self) -> f64 {
        self.fc / self.eo * self.r / (self.r - 1.0)
    }

    fn compression(&self, e: f64) -> (f64, f64) {
        let (x, r) = (e / self.eo, self.r);
        let k = if e > self.eo { 1.0 } else { self.k };
        let power = x.powf(k * r);
        let d = r - 1.0 + power;
        if d.is_infinite() {
            return (0.0, 0.0);
        }
        (self.fc * (r * x / d), self.fc / self.eo * (r / d - k * r * r * power / (d * d)))
    }

    fn tension(&self, e: f64) -> (f64, f64) {
        if e + f64::EPSILON >= self.ecr {
            let stress = self.fcr * (self.ecr / e).powf(self.b);
            return (stress, -stress * self.b / e);
        }
        let slope = self.fcr / self.ecr;
        (slope * e, slope)
    }

    /// Between the lines of reloading and unloading.
    fn inside(&self, c: &History, slope: f64, e: f64) -> (f64, f64) {
        let modulus = self.modulus();
        let lower = c.low[1] + slope * (e - c.low[0]);
        let flat = slope.min(UPPER_SLOPE * modulus);
        let upper = flat * (e - c.zero);
        let elastic = c.stress + modulus * (e - c.strain);
        if lower - f64::EPSILON <= elastic && upper + f64::EPSILON >= elastic {
            (elastic, modulus)
        } else if upper - f64::EPSILON <= elastic {
            (upper, flat)
        } else {
            (lower, slope)
        }
    }

    fn begin(&self) -> History {
        let (modulus, low) = (self.modulus(), self.compression(FIRST_STRAIN).0);
        History {
            begun: 1.0,
            low: [FIRST_STRAIN, low],
            high: self.fcr,
            tension_slope: self.fcr / self.ecr,
            reloading: [modulus; 2],
            ..History::default()
        }
    }
}

impl UniaxialLaw for Concrete06 {
    type State = History;
    const NAME: &'static str = "Concrete06";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let begun = if c.begun == 0.0 { self.begin() } else { *c };
        let (c, e) = (&begun, strain.value);
        let mut t = History { strain: e, ..*c };
        let modulus = self.modulus();
        let cracked = (c.zero - c.zero_tension).abs() <= f64::EPSILON;
        let (value, tangent) = if e - f64::EPSILON <= c.low[0] {
            let (f, slope) = self.compression(e);
            t.low = [e, f];
            t.zero = ((1.0 - (-e / self.eo * self.alpha_c).exp()) * e).max(e - f / modulus);
            t.reloading[0] = (f / (e - t.zero)).min(modulus);
            (f, slope)
        } else if e + f64::EPSILON <= c.zero {
            self.inside(c, c.reloading[usize::from(cracked)], e)
        } else if e - c.zero + f64::EPSILON <= c.high / c.tension_slope {
            (c.tension_slope * (e - c.zero), c.tension_slope)
        } else {
            let initial = self.fcr / self.ecr;
            let (f, slope) = self.tension(e - c.zero + c.shift);
            t.high = f;
            t.zero_tension = ((1.0 - (-e / self.ecr * self.alpha_t).exp()) * e).min(e - f / initial);
            t.tension_slope = (f / (e - t.zero_tension)).min(initial);
            t.shift = t.zero_tension - c.zero + c.shift;
            t.reloading[1] = c.low[1] / (c.low[0] - t.zero_tension);
            t.zero = t.zero_tension;
            (f, slope)
        };
        t.stress = value;
        finite(Self::NAME, e, value, tangent, t)
    }

    fn initial_tangent(&self) -> f64 {
        self.modulus()
    }
}

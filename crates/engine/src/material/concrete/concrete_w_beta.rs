//! Concrete of planar trusses and panels (Lu and Panagiotou, 2014, <https://doi.org/10.1061/(ASCE)ST.1943-541X.0000875>).

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw, finite};

/// Factor of the rate of tension stiffening over the root of its share (Stevens, Uzumeri, Collins and Will, 1991).
const STIFFENING_RATE: f64 = 540.0;

/// Concrete with multilinear softening on either side, and an aim of its own for the first closure of cracks.
#[derive(Clone, Debug, PartialEq)]
pub struct ConcreteWBeta {
    /// Strength and its strain: compressive, negative.
    pub peak: [f64; 2],
    /// Strength and its strain with confinement.
    pub confined: [f64; 2],
    /// Stress and strain in the middle of softening in compression.
    pub middle: [f64; 2],
    /// Residual stress and strain in compression.
    pub residual: [f64; 2],
    /// Tensile strength.
    pub ft: f64,
    /// Stress and strain in the middle of softening in tension.
    pub tension_middle: [f64; 2],
    /// Residual stress and strain in tension.
    pub tension_residual: [f64; 2],
    /// Share of the secant modulus in the modulus of unloading from compression.
    pub lambda: f64,
    /// Compressive stress over tensile strength at which cracks have closed.
    pub alpha: f64,
    /// Share of the tensile strength that tension stiffening leaves; 0 for the points of softening.
    pub stiffening: f64,
    /// Initial modulus, from the secant modulus of the strength to twice that.
    pub e0: f64,
}

crate::state_struct! {
    /// History of [`ConcreteWBeta`].
    pub struct History {
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
        /// Initial modulus minus the tangent.
        softening: f64,
        /// Smallest strain, and the stress there.
        low: [f64; 2],
        /// Largest strain, and the stress there.
        high: [f64; 2],
    }
}

/// A line through two points, each stress and strain: stress and slope.
fn line([f, x]: [f64; 2], [f1, x1]: [f64; 2], e: f64) -> (f64, f64) {
    let slope = if x == x1 { 0.0 } else { (f - f1) / (x - x1) };
    (slope * (e - x1) + f1, slope)
}

impl ConcreteWBeta {
    /// Strain and stress at which cracks have closed.
    fn closed(&self) -> [f64; 2] {
        let ([fpc, ec0], stress) = (self.peak, -self.alpha * self.ft);
        let bend = (fpc - self.e0 * ec0) / (ec0 * ec0);
        if bend == 0.0 {
            return [stress / self.e0, stress];
        }
        let root = (self.e0 * self.e0 + 4.0 * bend * stress).sqrt();
        let [a, b] = [root, -root].map(|r| (r - self.e0) / (fpc - self.e0 * ec0) * 0.5 * (ec0 * ec0));
        [if a > b && a <= 0.0 { a } else { b }, stress]
    }

    /// Envelope in tension.
    fn tension(&self, e: f64) -> (f64, f64) {
        let first = self.ft / self.e0;
        if e <= first {
            return (self.e0 * e, self.e0);
        }
        if self.stiffening != 0.0 {
            let rate = if self.stiffening > 0.0 { STIFFENING_RATE / self.stiffening.sqrt() } else { 0.0 };
            let lost = self.ft * (1.0 - self.stiffening) * (-rate * (e - first)).exp();
            return (lost + self.ft * self.stiffening, -rate * lost);
        }
        match e {
            e if e <= self.tension_middle[1] => line([self.ft, first], self.tension_middle, e),
            e if e <= self.tension_residual[1] => line(self.tension_middle, self.tension_residual, e),
            _ => (self.tension_residual[0], 0.0),
        }
    }

    /// Envelope in compression.
    fn compression(&self, e: f64) -> (f64, f64) {
        let ([fpc, ec0], [fcc, ecc]) = (self.peak, self.confined);
        match e {
            e if e >= ec0 => {
                let bend = fpc / (ec0 * ec0) - self.e0 / ec0;
                (self.e0 * e + bend * (e * e), self.e0 + 2.0 * bend * e)
            }
            e if e >= ecc => {
                let bend = (fpc - fcc) / (ec0 - ecc).powi(3) * (e - ecc).powi(2);
                (bend * (e - ecc) + fcc, 3.0 * bend)
            }
            e if e >= self.middle[1] => line(self.confined, self.middle, e),
            e if e >= self.residual[1] => line(self.middle, self.residual, e),
            _ => (self.residual[0], 0.0),
        }
    }

    /// Stress and slope towards tension.
    fn up(&self, c: &History, e: f64) -> (f64, f64) {
        let (step, [high, peak]) = (e - c.strain, c.high);
        if e > high {
            return self.tension(e);
        }
        let to_peak = (peak - c.stress) / (high - c.strain);
        if c.stress < 0.0 {
            let secant = if c.strain == 0.0 { 0.0 } else { c.stress / c.strain };
            if secant > self.e0 || secant < 0.0 {
                return (to_peak * step + c.stress, to_peak);
            }
            let slope = (1.0 - self.lambda) * self.e0 + self.lambda * secant;
            let stress = slope * step + c.stress;
            if stress <= 0.0 {
                return (stress, slope);
            }
            let zero = e - stress / slope;
            let slope = peak / (high - zero);
            return (slope * (e - zero), slope);
        }
        let to_origin = c.stress / c.strain;
        let slope = if e < 0.0 && to_origin > to_peak { to_origin } else { to_peak };
        (slope * step + c.stress, slope)
    }

    /// Stress and slope towards compression.
    fn down(&self, c: &History, e: f64) -> (f64, f64) {
        let (step, [closed, aim]) = (e - c.strain, self.closed());
        if e - c.low[0] <= f64::EPSILON {
            if e >= closed && c.high[0] > 0.0 {
                let slope = (aim - c.stress) / (closed - c.strain);
                return (slope * step + c.stress, slope);
            }
            return self.compression(e);
        }
        if self.e0 * step + c.stress >= 0.0 {
            return (self.e0 * step + c.stress, self.e0);
        }
        // Tension is unloaded first.
        let (x, f) = if c.stress > 0.0 { (c.strain - c.stress / self.e0, 0.0) } else { (c.strain, c.stress) };
        let to_low = (c.low[1] - f) / (c.low[0] - x);
        if x >= closed {
            let to_aim = (aim - f) / (closed - x);
            let slope = if (to_aim > to_low && c.low[0] <= self.peak[1]) || x == closed { to_low } else { to_aim };
            return (slope * (e - x) + f, slope);
        }
        // The slope is that from the place before the tension was unloaded.
        let slope = (c.low[1] - c.stress) / (c.low[0] - c.strain);
        (slope * (e - x) + f, slope)
    }
}

impl UniaxialLaw for ConcreteWBeta {
    type State = History;
    const NAME: &'static str = "ConcretewBeta";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let e = strain.value;
        if (e - c.strain).abs() < f64::EPSILON {
            return Ok((Stress { value: c.stress, tangent: self.e0 - c.softening, damping: 0.0 }, *c));
        }
        let (value, tangent) = if e > c.strain { self.up(c, e) } else { self.down(c, e) };
        let mut t = History { strain: e, stress: value, softening: self.e0 - tangent, ..*c };
        if e >= c.high[0] {
            t.high = [e, value];
        } else if e <= c.low[0] {
            t.low = [e, value];
        }
        finite(Self::NAME, e, value, tangent, t)
    }

    fn initial_tangent(&self) -> f64 {
        self.e0
    }
}

//! Concrete of the Chinese code for the design of concrete structures (GB 50010-2010, appendix C), with plastic strains.

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw, finite};

/// Base of the growth of the plastic strain, as OpenSees has it.
const GROWTH: f64 = 2718.0 / 1000.0;

/// Concrete with damage in tension and in compression.
#[derive(Clone, Debug, PartialEq)]
pub struct ConcreteD {
    /// Compressive strength, negative.
    pub fc: f64,
    /// Strain at the strength, negative.
    pub ec: f64,
    /// Tensile strength.
    pub ft: f64,
    /// Strain at the tensile strength.
    pub et: f64,
    /// Initial modulus, greater than the secant moduli of the strengths.
    pub modulus: f64,
    /// Softening in compression and in tension.
    pub alpha: [f64; 2],
    /// Factor and exponent of the plastic strain.
    pub plastic: [f64; 2],
}

crate::state_struct! {
    /// History of [`ConcreteD`].
    pub struct History {
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
        /// Initial modulus minus the tangent.
        softening: f64,
        /// 1 off the envelopes.
        inside: f64,
        /// Damage of compression.
        compressed: f64,
        /// Damage of tension.
        tensioned: f64,
        /// Loss of stiffness in unloading from compression.
        loss_low: f64,
        /// Loss of stiffness in unloading from tension.
        loss_high: f64,
        /// Plastic strain.
        plastic: f64,
        /// Strain at which the envelope in compression was left.
        low: f64,
        /// Strain at which that in tension was left, from the plastic strain on.
        high: f64,
    }
}

/// Damage over the strain `x`, over that at the strength, and its derivative. `ratio` is the secant modulus of the
/// strength over the initial one.
fn damage(x: f64, ratio: f64, alpha: f64) -> (f64, f64) {
    if x < 1.0 {
        let n = 1.0 / (1.0 - ratio);
        let d = n - 1.0 + x.powf(n);
        return (1.0 - ratio * n / d, n * n * ratio * x.powf(n - 1.0) / (d * d));
    }
    let d = alpha * (x - 1.0) * (x - 1.0) + x;
    (1.0 - ratio / d, ratio * (alpha * 2.0 * (x - 1.0) + 1.0) / (d * d))
}

impl ConcreteD {
    /// Stress and slope on an envelope.
    fn envelope(&self, t: &mut History, e: f64) -> (f64, f64) {
        let modulus = self.modulus;
        if e >= t.plastic {
            t.high = e - t.plastic;
            let (d, slope) = damage(t.high / self.et, self.ft / (modulus * self.et), self.alpha[1]);
            t.tensioned = d;
            t.loss_high = d + t.compressed - d * t.compressed;
            let whole = 1.0 - t.compressed;
            return ((1.0 - t.loss_high) * modulus * t.high, modulus * whole * (1.0 - d - slope / self.et * t.high));
        }
        t.low = e;
        let (d, slope) = damage(e / self.ec, self.fc / (modulus * self.ec), self.alpha[0]);
        t.compressed = d;
        t.loss_high = t.tensioned + d - t.tensioned * d;
        let share = self.plastic[0] * (GROWTH.powf(d * self.plastic[1]) - 1.0);
        t.plastic = share * e;
        t.loss_low = (d - share) / (1.0 - share);
        ((1.0 - t.loss_low) * modulus * (e - t.plastic), modulus * (1.0 - d - slope / self.ec * e))
    }
}

impl UniaxialLaw for ConcreteD {
    type State = History;
    const NAME: &'static str = "ConcreteD";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let e = strain.value;
        let step = e - c.strain;
        if step.abs() < f64::EPSILON {
            return Ok((Stress { value: c.stress, tangent: self.modulus - c.softening, damping: 0.0 }, *c));
        }
        let mut t = History { strain: e, ..*c };
        let opens = e > c.plastic;
        let on_envelope = match (c.inside == 0.0, opens) {
            (true, true) => step > 0.0,
            (true, false) => step < 0.0,
            (false, true) => e - c.plastic >= c.high,
            (false, false) => e <= c.low,
        };
        t.inside = f64::from(!on_envelope);
        let (value, tangent) = if on_envelope {
            self.envelope(&mut t, e)
        } else {
            let slope = (1.0 - if opens { c.loss_high } else { c.loss_low }) * self.modulus;
            (slope * (e - c.plastic), slope)
        };
        (t.stress, t.softening) = (value, self.modulus - tangent);
        finite(Self::NAME, e, value, tangent, t)
    }

    fn initial_tangent(&self) -> f64 {
        self.modulus
    }
}

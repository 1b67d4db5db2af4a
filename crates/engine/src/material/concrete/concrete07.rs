//! Concrete with the envelopes of Tsai and a simplified hysteresis (Chang and Mander, 1994; Waugh, 2009).

mod trial;

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw, finite};
use trial::Trial;

/// Concrete of Chang and Mander with simple rules of unloading.
#[derive(Clone, Debug, PartialEq)]
pub struct Concrete07 {
    /// Compressive strength and its strain, negative.
    pub compression: [f64; 2],
    /// Tensile strength and its strain.
    pub tension: [f64; 2],
    /// Initial modulus.
    pub ec: f64,
    /// Strain divided by that of the strength where the envelope becomes straight, in tension.
    pub critical_tension: f64,
    /// The same in compression.
    pub critical_compression: f64,
    /// Shape of the envelopes.
    pub r: f64,
    /// Part of its strain that cracked concrete commits where it leaves the compressive envelope; 0 in OpenSees.
    pub kept_strain: f64,
}

crate::state_struct! {
    /// History of [`Concrete07`].
    pub struct History {
        /// Least strain and its stress.
        least: [f64; 2],
        /// Largest strain and its stress.
        largest: [f64; 2],
        /// Strain and stress at the last reversal towards tension.
        unload: [f64; 2],
        /// Strain and stress at the last reversal towards compression.
        reload: [f64; 2],
        /// Strain where the last closing curve of a crack begins.
        closing: f64,
        /// Strain and stress where that curve was left.
        left: [f64; 2],
        /// 1 towards compression, -1 towards tension, 0 virgin.
        loading: f64,
        /// 1 if cracked or spalled.
        cracked: f64,
        /// Number of the branch.
        rule: f64,
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
        /// Tangent minus the initial modulus.
        softening: f64,
    }
}

/// A stress and its slope.
type Curve = (f64, f64);

impl Concrete07 {
    /// The curve of Tsai: stress divided by the strength and slope divided by the initial modulus.
    fn tsai(&self, x: f64, n: f64) -> Curve {
        if x <= 0.0 {
            return (0.0, 1.0);
        }
        let r = self.r;
        let d =
            if r == 1.0 { 1.0 + (n - 1.0 + x.ln()) * x } else { 1.0 + (n - r / (r - 1.0)) * x + x.powf(r) / (r - 1.0) };
        (n * x / d, (1.0 - x.powf(r)) / (d * d))
    }

    /// Stress and slope of an envelope at a strain divided by that of the strength, and true beyond its end.
    fn envelope(&self, [strength, strain]: [f64; 2], critical: f64, x: f64) -> (Curve, bool) {
        let n = self.ec * strain / strength;
        if x < critical {
            let (y, z) = self.tsai(x, n);
            return ((strength * y, self.ec * z), false);
        }
        let (y, z) = self.tsai(critical, n);
        if x <= critical - y / (n * z) {
            return ((strength * (y + n * z * (x - critical)), self.ec * z), false);
        }
        ((0.0, 0.0), true)
    }

    /// Strain of the end of an envelope divided by that of the strength.
    fn end(&self, [strength, strain]: [f64; 2], critical: f64) -> f64 {
        let n = self.ec * strain / strength;
        let (y, z) = self.tsai(critical, n);
        critical - y / (n * z)
    }

    /// Secant modulus of unloading from compression to zero stress.
    fn compressive_secant(&self, [e, f]: [f64; 2]) -> f64 {
        let [_, e0] = self.compression;
        self.ec * ((f / (self.ec * e0) + 0.57) / (e / e0 + 0.57))
    }
}

impl UniaxialLaw for Concrete07 {
    type State = History;
    const NAME: &'static str = "Concrete07";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let e = strain.value;
        let mut t = Trial {
            law: self,
            committed: c,
            next: History { strain: e, ..*c },
            e,
            low: c.least,
            high: c.largest,
            plastic: [0.0; 2],
            secant: self.compressive_secant(c.least),
        };
        t.plastic[0] = t.low[0] - t.low[1] / t.secant;
        let depth = t.low[0] / self.compression[1];
        if depth > self.end(self.compression, self.critical_compression) {
            t.next.cracked = 1.0;
        } else if t.high[0] == 0.0 {
            // Compression shifts the first point of unloading in tension.
            let (curve, _) = self.envelope(self.tension, self.critical_tension, depth);
            t.high = [depth * self.tension[1], curve.0];
            t.next.largest = t.high;
        }
        let [ft, et] = self.tension;
        let secant = self.ec * ((t.high[1] / (self.ec * et) + 0.67) / (t.high[0] / et + 0.67));
        t.plastic[1] = (t.high[0] - t.high[1] / secant).max(0.0);
        debug_assert!(ft > 0.0);
        if e >= 0.0 && e / et > self.end(self.tension, self.critical_tension) {
            t.next.cracked = 1.0;
        }
        let d = e - c.strain;
        let (value, tangent) = if d.abs() <= f64::EPSILON {
            (c.stress, self.ec + c.softening)
        } else if c.loading == 0.0 {
            t.next.loading = if e >= 0.0 { -1.0 } else { 1.0 };
            if e >= 0.0 { t.on_tension() } else { t.on_compression() }
        } else {
            match (c.loading > 0.0, d < 0.0) {
                (true, true) => t.continues_to_compression(),
                (true, false) => t.turns_to_tension(),
                (false, false) => t.continues_to_tension(),
                (false, true) => t.turns_to_compression(),
            }
        };
        let mut next = t.next;
        (next.stress, next.softening) = (value, tangent - self.ec);
        finite(Self::NAME, e, value, tangent, next)
    }

    fn initial_tangent(&self) -> f64 {
        self.ec
    }
}

//! Concrete confined by stirrups and jackets (Braga, Gigliotti and Laterza, 2006), unloading of Karsan and Jirsa (1969).

mod confinement;

use crate::material::concrete::karsan_jirsa::permanent_strain;
use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw, finite};
pub use confinement::{Confinement, ConfinementSection, Dilation, Hoop, UltimateStrain};

/// Concrete without tension along a given envelope.
#[derive(Clone, Debug, PartialEq)]
pub struct ConfinedConcrete01 {
    /// Strain and stress of the points of the envelope, negative, beginning at zero.
    envelope: Vec<[f64; 2]>,
    /// Strain at the strength, negative.
    peak: f64,
    /// Ultimate strain, negative.
    ultimate: f64,
    /// Initial modulus.
    modulus: f64,
}

crate::state_struct! {
    /// History of [`ConfinedConcrete01`].
    pub struct History {
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
        /// Tangent minus the initial modulus.
        softening: f64,
        /// Least strain.
        min: f64,
        /// Strain of zero stress on the unloading line from the least strain.
        end: f64,
        /// Unloading slope minus the initial modulus.
        unloading: f64,
    }
}

impl ConfinedConcrete01 {
    /// Number of points of the envelope.
    pub fn points(&self) -> usize {
        self.envelope.len()
    }

    /// Stress and slope of the envelope. The stress of its last point goes on to the ultimate strain.
    fn envelope(&self, e: f64) -> (f64, f64) {
        if e > 0.0 || e < self.ultimate {
            return (0.0, 0.0);
        }
        let after = self.envelope.partition_point(|p| p[0] >= e);
        match (after, self.envelope.get(after)) {
            (0, _) | (_, None) => (self.envelope[self.envelope.len() - 1][1], 0.0),
            (i, Some(to)) => {
                let from = self.envelope[i - 1];
                let slope = (to[1] - from[1]) / (to[0] - from[0]);
                (from[1] + slope * (e - from[0]), slope)
            }
        }
    }

    /// Strain of zero stress and slope of the unloading line from a point of the envelope.
    fn unload(&self, min: f64, stress: f64) -> (f64, f64) {
        let end = permanent_strain(min, self.peak, self.ultimate);
        let (length, elastic) = (min - end, stress / self.modulus);
        if length > -f64::EPSILON {
            (end, self.modulus)
        } else if length <= elastic {
            (end, stress / length)
        } else {
            (min - elastic, self.modulus)
        }
    }
}

impl UniaxialLaw for ConfinedConcrete01 {
    type State = History;
    const NAME: &'static str = "ConfinedConcrete01";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let e = strain.value;
        let d = e - c.strain;
        if d.abs() < f64::EPSILON {
            return Ok((Stress { value: c.stress, tangent: self.modulus + c.softening, damping: 0.0 }, *c));
        }
        let mut t = History { strain: e, ..*c };
        let slope = self.modulus + c.unloading;
        let straight = c.stress + slope * d;
        let (value, tangent) = if e > 0.0 {
            (0.0, 0.0)
        } else if d < 0.0 {
            let reloading = if e <= c.min {
                let (value, tangent) = self.envelope(e);
                let (end, slope) = self.unload(e, value);
                (t.min, t.end, t.unloading) = (e, end, slope - self.modulus);
                (value, tangent)
            } else if e <= c.end {
                (slope * (e - c.end), slope)
            } else {
                (0.0, 0.0)
            };
            if straight > reloading.0 { (straight, slope) } else { reloading }
        } else if straight <= 0.0 {
            (straight, slope)
        } else {
            (0.0, 0.0)
        };
        (t.stress, t.softening) = (value, tangent - self.modulus);
        finite(Self::NAME, e, value, tangent, t)
    }

    fn initial_tangent(&self) -> f64 {
        self.modulus
    }
}

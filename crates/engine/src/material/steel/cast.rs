//! Yielding fingers of a cast steel brace (Gray, Christopoulos and Packer, 2010, and Lignos).

use super::steel_fracture_di::transition;
use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw, finite};

/// Differences of strains that count as none.
const NONE: f64 = 10.0 * f64::EPSILON;
/// Exponent of isotropic hardening.
const HARDENING_EXPONENT: f64 = 0.8;

/// A yielding connector whose fingers bend, and pull at large deformations.
#[derive(Clone, Debug, PartialEq)]
pub struct Cast {
    /// Number of fingers.
    pub legs: f64,
    /// Width of a finger at its base.
    pub width: f64,
    /// Thickness of a finger.
    pub thickness: f64,
    /// Length of a finger.
    pub length: f64,
    /// Yield stress.
    pub fy: f64,
    /// Elastic modulus.
    pub e: f64,
    /// Hardening ratio.
    pub b: f64,
    /// Radius of the curve between elastic and hardening, and its two coefficients.
    pub r: [f64; 3],
    /// Isotropic hardening a1 to a4.
    pub a: [f64; 4],
}

crate::state_struct! {
    /// History of [`Cast`].
    pub struct History {
        /// 1 tension, -1 compression, 0 virgin.
        loading: f64,
        /// Deformation.
        strain: f64,
        /// Force.
        stress: f64,
        /// Least and largest deformation at turns.
        extreme: [f64; 2],
        /// Extreme deformation that this half-cycle goes away from.
        plastic: f64,
        /// Deformation and force where the asymptotes meet.
        corner: [f64; 2],
        /// Deformation and force of the last turn, without the pull.
        turn: [f64; 2],
    }
}

impl Cast {
    /// Initial stiffness of the fingers.
    fn stiffness(&self) -> f64 {
        1.0 / 6.0 * self.legs * self.width * self.e * (self.thickness / self.length).powi(3)
    }

    /// Yield force.
    fn strength(&self) -> f64 {
        self.legs * self.width * self.thickness.powi(2) * self.fy / (4.0 * self.length)
    }

    /// Begin of a half-cycle in the direction `s` at the committed point.
    fn reverse(&self, c: &History, t: &mut History, e: f64, s: f64) {
        let (kp, pp) = (self.stiffness(), self.strength());
        let (hardening, first) = (self.b * kp, pp / kp);
        let yielded = ((e - c.turn[0]) / (c.corner[0] - c.turn[0])).abs() > 1.0;
        let pulls = e > 0.0 && c.stress > 0.0 || e < 0.0 && c.stress < 0.0;
        let stress = if pulls { c.stress * (2.0 * c.strain / self.length).cos() } else { c.stress };
        t.turn = [c.strain, stress];
        // As in OpenSees, the least deformation of isotropic hardening is that of first yielding.
        let (range, growth) = if s > 0.0 {
            t.extreme[0] = c.extreme[0].min(c.strain);
            (if yielded { c.extreme[1] } else { first } - t.extreme[0], self.a[2])
        } else {
            t.extreme[1] = c.extreme[1].max(c.strain);
            (t.extreme[1] + first, self.a[0])
        };
        let shift = 1.0 + growth * (range / (2.0 * (self.a[1] * first))).powf(HARDENING_EXPONENT);
        let at = (s * (pp * shift - hardening * first * shift) - stress + kp * c.strain) / (kp - hardening);
        t.corner = [at, s * pp * shift + hardening * (at - s * first * shift)];
        t.plastic = t.extreme[usize::from(s > 0.0)];
        t.loading = s;
    }
}

impl UniaxialLaw for Cast {
    type State = History;
    const NAME: &'static str = "CastFuse";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let (kp, pp) = (self.stiffness(), self.strength());
        let (e, first) = (strain.value, pp / kp);
        let d = e - c.strain;
        let mut t = History { strain: e, ..*c };
        if c.loading == 0.0 {
            if d.abs() < NONE {
                return Ok((Stress { value: 0.0, tangent: kp, damping: 0.0 }, *c));
            }
            let s = d.signum();
            t.loading = s;
            t.extreme = [-first, first];
            (t.corner, t.plastic) = ([s * first, s * pp], s * first);
        } else if c.loading * d < 0.0 {
            self.reverse(c, &mut t, e, d.signum());
        }
        let xi = ((t.plastic - t.corner[0]) / first).abs();
        let r = self.r[0] * (1.0 - (self.r[1] * xi) / (self.r[2] + xi));
        let (length, rise) = (t.corner[0] - t.turn[0], t.corner[1] - t.turn[1]);
        let x = (e - t.turn[0]) / length;
        let (share, slope) = transition(x, self.b, r);
        let (bent, slope) = (share * rise + t.turn[1], slope * (rise / length));
        let (value, tangent) = if e > 0.0 && bent > 0.0 || e < 0.0 && bent < 0.0 {
            let angle = 2.0 * e / self.length;
            let cos = angle.cos();
            (bent / cos, slope / cos + bent * angle.sin() * 2.0 / (self.length * cos * cos))
        } else {
            (bent, slope)
        };
        t.stress = value;
        finite(Self::NAME, e, value, tangent, t)
    }

    fn initial_tangent(&self) -> f64 {
        self.stiffness()
    }
}

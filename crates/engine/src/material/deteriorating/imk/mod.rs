//! Deteriorating plastic hinges in the form of EPFL's RESSLab: the Ibarra-Medina-Krawinkler laws with bilinear, peak-oriented
//! and pinched hysteresis (Ibarra, Medina and Krawinkler, 2005, <https://doi.org/10.1002/eqe.495>; Elkady and Ikeda, 2022).

mod bilin;
mod peak_oriented;

use crate::material::Stress;
use crate::rules::{Consistent, OpenSees};
pub use bilin::ImkBilin;
pub use peak_oriented::{ImkPeakOriented, ImkPinching, Pinching};
use std::fmt;

/// Tangent of a branch without slope, which keeps the stiffness matrix regular.
const FLAT: f64 = 1e-6;

/// Backbone on one side, positive on both sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ImkSide {
    /// Deformation from the yield point to the cap.
    pub plastic: f64,
    /// Deformation from the cap to zero strength.
    pub post_capping: f64,
    /// Ultimate deformation.
    pub ultimate: f64,
    /// Yield strength.
    pub strength: f64,
    /// Largest strength divided by the yield strength.
    pub peak: f64,
    /// Residual strength divided by the yield strength.
    pub residual: f64,
    /// Rate of cyclic deterioration D.
    pub rate: f64,
}

impl ImkSide {
    /// Residual strength.
    #[inline]
    fn residual_strength(&self) -> f64 {
        self.strength * self.residual
    }
}

/// Deterioration of one mode with the dissipated energy: β = (E / (Λ Fy - ΣE))ᶜ, with E the energy of the excursion and Fy the
/// positive yield strength.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ImkDeterioration {
    /// Cumulative deformation capacity Λ.
    pub capacity: f64,
    /// Rate c.
    pub exponent: f64,
}

impl ImkDeterioration {
    /// β between 0 and 1, and true if the energy capacity is exhausted.
    #[inline]
    fn beta(&self, strength: f64, excursion: f64, total: f64) -> (f64, bool) {
        let beta = (excursion / (self.capacity * strength - total)).powf(self.exponent);
        // The power is undefined if an excursion returned more energy than it took.
        if beta.is_nan() { (0.0, false) } else { (beta.clamp(0.0, 1.0), beta > 1.0) }
    }

    /// The same for the unloading stiffness at a reversal, whose excursion gives back the stored energy.
    #[inline]
    fn beta_of_unloading(&self, strength: f64, c: &Motion) -> (f64, bool) {
        let stored = 0.5 * (c.stress / c.unloading) * c.stress;
        self.beta(strength, c.energy - c.spent - stored, c.energy - stored)
    }
}

/// Rules of the laws that differ in OpenSees.
pub trait Rules: Clone + fmt::Debug + Send + Sync + 'static {
    /// Tangent of a step that moved, from the slope of its branch and the secant of the step.
    fn tangent(slope: f64, _secant: f64) -> f64 {
        slope
    }

    /// Tangent of a step that did not move or that began without strength, from the committed tangent and that of the last trial.
    fn tangent_at_rest(committed: f64, _last: f64) -> f64 {
        committed
    }
}

impl Rules for Consistent {}

/// The tangent of a step is its secant, and a step that does not move keeps the tangent of the last trial.
impl Rules for OpenSees {
    fn tangent(_: f64, secant: f64) -> f64 {
        secant
    }

    fn tangent_at_rest(_: f64, last: f64) -> f64 {
        last
    }
}

/// A tangent other than zero.
fn not_flat(tangent: f64) -> f64 {
    if tangent == 0.0 { FLAT } else { tangent }
}

crate::state_struct! {
    /// Backbone of one side, with positive deformations and forces.
    pub struct Curve {
        /// Yield strength.
        strength: f64,
        /// Deformation and force at the cap.
        cap: [f64; 2],
        /// Slope before the cap.
        hardening: f64,
        /// Slope beyond the cap.
        softening: f64,
    }
}

impl Curve {
    /// The curve before any deterioration.
    fn virgin(s: &ImkSide, ke: f64) -> Self {
        let force = s.peak * s.strength;
        Self {
            strength: s.strength,
            cap: [s.strength / ke + s.plastic, force],
            hardening: (force - s.strength) / s.plastic,
            softening: -force / s.post_capping,
        }
    }

    /// Deterioration by the factors of strength and of capping. The slope beyond the cap follows from the strength.
    #[inline]
    fn deteriorate(&mut self, ke: f64, [strength, capping]: [f64; 2], softening: impl FnOnce(&Self) -> f64) {
        let intercept = (self.cap[1] - self.softening * self.cap[0]) * capping;
        self.strength *= strength;
        self.hardening *= strength;
        self.softening = softening(self);
        let hardening_intercept = self.strength - self.hardening * (self.strength / ke);
        self.cap[0] = if self.hardening <= self.softening {
            0.0
        } else {
            (intercept - hardening_intercept) / (self.hardening - self.softening)
        };
        self.cap[1] = hardening_intercept + self.hardening * self.cap[0];
    }
}

crate::state_struct! {
    /// Motion and energy of a hinge.
    pub struct Motion {
        /// 1 after the first step.
        started: f64,
        /// Deformation.
        strain: f64,
        /// Force.
        stress: f64,
        /// Tangent.
        tangent: f64,
        /// Unloading stiffness.
        unloading: f64,
        /// Dissipated and stored energy.
        energy: f64,
        /// The same at the start of the excursion.
        spent: f64,
    }
}

impl Motion {
    fn virgin(ke: f64) -> Self {
        Self { started: 1.0, tangent: ke, unloading: ke, ..Self::default() }
    }

    /// Returns true if a step from here leaves its branch towards zero.
    #[inline]
    fn reverses(&self, du: f64) -> bool {
        self.stress * du < 0.0 || (self.stress == 0.0 && self.strain * du <= 0.0)
    }

    /// Energy of the excursion.
    #[inline]
    fn excursion(&self) -> f64 {
        (self.energy - self.spent).max(0.0)
    }

    /// Sets the tangent at the end of a step, of the slope of its branch where it moved, and returns the response.
    #[inline]
    fn finish<R: Rules>(&mut self, c: &Self, last: &Self, slope: Option<f64>) -> Option<Stress> {
        self.tangent = not_flat(match slope {
            Some(slope) => R::tangent(slope, (self.stress - c.stress) / (self.strain - c.strain)),
            None => R::tangent_at_rest(c.tangent, last.tangent),
        });
        let answer = Stress { value: self.stress, tangent: self.tangent, damping: 0.0 };
        (answer.value.is_finite() && answer.tangent.is_finite()).then_some(answer)
    }
}

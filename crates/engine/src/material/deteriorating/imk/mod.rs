//! Deteriorating plastic hinges in the form of EPFL's RESSLab: the Ibarra-Medina-Krawinkler laws with bilinear, peak-oriented
//! and pinched hysteresis (Ibarra, Medina and Krawinkler, 2005, <https://doi.org/10.1002/eqe.495>; Elkady and Ikeda, 2022).

mod bilin;
mod peak_oriented;

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
    fn beta(&self, strength: f64, excursion: f64, total: f64) -> (f64, bool) {
        let beta = (excursion / (self.capacity * strength - total)).powf(self.exponent);
        // The power is undefined if an excursion returned more energy than it took.
        if beta.is_nan() { (0.0, false) } else { (beta.clamp(0.0, 1.0), beta > 1.0) }
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

/// Sign of a side by its index.
fn sign(side: usize) -> f64 {
    if side == 0 { 1.0 } else { -1.0 }
}

//! Stiffness that OpenSees reports.

use super::SteelDrc;

/// Least and largest stiffness, divided by the elastic modulus.
const REPORTED: [f64; 2] = [0.005, 1.0];

impl SteelDrc {
    /// A stiffness, within OpenSees' bounds.
    pub(super) fn bounded(&self, k: f64) -> f64 {
        if self.compat { k.max(REPORTED[0] * self.e).min(REPORTED[1] * self.e) } else { k }
    }

    /// Damping of the dashpot, which OpenSees does not report.
    pub(super) fn damping(&self, c: f64) -> f64 {
        if self.compat { 0.0 } else { c }
    }
}

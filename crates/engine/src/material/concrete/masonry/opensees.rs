//! Slopes of OpenSees.

use super::Masonry;

impl Masonry {
    /// Initial stiffness; OpenSees reports the modulus.
    pub(super) fn reported_stiffness(&self) -> f64 {
        if self.compat { self.modulus } else { self.stiffness() }
    }

    /// Length of the end of reloading, between two strains; OpenSees takes the difference of the slopes there.
    pub(super) fn end_length(&self, strains: [f64; 2], slopes: [f64; 2]) -> f64 {
        let [from, to] = if self.compat { slopes } else { strains };
        to - from
    }
}

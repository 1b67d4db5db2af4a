//! Constants and curves of OpenSees.

use super::{Bauschinger, DoddRestrepo};

impl DoddRestrepo {
    /// A constant of the source; OpenSees has it in single precision.
    pub(super) fn constant(&self, x: f64) -> f64 {
        if self.compat { f64::from(x as f32) } else { x }
    }

    /// True stress and slope of a curve, whose end moves with the strain at a rate.
    pub(super) fn on_curve(&self, curve: &Bauschinger, e: f64, moving: f64) -> (f64, f64) {
        if self.compat { curve.opensees(e) } else { curve.at(e, moving) }
    }
}

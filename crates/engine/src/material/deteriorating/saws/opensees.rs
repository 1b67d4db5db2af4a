//! `SAWS` by OpenSees' rules.
//!
//! The intersection of pinched line and envelope has a force tolerance of 1e-6. The envelope's tangent is that of
//! another displacement. A few reversals inside the loop have different rules on the negative side.

use super::{Path, Rules, SawsParameters, word};
use crate::rules::OpenSees;

impl Rules for OpenSees {
    const TOLERANCE: f64 = 1e-6;

    fn curve_slope(wall: &SawsParameters, x: f64, (target, force): (f64, f64), _: f64) -> f64 {
        let (asymptote, left) = (wall.fo + wall.r[0] * wall.so * target, (-wall.so * x / wall.fo).exp());
        let share = force / asymptote;
        asymptote * wall.so / wall.fo * left + wall.r[0] * wall.so * share
    }

    fn leaves(leaves: f64, s: f64, passed: bool) -> f64 {
        if s > 0.0 && passed { -leaves } else { leaves }
    }

    fn keeps_pinched(s: f64, fresh: bool) -> bool {
        fresh || s > 0.0
    }

    fn before_reloading(s: f64) -> f64 {
        if s < 0.0 { word(Path::Unloading, 1.0) } else { word(Path::Pinched, s) }
    }
}

//! `SAWS` by OpenSees' rules.
//!
//! The place where the pinched line leaves the envelope is found to a force of 1e-6. The tangent of the envelope has parts of another
//! displacement. The negative side has other rules in a few turns within the loop.

use super::{Path, Rules, Wall, word};
use crate::rules::OpenSees;

impl Rules for OpenSees {
    const TOLERANCE: f64 = 1e-6;

    fn curve_slope(wall: &Wall, x: f64, (target, force): (f64, f64), _: f64) -> f64 {
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

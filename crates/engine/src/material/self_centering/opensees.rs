//! `SelfCentering` by OpenSees' rules.
//!
//! A flag remembers where it was left when a step jumps from it to the elastic part around zero, or a trial state was on it. A step that
//! begins to slip slips as a whole. Slip does not change the tangent.

use super::{History, Rules};
use crate::rules::OpenSees;

impl Rules for OpenSees {
    const COMES_BACK: bool = false;

    fn begin(committed: &History, last: &History, steps: f64) -> History {
        if last.steps == steps { *last } else { History { steps, ..*committed } }
    }

    fn slip(d: f64, _: f64) -> f64 {
        d
    }

    fn slipping(moved: f64, tangent: f64, _: f64) -> (f64, f64) {
        (moved, tangent)
    }
}

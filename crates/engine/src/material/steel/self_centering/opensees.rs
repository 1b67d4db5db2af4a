//! `SelfCentering` by OpenSees' rules.
//!
//! A flag keeps its shift after a jump to the elastic range around zero, or after a trial on it. A step that begins to
//! slip slips as a whole. Slip does not change the tangent.

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

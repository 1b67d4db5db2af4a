//! `HDR` by OpenSees' rules.

use super::{Damage, Rules};
use crate::rules::OpenSees;

impl Rules for OpenSees {
    const SIDE_BY_SIDE: bool = false;

    /// Variables that a displacement does not change keep the value of the last trial.
    fn begin(_: &Damage, last: &Damage) -> Damage {
        *last
    }

    /// OpenSees omits the hysteretic part.
    fn initial(elastic: f64, _: f64) -> f64 {
        elastic
    }

    /// OpenSees has c₄ instead of c₃.
    fn mullins_slope(_: f64, c4: f64) -> f64 {
        1.0 - c4
    }

    fn moved(way: f64, _: &[f64; 2], _: &[f64; 2]) -> bool {
        way > f64::EPSILON
    }

    /// The tangent omits the direction of the step.
    fn turns(_: f64) -> bool {
        false
    }
}

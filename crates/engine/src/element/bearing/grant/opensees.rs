//! `HDR` by OpenSees' rules.

use super::{Damage, Rules};
use crate::rules::OpenSees;

impl Rules for OpenSees {
    /// Damage that a displacement does not change keeps the value of the trial before.
    fn begin(_: &Damage, last: &Damage) -> Damage {
        *last
    }

    /// The hysteretic part is left out.
    fn initial(elastic: f64, _: f64) -> f64 {
        elastic
    }

    /// OpenSees has c₄ where c₃ belongs.
    fn fading(_: f64, c4: f64) -> f64 {
        1.0 - c4
    }

    fn moved(way: f64, _: &[f64; 2], _: &[f64; 2]) -> bool {
        way > f64::EPSILON
    }

    /// The direction is left out of the tangent.
    fn turns(_: f64) -> bool {
        false
    }
}

//! `HDR` by OpenSees' rules.

use super::{Damage, Rules};
use crate::numeric::real::Real;
use crate::rules::OpenSees;

impl Rules for OpenSees {
    const SIDE_BY_SIDE: bool = false;
    /// The tangent omits the direction of the step.
    const TURNS: bool = false;

    /// Variables that a displacement does not change keep the value of the last trial.
    fn begin<T: Real>(_: &Damage<T>, last: &Damage<T>) -> Damage<T> {
        *last
    }

    /// OpenSees omits the hysteretic part.
    fn initial(elastic: f64, _: f64) -> f64 {
        elastic
    }

    /// OpenSees has c₄ instead of c₃.
    fn mullins_slope<T: Real>(_: T, c4: T) -> T {
        T::ONE - c4
    }

    fn rests<T: Real>(way: T, _: &[T; 2], _: &[T; 2]) -> T {
        way.where_greater(T::of(f64::EPSILON), T::ZERO, T::ONE)
    }
}

//! Rules of `Bilin` that OpenSees has otherwise.

use super::lower;
use crate::material::deteriorating::hinge::FLAT;
use crate::rules::Consistent;
use std::fmt;

/// Rules of [`Bilin`](super::Bilin) that differ in OpenSees. A side is given by the sign of the step that goes to it.
pub trait Rules: Clone + fmt::Debug + Send + Sync + 'static {
    /// A side that breaks at its residual strength leaves the other side its strength.
    const SPARES_RESIDUAL: bool = false;
    /// The target of a step moves with the energy that the step dissipates.
    const MOVES_TARGET: bool = true;

    /// Distance of a target before the first yield point.
    fn before_yield(_sign: f64) -> f64 {
        1e-9
    }

    /// Sum of the forces, and of the target force of the side behind, whose half is the mean force of unloading: `force` at the turn,
    /// `ahead` and `behind` at the targets.
    fn unloading_forces(_sign: f64, force: f64, ahead: f64, _behind: f64) -> f64 {
        force + ahead
    }

    /// The unloading stiffness stays as it is: where nothing deteriorates any more, or a branch beyond a cap is level.
    fn keeps_stiffness(_sign: f64, settled: bool, _level: impl Fn(usize) -> bool) -> bool {
        settled
    }

    /// A step to `x` may be on the branches before the cap, which the line from the target meets at `meets`.
    fn before_cap(_x: f64, _meets: impl FnOnce() -> f64) -> bool {
        true
    }

    /// Force and slope at the residual strength.
    fn residual(elastic: (f64, f64), residual: f64) -> (f64, f64) {
        lower(elastic, (residual, -FLAT))
    }

    /// The lower of the line of unloading and another.
    fn lower(_sign: f64, elastic: (f64, f64), other: (f64, f64)) -> (f64, f64) {
        lower(elastic, other)
    }

    /// A branch beyond the cap may come to zero force in a step that begins at this force.
    fn may_stop(force: f64) -> bool {
        force >= 0.0
    }

    /// Tangent of a step, of the slope of its branch after the deterioration and before.
    fn tangent(_after: f64, before: f64) -> f64 {
        before
    }
}

impl Rules for Consistent {}

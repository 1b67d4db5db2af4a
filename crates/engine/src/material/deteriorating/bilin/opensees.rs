//! `Bilin` by OpenSees' rules.
//!
//! The tangent of a step in which the backbone deteriorates is that of the deteriorated backbone at its limit. A step
//! from one side beyond the cap of the other may lose all strength or have none. The unloading stiffness deteriorates by
//! different rules on the two sides. A jump to the residual strength needs no path.

use super::{Rules, lower};
use crate::material::deteriorating::hinge::FLAT;
use crate::rules::OpenSees;

impl Rules for OpenSees {
    const SPARES_RESIDUAL: bool = true;
    const MOVES_TARGET: bool = false;

    fn before_yield(sign: f64) -> f64 {
        if sign < 0.0 { -1e-9 } else { 1e-9 }
    }

    fn unloading_forces(sign: f64, force: f64, ahead: f64, behind: f64) -> f64 {
        if sign < 0.0 { behind - force } else { force + ahead }
    }

    fn keeps_stiffness(sign: f64, settled: bool, level: impl Fn(usize) -> bool) -> bool {
        if sign > 0.0 { level(0) || level(1) } else { settled }
    }

    fn before_cap(x: f64, meets: impl FnOnce() -> f64) -> bool {
        x <= meets()
    }

    fn residual(_: (f64, f64), residual: f64) -> (f64, f64) {
        (residual, -FLAT)
    }

    fn lower(sign: f64, elastic: (f64, f64), other: (f64, f64)) -> (f64, f64) {
        let least = lower(elastic, other);
        if sign > 0.0 { (least.0, other.1) } else { least }
    }

    fn may_stop(_: f64) -> bool {
        true
    }

    fn tangent(after: f64, _: f64) -> f64 {
        after
    }
}

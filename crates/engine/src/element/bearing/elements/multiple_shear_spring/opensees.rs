//! `multipleShearSpring` by OpenSees' rules: the stiffness has a factor of its own and is no derivative of the force.

use super::{Factors, Rules};
use crate::rules::OpenSees;

impl Rules for OpenSees {
    fn scale(factors: &Factors) -> f64 {
        factors.stiffness
    }

    fn slope(_: &Factors) -> f64 {
        0.0
    }

    fn symmetric(_: bool) -> bool {
        true
    }
}

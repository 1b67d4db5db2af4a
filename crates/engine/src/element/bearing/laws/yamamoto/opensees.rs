//! `YamamotoBiaxialHDR` by OpenSees' rules.

use super::{Evolution, Rules, along};
use crate::element::Mass;
use crate::rules::OpenSees;

impl Rules for OpenSees {
    /// One forward Euler step.
    fn integrate(start: Evolution, _: f64, rate: impl Fn(Evolution) -> Evolution) -> Evolution {
        along(start, rate(start), 1.0)
    }

    fn keeps_stiffness() -> bool {
        true
    }

    /// The mass of node j is at the rotations of node i.
    fn masses(masses: Mass) -> Mass {
        match masses {
            Mass::Lumped(mut m) => {
                m.copy_within(6..9, 3);
                m[6..9].fill(0.0);
                Mass::Lumped(m)
            }
            masses => masses,
        }
    }
}

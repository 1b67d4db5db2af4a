//! Yielding of an elastic member.

use super::{AmendedForce, AmendmentLaw, DeformationState, Pair};
use crate::element::ElementResult;

/// Plastic deformation e_p with kinematic hardening: q' = q - k e_p and |q' - H e_p| ≤ F_y. With H = b k / (1 - b), b
/// is the ratio of post-yield to elastic stiffness. Radial return is exact for the step (Simo and Hughes, Computational
/// Inelasticity, 1998, section 1.4).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Yielding {
    /// Yield force F_y.
    pub force: f64,
    /// Elastic stiffness k of the element in this direction.
    pub stiffness: f64,
    /// Hardening ratio b, 0 to below 1.
    pub hardening: f64,
}

crate::state_struct! {
    /// State variables.
    pub struct YieldingState {
        /// Plastic deformation e_p.
        deformation: [f64; 2],
    }
}

impl AmendmentLaw for Yielding {
    type State = YieldingState;
    const NAME: &'static str = "yielding";

    fn amend(&self, committed: &YieldingState, d: &DeformationState) -> ElementResult<(AmendedForce, YieldingState)> {
        let k = self.stiffness;
        let h = self.hardening / (1.0 - self.hardening) * k;
        let ep = committed.deformation;
        let relative: Pair = std::array::from_fn(|i| d.q[i] - (k + h) * ep[i]);
        let size = relative[0].hypot(relative[1]);
        let excess = size - self.force;
        if excess <= 0.0 {
            let mut v = AmendedForce::unchanged(d.q);
            v.q = std::array::from_fn(|i| d.q[i] - k * ep[i]);
            return Ok((v, *committed));
        }
        let n = relative.map(|x| x / size);
        let flow = excess / (k + h);
        let deformation: Pair = std::array::from_fn(|i| ep[i] + flow * n[i]);
        let mut v = AmendedForce { q: std::array::from_fn(|i| d.q[i] - k * deformation[i]), ..AmendedForce::default() };
        for i in 0..2 {
            for j in 0..2 {
                let unit = f64::from(u8::from(i == j));
                let rotation = flow / size * (unit - n[i] * n[j]);
                v.by_force[i][j] = unit - k * (n[i] * n[j] / (k + h) + rotation);
            }
        }
        Ok((v, YieldingState { deformation }))
    }

    fn with_stiffness(&self, stiffness: f64) -> Option<Self> {
        Some(Self { stiffness, ..*self })
    }
}

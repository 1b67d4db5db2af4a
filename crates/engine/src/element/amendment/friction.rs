//! Coulomb friction in parallel, such as that of a guide or a test rig.

use super::{AmendedForce, AmendmentLaw, DeformationState, Pair};
use crate::element::ElementResult;

/// f = k (e - e_s) with |f| ≤ F: Coulomb's law regularised as elastic-plastic, isotropic in two directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Friction {
    /// Friction force F.
    pub force: f64,
    /// Stiffness k before sliding.
    pub stiffness: f64,
}

crate::state_struct! {
    /// State variables.
    pub struct FrictionState {
        /// Friction force f.
        force: [f64; 2],
    }
}

impl AmendmentLaw for Friction {
    type State = FrictionState;
    const NAME: &'static str = "friction";

    fn amend(&self, committed: &FrictionState, d: &DeformationState) -> ElementResult<(AmendedForce, FrictionState)> {
        let de = d.increment();
        let trial: Pair = std::array::from_fn(|i| committed.force[i] + self.stiffness * de[i]);
        let size = trial[0].hypot(trial[1]);
        let slips = size > self.force;
        let force = if slips { trial.map(|t| self.force * t / size) } else { trial };
        let mut v = AmendedForce::unchanged(d.q);
        for i in 0..2 {
            v.q[i] += force[i];
            for j in 0..2 {
                let unit = f64::from(u8::from(i == j));
                v.by_deformation[i][j] = if slips {
                    self.stiffness * self.force / size * (unit - trial[i] * trial[j] / (size * size))
                } else {
                    self.stiffness * unit
                };
            }
        }
        Ok((v, FrictionState { force }))
    }
}

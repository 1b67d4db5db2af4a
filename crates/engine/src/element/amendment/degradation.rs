//! Strength lost with accumulated damage.

use super::{AmendedForce, AmendmentLaw, DeformationState, Share, Weakening};
use crate::element::ElementError;

/// s = 1 - loss (1 - exp(-E / E₀)) with the energy E that the hysteretic part has taken in, counted without sign as
/// in the damage index of Park and Ang, J. Struct. Eng. 111 (1985).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Degradation {
    /// Part of the force lost in the end.
    pub loss: f64,
    /// Energy E₀ that brings 63 % of it.
    pub energy: f64,
    /// What it acts on.
    pub share: Share,
}

crate::state_struct! {
    /// History.
    pub struct Damage {
        /// Accumulated energy E.
        energy: f64,
    }
}

impl Degradation {
    /// s after an energy.
    fn factor(&self, energy: f64) -> f64 {
        1.0 - self.loss * (1.0 - (-energy / self.energy).exp())
    }
}

impl AmendmentLaw for Degradation {
    type State = Damage;
    const NAME: &'static str = "degradation";

    fn amend(&self, committed: &Damage, d: &DeformationState) -> Result<(AmendedForce, Damage), ElementError> {
        let work = self.share.work(d);
        let energy = committed.energy + work.abs();
        let slope = -self.loss * (-energy / self.energy).exp() / self.energy * work.signum();
        Ok((self.share.scale_by_work(d, self.factor(energy), slope), Damage { energy }))
    }

    fn weakening(&self, committed: &Damage) -> Option<Weakening> {
        self.share.weakening(self.factor(committed.energy))
    }
}

//! Relaxation of the force: quasi-linear viscoelasticity.

use super::{AmendedForce, AmendmentLaw, DeformationState, Pair};
use crate::element::ElementResult;

/// Largest number of relaxation times.
pub(super) const TIME_COUNT: usize = 4;

/// Times at equal distances of their logarithms, and their number: one where they spread over no decades.
pub(super) fn times(shortest: f64, decades: f64) -> (impl Iterator<Item = f64>, usize) {
    let n = if decades > 0.0 { TIME_COUNT } else { 1 };
    let step = decades / (TIME_COUNT - 1) as f64;
    ((0..n).map(move |i| shortest * 10f64.powf(step * i as f64)), n)
}

/// Fung's quasi-linear viscoelasticity (Biomechanics, 1981). The amended force is q + Σ h_i with h_i' = g_i q' - h_i /
/// τ_i. There is one relaxation time, or four at equal distances of ln τ, which share g. Four of them let the force
/// relax with the logarithm of time, as in polymers.
///
/// The integration is exact for a force that is linear over the step. Nothing relaxes if no time passes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Relaxation {
    /// Relative increase g of the force at a sudden change.
    pub strength: f64,
    /// Shortest relaxation time.
    pub time: f64,
    /// Decades from the shortest to the longest relaxation time; 0 for a single one.
    pub decades: f64,
}

crate::state_struct! {
    /// State variables.
    pub struct RelaxationState {
        /// Viscous force h_i of the first direction for each relaxation time.
        first: [f64; TIME_COUNT],
        /// Viscous force h_i of the second direction.
        second: [f64; TIME_COUNT],
        /// Force q of the element.
        force: [f64; 2],
    }
}

impl Relaxation {
    /// Relaxation times τ_i with their parts of the strength g_i.
    fn branches(&self) -> impl Iterator<Item = (f64, f64)> {
        let (times, count) = times(self.time, self.decades);
        let strength = self.strength / count as f64;
        times.map(move |time| (time, strength))
    }
}

impl AmendmentLaw for Relaxation {
    type State = RelaxationState;
    const NAME: &'static str = "relaxation";

    fn amend(
        &self,
        committed: &RelaxationState,
        d: &DeformationState,
    ) -> ElementResult<(AmendedForce, RelaxationState)> {
        let mut next = RelaxationState { force: d.q, ..*committed };
        let change: Pair = std::array::from_fn(|i| d.q[i] - committed.force[i]);
        let mut v = AmendedForce::unchanged(d.q);
        for (b, (time, strength)) in self.branches().enumerate() {
            let a = d.dt.max(0.0) / time;
            let (decay, mean) = if a > 0.0 { ((-a).exp(), -(-a).exp_m1() / a) } else { (1.0, 1.0) };
            for (i, h) in [&mut next.first[b], &mut next.second[b]].into_iter().enumerate() {
                *h = decay * *h + strength * mean * change[i];
                v.q[i] += *h;
                v.by_force[i][i] += strength * mean;
            }
        }
        Ok((v, next))
    }

    fn depends_on_time(&self) -> bool {
        true
    }
}

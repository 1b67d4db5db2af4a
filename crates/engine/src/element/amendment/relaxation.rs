//! A force that relaxes: quasi-linear viscoelasticity.

use super::{AmendedForce, AmendmentLaw, DeformationState, Pair};
use crate::element::ElementError;

/// Relaxation times.
const TIMES: usize = 4;

/// Each change of the force is larger by g at first and relaxes, by Fung's quasi-linear viscoelasticity (Biomechanics, 1981):
/// the amended force is q + Σ h_i with h_i' = g_i q' - h_i / τ_i. One relaxation time, or four, spaced evenly in their logarithm,
/// that share g: a force that relaxes with the logarithm of time, as polymers do.
///
/// Exact where the force grows evenly over a step. Where no time passes nothing relaxes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Relaxation {
    /// Part g by which the force of a sudden change is larger.
    pub strength: f64,
    /// Shortest relaxation time.
    pub time: f64,
    /// Decades from it to the longest one; there is one alone where it is 0.
    pub decades: f64,
}

crate::state_struct! {
    /// History.
    pub struct Relaxing {
        /// What relaxes of the first direction, by relaxation time.
        first: [f64; TIMES],
        /// The same of the second.
        second: [f64; TIMES],
        /// Force that it follows.
        force: [f64; 2],
    }
}

impl Relaxation {
    /// Relaxation times with the part of the strength that each has.
    fn branches(&self) -> impl Iterator<Item = (f64, f64)> {
        let n = if self.decades > 0.0 { TIMES } else { 1 };
        let (time, strength) = (self.time, self.strength / n as f64);
        let step = self.decades / (TIMES - 1) as f64;
        (0..n).map(move |i| (time * 10f64.powf(step * i as f64), strength))
    }
}

impl AmendmentLaw for Relaxation {
    type State = Relaxing;
    const NAME: &'static str = "relaxation";

    fn amend(&self, committed: &Relaxing, d: &DeformationState) -> Result<(AmendedForce, Relaxing), ElementError> {
        let mut next = Relaxing { force: d.q, ..*committed };
        let change: Pair = std::array::from_fn(|i| d.q[i] - committed.force[i]);
        let mut v = AmendedForce::unchanged(d.q);
        for (b, (time, strength)) in self.branches().enumerate() {
            let a = d.dt.max(0.0) / time;
            let (left, mean) = if a > 0.0 { ((-a).exp(), -(-a).exp_m1() / a) } else { (1.0, 1.0) };
            for (i, h) in [&mut next.first[b], &mut next.second[b]].into_iter().enumerate() {
                *h = left * *h + strength * mean * change[i];
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

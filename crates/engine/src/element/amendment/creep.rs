//! Creep under a force: deformation in series that follows it late.

use super::relaxation::{TIME_COUNT, times};
use super::{AmendedForce, AmendmentLaw, DeformationState, Pair, Slack, SlackCurve};
use crate::element::ElementResult;

/// Kelvin elements in series (Findley, Lai and Onaran, Creep and Relaxation of Nonlinear Viscoelastic Materials, 1976).
/// The element gets e - Σ s_i with τ_i s_i' = c_i q - s_i. There is one retardation time, or four at equal distances of
/// ln τ, which share the compliance. Four of them let the deformation grow with the logarithm of time.
///
/// The integration is exact for a force that is linear over the step. Nothing creeps if no time passes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Creep {
    /// Deformation under a unit of force that is held for ever, beside that of the element.
    pub compliance: f64,
    /// Shortest retardation time.
    pub time: f64,
    /// Decades from the shortest to the longest retardation time; 0 for a single one.
    pub decades: f64,
}

crate::state_struct! {
    /// State variables.
    pub struct CreepState {
        /// Deformation s_i of the first direction for each retardation time.
        first: [f64; TIME_COUNT],
        /// Deformation s_i of the second direction.
        second: [f64; TIME_COUNT],
        /// Force q.
        force: [f64; 2],
    }
}

/// Deformation of a Kelvin element after a step: its parts by the one before, by the force before and by the force after.
struct Step {
    kept: f64,
    before: f64,
    after: f64,
}

impl Creep {
    fn steps(&self, dt: f64) -> impl Iterator<Item = Step> {
        let (times, count) = times(self.time, self.decades);
        let compliance = self.compliance / count as f64;
        times.map(move |time| {
            let a = dt.max(0.0) / time;
            let (kept, mean) = if a > 0.0 { ((-a).exp(), -(-a).exp_m1() / a) } else { (1.0, 1.0) };
            Step { kept, before: compliance * (mean - kept), after: compliance * (1.0 - mean) }
        })
    }
}

impl AmendmentLaw for Creep {
    type State = CreepState;
    const NAME: &'static str = "creep";

    fn slack(&self, committed: &CreepState, dt: f64) -> Option<Slack> {
        let (mut unloaded, mut flexibility): (Pair, f64) = ([0.0; 2], 0.0);
        for (step, crept) in self.steps(dt).zip(committed.first.iter().zip(&committed.second)) {
            for ((s, crept), force) in unloaded.iter_mut().zip([crept.0, crept.1]).zip(committed.force) {
                *s += step.kept * crept + step.before * force;
            }
            flexibility += step.after;
        }
        let committed = [committed.first.iter().sum(), committed.second.iter().sum()];
        Some(Slack { curve: SlackCurve::Linear { unloaded, flexibility }, stiffness: 0.0, committed })
    }

    fn amend(&self, committed: &CreepState, d: &DeformationState) -> ElementResult<(AmendedForce, CreepState)> {
        let mut next = CreepState { force: d.q, ..*committed };
        for (b, step) in self.steps(d.dt).enumerate() {
            for (i, s) in [&mut next.first[b], &mut next.second[b]].into_iter().enumerate() {
                *s = step.kept * *s + step.before * committed.force[i] + step.after * d.q[i];
            }
        }
        Ok((AmendedForce { q: d.q, by_force: d.slack.follows, ..AmendedForce::default() }, next))
    }

    fn depends_on_time(&self) -> bool {
        true
    }
}

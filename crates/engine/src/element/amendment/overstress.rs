//! Viscous overstress: a force that depends on the rate of deformation.

use super::{AmendedForce, AmendmentLaw, DeformationState, Pair};
use crate::element::{ElementError, ElementResult};

/// A Maxwell element in parallel, with a power-law dashpot: f' = k e' - k v₀ (|f| / F₀)^(1/n) f/|f|. At a constant
/// speed v the overstress is F₀ (v / v₀)ⁿ. The dashpot is linear for n = 1. Small n gives the overstress of high
/// damping rubber (Bhuiyan et al., Int. J. Solids Struct. 46 (2009)).
///
/// The rate is Δe over the increment of domain time, in static analyses too. The dashpot is locked if no time passes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overstress {
    /// Overstress F₀ at the speed v₀.
    pub force: f64,
    /// Reference speed v₀.
    pub speed: f64,
    /// Exponent n, above 0 and at most 1.
    pub power: f64,
    /// Stiffness k of the spring.
    pub stiffness: f64,
}

crate::state_struct! {
    /// State variables.
    pub struct OverstressState {
        /// Overstress f.
        force: [f64; 2],
    }
}

impl Overstress {
    /// Overstress after a step from its value with a locked dashpot, and its derivative. Backward Euler: x + k dt v₀ (x
    /// / F₀)^(1/n) = x_tr.
    fn relax(&self, trial: f64, dt: f64) -> ElementResult<(f64, f64)> {
        if dt <= 0.0 || trial == 0.0 {
            return Ok((trial, 1.0));
        }
        let p = 1.0 / self.power;
        let c = self.stiffness * dt * self.speed;
        // The root lies below the trial value and below the dashpot-only value. The function is convex, so Newton's
        // method from the smaller of both converges monotonically.
        let mut x = trial.min(self.force * (trial / c).powf(self.power));
        for _ in 0..100 {
            let flow = c * (x / self.force).powf(p);
            let slope = 1.0 + p * flow / x;
            let step = (x + flow - trial) / slope;
            x -= step;
            if step.abs() <= 1e-14 * trial {
                let slope = 1.0 + p * c * (x / self.force).powf(p) / x;
                return Ok((x, 1.0 / slope));
            }
        }
        Err(ElementError("overstress: the step has no solution".into()))
    }
}

impl AmendmentLaw for Overstress {
    type State = OverstressState;
    const NAME: &'static str = "overstress";

    fn amend(
        &self,
        committed: &OverstressState,
        d: &DeformationState,
    ) -> ElementResult<(AmendedForce, OverstressState)> {
        let de = d.increment();
        let trial: Pair = std::array::from_fn(|i| committed.force[i] + self.stiffness * de[i]);
        let size = trial[0].hypot(trial[1]);
        let (overstress, slope) = self.relax(size, d.dt)?;
        let mut v = AmendedForce::unchanged(d.q);
        if size == 0.0 {
            v.by_deformation = [[self.stiffness, 0.0], [0.0, self.stiffness]];
            return Ok((v, OverstressState { force: trial }));
        }
        let n = trial.map(|t| t / size);
        let force = n.map(|n| overstress * n);
        for i in 0..2 {
            v.q[i] += force[i];
            for j in 0..2 {
                let unit = f64::from(u8::from(i == j));
                v.by_deformation[i][j] =
                    self.stiffness * (slope * n[i] * n[j] + overstress / size * (unit - n[i] * n[j]));
            }
        }
        Ok((v, OverstressState { force }))
    }

    fn depends_on_time(&self) -> bool {
        true
    }
}

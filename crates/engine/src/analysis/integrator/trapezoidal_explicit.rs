//! Explicit methods that weight the forces of both ends of a step.

use super::central_difference::only_once;
use super::{AlphaParameters, Integrator};
use crate::analysis::failure::Failure;
use crate::analysis::system::{Coefficients, System};

/// `integrator HHTExplicit_TP` and `HHTGeneralizedExplicit_TP`: as [`ExplicitAlpha`](super::ExplicitAlpha), but the elements are
/// evaluated at the displacement predicted for the end of the step, and their forces there and at its begin are weighted.
#[derive(Clone, Debug)]
pub struct TrapezoidalExplicit {
    name: &'static str,
    p: AlphaParameters,
    dt: f64,
    corrections: u32,
}

impl TrapezoidalExplicit {
    /// From its parameters.
    pub fn new(name: &'static str, p: AlphaParameters) -> Self {
        Self { name, p, dt: 0.0, corrections: 0 }
    }
}

/// Predict displacement and velocity at the end of a step of Newmark's method as far as the acceleration there does not count,
/// which is left at zero; degrees of freedom that are held keep theirs.
pub(super) fn predict(s: &mut System<'_>, p: &AlphaParameters, dt: f64) {
    s.moved = true;
    let (old, new, held) = (s.old, &mut *s.new, &s.work.plan.map.held);
    for i in (0..held.len()).filter(|&i| !held[i]) {
        let (v, a) = (old.vel[i], old.accel[i]);
        new.disp[i] = old.disp[i] + dt * v + dt * dt * (0.5 - p.beta) * a;
        new.vel[i] = v + dt * (1.0 - p.gamma) * a;
        new.accel[i] = 0.0;
    }
}

impl Integrator for TrapezoidalExplicit {
    fn name(&self) -> &'static str {
        self.name
    }
    fn balances(&self) -> bool {
        false
    }

    fn prepare(&mut self, s: &mut System<'_>) -> Result<(), Failure> {
        s.hold_committed(1.0 - self.p.force, 1.0 - self.p.inertia)
    }

    fn begin(&mut self, s: &mut System<'_>, dt: f64) -> Result<(), Failure> {
        let AlphaParameters { inertia, force, gamma, .. } = self.p;
        (self.dt, self.corrections) = (dt, 0);
        predict(s, &self.p, dt);
        s.coefficients = Coefficients { k: 0.0, c: force * gamma * dt, m: inertia };
        s.weigh_unbalance(force, inertia);
        s.apply_loads(s.old.time + dt)
    }

    /// The unknown is the acceleration at the end of the step.
    fn update(&mut self, s: &mut System<'_>, correction: &mut [f64]) -> Result<(), Failure> {
        only_once(self.name, &mut self.corrections, s)?;
        let (dt, AlphaParameters { beta, gamma, .. }) = (self.dt, self.p);
        s.spread(correction);
        s.add_motion(Coefficients { k: beta * dt * dt, c: gamma * dt, m: 1.0 });
        Ok(())
    }

    fn commit(&mut self, s: &mut System<'_>, _: usize) -> Result<(), Failure> {
        s.hold_unbalance(1.0 - self.p.force, 1.0 - self.p.inertia);
        Ok(())
    }
}

//! Explicit members of the generalised α family.

use super::central_difference::only_once;
use super::{AlphaParameters, Integrator};
use crate::analysis::failure::Failure;
use crate::analysis::system::{Coefficients, System};

/// `integrator NewmarkExplicit`, `HHTExplicit` and `HHTGeneralizedExplicit`: the displacement at the end of a step is
/// predicted without its acceleration, for which the equations are solved; the tangent has mass and damping only.
///
/// Elements need not see the end of the step: then they stay where the equations were formed, as in OpenSees without
/// `-updateElemDisp`.
#[derive(Clone, Debug)]
pub struct ExplicitAlpha {
    name: &'static str,
    p: AlphaParameters,
    /// Elements see the end of the step.
    update_elements: bool,
    dt: f64,
    corrections: u32,
    /// Displacements predicted for the end of the step.
    disp: Vec<f64>,
    /// Velocities predicted for the end of the step.
    vel: Vec<f64>,
}

impl ExplicitAlpha {
    /// From its parameters.
    pub fn new(name: &'static str, p: AlphaParameters, update_elements: bool) -> Self {
        Self { name, p, update_elements, dt: 0.0, corrections: 0, disp: vec![], vel: vec![] }
    }
}

impl Integrator for ExplicitAlpha {
    fn name(&self) -> &'static str {
        self.name
    }
    fn balances(&self) -> bool {
        false
    }

    fn prepare(&mut self, s: &mut System<'_>) -> Result<(), Failure> {
        self.disp.resize(s.old.disp.len(), 0.0);
        self.vel.resize(s.old.disp.len(), 0.0);
        Ok(())
    }

    fn begin(&mut self, s: &mut System<'_>, dt: f64) -> Result<(), Failure> {
        let AlphaParameters { inertia, force, beta, gamma } = self.p;
        (self.dt, self.corrections) = (dt, 0);
        s.coefficients = Coefficients { k: 0.0, c: force * gamma * dt, m: inertia };
        s.moved = true;
        let (old, new, held) = (s.old, &mut *s.new, &s.work.plan.map.held);
        self.disp.copy_from_slice(&old.disp);
        self.vel.copy_from_slice(&old.vel);
        for i in (0..held.len()).filter(|&i| !held[i]) {
            let (u, v, a) = (old.disp[i], old.vel[i], old.accel[i]);
            self.disp[i] = u + dt * v + dt * dt * (0.5 - beta) * a;
            self.vel[i] = v + dt * (1.0 - gamma) * a;
            new.disp[i] = (1.0 - force) * u + force * self.disp[i];
            new.vel[i] = (1.0 - force) * v + force * self.vel[i];
            new.accel[i] = (1.0 - inertia) * a;
        }
        s.apply_loads(s.old.time + force * dt)
    }

    /// The unknown is the acceleration at the end of the step.
    fn update(&mut self, s: &mut System<'_>, correction: &mut [f64]) -> Result<(), Failure> {
        only_once(self.name, &mut self.corrections, s)?;
        let (dt, AlphaParameters { beta, gamma, .. }) = (self.dt, self.p);
        let (new, held) = (&mut *s.new, &s.work.plan.map.held);
        new.disp.copy_from_slice(&self.disp);
        new.vel.copy_from_slice(&self.vel);
        (0..held.len()).filter(|&i| !held[i]).for_each(|i| new.accel[i] = 0.0);
        s.spread(correction);
        s.add_motion(Coefficients { k: beta * dt * dt, c: gamma * dt, m: 1.0 });
        s.moved = self.update_elements;
        s.apply_loads_at_end(self.p.force, dt)
    }
}

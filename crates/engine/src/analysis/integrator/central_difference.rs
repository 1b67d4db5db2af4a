//! Central differences.

use super::Integrator;
use crate::analysis::failure::{Cause, Failure};
use crate::analysis::system::{Coefficients, System};

/// Explicit methods take one correction a step: a second one means an algorithm that iterates.
pub(super) fn only_once(name: &str, count: &mut u32, s: &System<'_>) -> Result<(), Failure> {
    *count += 1;
    if *count > 1 {
        let message = format!("{name} is explicit and takes one correction a step: use \"algorithm Linear\" with it");
        return Err(s.failure(Cause::Model(message)));
    }
    Ok(())
}

/// `integrator CentralDifference`: equilibrium at the begin of the step gives the displacements at its end. Velocity
/// and acceleration at the end are backward differences.
#[derive(Clone, Debug)]
pub struct CentralDifference {
    name: &'static str,
    /// As OpenSees starts: the displacement one step before the first is that at the start, whatever the velocity.
    start_at_rest: bool,
    /// Damping counts in the tangent.
    damped: bool,
    dt: f64,
    corrections: u32,
    /// Displacements one step before the committed state.
    before: Vec<f64>,
    fresh: bool,
}

impl CentralDifference {
    /// With or without damping forces at the velocity in the middle of two steps; `start_at_rest` begins as OpenSees.
    pub fn new(name: &'static str, damped: bool, start_at_rest: bool) -> Self {
        Self { name, start_at_rest, damped, dt: 0.0, corrections: 0, before: vec![], fresh: true }
    }
}

impl Integrator for CentralDifference {
    fn name(&self) -> &'static str {
        self.name
    }
    fn balances(&self) -> bool {
        false
    }
    fn stability_limit(&self) -> Option<f64> {
        Some(2.0)
    }

    fn prepare(&mut self, s: &mut System<'_>) -> Result<(), Failure> {
        self.before.resize(s.old.disp.len(), 0.0);
        self.fresh = true;
        Ok(())
    }

    fn begin(&mut self, s: &mut System<'_>, dt: f64) -> Result<(), Failure> {
        (self.dt, self.corrections) = (dt, 0);
        let (old, new, held) = (s.old, &mut *s.new, &s.work.plan.map.held);
        if self.fresh {
            self.fresh = false;
            let (v, a) = if self.start_at_rest { (0.0, 0.0) } else { (dt, 0.5 * dt * dt) };
            for (i, before) in self.before.iter_mut().enumerate() {
                *before = old.disp[i] - v * old.vel[i] + a * old.accel[i];
            }
        }
        let (velocity, accel) = (0.5 / dt, 1.0 / (dt * dt));
        s.coefficients = Coefficients { k: 0.0, c: if self.damped { velocity } else { 0.0 }, m: accel };
        for i in (0..held.len()).filter(|&i| !held[i]) {
            let last = old.disp[i] - self.before[i];
            // Velocity in the middle of two steps, so far with no further displacement.
            new.vel[i] = if self.damped { velocity * last } else { 0.0 };
            new.accel[i] = -accel * last;
        }
        s.apply_loads(s.old.time)
    }

    fn update(&mut self, s: &mut System<'_>, correction: &mut [f64]) -> Result<(), Failure> {
        only_once(self.name, &mut self.corrections, s)?;
        s.spread(correction);
        s.add_motion(Coefficients { k: 1.0, c: 0.0, m: 0.0 });
        let (old, new, held, dt) = (s.old, &mut *s.new, &s.work.plan.map.held, self.dt);
        for i in (0..held.len()).filter(|&i| !held[i]) {
            new.vel[i] = (3.0 * new.disp[i] - 4.0 * old.disp[i] + self.before[i]) / (2.0 * dt);
            new.accel[i] = (new.vel[i] - old.vel[i]) / dt;
        }
        s.apply_loads(s.old.time + dt)
    }

    fn commit(&mut self, s: &mut System<'_>, _: usize) -> Result<(), Failure> {
        self.before.copy_from_slice(&s.old.disp);
        Ok(())
    }
}

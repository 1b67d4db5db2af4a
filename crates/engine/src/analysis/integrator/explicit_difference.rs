//! The leap-frog method.

use super::Integrator;
use super::central_difference::only_once;
use super::explicit_start::balanced_acceleration;
use crate::analysis::failure::Failure;
use crate::analysis::system::{Coefficients, System};

/// `integrator ExplicitDifference`: central differences as leap-frog. Velocities belong to the middle of the steps; they take
/// displacements to the end of a step, where the equations give the acceleration from forces of that displacement and damping
/// of the velocity in the middle. The tangent is the mass. Reported velocities are those of the end of the step.
#[derive(Clone, Debug)]
pub struct ExplicitDifference {
    /// As OpenSees starts: the first step takes the initial velocity for that half a step before, and the acceleration for what
    /// it was set to.
    start_whole: bool,
    dt: f64,
    corrections: u32,
    fresh: bool,
    /// Velocities half a step before the committed state.
    middle: Vec<f64>,
    /// Values of the current step.
    next: Vec<f64>,
    /// Accelerations of the committed state.
    accel: Vec<f64>,
}

impl ExplicitDifference {
    /// `start_whole` begins as OpenSees.
    pub fn new(start_whole: bool) -> Self {
        let [middle, next, accel] = [const { vec![] }; 3];
        Self { start_whole, dt: 0.0, corrections: 0, fresh: true, middle, next, accel }
    }
}

impl Integrator for ExplicitDifference {
    fn name(&self) -> &'static str {
        "ExplicitDifference"
    }
    fn balances(&self) -> bool {
        false
    }
    fn stability_limit(&self) -> Option<f64> {
        Some(2.0)
    }

    fn prepare(&mut self, s: &mut System<'_>) -> Result<(), Failure> {
        self.fresh = true;
        self.middle.clone_from(&s.old.vel);
        self.next.clone_from(&s.old.vel);
        self.accel.clone_from(&s.old.accel);
        Ok(())
    }

    fn begin(&mut self, s: &mut System<'_>, dt: f64) -> Result<(), Failure> {
        (self.dt, self.corrections) = (dt, 0);
        if self.fresh && !self.start_whole {
            balanced_acceleration(s, &mut self.accel)?;
            let start = s.old.vel.iter().zip(&self.accel);
            self.middle.iter_mut().zip(start).for_each(|(m, (v, a))| *m = v - 0.5 * dt * a);
        }
        self.fresh = false;
        s.coefficients = Coefficients { k: 0.0, c: 0.0, m: 1.0 };
        s.moved = true;
        let (old, new, held) = (s.old, &mut *s.new, &s.work.plan.map.held);
        for i in (0..held.len()).filter(|&i| !held[i]) {
            self.next[i] = self.middle[i] + dt * self.accel[i];
            new.disp[i] = old.disp[i] + dt * self.next[i];
            new.vel[i] = self.next[i];
            new.accel[i] = 0.0;
        }
        s.apply_loads(s.old.time + dt)
    }

    fn update(&mut self, s: &mut System<'_>, correction: &mut [f64]) -> Result<(), Failure> {
        only_once(self.name(), &mut self.corrections, s)?;
        s.spread(correction);
        let (new, held) = (&mut *s.new, &s.work.plan.map.held);
        for i in (0..held.len()).filter(|&i| !held[i]) {
            let a = s.work.spread[i];
            // Half a step at the acceleration of its middle, between those of the ends of the whole one.
            new.vel[i] = self.next[i] + 0.125 * self.dt * (3.0 * a + self.accel[i]);
            new.accel[i] = a;
        }
        s.work.spread.fill(0.0);
        s.moved = true;
        Ok(())
    }

    fn commit(&mut self, s: &mut System<'_>, _: usize) -> Result<(), Failure> {
        self.middle.copy_from_slice(&self.next);
        self.accel.copy_from_slice(&s.new.accel);
        Ok(())
    }
}

//! The explicit method of Noh and Bathe.

use super::Integrator;
use super::central_difference::only_once;
use super::explicit_start::balanced_acceleration;
use crate::analysis::failure::Failure;
use crate::analysis::system::{Coefficients, System};

/// `integrator ExplicitBathe` (Noh and Bathe, 2013): a step in two parts, p and 1 - p of it, each with accelerations from the mass
/// alone; the parts are chosen so that high frequencies are damped.
#[derive(Clone, Debug)]
pub struct ExplicitBathe {
    /// Share of the first part.
    p: f64,
    /// Weights of the accelerations at the begin, in between and at the end in the last correction of the velocity.
    q: [f64; 3],
    /// As OpenSees starts: with the acceleration that has been set, in balance or not.
    start_as_set: bool,
    dt: f64,
    corrections: u32,
    fresh: bool,
    /// Accelerations of the committed state.
    accel: Vec<f64>,
    /// Velocities in between.
    vel: Vec<f64>,
    x: Vec<f64>,
}

impl ExplicitBathe {
    /// With the share of the first part, 0 to 1; 0.54 damps the modes at the limit of stability best.
    pub fn new(p: f64, start_as_set: bool) -> Self {
        let q1 = (1.0 - 2.0 * p) / (2.0 * p * (1.0 - p));
        let q2 = 0.5 - p * q1;
        let q = [0.5 - q1 - q2, q1, q2];
        let [accel, vel, x] = [const { vec![] }; 3];
        Self { p, q, start_as_set, dt: 0.0, corrections: 0, fresh: true, accel, vel, x }
    }
}

impl Integrator for ExplicitBathe {
    fn name(&self) -> &'static str {
        "ExplicitBathe"
    }
    fn balances(&self) -> bool {
        false
    }
    fn stability_limit(&self) -> Option<f64> {
        // Noh and Bathe (2013), for p of a half and more.
        Some(2.0 / self.p.max(1.0 - self.p))
    }

    fn prepare(&mut self, s: &mut System<'_>) -> Result<(), Failure> {
        self.fresh = true;
        self.accel.clone_from(&s.old.accel);
        self.vel.clone_from(&s.old.vel);
        self.x.resize(s.work.b.len(), 0.0);
        Ok(())
    }

    fn begin(&mut self, s: &mut System<'_>, dt: f64) -> Result<(), Failure> {
        (self.dt, self.corrections) = (dt, 0);
        if self.fresh && !self.start_as_set {
            balanced_acceleration(s, &mut self.accel)?;
        }
        self.fresh = false;
        s.coefficients = Coefficients { k: 0.0, c: 0.0, m: 1.0 };
        s.moved = true;
        let part = self.p * dt;
        let (old, new, held) = (s.old, &mut *s.new, &s.work.plan.map.held);
        for i in (0..held.len()).filter(|&i| !held[i]) {
            let (v, a) = (old.vel[i], self.accel[i]);
            new.disp[i] = old.disp[i] + part * v + 0.5 * part * part * a;
            new.vel[i] = v + part * a;
            new.accel[i] = 0.0;
        }
        s.apply_loads(s.old.time + part)
    }

    /// The unknown is the acceleration in between; that of the end of the step is solved for here.
    fn update(&mut self, s: &mut System<'_>, correction: &mut [f64]) -> Result<(), Failure> {
        only_once(self.name(), &mut self.corrections, s)?;
        let (first, rest) = (self.p * self.dt, (1.0 - self.p) * self.dt);
        s.spread(correction);
        let (old, new, held) = (s.old, &mut *s.new, &s.work.plan.map.held);
        for i in (0..held.len()).filter(|&i| !held[i]) {
            let a = s.work.spread[i];
            let v = old.vel[i] + 0.5 * first * (self.accel[i] + a);
            new.disp[i] += rest * v + 0.5 * rest * rest * a;
            new.vel[i] = v + rest * a;
            self.vel[i] = v + rest * (self.q[0] * self.accel[i] + (0.5 + self.q[1]) * a);
        }
        s.work.spread.fill(0.0);
        s.moved = true;
        s.apply_loads(s.old.time + self.dt)?;
        s.form_unbalance(false)?;
        self.x.copy_from_slice(&s.work.b);
        s.solve_for(&mut self.x)?;
        s.spread(&self.x);
        let (new, held) = (&mut *s.new, &s.work.plan.map.held);
        for i in (0..held.len()).filter(|&i| !held[i]) {
            let a = s.work.spread[i];
            new.vel[i] = self.vel[i] + rest * self.q[2] * a;
            new.accel[i] = a;
        }
        s.work.spread.fill(0.0);
        s.moved = true;
        Ok(())
    }

    fn commit(&mut self, s: &mut System<'_>, _: usize) -> Result<(), Failure> {
        self.accel.copy_from_slice(&s.new.accel);
        Ok(())
    }
}

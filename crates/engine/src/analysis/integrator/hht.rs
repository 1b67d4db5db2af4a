//! The method of Hilber, Hughes and Taylor.

use super::Integrator;
use super::newmark::{Form, Newmark};
use crate::analysis::failure::Failure;
use crate::analysis::opensees::Parts;
use crate::analysis::system::{Coefficients, System};

/// `integrator HHT` (Hilber, Hughes and Taylor, 1977): stiffness and damping forces, and the loads, count at the
/// fraction α of the step; α = 1 is Newmark's method.
#[derive(Clone, Debug)]
pub struct Hht {
    alpha: f64,
    gamma: f64,
    beta: f64,
    dt: f64,
    c: Coefficients,
    /// Displacements at the end of the step.
    disp: Vec<f64>,
    /// Velocities at the end of the step.
    vel: Vec<f64>,
}

impl Hht {
    /// From α, γ and β.
    pub fn new(alpha: f64, gamma: f64, beta: f64) -> Self {
        Self { alpha, gamma, beta, dt: 0.0, c: Coefficients::default(), disp: vec![], vel: vec![] }
    }

    /// With the γ and β that keep the method of second order: γ = 3/2 - α, β = (2 - α)²/4.
    pub fn second_order(alpha: f64) -> Self {
        Self::new(alpha, 1.5 - alpha, 0.25 * (2.0 - alpha) * (2.0 - alpha))
    }
}

impl Integrator for Hht {
    fn name(&self) -> &'static str {
        "HHT"
    }
    fn opensees_begin(&self) -> Option<Parts> {
        Some([false, true, true])
    }
    fn prepare(&mut self, s: &mut System<'_>) -> Result<(), Failure> {
        self.disp.resize(s.old.disp.len(), 0.0);
        self.vel.resize(s.old.vel.len(), 0.0);
        Ok(())
    }

    fn begin(&mut self, s: &mut System<'_>, dt: f64) -> Result<(), Failure> {
        let (gamma, beta, alpha) = (self.gamma, self.beta, self.alpha);
        self.dt = dt;
        self.c = Newmark::coefficients(gamma, beta, Form::Displacement, dt);
        s.coefficients = Coefficients { k: alpha * self.c.k, c: alpha * self.c.c, m: self.c.m };
        let (old, new, held) = (s.old, &mut *s.new, &s.work.plan.map.held);
        self.disp.copy_from_slice(&old.disp);
        self.vel.copy_from_slice(&old.vel);
        for i in (0..held.len()).filter(|&i| !held[i]) {
            let (v, a) = (old.vel[i], old.accel[i]);
            self.vel[i] = (1.0 - gamma / beta) * v + dt * (1.0 - 0.5 * gamma / beta) * a;
            new.accel[i] = -v / (beta * dt) + (1.0 - 0.5 / beta) * a;
            new.vel[i] = (1.0 - alpha) * v + alpha * self.vel[i];
        }
        s.apply_loads(s.old.time + alpha * dt)
    }

    fn update(&mut self, s: &mut System<'_>, correction: &mut [f64]) -> Result<(), Failure> {
        s.spread(correction);
        let (c, alpha) = (self.c, self.alpha);
        let new = &mut *s.new;
        for (i, d) in s.work.spread.iter().enumerate() {
            self.disp[i] += c.k * d;
            self.vel[i] += c.c * d;
            new.disp[i] += alpha * c.k * d;
            new.vel[i] += alpha * c.c * d;
            new.accel[i] += c.m * d;
        }
        s.work.spread.fill(0.0);
        Ok(())
    }

    fn commit(&mut self, s: &mut System<'_>, _: usize) -> Result<(), Failure> {
        // Imposed displacements are those of the begin of the step here; the loads move them to its end.
        s.new.disp.copy_from_slice(&self.disp);
        s.new.vel.copy_from_slice(&self.vel);
        s.respond_at_end(self.alpha, self.dt)
    }
}

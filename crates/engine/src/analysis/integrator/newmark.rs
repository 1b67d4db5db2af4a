//! Newmark's method.

use super::Integrator;
use crate::analysis::failure::Failure;
use crate::analysis::opensees::Parts;
use crate::analysis::system::{Coefficients, System};
use crate::numeric::real::Real;

/// Unknown of the equations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// Displacements.
    Displacement,
    /// Velocities.
    Velocity,
    /// Accelerations.
    Acceleration,
}

/// `integrator Newmark` (Newmark, 1959).
#[derive(Clone, Debug)]
pub struct Newmark {
    gamma: f64,
    beta: f64,
    form: Form,
    c: Coefficients,
}

impl Newmark {
    /// From γ and β.
    pub fn new(gamma: f64, beta: f64, form: Form) -> Self {
        Self { gamma, beta, form, c: Coefficients::default() }
    }

    /// Unknown of the equations.
    pub(in crate::analysis) fn form(&self) -> Form {
        self.form
    }

    /// Coefficients of a step of length `dt`.
    pub(in crate::analysis) fn coefficients_of_step(&self, dt: f64) -> Coefficients {
        Self::coefficients(self.gamma, self.beta, self.form, dt)
    }

    /// Velocity and acceleration at the end of a step of length `dt` in which the displacement does not change, from those at
    /// its begin.
    #[inline(always)]
    pub(in crate::analysis) fn predict<T: Real>(&self, dt: f64, vel: T, accel: T) -> (T, T) {
        let (gamma, beta) = (self.gamma, self.beta);
        let next_vel = vel * (1.0 - gamma / beta) + accel * (dt * (1.0 - 0.5 * gamma / beta));
        (next_vel, -vel / (beta * dt) + accel * (1.0 - 0.5 / beta))
    }

    /// Displacement, velocity and acceleration per unit of the unknown.
    pub(super) fn coefficients(gamma: f64, beta: f64, form: Form, dt: f64) -> Coefficients {
        match form {
            Form::Displacement => Coefficients { k: 1.0, c: gamma / (beta * dt), m: 1.0 / (beta * dt * dt) },
            Form::Velocity => Coefficients { k: beta * dt / gamma, c: 1.0, m: 1.0 / (gamma * dt) },
            Form::Acceleration => Coefficients { k: beta * dt * dt, c: gamma * dt, m: 1.0 },
        }
    }
}

impl Integrator for Newmark {
    fn name(&self) -> &'static str {
        "Newmark"
    }

    fn newmark(&self) -> Option<&Newmark> {
        Some(self)
    }

    fn opensees_begin(&self) -> Option<Parts> {
        let unknown_is_not = |form| self.form != form;
        Some([Form::Displacement, Form::Velocity, Form::Acceleration].map(unknown_is_not))
    }

    /// Predictor: the unknown does not change, the two others follow by Newmark's formulas. Degrees of freedom that
    /// are held keep their velocity and acceleration.
    fn begin(&mut self, s: &mut System<'_>, dt: f64) -> Result<(), Failure> {
        let (gamma, beta) = (self.gamma, self.beta);
        self.c = self.coefficients_of_step(dt);
        s.coefficients = self.c;
        s.moved |= self.form != Form::Displacement;
        let (old, new, held) = (s.old, &mut *s.new, &s.work.plan.map.held);
        for i in (0..held.len()).filter(|&i| !held[i]) {
            let (v, a) = (old.vel[i], old.accel[i]);
            match self.form {
                Form::Displacement => (new.vel[i], new.accel[i]) = self.predict(dt, v, a),
                Form::Velocity => {
                    new.disp[i] = old.disp[i] + dt * v + dt * dt * (0.5 - beta / gamma) * a;
                    new.accel[i] = (1.0 - 1.0 / gamma) * a;
                }
                Form::Acceleration => {
                    new.disp[i] = old.disp[i] + dt * v + 0.5 * dt * dt * a;
                    new.vel[i] = v + dt * a;
                }
            }
        }
        s.apply_loads(s.old.time + dt)
    }

    fn update(&mut self, s: &mut System<'_>, correction: &mut [f64]) -> Result<(), Failure> {
        s.add_correction(correction, self.c);
        Ok(())
    }
}

//! The generalised α methods.

use super::Integrator;
use super::newmark::{Form, Newmark};
use crate::analysis::failure::Failure;
use crate::analysis::opensees::Parts;
use crate::analysis::system::{Coefficients, System};

/// Parameters of [`GeneralizedAlpha`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AlphaParameters {
    /// Fraction of the step at which inertia counts.
    pub inertia: f64,
    /// Fraction of the step at which stiffness, damping and loads count.
    pub force: f64,
    /// Newmark's β.
    pub beta: f64,
    /// Newmark's γ.
    pub gamma: f64,
}

impl AlphaParameters {
    /// With the β and γ that keep the method of second order and damp high frequencies most.
    pub fn second_order(inertia: f64, force: f64) -> Self {
        let d = inertia - force;
        Self { inertia, force, beta: 0.25 * (1.0 + d) * (1.0 + d), gamma: 0.5 + d }
    }

    /// By the spectral radius that is left at infinite frequency, 0 to 1.
    pub fn spectral(rho: f64) -> Self {
        Self::second_order((2.0 - rho) / (1.0 + rho), 1.0 / (1.0 + rho))
    }

    /// Of an explicit method, by the spectral radius at the bifurcation (Hulbert and Chung, 1996) and the fraction of the step
    /// at which forces count, which is other than 1.
    pub fn explicit_by_bifurcation(rho: f64, force: f64) -> Self {
        let inertia = (2.0 - rho) / (1.0 + rho);
        let top = 5.0 - 3.0 * rho
            + 3.0 * force * (rho * rho - rho - 2.0)
            + force * force * (2.0 + 3.0 * rho - rho * rho * rho);
        let beta = top / ((force - 1.0) * (rho - 2.0) * (1.0 + rho) * (1.0 + rho));
        Self { inertia, force, beta, gamma: 0.5 + inertia - force }
    }
}

/// `integrator GeneralizedAlpha` (Chung and Hulbert, 1993) and `HHTGeneralized`.
#[derive(Clone, Debug)]
pub struct GeneralizedAlpha {
    name: &'static str,
    p: AlphaParameters,
    /// Corrections go into the acceleration as a whole, though the tangent takes a fraction of them: OpenSees'
    /// `GeneralizedAlpha`.
    whole_inertia: bool,
    dt: f64,
    c: Coefficients,
    /// Displacements at the end of the step.
    disp: Vec<f64>,
    /// Velocities at the end of the step.
    vel: Vec<f64>,
    /// Accelerations at the end of the step.
    accel: Vec<f64>,
}

impl GeneralizedAlpha {
    /// From its parameters; `whole_inertia` lets inertia count at the end of the step once the motion has been
    /// corrected, as OpenSees' `GeneralizedAlpha` does.
    pub fn new(name: &'static str, p: AlphaParameters, whole_inertia: bool) -> Self {
        let c = Coefficients::default();
        Self { name, p, whole_inertia, dt: 0.0, c, disp: vec![], vel: vec![], accel: vec![] }
    }
}

impl Integrator for GeneralizedAlpha {
    fn name(&self) -> &'static str {
        self.name
    }
    fn opensees_begin(&self) -> Option<Parts> {
        Some([false, true, true])
    }
    fn prepare(&mut self, s: &mut System<'_>) -> Result<(), Failure> {
        let n = s.old.disp.len();
        [&mut self.disp, &mut self.vel, &mut self.accel].into_iter().for_each(|v| v.resize(n, 0.0));
        Ok(())
    }

    fn begin(&mut self, s: &mut System<'_>, dt: f64) -> Result<(), Failure> {
        let AlphaParameters { inertia, force, beta, gamma } = self.p;
        self.dt = dt;
        self.c = Newmark::coefficients(gamma, beta, Form::Displacement, dt);
        s.coefficients = Coefficients { k: force * self.c.k, c: force * self.c.c, m: inertia * self.c.m };
        let (old, new, held) = (s.old, &mut *s.new, &s.work.plan.map.held);
        self.disp.copy_from_slice(&old.disp);
        self.vel.copy_from_slice(&old.vel);
        self.accel.copy_from_slice(&old.accel);
        for i in (0..held.len()).filter(|&i| !held[i]) {
            let (v, a) = (old.vel[i], old.accel[i]);
            self.vel[i] = (1.0 - gamma / beta) * v + dt * (1.0 - 0.5 * gamma / beta) * a;
            self.accel[i] = -v / (beta * dt) + (1.0 - 0.5 / beta) * a;
            new.vel[i] = (1.0 - force) * v + force * self.vel[i];
            new.accel[i] = (1.0 - inertia) * a + inertia * self.accel[i];
        }
        s.apply_loads(s.old.time + force * dt)
    }

    fn update(&mut self, s: &mut System<'_>, correction: &mut [f64]) -> Result<(), Failure> {
        s.spread(correction);
        let (c, force, inertia) = (self.c, self.p.force, self.p.inertia);
        let (old, new) = (s.old, &mut *s.new);
        for (i, d) in s.work.spread.iter().enumerate() {
            self.disp[i] += c.k * d;
            self.vel[i] += c.c * d;
            self.accel[i] += c.m * d;
            new.disp[i] += force * c.k * d;
            new.vel[i] += force * c.c * d;
            new.accel[i] = if self.whole_inertia {
                self.accel[i]
            } else {
                (1.0 - inertia) * old.accel[i] + inertia * self.accel[i]
            };
        }
        s.work.spread.fill(0.0);
        s.moved = true;
        Ok(())
    }

    fn commit(&mut self, s: &mut System<'_>, _: usize) -> Result<(), Failure> {
        // Imposed displacements are those of the begin of the step here; the loads move them to its end.
        s.new.disp.copy_from_slice(&self.disp);
        s.new.vel.copy_from_slice(&self.vel);
        s.new.accel.copy_from_slice(&self.accel);
        s.respond_at_end(self.p.force, self.dt)
    }
}

//! Collocation methods.

use super::Integrator;
use super::newmark::{Form, Newmark};
use crate::analysis::failure::Failure;
use crate::analysis::system::{Coefficients, System};

/// `integrator Collocation` (Hilber and Hughes, 1978) and `WilsonTheta`: equilibrium holds at θ times the step, and the
/// end of the step follows from an acceleration that is linear in time.
#[derive(Clone, Debug)]
pub struct Collocation {
    name: &'static str,
    theta: f64,
    beta: f64,
    gamma: f64,
    dt: f64,
    c: Coefficients,
}

/// β as a polynomial in θ, the highest power first.
const OPTIMAL_BETA: [f64; 10] = [
    -6.018722044382699e2,
    6.618777151634235e3,
    -3.231561059595987e4,
    9.195359004558867e4,
    -1.680788908312227e5,
    2.047005794710718e5,
    -1.661421563528177e5,
    8.667950092619179e4,
    -2.638652989051994e4,
    3.572862280471971e3,
];

impl Collocation {
    /// From θ, β and γ.
    pub fn new(theta: f64, beta: f64, gamma: f64) -> Self {
        Self { name: "Collocation", theta, beta, gamma, dt: 0.0, c: Coefficients::default() }
    }

    /// With γ = 1/2 and the β of least dissipation that is stable whatever the step: OpenSees' fit of the optimal
    /// values of Hilber and Hughes (1978), for θ a little above 1.
    pub fn stable(theta: f64) -> Self {
        let beta = OPTIMAL_BETA.iter().fold(0.0, |sum, c| sum * theta + c);
        Self::new(theta, beta, 0.5)
    }

    /// Wilson's method (Wilson, 1968): linear acceleration, β = 1/6 and γ = 1/2.
    pub fn wilson(theta: f64) -> Self {
        Self { name: "WilsonTheta", ..Self::new(theta, 1.0 / 6.0, 0.5) }
    }
}

impl Integrator for Collocation {
    fn name(&self) -> &'static str {
        self.name
    }
    fn begin(&mut self, s: &mut System<'_>, dt: f64) -> Result<(), Failure> {
        let (gamma, beta, long) = (self.gamma, self.beta, self.theta * dt);
        self.dt = dt;
        self.c = Newmark::coefficients(gamma, beta, Form::Displacement, long);
        s.coefficients = self.c;
        let (old, new, held) = (s.old, &mut *s.new, &s.work.plan.map.held);
        for i in (0..held.len()).filter(|&i| !held[i]) {
            let (v, a) = (old.vel[i], old.accel[i]);
            new.vel[i] = (1.0 - gamma / beta) * v + long * (1.0 - 0.5 * gamma / beta) * a;
            new.accel[i] = -v / (beta * long) + (1.0 - 0.5 / beta) * a;
        }
        s.apply_loads(s.old.time + long)
    }

    fn update(&mut self, s: &mut System<'_>, correction: &mut [f64]) -> Result<(), Failure> {
        s.add_correction(correction, self.c);
        Ok(())
    }

    fn commit(&mut self, s: &mut System<'_>, _: usize) -> Result<(), Failure> {
        let (gamma, beta, dt, theta) = (self.gamma, self.beta, self.dt, self.theta);
        let (old, new, held) = (s.old, &mut *s.new, &s.work.plan.map.held);
        for i in (0..held.len()).filter(|&i| !held[i]) {
            let (v, a) = (old.vel[i], old.accel[i]);
            // Dependent degrees of freedom follow by the same linear formulas.
            let end = a + (new.accel[i] - a) / theta;
            new.accel[i] = end;
            new.vel[i] = v + dt * ((1.0 - gamma) * a + gamma * end);
            new.disp[i] = old.disp[i] + dt * v + dt * dt * ((0.5 - beta) * a + beta * end);
        }
        s.respond_at_end(theta, dt)
    }
}

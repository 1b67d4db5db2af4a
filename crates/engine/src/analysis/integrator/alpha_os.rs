//! The operator-splitting methods.

use super::central_difference::only_once;
use super::{AlphaParameters, Integrator};
use crate::analysis::failure::Failure;
use crate::analysis::system::{Coefficients, System};

/// `integrator AlphaOS` and `AlphaOSGeneralized` (Combescure and Pegon, 1997): the elements are evaluated at a predicted
/// displacement, and a linear stiffness corrects it once. Inertia, stiffness and damping count at fractions of the step.
///
/// As in OpenSees the elements stay at the predicted displacement unless they are updated with the corrected one.
#[derive(Clone, Debug)]
pub struct AlphaOs {
    name: &'static str,
    p: AlphaParameters,
    /// Elements see the corrected displacements.
    update_elements: bool,
    c: Coefficients,
    dt: f64,
    corrections: u32,
    /// Displacements predicted for the end of the step, and of the last step.
    disp: Vec<f64>,
    last: Vec<f64>,
    /// Velocities predicted for the end of the step.
    vel: Vec<f64>,
    /// Correction of the last step, at all degrees of freedom, and what follows from it in the equations.
    lag: Vec<f64>,
    extra: Vec<f64>,
}

impl AlphaOs {
    /// From its parameters.
    pub fn new(name: &'static str, p: AlphaParameters, update_elements: bool) -> Self {
        let c = Coefficients::default();
        let [disp, last, vel, lag, extra] = [const { vec![] }; 5];
        Self { name, p, update_elements, c, dt: 0.0, corrections: 0, disp, last, vel, lag, extra }
    }

    /// The elements were at the predicted displacement of the last step, not at the corrected one: the linear stiffness makes
    /// up for that share of their forces.
    fn add_lag(&mut self, s: &mut System<'_>, correction: &mut [f64]) -> Result<(), Failure> {
        // Imposed motions were not predicted.
        let held = &s.work.plan.map.held;
        for (i, lag) in self.lag.iter_mut().enumerate().filter(|(i, _)| !held[*i]) {
            *lag = (self.p.force - 1.0) * (s.old.disp[i] - self.last[i]);
        }
        s.stiffness_times(&self.lag, &mut self.extra)?;
        s.solve_for(&mut self.extra)?;
        correction.iter_mut().zip(&self.extra).for_each(|(x, e)| *x += e);
        Ok(())
    }
}

impl Integrator for AlphaOs {
    fn name(&self) -> &'static str {
        self.name
    }
    fn balances(&self) -> bool {
        false
    }
    fn multiplies_tangents(&self) -> bool {
        true
    }

    fn prepare(&mut self, s: &mut System<'_>) -> Result<(), Failure> {
        let n = s.old.disp.len();
        self.disp.resize(n, 0.0);
        self.vel.resize(n, 0.0);
        self.lag.clear();
        self.lag.resize(n, 0.0);
        self.extra.resize(s.work.b.len(), 0.0);
        self.last.clone_from(&s.old.disp);
        Ok(())
    }

    fn begin(&mut self, s: &mut System<'_>, dt: f64) -> Result<(), Failure> {
        let AlphaParameters { inertia, force, beta, gamma } = self.p;
        (self.dt, self.corrections) = (dt, 0);
        self.c = Coefficients { k: 1.0, c: gamma / (beta * dt), m: 1.0 / (beta * dt * dt) };
        s.coefficients = Coefficients { k: force * self.c.k, c: force * self.c.c, m: inertia * self.c.m };
        s.moved = true;
        let (old, new, held) = (s.old, &mut *s.new, &s.work.plan.map.held);
        self.disp.copy_from_slice(&old.disp);
        self.vel.copy_from_slice(&old.vel);
        for i in (0..held.len()).filter(|&i| !held[i]) {
            let (u, v, a) = (old.disp[i], old.vel[i], old.accel[i]);
            self.disp[i] = u + dt * v + dt * dt * (0.5 - beta) * a;
            self.vel[i] = v + dt * (1.0 - gamma) * a;
            new.disp[i] = (1.0 - force) * self.last[i] + force * self.disp[i];
            new.vel[i] = (1.0 - force) * v + force * self.vel[i];
            new.accel[i] = (1.0 - inertia) * a;
        }
        s.apply_loads(s.old.time + force * dt)
    }

    fn update(&mut self, s: &mut System<'_>, correction: &mut [f64]) -> Result<(), Failure> {
        only_once(self.name, &mut self.corrections, s)?;
        if self.p.force != 1.0 {
            self.add_lag(s, correction)?;
        }
        let (new, held) = (&mut *s.new, &s.work.plan.map.held);
        new.disp.copy_from_slice(&self.disp);
        new.vel.copy_from_slice(&self.vel);
        (0..held.len()).filter(|&i| !held[i]).for_each(|i| new.accel[i] = 0.0);
        s.spread(correction);
        s.add_motion(self.c);
        s.moved = self.update_elements;
        s.apply_loads_at_end(self.p.force, self.dt)
    }

    fn commit(&mut self, _: &mut System<'_>, _: usize) -> Result<(), Failure> {
        self.last.copy_from_slice(&self.disp);
        Ok(())
    }
}

//! Explicit members of the generalised α family.

use super::central_difference::only_once;
use super::{AlphaParameters, Integrator};
use crate::analysis::failure::Failure;
use crate::analysis::system::{Coefficients, System};
use nalgebra::Matrix3;

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
    fn stability_limit(&self) -> Option<f64> {
        self.p.explicit_stability_limit()
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

/// Largest ω dt that is looked at.
const MAX_ANGLE: f64 = 16.0;
/// Squarings of the amplification matrix.
const SQUARINGS: u32 = 20;
/// Growth in a step that is no round-off.
const GROWTH: f64 = 1e-4;

impl AlphaParameters {
    /// Largest ω dt at which an oscillation without damping does not grow, by bisection.
    fn explicit_stability_limit(&self) -> Option<f64> {
        let grows = |angle: f64| self.explicit_growth(angle) > 1.0 + GROWTH;
        if !grows(MAX_ANGLE) {
            return None;
        }
        let (mut low, mut high) = (0.0, MAX_ANGLE);
        while high - low > 1e-6 {
            let middle = 0.5 * (low + high);
            if grows(middle) { high = middle } else { low = middle }
        }
        Some(high)
    }

    /// Spectral radius of the amplification matrix of displacement, velocity times dt and acceleration times dt².
    fn explicit_growth(&self, angle: f64) -> f64 {
        let Self { inertia, force, beta, gamma } = *self;
        let k = angle * angle / inertia;
        // inertia a1 + (1 - inertia) a + ω² ((1 - force) u + force (u + v + (1/2 - β) a)) = 0
        let last = [-k, -k * force, -k * force * (0.5 - beta) - (1.0 - inertia) / inertia];
        let disp = [1.0, 1.0, 0.5 - beta];
        let vel = [0.0, 1.0, 1.0 - gamma];
        let row = |own: [f64; 3], share: f64| [0, 1, 2].map(|j| own[j] + share * last[j]);
        let mut power = Matrix3::from_row_slice(&[row(disp, beta), row(vel, gamma), last].concat());
        // |A^N|^(1/N), the powers scaled so that they stay finite.
        let mut logarithm = 0.0;
        for _ in 0..SQUARINGS {
            let size = power.amax();
            power /= size;
            power *= power;
            logarithm = 2.0 * (logarithm + size.ln());
        }
        ((logarithm + power.amax().ln()) / 2f64.powi(SQUARINGS as i32)).exp()
    }
}

#[cfg(test)]
mod tests {
    use super::AlphaParameters;

    /// Of Newmark's method without β it is √(2/γ) (Hughes, 1987, section 9.1.2).
    #[test]
    fn limit_of_newmark_is_known() {
        for gamma in [0.5, 0.6, 0.8] {
            let p = AlphaParameters { inertia: 1.0, force: 1.0, beta: 0.0, gamma };
            let limit = p.explicit_stability_limit().unwrap_or(0.0);
            assert!((limit - (2.0 / gamma).sqrt()).abs() < 2e-3, "{gamma}: {limit}");
        }
    }
}

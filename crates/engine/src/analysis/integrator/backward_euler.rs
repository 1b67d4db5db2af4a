//! Backward differences of second order.

use super::Integrator;
use super::multistep::{Formula, Method, Multistep};

/// `integrator BackwardEuler` (Liu and others, 2012), after two steps of the trapezoidal rule.
#[derive(Clone, Copy, Debug)]
struct BackwardEuler {
    /// Acceleration from the displacement and the velocity of the last step, instead of from velocities.
    one_step: bool,
}

impl Method for BackwardEuler {
    fn name(&self) -> &'static str {
        "BackwardEuler"
    }
    fn formula(&self, past: usize, dt: f64) -> Formula {
        if past < 2 {
            return Formula::trapezoidal(dt);
        }
        let mut f = Formula::bdf2(dt);
        if self.one_step {
            f.c.m = 2.0 / (dt * dt);
            f.accel = [0.0, 0.0, 0.0, -2.0 / dt, 0.0, 0.0, 0.0];
        }
        f
    }
}

/// The integrator; `one_step` is its option 1.
pub fn backward_euler(one_step: bool) -> Box<dyn Integrator> {
    Box::new(Multistep::new(BackwardEuler { one_step }))
}

//! Park's method.

use super::Integrator;
use super::multistep::{Formula, Method, Multistep};
use crate::analysis::system::Coefficients;

/// `integrator ParkLMS3` (Park, 1975): the mean of Gear's methods of second and third order, for displacements and for
/// velocities, after two steps of the trapezoidal rule.
#[derive(Clone, Copy, Debug)]
struct ParkLMS3;

impl Method for ParkLMS3 {
    fn name(&self) -> &'static str {
        "ParkLMS3"
    }
    fn formula(&self, past: usize, dt: f64) -> Formula {
        if past < 2 {
            return Formula::trapezoidal(dt);
        }
        // d/dt x = (10 x - 15 x₋₁ + 6 x₋₂ - x₋₃) / 6 dt, used twice.
        let (d2, r) = (dt * dt, 10.0 / (6.0 * dt));
        let vel = [-5.0 / (6.0 * dt), 1.0 / dt, -1.0 / (6.0 * dt), 0.0, 0.0, 0.0, 0.0];
        let accel = [-25.0 / 18.0 / d2, 5.0 / 3.0 / d2, -5.0 / 18.0 / d2, -2.5 / dt, 1.0 / dt, -1.0 / (6.0 * dt), 0.0];
        Formula { c: Coefficients { k: 1.0, c: r, m: r * r }, vel, accel }
    }
}

/// The integrator.
pub fn park_lms3() -> Box<dyn Integrator> {
    Box::new(Multistep::new(ParkLMS3))
}

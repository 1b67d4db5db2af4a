//! A composite method of three steps.

use super::Integrator;
use super::multistep::{Formula, Method, Multistep};

/// `integrator TRBDF3`: the trapezoidal rule, the second-order backward difference and Houbolt's third-order differences in
/// turn.
#[derive(Clone, Copy, Debug)]
struct TRBDF3;

impl Method for TRBDF3 {
    fn name(&self) -> &'static str {
        "TRBDF3"
    }
    fn formula(&self, past: usize, dt: f64) -> Formula {
        match past % 3 {
            0 => Formula::trapezoidal(dt),
            1 => Formula::bdf2(dt),
            _ => Formula::houbolt(dt),
        }
    }
}

/// The integrator.
pub fn trbdf3() -> Box<dyn Integrator> {
    Box::new(Multistep::new(TRBDF3))
}

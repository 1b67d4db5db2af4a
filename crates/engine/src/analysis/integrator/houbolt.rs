//! Houbolt's method.

use super::Integrator;
use super::multistep::{Formula, Method, Multistep};

/// `integrator Houbolt` (Houbolt, 1950), after two steps of the trapezoidal rule.
#[derive(Clone, Copy, Debug)]
struct Houbolt;

impl Method for Houbolt {
    fn name(&self) -> &'static str {
        "Houbolt"
    }
    fn formula(&self, past: usize, dt: f64) -> Formula {
        if past < 2 { Formula::trapezoidal(dt) } else { Formula::houbolt(dt) }
    }
}

/// The integrator.
pub fn houbolt() -> Box<dyn Integrator> {
    Box::new(Multistep::new(Houbolt))
}

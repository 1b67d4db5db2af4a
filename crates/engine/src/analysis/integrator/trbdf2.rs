//! The composite method of Bank and others.

use super::Integrator;
use super::multistep::{Formula, Method, Multistep};

/// `integrator TRBDF2` (Bank et al., 1985; Bathe, 2007): steps of the trapezoidal rule and of the second-order backward
/// difference in turn. Unlike in those papers both are whole steps, as OpenSees has it.
#[derive(Clone, Copy, Debug)]
struct TRBDF2;

impl Method for TRBDF2 {
    fn name(&self) -> &'static str {
        "TRBDF2"
    }
    fn formula(&self, past: usize, dt: f64) -> Formula {
        if past.is_multiple_of(2) { Formula::trapezoidal(dt) } else { Formula::bdf2(dt) }
    }
}

/// The integrator.
pub fn trbdf2() -> Box<dyn Integrator> {
    Box::new(Multistep::new(TRBDF2))
}

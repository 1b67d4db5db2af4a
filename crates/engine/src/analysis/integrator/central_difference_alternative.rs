//! Central differences as OpenSees' alternative has them.

use super::Integrator;
use super::central_difference::only_once;
use crate::analysis::failure::Failure;
use crate::analysis::system::{Coefficients, System};

/// OpenSees' `integrator CentralDifferenceAlternative`: as [`CentralDifference`](super::CentralDifference), but damping forces are
/// those at the velocity in the middle of the last step, which is the velocity that is reported. There are no accelerations.
#[derive(Clone, Debug, Default)]
pub struct CentralDifferenceAlternative {
    dt: f64,
    corrections: u32,
}

impl Integrator for CentralDifferenceAlternative {
    fn name(&self) -> &'static str {
        "CentralDifferenceAlternative"
    }
    fn balances(&self) -> bool {
        false
    }
    fn stability_limit(&self) -> Option<f64> {
        Some(2.0)
    }

    fn begin(&mut self, s: &mut System<'_>, dt: f64) -> Result<(), Failure> {
        (self.dt, self.corrections) = (dt, 0);
        s.coefficients = Coefficients { k: 0.0, c: 0.0, m: 1.0 };
        s.apply_loads(s.old.time)
    }

    fn update(&mut self, s: &mut System<'_>, correction: &mut [f64]) -> Result<(), Failure> {
        only_once(self.name(), &mut self.corrections, s)?;
        s.spread(correction);
        let (old, new, held, dt) = (s.old, &mut *s.new, &s.work.plan.map.held, self.dt);
        for i in (0..held.len()).filter(|&i| !held[i]) {
            new.vel[i] = old.vel[i] + dt * s.work.spread[i];
            new.disp[i] = old.disp[i] + dt * new.vel[i];
        }
        s.work.spread.fill(0.0);
        s.moved = true;
        s.apply_loads(s.old.time + dt)
    }
}

//! The end of a step of an integrator that solves at another time.

use super::System;
use crate::analysis::failure::Failure;

impl System<'_> {
    /// Apply the loads of the end of a step of length `dt` that has been solved after `part` of it. In OpenSees loads and imposed
    /// motions stay those of that time, and the clock goes on from there: it rounds otherwise, and a motion may have ended by then.
    pub fn apply_loads_at_end(&mut self, part: f64, dt: f64) -> Result<(), Failure> {
        let (solved_at, end) = (self.new.time, self.old.time + dt);
        let compat = self.work.opensees.is_some();
        let (loaded_at, ended_at) = if compat { (solved_at, solved_at + (1.0 - part) * dt) } else { (end, end) };
        self.apply_loads(loaded_at)?;
        self.new.time = ended_at;
        Ok(())
    }

    /// The same, and evaluate all elements. In OpenSees no more time has passed for them than when the step was solved.
    pub fn respond_at_end(&mut self, part: f64, dt: f64) -> Result<(), Failure> {
        let passed = self.new.time - self.old.time;
        self.moved = true;
        self.apply_loads_at_end(part, dt)?;
        self.passed = self.work.opensees.is_some().then_some(passed);
        // `passed` holds for this evaluation alone, so that it gives the committed tangent too where that is needed.
        let done = self.respond(self.work.wants_committed_tangent());
        self.passed = None;
        done
    }
}

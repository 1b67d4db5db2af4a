//! Common part of the linear multistep methods: the motion at the end of a step follows from the unknown displacement and
//! from the motion at the ends of the steps before.

use super::Integrator;
use crate::analysis::failure::Failure;
use crate::analysis::opensees::Parts;
use crate::analysis::system::{Coefficients, System};
use std::fmt;

/// Weights of displacements now, one and two steps ago, of velocities likewise, and of the acceleration now.
pub(super) type Weights = [f64; 7];

/// Velocity and acceleration at the end of a step, as long as the displacement has not changed, and what a unit of
/// displacement adds to them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Formula {
    pub(super) c: Coefficients,
    pub(super) vel: Weights,
    pub(super) accel: Weights,
}

impl Formula {
    /// Constant average acceleration, which needs no past: all these methods begin with it.
    pub(super) fn trapezoidal(dt: f64) -> Self {
        Self {
            c: Coefficients { k: 1.0, c: 2.0 / dt, m: 4.0 / (dt * dt) },
            vel: [0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0],
            accel: [0.0, 0.0, 0.0, -4.0 / dt, 0.0, 0.0, -1.0],
        }
    }

    /// The backward difference of second order: velocity from displacements, acceleration from velocities.
    pub(super) fn bdf2(dt: f64) -> Self {
        let d2 = dt * dt;
        Self {
            c: Coefficients { k: 1.0, c: 1.5 / dt, m: 2.25 / d2 },
            vel: [-0.5 / dt, 0.5 / dt, 0.0, 0.0, 0.0, 0.0, 0.0],
            accel: [-0.75 / d2, 0.75 / d2, 0.0, -2.0 / dt, 0.5 / dt, 0.0, 0.0],
        }
    }

    /// Third-order differences of the displacements for velocity and acceleration (Houbolt, 1950).
    pub(super) fn houbolt(dt: f64) -> Self {
        let d2 = dt * dt;
        Self {
            c: Coefficients { k: 1.0, c: 11.0 / (6.0 * dt), m: 2.0 / d2 },
            vel: [-7.0 / (6.0 * dt), 1.5 / dt, -1.0 / (3.0 * dt), 0.0, 0.0, 0.0, 0.0],
            accel: [-3.0 / d2, 4.0 / d2, -1.0 / d2, 0.0, 0.0, 0.0, 0.0],
        }
    }
}

/// A linear multistep method.
pub(super) trait Method: Clone + fmt::Debug + Send + 'static {
    /// Name in the `integrator` command.
    fn name(&self) -> &'static str;
    /// Formula of a step of length `dt` after `past` steps of that length.
    fn formula(&self, past: usize, dt: f64) -> Formula;
}

/// Carries out a method: keeps the past, and begins anew when the step of time changes or a step has failed.
#[derive(Clone, Debug)]
pub(super) struct Multistep<M> {
    method: M,
    c: Coefficients,
    dt: f64,
    /// Steps of length `dt` committed one after the other.
    past: usize,
    /// Displacements one and two steps before the committed state.
    disp: [Vec<f64>; 2],
    /// Velocities, likewise.
    vel: [Vec<f64>; 2],
    /// Begun and not yet committed.
    open: bool,
}

impl<M: Method> Multistep<M> {
    pub(super) fn new(method: M) -> Self {
        let none = || [vec![], vec![]];
        Self { method, c: Coefficients::default(), dt: 0.0, past: 0, disp: none(), vel: none(), open: false }
    }
}

impl<M: Method> Integrator for Multistep<M> {
    fn name(&self) -> &'static str {
        self.method.name()
    }
    fn opensees_begin(&self) -> Option<Parts> {
        Some([false, true, true])
    }
    fn prepare(&mut self, s: &mut System<'_>) -> Result<(), Failure> {
        let n = s.old.disp.len();
        self.disp.iter_mut().chain(&mut self.vel).for_each(|v| v.resize(n, 0.0));
        (self.past, self.open) = (0, false);
        Ok(())
    }

    fn begin(&mut self, s: &mut System<'_>, dt: f64) -> Result<(), Failure> {
        if self.dt != dt || self.open {
            self.past = 0;
        }
        (self.dt, self.open) = (dt, true);
        let f = self.method.formula(self.past, dt);
        self.c = f.c;
        s.coefficients = f.c;
        let (old, new, held) = (s.old, &mut *s.new, &s.work.plan.map.held);
        for i in (0..held.len()).filter(|&i| !held[i]) {
            let now = [
                old.disp[i],
                self.disp[0][i],
                self.disp[1][i],
                old.vel[i],
                self.vel[0][i],
                self.vel[1][i],
                old.accel[i],
            ];
            let sum = |w: &Weights| w.iter().zip(&now).map(|(w, x)| w * x).sum::<f64>();
            (new.vel[i], new.accel[i]) = (sum(&f.vel), sum(&f.accel));
        }
        s.apply_loads(s.old.time + dt)
    }

    fn update(&mut self, s: &mut System<'_>, correction: &mut [f64]) -> Result<(), Failure> {
        s.add_correction(correction, self.c);
        Ok(())
    }

    fn commit(&mut self, s: &mut System<'_>, _: usize) -> Result<(), Failure> {
        for (past, now) in [(&mut self.disp, &s.old.disp), (&mut self.vel, &s.old.vel)] {
            past.swap(0, 1);
            past[0].copy_from_slice(now);
        }
        self.past += 1;
        self.open = false;
        Ok(())
    }
}

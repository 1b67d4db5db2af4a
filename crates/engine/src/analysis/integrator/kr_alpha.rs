//! The unconditionally stable explicit method of Kolay and Ricles.

use super::central_difference::only_once;
use super::{AlphaParameters, Integrator};
use crate::analysis::failure::Failure;
use crate::analysis::matrices::dense_tangent;
use crate::analysis::system::{Coefficients, System};
use crate::analysis::workspace::TangentMix;
use crate::solve::{SolveError, solve_dense};

/// `integrator KRAlphaExplicit` and `KRAlphaExplicit_TP` (Kolay and Ricles, 2014): displacement and
/// velocity at the end of a step follow from the motion at its begin by matrices made once from mass, damping and initial
/// stiffness, so that the method is stable whatever the step though no tangent is needed.
///
/// With A = M + γ Δt C + β Δt² K and D = αm M + αf (γ Δt C + β Δt² K) the matrices of the paper are α1 = A⁻¹ M,
/// α3 = (1 - αf) I + (αf - αm) α1, and the effective mass M (I - α3) = M A⁻¹ D: the accelerations are D⁻¹ A of
/// those that the mass alone would give. The matrices are dense.
#[derive(Clone, Debug)]
pub struct KrAlpha {
    p: AlphaParameters,
    /// The forces of both ends of a step are weighted, not the motion: `KRAlphaExplicit_TP`.
    trapezoidal: bool,
    /// Elements see the end of the step.
    update_elements: bool,
    /// Length of the step that the matrices are for; zero where there are none.
    dt: f64,
    corrections: u32,
    /// A⁻¹ M, by rows.
    alpha1: Vec<f64>,
    /// D⁻¹ A, by rows.
    gain: Vec<f64>,
    /// Displacements at the end of the step.
    disp: Vec<f64>,
    /// Velocities at the end of the step.
    vel: Vec<f64>,
    /// Two vectors of equations.
    x: Vec<f64>,
    y: Vec<f64>,
}

/// out = matrix x, by rows.
fn multiply(matrix: &[f64], x: &[f64], out: &mut [f64]) {
    for (o, row) in out.iter_mut().zip(matrix.chunks_exact(x.len().max(1))) {
        *o = row.iter().zip(x).map(|(a, b)| a * b).sum();
    }
}

impl KrAlpha {
    /// By the spectral radius that is left at infinite frequency; the elements see the end of each step, or stay at the
    /// displacement at which the equations were formed.
    pub fn new(rho: f64, update_elements: bool) -> Self {
        let p = AlphaParameters::spectral(rho);
        let [alpha1, gain, disp, vel, x, y] = [const { vec![] }; 6];
        Self { p, trapezoidal: false, update_elements, dt: 0.0, corrections: 0, alpha1, gain, disp, vel, x, y }
    }

    /// The same with the weights on the forces at both ends of a step: the elements see ends of steps only.
    pub fn trapezoidal(rho: f64) -> Self {
        Self { trapezoidal: true, ..Self::new(rho, true) }
    }

    /// Time of the evaluation of the elements, in parts of the step.
    fn place(&self) -> f64 {
        if self.trapezoidal { 1.0 } else { self.p.force }
    }

    fn make_matrices(&mut self, s: &mut System<'_>, dt: f64) -> Result<(), Failure> {
        let AlphaParameters { inertia, force, beta, gamma } = self.p;
        let mut matrix = |m: f64, f: f64| {
            s.coefficients = Coefficients { k: f * beta * dt * dt, c: f * gamma * dt, m };
            dense_tangent(s, TangentMix::INITIAL)
        };
        let (mass, a, d) = (matrix(1.0, 0.0), matrix(1.0, 1.0), matrix(inertia, force));
        let made = solve_dense(&a, &mass).and_then(|alpha1| Ok((alpha1, solve_dense(&d, &a)?)));
        match made {
            Ok((alpha1, gain)) => (self.alpha1, self.gain) = (alpha1, gain),
            Err(SolveError::Singular { equation }) => return Err(s.singular(equation)),
            Err(SolveError::OutOfMemory) => return Err(s.failure(crate::analysis::failure::Cause::OutOfMemory)),
        }
        self.dt = dt;
        Ok(())
    }
}

impl Integrator for KrAlpha {
    fn name(&self) -> &'static str {
        if self.trapezoidal { "KRAlphaExplicit_TP" } else { "KRAlphaExplicit" }
    }
    fn balances(&self) -> bool {
        false
    }

    fn prepare(&mut self, s: &mut System<'_>) -> Result<(), Failure> {
        self.dt = 0.0;
        let n = s.old.disp.len();
        self.disp.resize(n, 0.0);
        self.vel.resize(n, 0.0);
        self.x.resize(s.work.b.len(), 0.0);
        self.y.resize(s.work.b.len(), 0.0);
        if self.trapezoidal {
            s.hold_committed(1.0 - self.p.force, 0.0)?;
        }
        Ok(())
    }

    fn begin(&mut self, s: &mut System<'_>, dt: f64) -> Result<(), Failure> {
        if dt != self.dt {
            self.make_matrices(s, dt)?;
        }
        self.corrections = 0;
        s.coefficients = Coefficients { k: 0.0, c: 0.0, m: 1.0 };
        s.moved = true;
        let AlphaParameters { inertia, force, gamma, .. } = self.p;
        let place = self.place();
        for (x, &dof) in self.x.iter_mut().zip(&s.work.plan.map.dof_of) {
            *x = s.old.accel[dof];
        }
        multiply(&self.alpha1, &self.x, &mut self.y);
        s.spread(&self.y);
        let (old, new, held) = (s.old, &mut *s.new, &s.work.plan.map.held);
        self.disp.copy_from_slice(&old.disp);
        self.vel.copy_from_slice(&old.vel);
        for i in (0..held.len()).filter(|&i| !held[i]) {
            let (v, a) = (old.vel[i], s.work.spread[i]);
            let (du, dv) = (dt * v + (0.5 + gamma) * dt * dt * a, dt * a);
            self.disp[i] += du;
            self.vel[i] += dv;
            new.disp[i] = old.disp[i] + place * du;
            new.vel[i] = v + place * dv;
            new.accel[i] = (1.0 - force) * old.accel[i] + (force - inertia) * a;
        }
        s.work.spread.fill(0.0);
        if self.trapezoidal {
            s.weigh_unbalance(force, 1.0);
        }
        s.apply_loads(s.old.time + place * dt)
    }

    fn update(&mut self, s: &mut System<'_>, correction: &mut [f64]) -> Result<(), Failure> {
        only_once(self.name(), &mut self.corrections, s)?;
        multiply(&self.gain, correction, &mut self.x);
        s.spread(&self.x);
        let (new, held) = (&mut *s.new, &s.work.plan.map.held);
        new.disp.copy_from_slice(&self.disp);
        new.vel.copy_from_slice(&self.vel);
        for i in (0..held.len()).filter(|&i| !held[i]) {
            new.accel[i] = s.work.spread[i];
        }
        s.work.spread.fill(0.0);
        s.moved = self.update_elements;
        s.apply_loads_at_end(self.place(), self.dt)
    }

    fn commit(&mut self, s: &mut System<'_>, _: usize) -> Result<(), Failure> {
        if self.trapezoidal {
            s.hold_unbalance(1.0 - self.p.force, 0.0);
        }
        Ok(())
    }
}

//! Implicit integrators for hybrid simulation with a fixed number of iterations.

use super::Integrator;
use crate::analysis::failure::Failure;
use crate::analysis::system::System;
use crate::solve::Use;

/// `NewmarkHSFixedNumIter` and the like (Schellenberg, Mahin and Fenves, 2009): the trial displacements follow a polynomial
/// through those of the last steps and the newest solution, at places that advance evenly with the iterations, so that a test
/// specimen moves smoothly. A last correction comes when the step ends; the elements do not see it.
#[derive(Clone, Debug)]
pub struct FixedIterations {
    name: &'static str,
    inner: Box<dyn Integrator>,
    /// Order of the polynomial, 1 to 3.
    order: usize,
    /// Displacements of all degrees of freedom one and two steps before the committed ones.
    before: [Vec<f64>; 2],
    /// Unknown of the equations at the trial state, from the begin of the step.
    moved: Vec<f64>,
    correction: Vec<f64>,
}

impl FixedIterations {
    /// Around another integrator, whose unknown is the displacement.
    pub fn new(name: &'static str, inner: Box<dyn Integrator>, order: usize) -> Self {
        Self { name, inner, order, before: [vec![], vec![]], moved: vec![], correction: vec![] }
    }

    /// Lagrange's polynomials at `x`, through the newest solution at 1, the begin of the step at 0 and the steps before it
    /// at -1 and -2: weights of the first and of the last two.
    fn weights(&self, x: f64) -> (f64, [f64; 2]) {
        match self.order {
            1 => (x, [0.0, 0.0]),
            2 => (x * (x + 1.0) / 2.0, [(x - 1.0) * x / 2.0, 0.0]),
            _ => (x * (x + 1.0) * (x + 2.0) / 6.0, [(x - 1.0) * x * (x + 2.0) / 2.0, -(x - 1.0) * x * (x + 1.0) / 6.0]),
        }
    }
}

impl Integrator for FixedIterations {
    fn name(&self) -> &'static str {
        self.name
    }
    fn is_static(&self) -> bool {
        self.inner.is_static()
    }
    fn balances(&self) -> bool {
        false
    }

    fn prepare(&mut self, s: &mut System<'_>) -> Result<(), Failure> {
        self.before.iter_mut().for_each(|b| b.clone_from(&s.old.disp));
        self.moved.resize(s.work.b.len(), 0.0);
        self.correction.resize(s.work.b.len(), 0.0);
        self.inner.prepare(s)
    }

    fn begin(&mut self, s: &mut System<'_>, dt: f64) -> Result<(), Failure> {
        self.moved.fill(0.0);
        self.inner.begin(s, dt)
    }

    fn update(&mut self, s: &mut System<'_>, correction: &mut [f64]) -> Result<(), Failure> {
        let (made, allowed) = s.work.progress;
        let (newest, past) = self.weights(made as f64 / allowed as f64);
        for (i, (x, m)) in correction.iter().zip(&mut self.moved).enumerate() {
            let mut place = newest * (*m + x);
            if let Some(&dof) = s.work.plan.map.dof_of.get(i) {
                let steps = past.iter().zip(&self.before);
                place += steps.map(|(w, b)| w * (b[dof] - s.old.disp[dof])).sum::<f64>();
            }
            self.correction[i] = place - *m;
            *m = place;
        }
        self.inner.update(s, &mut self.correction)
    }

    fn commit(&mut self, s: &mut System<'_>, iterations: usize) -> Result<(), Failure> {
        s.form_tangent(s.work.matrix.mix, Use::Once)?;
        self.correction.copy_from_slice(&s.work.b);
        s.solve_for(&mut self.correction)?;
        self.inner.update(s, &mut self.correction)?;
        let [last, earlier] = &mut self.before;
        earlier.copy_from_slice(last);
        last.copy_from_slice(&s.old.disp);
        self.inner.commit(s, iterations)
    }
}

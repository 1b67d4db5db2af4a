//! The unbalance of a step as a weighted sum over both of its ends.

use super::system::System;

/// Weights of the unbalance at the end of a step, and the contribution of its begin. Methods that weight *forces* by the
/// trapezoidal rule differ from those that evaluate the elements once at a weighted *motion* where these are nonlinear.
#[derive(Clone, Debug, Default)]
pub(super) struct TwoEndResidual {
    /// Of loads, resisting forces and damping at the end of the step.
    forces: f64,
    /// Of the inertia.
    inertia: f64,
    /// Contribution of the begin of the step, weights included.
    held: Vec<f64>,
    /// Room for the unbalance that is not to be lost, and for one with whole inertia.
    kept: Vec<f64>,
    whole: Vec<f64>,
}

impl System<'_> {
    /// From here on sum the unbalance as `forces` (P - R - C v) - `inertia` M a at the trial state, and what the last
    /// [`System::hold_unbalance`] has left. The forces of constraints count whole, and those of the end of the step alone.
    pub fn weigh_unbalance(&mut self, forces: f64, inertia: f64) {
        let n = self.work.b.len();
        let t = self.work.two_end_residual.get_or_insert_default();
        t.held.resize(n, 0.0);
        (t.forces, t.inertia) = (forces, inertia);
    }

    /// Keep the unbalance of the trial state, with weights, for the next step. The elements are not evaluated again.
    pub fn hold_unbalance(&mut self, forces: f64, inertia: f64) {
        let mut t = self.work.two_end_residual.take().unwrap_or_default();
        // The unbalance that the step has ended with is looked at after it.
        t.kept.clone_from(&self.work.b);
        t.held.clear();
        t.held.resize(self.work.b.len(), 0.0);
        (t.forces, t.inertia) = (forces, inertia);
        self.sum_weighted(&mut t);
        std::mem::swap(&mut t.held, &mut self.work.b);
        self.work.b.copy_from_slice(&t.kept);
        self.work.two_end_residual = Some(t);
    }

    /// Add a factor times a vector to what is held for the next step.
    pub fn add_to_held(&mut self, factor: f64, x: &[f64]) {
        if let Some(t) = &mut self.work.two_end_residual {
            t.held.iter_mut().zip(x).for_each(|(h, x)| *h += factor * x);
        }
    }

    /// Hold the unbalance of the committed state, which no step of this integrator has ended at.
    ///
    /// # Errors
    /// An element finds no force.
    pub fn hold_committed(&mut self, forces: f64, inertia: f64) -> Result<(), super::failure::Failure> {
        self.apply_loads(self.old.time)?;
        self.respond(false)?;
        self.hold_unbalance(forces, inertia);
        Ok(())
    }

    pub(super) fn sum_weighted(&mut self, t: &mut TwoEndResidual) {
        if t.forces != 0.0 {
            self.sum_forces(t.inertia / t.forces);
            self.work.b.iter_mut().zip(&t.held).for_each(|(b, held)| *b = t.forces * *b + held);
        } else if t.inertia != 0.0 {
            // Only the inertia counts: what it adds to the other forces.
            self.sum_forces(1.0);
            t.whole.clone_from(&self.work.b);
            self.sum_forces(0.0);
            let parts = self.work.b.iter_mut().zip(&t.whole).zip(&t.held);
            parts.for_each(|((b, whole), held)| *b = t.inertia * (whole - *b) + held);
        } else {
            self.work.b.copy_from_slice(&t.held);
        }
    }
}

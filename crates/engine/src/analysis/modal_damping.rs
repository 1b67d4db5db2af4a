//! Forces and matrix of damping by modes.

use super::ground_inertia::mass_times;
use super::state::State;
use super::workspace::Workspace;
use crate::assembly::Storage;
use crate::model::Model;
use crate::numeric::{axpy, dot};

/// Modes that damp, ready for the equations.
#[derive(Clone, Debug, Default)]
pub(super) struct DampedModes {
    /// 2 ζ ω, M φ over all degrees of freedom, and M φ of the equations.
    modes: Vec<(f64, Vec<f64>, Vec<f64>)>,
    in_tangent: bool,
}

impl DampedModes {
    /// Returns true if no mode is damped.
    pub(super) fn is_empty(&self) -> bool {
        self.modes.is_empty()
    }

    pub(super) fn new(model: &Model, condense: impl Fn(&[f64], &mut [f64]), equations: usize) -> Self {
        let d = &model.modal_damping;
        let modes = d.modes.iter().map(|(factor, shape)| {
            let mut shape = shape.clone();
            shape.resize(model.dofs(), 0.0);
            let full = mass_times(model, &shape, false);
            let mut own = vec![0.0; equations];
            condense(&full, &mut own);
            (*factor, full, own)
        });
        Self { modes: modes.collect(), in_tangent: d.in_tangent }
    }
}

impl Workspace {
    /// Subtract the forces of damping by modes from `full`.
    pub(super) fn subtract_modal_damping(&mut self, state: &State) {
        for (factor, mass_shape, _) in &self.damped_modes.modes {
            axpy(-factor * dot(mass_shape, &state.vel), mass_shape, &mut self.full);
        }
    }

    /// Add the matrix of damping by modes to the tangent, as far as its pattern has room for it: Newton's method comes
    /// to the same motion without the rest.
    pub(super) fn add_modal_damping(&mut self, factor: f64) {
        if !self.damped_modes.in_tangent || factor == 0.0 {
            return;
        }
        let pattern = &self.plan.pattern;
        for (damping, _, shape) in &self.damped_modes.modes {
            for (i, a) in shape.iter().enumerate().filter(|(_, a)| **a != 0.0) {
                for (j, b) in shape.iter().enumerate().filter(|(j, _)| pattern.storage != Storage::Upper || i <= *j) {
                    if let Some(at) = pattern.place(i, j) {
                        self.matrix.values[at] += factor * damping * a * b;
                    }
                }
            }
        }
    }
}

//! Parts of the equations of motion that never change, for analyses of several models side by side.

use super::{MassPlace, SteadyMatrices, TangentMix, Workspace};
use crate::analysis::system::Coefficients;
use crate::model::Model;

/// Constant parts of the equations of one model.
#[derive(Clone, Debug)]
pub(in crate::analysis) struct ConstantParts<'a> {
    /// Entries of the matrix of a step: of mass and of elements whose tangent never changes.
    pub base: &'a [f64],
    /// Lumped masses of the nodes: degree of freedom, mass, mass-proportional damping.
    pub nodal: &'a [(usize, f64, f64)],
    /// Damping and mass of the elements as matrices of the equations, where these are used.
    pub steady: Option<&'a SteadyMatrices>,
    /// By element.
    pub elements: Vec<ConstantElement<'a>>,
}

/// Constant parts of an element.
#[derive(Clone, Copy, Debug)]
pub(in crate::analysis) struct ConstantElement<'a> {
    /// Its tangent never changes and is part of the base.
    pub linear: bool,
    /// Its materials have a damping matrix, which changes.
    pub viscous: bool,
    /// Inertia or Rayleigh damping come with its motion.
    pub is_dynamic: bool,
    /// Factor of mass-proportional damping.
    pub alpha_m: f64,
    /// Stiffness that damps, n x n by rows, and its factor in the forces; empty where there is none.
    pub damping: (&'a [f64], f64),
    /// Factor of this stiffness in a tangent that changes, per unit of velocity.
    pub damping_in_tangent: f64,
    /// Mass: nothing, lumped by degrees of freedom, or n x n by rows.
    pub mass: &'a [f64],
}

impl Workspace {
    /// Assemble the constant entries of the matrix of a step by Newton's method.
    pub(in crate::analysis) fn assemble_constant(&mut self, model: &Model, c: Coefficients) {
        self.assemble_base(model, c, TangentMix::CURRENT);
        self.matrix.base_of = Some((c, TangentMix::CURRENT));
        self.find_steady(model);
    }

    /// Constant parts of the equations, after [`Workspace::assemble_constant`]. `None` where more than the tangents and
    /// viscous matrices of the elements changes in a step, or with `dynamic` other forces act than those of elements and nodal
    /// masses.
    pub(in crate::analysis) fn constant_parts(&self, model: &Model, dynamic: bool) -> Option<ConstantParts<'_>> {
        let e = &self.elements;
        let other_forces = self.two_end_residual.is_some() || !self.damped_modes.is_empty();
        let changes = e.residual_needs_tangent || self.wants_committed_tangent() || !e.renewed.0.is_empty();
        if dynamic && (other_forces || changes) || self.small_beams.count > 0 {
            return None;
        }
        let sizes = model.elements.iter().map(|e| e.dofs.len());
        let elements: Option<Vec<_>> = sizes.enumerate().map(|(i, n)| self.constant_element(i, n)).collect();
        Some(ConstantParts {
            base: &self.matrix.base,
            nodal: &self.nodal,
            steady: self.steady.as_deref(),
            elements: elements?,
        })
    }

    /// Constant parts of an element with n degrees of freedom.
    fn constant_element(&self, i: usize, n: usize) -> Option<ConstantElement<'_>> {
        let (all, m) = (&self.elements, &self.elements.entries[i]);
        if m.counts_calls || m.keeps_tangent || m.stiffness_as_mass || m.inertance.is_some() {
            return None;
        }
        let (r, matrix) = (&m.rayleigh.forces, m.at..m.at + n * n);
        let (stiffness, factor) =
            if m.linear { (&all.tangent, r.beta_k + r.beta_k0 + r.beta_kc) } else { (&all.initial, r.beta_k0) };
        Some(ConstantElement {
            linear: m.linear,
            viscous: m.damping.is_some(),
            is_dynamic: m.is_dynamic,
            alpha_m: r.alpha_m,
            damping: if factor == 0.0 { (&[], 0.0) } else { (&stiffness[matrix], factor) },
            damping_in_tangent: if m.linear { 0.0 } else { m.rayleigh.tangent.beta_k0 },
            mass: match m.mass {
                MassPlace::None => &[],
                MassPlace::Lumped(at) => &all.mass[at..at + n],
                MassPlace::Consistent(at) => &all.mass[at..at + n * n],
            },
        })
    }
}

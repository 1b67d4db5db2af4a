//! Forces that are taken off the unbalance: resisting forces of the elements, damping and inertia of elements and nodes.

use super::{ElementWorkspace, MassPlace, Workspace};
use crate::analysis::state::State;
use crate::element::MAX_DOFS;
use crate::model::{ElementId, Model, Rayleigh};
use crate::numeric::dot;

impl Workspace {
    /// Subtract the forces of the elements from `full`: resisting forces, and with `dynamic` damping and inertia.
    pub(in crate::analysis) fn subtract_elements(&mut self, model: &Model, state: &State, dynamic: bool) {
        for (e, m) in model.elements.iter().zip(&self.elements.entries) {
            let force = &state.force[e.force.clone()];
            for (&d, f) in e.dofs.iter().zip(force) {
                self.full[d as usize] -= f;
            }
            if dynamic && m.is_dynamic {
                let mut f = [0.0; MAX_DOFS];
                self.add_dynamic_force(&e.dofs, m, &m.rayleigh.forces, state, 1.0, &mut f);
                for (&d, f) in e.dofs.iter().zip(&f) {
                    self.full[d as usize] -= f;
                }
            }
        }
    }

    /// Subtract the same from the unbalance of the equations, `inertia` times the inertia of it: what goes to the supports is
    /// left out.
    #[inline]
    pub(in crate::analysis) fn condense_elements(&mut self, model: &Model, state: &State, dynamic: bool, inertia: f64) {
        self.plan.subtract_forces(&state.force, &mut self.b);
        if dynamic {
            self.subtract_dynamic(model, state, inertia);
        }
    }

    /// Subtract damping and a share of the inertia of an element from the unbalance of the equations.
    pub(super) fn subtract_dynamic_of(&mut self, i: usize, model: &Model, state: &State, inertia: f64) {
        let (e, m) = (&model.elements[i], &self.elements.entries[i]);
        if m.is_dynamic {
            let mut f = [0.0; MAX_DOFS];
            self.add_dynamic_force(&e.dofs, m, &m.rayleigh.forces, state, inertia, &mut f);
            self.plan.subtract_force(i, e.force.start, &f, &mut self.b);
        }
    }

    /// Add the damping forces of an element by factors of Rayleigh, and a share of its inertia.
    fn add_dynamic_force(
        &self,
        dofs: &[u32],
        m: &ElementWorkspace,
        r: &Rayleigh,
        state: &State,
        inertia: f64,
        out: &mut [f64; MAX_DOFS],
    ) {
        // Products of the sizes of beams have no loops.
        match dofs.len() {
            6 => self.add_dynamic_force_of::<6>(6, dofs, m, r, state, inertia, out),
            12 => self.add_dynamic_force_of::<12>(12, dofs, m, r, state, inertia, out),
            n => self.add_dynamic_force_of::<MAX_DOFS>(n, dofs, m, r, state, inertia, out),
        }
    }

    /// The same for an element of `n` degrees of freedom, at most `N`.
    #[inline(always)]
    #[allow(clippy::too_many_arguments)]
    fn add_dynamic_force_of<const N: usize>(
        &self,
        n: usize,
        dofs: &[u32],
        m: &ElementWorkspace,
        r: &Rayleigh,
        state: &State,
        inertia: f64,
        out: &mut [f64; MAX_DOFS],
    ) {
        let (mut v, mut a) = ([0.0; N], [0.0; N]);
        for ((&d, v), a) in dofs.iter().zip(&mut v).zip(&mut a) {
            *v = state.vel[d as usize];
            *a = r.alpha_m * *v + inertia * state.accel[d as usize];
        }
        let mut add = |matrix: &[f64], factor: f64, x: &[f64]| {
            if factor != 0.0 {
                for (o, row) in out.iter_mut().zip(matrix.chunks_exact(n)) {
                    *o += factor * dot(row, x);
                }
            }
        };
        let range = m.at..m.at + n * n;
        if m.linear {
            add(&self.elements.tangent[range], r.beta_k + r.beta_k0 + r.beta_kc, &v[..n]);
        } else {
            add(&self.elements.tangent[range.clone()], r.beta_k, &v[..n]);
            if r.beta_k0 != 0.0 {
                add(&self.elements.initial[range.clone()], r.beta_k0, &v[..n]);
            }
            if r.beta_kc != 0.0 {
                add(&self.elements.committed[range], r.beta_kc, &v[..n]);
            }
        }
        match m.mass {
            MassPlace::None => {}
            MassPlace::Lumped(at) => {
                out.iter_mut().zip(&self.elements.mass[at..at + n]).zip(&a).for_each(|((o, m), a)| *o += m * a);
            }
            MassPlace::Consistent(at) => add(&self.elements.mass[at..at + n * n], 1.0, &a[..n]),
        }
    }

    /// The Rayleigh damping force of an element.
    pub(in crate::analysis) fn rayleigh_force(&self, model: &Model, id: ElementId, state: &State) -> [f64; MAX_DOFS] {
        self.damping_and_inertia(model, id, state, 0.0)
    }

    /// The Rayleigh damping force and the inertia of an element.
    pub(in crate::analysis) fn dynamic_force(&self, model: &Model, id: ElementId, state: &State) -> [f64; MAX_DOFS] {
        self.damping_and_inertia(model, id, state, 1.0)
    }

    fn damping_and_inertia(&self, model: &Model, id: ElementId, state: &State, inertia: f64) -> [f64; MAX_DOFS] {
        let mut f = [0.0; MAX_DOFS];
        let m = &self.elements.entries[id.0];
        self.add_dynamic_force(&model.elements[id.0].dofs, m, &m.rayleigh.forces, state, inertia, &mut f);
        f
    }

    /// Subtract the Rayleigh damping forces of the elements from `full`.
    pub(in crate::analysis) fn subtract_damping(&mut self, model: &Model, state: &State) {
        for (e, m) in model.elements.iter().zip(&self.elements.entries).filter(|(_, m)| !m.rayleigh.reported.is_zero())
        {
            let mut f = [0.0; MAX_DOFS];
            // Inertia is no part of a report of damping.
            self.add_dynamic_force(&e.dofs, m, &m.rayleigh.reported, state, 0.0, &mut f);
            for (&d, f) in e.dofs.iter().zip(&f) {
                self.full[d as usize] -= f;
            }
        }
    }

    /// Rayleigh damping forces of all elements that take part in the equations, laid out as `State::force`.
    pub(in crate::analysis) fn damping_forces(&self, model: &Model, state: &State, out: &mut [f64]) {
        let all = model.elements.iter().zip(&self.elements.entries).enumerate();
        for (i, (e, _)) in all.filter(|(_, (_, m))| m.is_dynamic) {
            let force = self.rayleigh_force(model, ElementId(i), state);
            out[e.force.clone()].copy_from_slice(&force[..e.force.len()]);
        }
    }

    /// Subtract the mass-proportional damping of the nodes from `full`.
    pub(in crate::analysis) fn subtract_nodal_damping(&mut self, state: &State) {
        for &(dof, mass, alpha_m) in &self.nodal {
            self.full[dof] -= mass * alpha_m * state.vel[dof];
        }
    }

    /// Subtract a share of the inertia, and the mass-proportional damping, of the nodes from `full`.
    pub(in crate::analysis) fn subtract_nodal_inertia(&mut self, state: &State, inertia: f64) {
        for &(dof, mass, alpha_m) in &self.nodal {
            self.full[dof] -= mass * (inertia * state.accel[dof] + alpha_m * state.vel[dof]);
        }
    }
}

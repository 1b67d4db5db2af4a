//! Tangent of the equations from the matrices of the elements.

use super::{ElementMatrices, MassPlace, TangentMix, Workspace};
use crate::analysis::state::State;
use crate::analysis::system::Coefficients;
use crate::element::{ElementInput, ElementOutput, Histories, MAX_DOFS, MatrixMask};
use crate::model::Model;
use crate::numeric::dot;

impl Workspace {
    /// Assemble the tangent into `values`. What does not change from iteration to iteration is kept.
    pub(in crate::analysis) fn assemble(&mut self, model: &Model, c: Coefficients, mix: TangentMix) {
        if mix.initial != 0.0 {
            self.fill_initial(model);
        }
        if self.matrix.base_of != Some((c, mix)) {
            self.assemble_base(model, c, mix);
            self.matrix.base_of = Some((c, mix));
        }
        self.matrix.values.copy_from_slice(&self.matrix.base);
        for (p, axial) in self.small_beams.p_delta().zip(&self.elements.axial) {
            let m = &self.elements.entries[p.element];
            if m.p_delta {
                let current = c.k * m.mix(mix).current + c.c * m.rayleigh.tangent.beta_k;
                p.add_geometric(current * axial, &mut self.matrix.values);
            }
        }
        let all = model.elements.iter().zip(&self.elements.entries).enumerate();
        for (i, (e, m)) in all.filter(|(_, (_, m))| !m.linear && !m.p_delta) {
            let range = m.at..m.at + e.dofs.len().pow(2);
            let mix = m.mix(mix);
            let of_mass = if m.stiffness_as_mass { c.c + c.m } else { 0.0 };
            let current = c.k * mix.current + c.c * m.rayleigh.tangent.beta_k + of_mass;
            if current != 0.0 {
                self.plan.add_element(i, &self.elements.tangent[range.clone()], current, &mut self.matrix.values);
            }
            let initial = c.k * mix.initial + c.c * m.rayleigh.tangent.beta_k0;
            if initial != 0.0 {
                self.plan.add_element(i, &self.elements.initial[range.clone()], initial, &mut self.matrix.values);
            }
            if m.rayleigh.tangent.beta_kc != 0.0 && c.c != 0.0 {
                let factor = c.c * m.rayleigh.tangent.beta_kc;
                self.plan.add_element(i, &self.elements.committed[range.clone()], factor, &mut self.matrix.values);
            }
            if let Some(at) = m.damping.filter(|_| c.c != 0.0) {
                self.plan.add_element(i, &self.elements.damping[at..at + range.len()], c.c, &mut self.matrix.values);
            }
        }
    }

    /// Evaluate tangents that differ between the last trial state and the committed one.
    pub(in crate::analysis) fn renew_tangents(&mut self, model: &Model, state: &State) {
        if !self.elements.is_current {
            return;
        }
        let ElementMatrices { entries, tangent, renewed: (elements, room), .. } = &mut self.elements;
        for &i in elements.iter() {
            let (e, n) = (&model.elements[i], model.elements[i].dofs.len());
            let (mut disp, mut force, rest) = ([0.0; MAX_DOFS], [0.0; MAX_DOFS], [0.0; MAX_DOFS]);
            e.dofs.iter().zip(&mut disp).for_each(|(&d, u)| *u = state.disp[d as usize]);
            let input = ElementInput {
                disp: &disp[..n],
                vel: &rest[..n],
                accel: &[],
                load: &state.element_load[e.load.clone()],
                still: true,
                opensees: None,
                dt: 0.0,
                time: state.time,
                dynamic: false,
            };
            let tangent = &mut tangent[entries[i].at..entries[i].at + n * n];
            tangent.fill(0.0);
            let output =
                ElementOutput { force: &mut force[..n], tangent: Some(tangent), damping: None, part: MatrixMask::ALL };
            let committed = &state.history[e.state.clone()];
            // The same state was evaluated in the last iteration.
            let h = &mut Histories { committed, trial: &mut room[..committed.len()] };
            let _ = e.element.respond(&input, h, output);
        }
    }

    pub(super) fn assemble_base(&mut self, model: &Model, c: Coefficients, mix: TangentMix) {
        self.matrix.base.fill(0.0);
        let mut diagonal = [0.0; MAX_DOFS * MAX_DOFS];
        for (i, (e, m)) in model.elements.iter().zip(&self.elements.entries).enumerate() {
            let n = e.dofs.len();
            if m.linear {
                let r = &m.rayleigh.tangent;
                let factor = c.k * (mix.current + mix.initial) + c.c * (r.beta_k + r.beta_k0 + r.beta_kc);
                self.plan.add_element(i, &self.elements.tangent[m.at..m.at + n * n], factor, &mut self.matrix.base);
            }
            if let Some(at) = m.inertance.filter(|_| c.m != 0.0) {
                self.plan.add_element(i, &self.elements.mass[at..at + n * n], c.m, &mut self.matrix.base);
            }
            let factor = c.m + c.c * m.rayleigh.tangent.alpha_m;
            if factor == 0.0 {
                continue;
            }
            match m.mass {
                MassPlace::None => {}
                MassPlace::Lumped(at) => {
                    diagonal[..n * n].fill(0.0);
                    for (k, mass) in self.elements.mass[at..at + n].iter().enumerate() {
                        diagonal[k * n + k] = *mass;
                    }
                    self.plan.add_element(i, &diagonal[..n * n], factor, &mut self.matrix.base);
                }
                MassPlace::Consistent(at) => {
                    self.plan.add_element(i, &self.elements.mass[at..at + n * n], factor, &mut self.matrix.base);
                }
            }
        }
        for p in self.small_beams.p_delta() {
            let m = &self.elements.entries[p.element];
            if m.p_delta {
                let r = &m.rayleigh.tangent;
                let factor = c.k * (mix.current + mix.initial) + c.c * (r.beta_k + r.beta_k0);
                self.plan.add_element(p.element, &p.stiffness, factor, &mut self.matrix.base);
            }
        }
        for &(dof, mass, alpha_m) in &self.nodal {
            self.plan.add_diagonal(dof, (c.m + c.c * alpha_m) * mass, &mut self.matrix.base);
        }
        self.plan.add_links(if c.k == 0.0 { 0.0 } else { 1.0 }, &mut self.matrix.base);
    }

    /// Stiffness of the elements, of the mix of the last tangent, times displacements of all degrees of freedom.
    pub(in crate::analysis) fn stiffness_times(&mut self, model: &Model, disp: &[f64], out: &mut [f64]) {
        self.full.fill(0.0);
        for (e, m) in model.elements.iter().zip(&self.elements.entries) {
            let n = e.dofs.len();
            let range = m.at..m.at + n * n;
            let initial = self.matrix.mix.initial != 0.0 && !m.linear && !m.initial_is_current;
            let k = if initial { &self.elements.initial[range] } else { &self.elements.tangent[range] };
            let mut u = [0.0; MAX_DOFS];
            e.dofs.iter().zip(&mut u).for_each(|(&d, u)| *u = disp[d as usize]);
            for (&d, row) in e.dofs.iter().zip(k.chunks_exact(n)) {
                self.full[d as usize] += dot(row, &u[..n]);
            }
        }
        let n = self.plan.map.equations;
        self.plan.map.condense(&self.full, &mut out[..n]);
        out[n..].fill(0.0);
    }
}

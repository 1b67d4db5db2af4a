//! What an analysis works with between two changes of the model: plan, factors, matrices of the elements, buffers.

mod forces;

use super::asking::{Asking, Calls};
use super::failure::Cause;
use super::loads::Loads;
use super::modal_damping::DampedModes;
use super::system::Coefficients;
use super::two_end_residual::TwoEndResidual;
use crate::assembly::{DofError, Handler, MpScope, Plan};
use crate::element::{MAX_DOFS, Mass, MatrixMask, Rows};
use crate::model::{Model, Rayleigh};
use crate::numeric::dot;
use crate::solve::{NEARLY_SINGULAR, Pivots, SolveError, Solver};

/// Which stiffness goes into the tangent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TangentMix {
    /// Share of the current tangent.
    pub current: f64,
    /// Share of the initial one.
    pub initial: f64,
}

impl TangentMix {
    /// The current tangent.
    pub const CURRENT: Self = Self { current: 1.0, initial: 0.0 };
    /// The initial tangent.
    pub const INITIAL: Self = Self { current: 0.0, initial: 1.0 };
}

/// Where the matrices of an element lie, and what they are multiplied with.
#[derive(Clone, Debug)]
pub(super) struct ElementWorkspace {
    /// Place of the tangent.
    pub at: usize,
    /// Place of the motion that it was asked at last.
    pub motion: usize,
    /// The tangent never changes, and there is no damping matrix.
    pub linear: bool,
    /// The force depends on velocities or on the time that passes.
    pub rates: bool,
    /// The answer goes on with every call.
    pub counts_calls: bool,
    /// A node of it is held, or follows others.
    pub constrained: bool,
    /// The current tangent stands for the initial one.
    initial_is_current: bool,
    /// The committed tangent stays that of the first step.
    keeps_committed: bool,
    /// Place of the damping matrix of viscous materials.
    pub damping: Option<usize>,
    /// Rows of the matrices that are read: those of degrees of freedom that are in the equations, and where Rayleigh
    /// damping makes forces of the matrices all of them.
    pub rows: Rows,
    mass: MassPlace,
    /// Inertia or damping forces come with its motion.
    is_dynamic: bool,
    rayleigh: Rayleigh,
    /// Those of them that are in the tangent: OpenSees leaves them out of some.
    in_tangent: Rayleigh,
    /// Those that reports of damping forces count: OpenSees asks no element whether it takes part.
    reported: Rayleigh,
}

#[derive(Clone, Debug)]
enum MassPlace {
    None,
    Lumped(usize),
    Consistent(usize),
}

/// Everything an analysis works with between two changes of the model.
#[derive(Debug)]
pub struct Workspace {
    /// Numbering, pattern and scatter maps.
    pub plan: Plan,
    /// Factors.
    pub solver: Solver,
    /// Loads, laid out flat.
    pub loads: Loads,
    /// Unbalance of the equations.
    pub b: Vec<f64>,
    /// Correction of the equations.
    pub x: Vec<f64>,
    /// A vector over all degrees of freedom, zero between uses.
    pub spread: Vec<f64>,
    /// Shares of the last tangent that was formed.
    pub(super) last: Option<Coefficients>,
    /// Which stiffness was in it.
    pub(super) last_mix: TangentMix,
    /// Iterations of the step so far, and those that the test allows.
    pub(super) progress: (usize, usize),
    /// What the unbalance is summed over both ends of a step with, where an integrator does.
    pub(super) two_end_residual: Option<TwoEndResidual>,
    /// Smallest pivot seen, where it was nearly zero.
    pub weak_pivot: Option<Pivots>,
    /// State determinations of elements so far.
    pub element_calls: u64,
    pub(super) full: Vec<f64>,
    pub(super) values: Vec<f64>,
    pub(super) factored: Vec<f64>,
    pub(super) matrices: Vec<ElementWorkspace>,
    pub(super) damped_modes: DampedModes,
    pub(super) tangent: Vec<f64>,
    pub(super) damping: Vec<f64>,
    pub(super) tangent_is_current: bool,
    pub(super) residual_needs_tangent: bool,
    /// The integrator multiplies the tangents of the elements with displacements of its own: all columns are read.
    pub(super) multiplies: bool,
    /// OpenSees' slips are followed.
    pub(super) compat: bool,
    /// Elements that count their calls.
    pub(super) counting: Vec<usize>,
    /// How often elements that count their calls are asked.
    pub(super) asking: Asking,
    /// How often they are to be asked now.
    pub(super) updates: Calls,
    /// Displacements that the elements were asked at last, and then their velocities, element after element.
    pub(super) motions: Vec<f64>,
    /// Displacements of all degrees of freedom when the elements were asked last in a step.
    pub(super) asked_at: Vec<f64>,
    initial: Vec<f64>,
    committed: Vec<f64>,
    mass: Vec<f64>,
    base: Vec<f64>,
    base_of: Option<(Coefficients, TangentMix)>,
    /// Lumped masses of the nodes: degree of freedom, mass, mass-proportional damping.
    nodal: Vec<(usize, f64, f64)>,
}

/// How to prepare.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PrepareOptions {
    /// Constraint handler.
    pub handler: Handler,
    /// Which multi-point constraints count.
    pub scope: MpScope,
    /// Whether imposed motions only hold their degrees of freedom.
    pub homogeneous: bool,
    /// OpenSees' slips are followed.
    pub compat: bool,
    /// Force a dense matrix, or a sparse one.
    pub dense: Option<bool>,
}

impl Workspace {
    /// Prepare for a model.
    ///
    /// # Errors
    /// Constraints that make no sense, or too little memory.
    pub fn new(model: &Model, options: &PrepareOptions) -> Result<Self, Cause> {
        let plan = Plan::new(model, options.handler, options.scope, options.homogeneous, options.dense)
            .map_err(|e: DofError| Cause::Model(e.message(model)))?;
        let solver = Solver::new(&plan.pattern, plan.multipliers > 0).map_err(|e| match e {
            SolveError::OutOfMemory => Cause::OutOfMemory,
            SolveError::Singular { .. } => Cause::Singular,
        })?;
        let mut constrained = plan.map.held.clone();
        plan.map.dependents.iter().for_each(|d| constrained[d.dof] = true);
        let (mut at, mut motion, mut damping, mut mass, mut matrices) = (0, 0, 0, vec![], vec![]);
        for e in &model.elements {
            let n = e.dofs.len();
            let nature = e.element.traits();
            let place = match e.element.mass() {
                Mass::None => MassPlace::None,
                Mass::Lumped(m) => {
                    mass.extend(m);
                    MassPlace::Lumped(mass.len() - n)
                }
                Mass::Consistent(m) => {
                    mass.extend(m);
                    MassPlace::Consistent(mass.len() - n * n)
                }
            };
            let rayleigh = if nature.rayleigh { e.rayleigh } else { Rayleigh::default() };
            let reported = if nature.rayleigh || options.compat { e.rayleigh } else { Rayleigh::default() };
            let initial_is_current = e.element.initial_is_current();
            let [rayleigh, reported] =
                [rayleigh, reported].map(|r| if initial_is_current { r.with_current_for_initial() } else { r });
            let all = !rayleigh.is_zero() || !reported.is_zero();
            matrices.push(ElementWorkspace {
                at,
                motion,
                rows: Rows::of(e.dofs.iter().map(|&d| all || !plan.map.terms(d as usize).is_empty())),
                linear: nature.linear && !nature.viscous,
                rates: nature.viscous || nature.elapses,
                counts_calls: e.element.counts_calls(),
                constrained: e.dofs.iter().any(|&d| constrained[d as usize]),
                initial_is_current,
                keeps_committed: options.compat && !e.element.renews_damping(),
                damping: nature.viscous.then_some(damping),
                is_dynamic: !matches!(place, MassPlace::None) || !rayleigh.is_zero(),
                mass: place,
                rayleigh,
                in_tangent: if e.element.damps_in_forces_only() { Rayleigh::default() } else { rayleigh },
                reported,
            });
            at += n * n;
            motion += 2 * n;
            damping += if nature.viscous { n * n } else { 0 };
        }
        let nodal = model.nodes.iter().flat_map(|node| {
            node.dofs().zip(&node.mass).filter(|(_, m)| **m != 0.0).map(|(d, &m)| (d, m, node.alpha_m))
        });
        let (n, len) = (plan.equations(), plan.pattern.len());
        let mut prepared = Self {
            nodal: nodal.collect(),
            loads: Loads::new(model, &plan.map, options.compat),
            b: vec![0.0; n],
            x: vec![0.0; n],
            spread: vec![0.0; model.dofs()],
            last: None,
            last_mix: TangentMix::CURRENT,
            progress: (0, 1),
            two_end_residual: None,
            weak_pivot: None,
            element_calls: 0,
            full: vec![0.0; model.dofs()],
            values: vec![0.0; len],
            factored: vec![0.0; len],
            tangent: vec![0.0; at],
            damping: vec![0.0; damping],
            tangent_is_current: false,
            residual_needs_tangent: false,
            multiplies: false,
            compat: options.compat,
            counting: (0..matrices.len()).filter(|&i| matrices[i].counts_calls).collect(),
            asking: Asking::default(),
            updates: Calls::NONE,
            motions: vec![0.0; motion],
            asked_at: vec![0.0; model.dofs()],
            initial: vec![],
            committed: vec![],
            mass,
            base: vec![0.0; len],
            base_of: None,
            matrices,
            damped_modes: DampedModes::new(model, |full, own| plan.map.condense(full, own), plan.map.equations),
            plan,
            solver,
        };
        prepared.fill_matrices(model);
        Ok(prepared)
    }

    fn fill_matrices(&mut self, model: &Model) {
        let mut damped = Rayleigh::default();
        for (e, m) in model.elements.iter().zip(&self.matrices) {
            if m.linear {
                e.element.initial_tangent(&mut self.tangent[m.at..m.at + e.dofs.len().pow(2)]);
            } else {
                damped.beta_k += m.rayleigh.beta_k.abs();
                damped.beta_k0 += m.reported.beta_k0.abs();
                damped.beta_kc += m.reported.beta_kc.abs();
            }
        }
        if damped.beta_k0 != 0.0 {
            self.fill_initial(model);
        }
        if damped.beta_kc != 0.0 {
            self.committed = vec![0.0; self.tangent.len()];
        }
        self.residual_needs_tangent = damped.beta_k != 0.0;
    }

    fn fill_initial(&mut self, model: &Model) {
        if self.initial.is_empty() && !self.tangent.is_empty() {
            self.initial = vec![0.0; self.tangent.len()];
            for (e, m) in model.elements.iter().zip(&self.matrices) {
                e.element.initial_tangent(&mut self.initial[m.at..m.at + e.dofs.len().pow(2)]);
            }
        }
    }

    /// Forget tangents and factors, which are those of another state.
    pub(super) fn forget(&mut self) {
        self.tangent_is_current = false;
        self.solver.forget();
    }

    /// What is read of the matrices of an element.
    #[inline]
    pub(super) fn part(&self, m: &ElementWorkspace) -> MatrixMask {
        MatrixMask { rows: m.rows, columns: if self.multiplies { Rows::ALL } else { m.rows } }
    }

    /// Clear `spread` of imposed motions and of what followed them.
    #[inline]
    pub(super) fn clear_imposed(&mut self) {
        self.loads.imposed.iter().for_each(|i| self.spread[i.dof] = 0.0);
        self.plan.map.dependents.iter().for_each(|d| self.spread[d.dof] = 0.0);
    }

    /// Whether the damping needs the tangent of the committed state.
    #[inline]
    pub(super) fn wants_committed_tangent(&self) -> bool {
        !self.committed.is_empty()
    }

    /// Take the current tangents for those of the committed state: all before the first step, then those that are taken anew.
    pub(super) fn commit_tangents(&mut self, first: bool) {
        if !first && self.matrices.iter().any(|m| m.keeps_committed) {
            let ends = self.matrices.iter().skip(1).map(|m| m.at).chain([self.tangent.len()]);
            for (m, end) in self.matrices.iter().zip(ends).filter(|(m, _)| !m.keeps_committed) {
                self.committed[m.at..end].copy_from_slice(&self.tangent[m.at..end]);
            }
        } else {
            self.committed.copy_from_slice(&self.tangent);
        }
        self.base_of = None;
    }

    /// Remember a pivot that is nearly zero.
    pub(super) fn note_pivot(&mut self, p: Pivots) {
        if p.ratio <= NEARLY_SINGULAR && self.plan.handler.eliminates() && self.weak_pivot.is_none() {
            self.weak_pivot = Some(p);
        }
    }

    /// Assemble the tangent into `values`. What does not change from iteration to iteration is kept.
    pub(super) fn assemble(&mut self, model: &Model, c: Coefficients, mix: TangentMix) {
        if mix.initial != 0.0 {
            self.fill_initial(model);
        }
        if self.base_of != Some((c, mix)) {
            self.assemble_base(model, c, mix);
            self.base_of = Some((c, mix));
        }
        self.values.copy_from_slice(&self.base);
        for (i, (e, m)) in model.elements.iter().zip(&self.matrices).enumerate().filter(|(_, (_, m))| !m.linear) {
            let range = m.at..m.at + e.dofs.len().pow(2);
            let mix = match m.initial_is_current {
                true => TangentMix { current: mix.current + mix.initial, initial: 0.0 },
                false => mix,
            };
            let current = c.k * mix.current + c.c * m.in_tangent.beta_k;
            if current != 0.0 {
                self.plan.add_element(i, &self.tangent[range.clone()], current, &mut self.values);
            }
            let initial = c.k * mix.initial + c.c * m.in_tangent.beta_k0;
            if initial != 0.0 {
                self.plan.add_element(i, &self.initial[range.clone()], initial, &mut self.values);
            }
            if m.in_tangent.beta_kc != 0.0 && c.c != 0.0 {
                let factor = c.c * m.in_tangent.beta_kc;
                self.plan.add_element(i, &self.committed[range.clone()], factor, &mut self.values);
            }
            if let Some(at) = m.damping.filter(|_| c.c != 0.0) {
                self.plan.add_element(i, &self.damping[at..at + range.len()], c.c, &mut self.values);
            }
        }
    }

    fn assemble_base(&mut self, model: &Model, c: Coefficients, mix: TangentMix) {
        self.base.fill(0.0);
        let mut diagonal = [0.0; MAX_DOFS * MAX_DOFS];
        for (i, (e, m)) in model.elements.iter().zip(&self.matrices).enumerate() {
            let n = e.dofs.len();
            if m.linear {
                let r = &m.in_tangent;
                let factor = c.k * (mix.current + mix.initial) + c.c * (r.beta_k + r.beta_k0 + r.beta_kc);
                self.plan.add_element(i, &self.tangent[m.at..m.at + n * n], factor, &mut self.base);
            }
            let factor = c.m + c.c * m.in_tangent.alpha_m;
            if factor == 0.0 {
                continue;
            }
            match m.mass {
                MassPlace::None => {}
                MassPlace::Lumped(at) => {
                    diagonal[..n * n].fill(0.0);
                    for (k, mass) in self.mass[at..at + n].iter().enumerate() {
                        diagonal[k * n + k] = *mass;
                    }
                    self.plan.add_element(i, &diagonal[..n * n], factor, &mut self.base);
                }
                MassPlace::Consistent(at) => {
                    self.plan.add_element(i, &self.mass[at..at + n * n], factor, &mut self.base);
                }
            }
        }
        for &(dof, mass, alpha_m) in &self.nodal {
            self.plan.add_diagonal(dof, (c.m + c.c * alpha_m) * mass, &mut self.base);
        }
        self.plan.add_links(if c.k == 0.0 { 0.0 } else { 1.0 }, &mut self.base);
    }

    /// Stiffness of the elements, of the mix of the last tangent, times displacements of all degrees of freedom.
    pub(super) fn stiffness_times(&mut self, model: &Model, disp: &[f64], out: &mut [f64]) {
        self.full.fill(0.0);
        for (e, m) in model.elements.iter().zip(&self.matrices) {
            let n = e.dofs.len();
            let range = m.at..m.at + n * n;
            let initial = self.last_mix.initial != 0.0 && !m.linear && !m.initial_is_current;
            let k = if initial { &self.initial[range] } else { &self.tangent[range] };
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

//! Data of an analysis between two changes of the model: plan, factors, matrices of the elements, buffers.

mod constant_parts;
mod forces;
mod led;
mod steady;
mod step_tangents;
mod tangent;

use super::bounds::Bounds;
use super::failure::Cause;
use super::loads::Loads;
use super::modal_damping::DampedModes;
use super::opensees::{Stage, TransformedNodes, UpdateCounts};
use super::small_beams::SmallBeams;
use super::system::{Coefficients, are_worth_threads};
use super::two_end_residual::TwoEndResidual;
use crate::assembly::{DofError, Handler, MpScope, Plan};
use crate::element::{Mass, MatrixMask, OpenSeesTraits, Rows};
use crate::model::{Model, Rayleigh};
use crate::solve::{NEARLY_SINGULAR, Pivots, SolveError, Solver, Threads};
pub(super) use constant_parts::ConstantParts;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
pub(super) use steady::{MatrixRows, SteadyMatrices};
use step_tangents::StepTangents;

/// Stiffness in the tangent.
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

/// Places of the matrices of an element, and their factors.
#[derive(Clone, Debug)]
pub(super) struct ElementWorkspace {
    /// Place of the tangent.
    pub at: usize,
    /// Place of the motion of the last evaluation.
    pub motion: usize,
    /// The tangent never changes, and there is no damping matrix.
    pub linear: bool,
    /// Only the geometric stiffness of its axial force changes, and no damping keeps that of the committed state.
    p_delta: bool,
    /// The force depends on velocities or on the time that passes.
    pub rates: bool,
    /// The force depends on the number of calls.
    pub counts_calls: bool,
    /// The history holds the tangent of the motion that it belongs to.
    pub keeps_tangent: bool,
    /// The current tangent replaces the initial one.
    initial_is_current: bool,
    /// The tangent stands for mass and damping too.
    stiffness_as_mass: bool,
    /// The committed tangent stays that of the first step.
    keeps_committed: bool,
    /// Place of the damping matrix of viscous materials.
    pub damping: Option<usize>,
    /// Rows of the matrices that are read: those of degrees of freedom in the equations. With Rayleigh damping these are all
    /// rows, for its forces.
    pub rows: Rows,
    mass: MassPlace,
    /// Place of the inertance among the masses.
    pub inertance: Option<usize>,
    /// Inertia or damping forces come with its motion.
    is_dynamic: bool,
    rayleigh: RayleighFactors,
}

impl ElementWorkspace {
    /// Shares of its current and initial tangent.
    fn mix(&self, mix: TangentMix) -> TangentMix {
        if !self.initial_is_current {
            return mix;
        }
        TangentMix { current: mix.current + mix.initial, initial: 0.0 }
    }
}

/// Factors of Rayleigh damping of an element.
#[derive(Clone, Debug)]
struct RayleighFactors {
    /// In the unbalance.
    forces: Rayleigh,
    /// In the tangent: OpenSees leaves them out of the tangent of some elements.
    tangent: Rayleigh,
    /// In reports of damping forces: OpenSees includes elements that take no part in the damping.
    reported: Rayleigh,
}

#[derive(Clone, Debug)]
enum MassPlace {
    None,
    Lumped(usize),
    Consistent(usize),
}

/// ElementWorkspace of all elements, one after the other.
#[derive(Debug, Default)]
pub(super) struct ElementMatrices {
    /// Places and factors by element.
    pub entries: Vec<ElementWorkspace>,
    /// Tangents of the last evaluation.
    pub tangent: Vec<f64>,
    /// Damping matrices of viscous materials.
    pub damping: Vec<f64>,
    /// Tangents of the virgin elements; empty until they are used.
    initial: Vec<f64>,
    /// Tangents of the committed state; empty unless Rayleigh damping uses them.
    committed: Vec<f64>,
    at_start: StepTangents,
    /// Axial forces of the beams of [`SmallBeams::p_delta`] in the tangents.
    pub axial: Vec<f64>,
    mass: Vec<f64>,
    /// Elements whose tangents are evaluated anew at the end of a step, and room for their trial states.
    renewed: (Vec<usize>, Vec<f64>),
    /// The tangents are those of the trial state.
    pub is_current: bool,
    /// A step with this plan has ended, and nothing has changed the state since: elements that keep their tangent in the
    /// history may give it.
    pub has_stepped: bool,
    /// Damping forces use the current tangents.
    pub residual_needs_tangent: bool,
    /// The integrator multiplies the tangents with displacements of its own, so that all columns are read.
    pub multiplies: bool,
    /// Some elements depend on the velocities of their nodes.
    pub sees_velocity: bool,
}

/// The tangent of the equations.
#[derive(Debug)]
pub(super) struct EquationMatrix {
    /// Entries in the order of the pattern.
    pub values: Vec<f64>,
    /// Entries that have been factored.
    pub factored: Vec<f64>,
    /// Shares of stiffness, damping and mass in the last tangent that was formed.
    pub coefficients: Option<Coefficients>,
    /// Stiffness in the last tangent that was formed.
    pub mix: TangentMix,
    /// Smallest pivot so far, where it was nearly zero.
    pub weak_pivot: Option<Pivots>,
    /// The last tangent was singular: its factors have a share of the initial stiffness.
    pub plateau: bool,
    /// Right-hand side, where the solution may have to be repeated.
    pub right_side: Vec<f64>,
    /// Entries of mass, constraints and linear elements, which stay from iteration to iteration.
    base: Vec<f64>,
    /// Shares that `base` belongs to.
    base_of: Option<(Coefficients, TangentMix)>,
}

impl EquationMatrix {
    fn new(entries: usize, equations: usize) -> Self {
        Self {
            plateau: false,
            right_side: vec![0.0; equations],
            values: vec![0.0; entries],
            factored: vec![0.0; entries],
            coefficients: None,
            mix: TangentMix::CURRENT,
            weak_pivot: None,
            base: vec![0.0; entries],
            base_of: None,
        }
    }
}

/// Motion of the last evaluation of the elements.
#[derive(Debug)]
pub(super) struct EvaluatedMotion {
    /// Displacements and then velocities of each element, element after element.
    pub elements: Vec<f64>,
    /// Displacements of all degrees of freedom.
    pub disp: Vec<f64>,
    /// State determinations of elements so far.
    pub calls: u64,
}

/// Data and buffers of an analysis between two changes of the model.
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
    /// Forces on all degrees of freedom.
    pub(super) full: Vec<f64>,
    pub(super) matrix: EquationMatrix,
    pub(super) elements: ElementMatrices,
    /// Beams that are evaluated side by side.
    pub(super) small_beams: SmallBeams,
    pub(super) evaluated: EvaluatedMotion,
    /// Iterations of the step so far, and the largest number that the test allows.
    pub(super) progress: (usize, usize),
    /// Unbalance over both ends of a step, for integrators that use it.
    pub(super) two_end_residual: Option<TwoEndResidual>,
    pub(super) damped_modes: DampedModes,
    /// Number of updates of the elements, under `--compat opensees` only.
    pub(super) opensees: Option<UpdateCounts>,
    /// Constrained nodes as OpenSees moves them, under `--compat opensees` only.
    pub(super) transformed: Option<Box<TransformedNodes>>,
    /// Set to stop before the next iteration.
    pub(super) interrupt: Option<Arc<AtomicBool>>,
    /// Lumped masses of the nodes: degree of freedom, mass, mass-proportional damping.
    nodal: Vec<(usize, f64, f64)>,
    /// Degrees of freedom that constraints in the equations let follow imposed ones alone, with what they follow.
    pub(super) followers: Vec<(usize, Vec<(usize, f64)>)>,
    /// Degrees of freedom whose velocity is imposed; empty where there are none.
    pub(super) led: Vec<bool>,
    /// Limits of deformations and displacements that mean something.
    pub(super) bounds: Bounds,
    /// Damping and inertia that never change, once they are needed and found.
    steady: Option<Box<SteadyMatrices>>,
    looked_for_steady: bool,
    /// Threads that work on the elements, and whether these are worth it.
    pub(super) threads: Threads,
    many: bool,
}

/// Options of a [`Workspace`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PrepareOptions {
    /// Constraint handler.
    pub handler: Handler,
    /// Multi-point constraints that count.
    pub scope: MpScope,
    /// Imposed motions only hold their degrees of freedom.
    pub homogeneous: bool,
    /// The known errors of OpenSees are reproduced.
    pub compat: bool,
    /// Force a dense matrix, or a sparse one.
    pub dense: Option<bool>,
}

impl ElementMatrices {
    /// For a model, without entries yet but those of the masses; and the length of the motions of all elements.
    fn new(model: &Model, plan: &Plan, compat: bool) -> (Self, usize) {
        let (mut at, mut motion, mut damping) = (0, 0, 0);
        let mut matrices = Self::default();
        for e in &model.elements {
            let n = e.dofs.len();
            let traits = e.element.traits();
            let mass = matrices.add_mass(e.element.mass(), n);
            let inertance = e.element.inertance().map(|m| {
                matrices.mass.extend(m);
                matrices.mass.len() - n * n
            });
            matrices.sees_velocity |= traits.viscous || inertance.is_some();
            let opensees = e.element.opensees();
            // OpenSees evaluates every element anew.
            let kept = e.element.roles().kept_tangent;
            let (followed, kept) = if compat { (opensees, None) } else { (OpenSeesTraits::default(), kept) };
            let [forces, reported] = [traits.rayleigh, traits.rayleigh || compat].map(|damped| {
                let factors = if damped { e.rayleigh } else { Rayleigh::default() };
                if inertance.is_some() {
                    return Rayleigh { alpha_m: factors.alpha_m, ..Rayleigh::default() };
                }
                if opensees.initial_is_current { factors.with_current_for_initial() } else { factors }
            });
            let tangent = if opensees.damps_in_forces_only { Rayleigh::default() } else { forces };
            let all = !forces.is_zero() || !reported.is_zero();
            matrices.entries.push(ElementWorkspace {
                at,
                motion,
                rows: Rows::of(e.dofs.iter().map(|&d| all || !plan.map.terms(d as usize).is_empty())),
                linear: traits.linear && !traits.viscous,
                p_delta: tangent.beta_kc == 0.0 && e.element.small_beam().is_some_and(|b| b.p_delta.is_some()),
                rates: traits.viscous || traits.elapses,
                counts_calls: followed.calls.is_some(),
                keeps_tangent: kept.is_some(),
                initial_is_current: opensees.initial_is_current,
                stiffness_as_mass: followed.stiffness_as_mass,
                keeps_committed: followed.keeps_first_damping,
                damping: traits.viscous.then_some(damping),
                is_dynamic: !matches!(mass, MassPlace::None) || !forces.is_zero(),
                mass,
                inertance,
                rayleigh: RayleighFactors { forces, tangent, reported },
            });
            if e.element.roles().renews_tangent {
                let (elements, room) = &mut matrices.renewed;
                elements.push(matrices.entries.len() - 1);
                room.resize(room.len().max(e.state.len()), 0.0);
            }
            at += n * n;
            motion += 2 * n;
            damping += if traits.viscous { n * n } else { 0 };
        }
        (matrices.tangent, matrices.damping) = (vec![0.0; at], vec![0.0; damping]);
        (matrices, motion)
    }

    /// Add the mass of an element with n degrees of freedom.
    fn add_mass(&mut self, mass: Mass, n: usize) -> MassPlace {
        let at = self.mass.len();
        match mass {
            Mass::None => MassPlace::None,
            Mass::Lumped(m) => {
                debug_assert_eq!(m.len(), n);
                self.mass.extend(m);
                MassPlace::Lumped(at)
            }
            Mass::Consistent(m) => {
                debug_assert_eq!(m.len(), n * n);
                self.mass.extend(m);
                MassPlace::Consistent(at)
            }
        }
    }
}

impl Workspace {
    /// Prepare for a model.
    ///
    /// # Errors
    /// Constraints that make no sense, or too little memory.
    pub fn new(model: &Model, options: &PrepareOptions, threads: &Threads) -> Result<Self, Cause> {
        let plan = Plan::new(model, options.handler, options.scope, options.homogeneous, options.dense)
            .map_err(|e: DofError| Cause::Model(e.message(model)))?;
        let solver = Solver::new(&plan.pattern, plan.multipliers > 0, threads).map_err(|e| match e {
            SolveError::OutOfMemory => Cause::OutOfMemory,
            SolveError::Singular { .. } => Cause::Singular,
        })?;
        let mut constrained = plan.map.held.clone();
        plan.map.dependents.iter().for_each(|d| constrained[d.dof] = true);
        let (mut elements, motions) = ElementMatrices::new(model, &plan, options.compat);
        let small_beams = SmallBeams::new(model, &plan, |i| elements.entries[i].at);
        elements.axial = vec![0.0; small_beams.p_delta().count()];
        let many = are_worth_threads(model, &small_beams.others);
        let nodal = model.nodes.iter().flat_map(|node| {
            node.dofs().zip(&node.mass).filter(|(_, m)| **m != 0.0).map(|(d, &m)| (d, m, node.alpha_m))
        });
        let with_loads = !model.fixes.is_empty() || model.patterns.values().any(|p| !p.motions.is_empty());
        let transformed = TransformedNodes::new(&plan.map.transformed, with_loads, model.dofs());
        let (n, len) = (plan.equations(), plan.pattern.len());
        let mut workspace = Self {
            nodal: nodal.collect(),
            loads: Loads::new(model, &plan.map, options.compat),
            b: vec![0.0; n],
            x: vec![0.0; n],
            spread: vec![0.0; model.dofs()],
            full: vec![0.0; model.dofs()],
            matrix: EquationMatrix::new(len, n),
            small_beams,
            elements,
            evaluated: EvaluatedMotion { elements: vec![0.0; motions], disp: vec![0.0; model.dofs()], calls: 0 },
            progress: (0, 1),
            two_end_residual: None,
            damped_modes: DampedModes::new(model, |full, own| plan.map.condense(full, own), plan.map.equations),
            opensees: options.compat.then(|| UpdateCounts::new(model, &constrained)),
            transformed,
            interrupt: None,
            followers: vec![],
            led: vec![],
            bounds: Bounds::new(model),
            steady: None,
            looked_for_steady: false,
            threads: threads.clone(),
            many,
            plan,
            solver,
        };
        workspace.find_led();
        workspace.fill_matrices(model);
        Ok(workspace)
    }

    fn fill_matrices(&mut self, model: &Model) {
        let mut damped = Rayleigh::default();
        for (e, m) in model.elements.iter().zip(&self.elements.entries) {
            if m.linear {
                e.element.initial_tangent(&mut self.elements.tangent[m.at..m.at + e.dofs.len().pow(2)]);
            } else {
                damped.beta_k += m.rayleigh.forces.beta_k.abs();
                damped.beta_k0 += m.rayleigh.reported.beta_k0.abs();
                damped.beta_kc += m.rayleigh.reported.beta_kc.abs();
            }
        }
        if damped.beta_k0 != 0.0 {
            self.fill_initial(model);
        }
        if damped.beta_kc != 0.0 {
            self.elements.committed = vec![0.0; self.elements.tangent.len()];
        }
        self.elements.residual_needs_tangent = damped.beta_k != 0.0;
    }

    fn fill_initial(&mut self, model: &Model) {
        if self.elements.initial.is_empty() && !self.elements.tangent.is_empty() {
            self.elements.initial = vec![0.0; self.elements.tangent.len()];
            for (e, m) in model.elements.iter().zip(&self.elements.entries) {
                e.element.initial_tangent(&mut self.elements.initial[m.at..m.at + e.dofs.len().pow(2)]);
            }
        }
    }

    /// Forget tangents and factors, which are those of another state.
    pub(super) fn forget(&mut self) {
        self.elements.is_current = false;
        self.elements.has_stepped = false;
        self.solver.forget();
    }

    /// Set the updates that the next evaluation makes of elements that depend on their number.
    #[inline]
    pub(super) fn enter(&mut self, stage: Stage) {
        if let Some(counts) = &mut self.opensees {
            counts.enter(stage);
        }
    }

    /// Returns true if an element depends on the number of its updates.
    #[inline]
    pub(super) fn counts_updates(&self) -> bool {
        self.opensees.as_ref().is_some_and(|counts| !counts.elements.is_empty())
    }

    /// Returns true if the elements are evaluated on several threads.
    #[inline]
    pub(super) fn side_by_side(&self) -> bool {
        self.many && self.threads.are_several()
    }

    /// Rows and columns that are read of the matrices of an element.
    #[inline]
    pub(super) fn part(&self, m: &ElementWorkspace) -> MatrixMask {
        MatrixMask::read_of(m.rows, self.elements.multiplies)
    }

    /// Clear `spread` of imposed motions and of what followed them.
    #[inline]
    pub(super) fn clear_imposed(&mut self) {
        self.loads.imposed.iter().for_each(|i| self.spread[i.dof] = 0.0);
        self.plan.map.dependents.iter().for_each(|d| self.spread[d.dof] = 0.0);
    }

    /// Returns true if the damping needs the tangent of the committed state.
    #[inline]
    pub(super) fn wants_committed_tangent(&self) -> bool {
        !self.elements.committed.is_empty()
    }

    /// Take the current tangents for those of the committed state. Before the first step (`first`) these are all tangents; later
    /// they leave out elements that keep their first one.
    pub(super) fn commit_tangents(&mut self, first: bool) {
        if !first && self.elements.entries.iter().any(|m| m.keeps_committed) {
            let ends = self.elements.entries.iter().skip(1).map(|m| m.at).chain([self.elements.tangent.len()]);
            for (m, end) in self.elements.entries.iter().zip(ends).filter(|(m, _)| !m.keeps_committed) {
                self.elements.committed[m.at..end].copy_from_slice(&self.elements.tangent[m.at..end]);
            }
        } else {
            self.elements.committed.copy_from_slice(&self.elements.tangent);
        }
        self.matrix.base_of = None;
    }

    /// Keep a pivot that is nearly zero.
    pub(super) fn note_pivot(&mut self, p: Pivots) {
        if p.ratio <= NEARLY_SINGULAR && self.plan.handler.eliminates() && self.matrix.weak_pivot.is_none() {
            self.matrix.weak_pivot = Some(p);
        }
    }
}

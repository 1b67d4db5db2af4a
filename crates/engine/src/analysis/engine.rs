//! A model, its state, and the steps that advance it.

mod derivatives;
mod matrix_terms;
mod options;
mod rates;
mod stepping;

use super::algorithm::Algorithm;
use super::bounds::Excess;
use super::convergence::Test;
use super::failure::Failure;
use super::integrator::Integrator;
use super::opensees::Stage;
use super::state::{State, StepStart};
use super::system::System;
use super::work_counts::WorkCounts;
use super::workspace::{PrepareOptions, Workspace};
use crate::assembly::{Handler, MpScope};
use crate::element::{Element, OutsideRange, Overload, Snapshot, Softening};
use crate::model::{ElementEntry, ElementId, GroundMotion, Model, NodeId, Pattern, PatternKind, Tag};
pub use derivatives::Derivative;
use derivatives::Derivatives;
pub use matrix_terms::MatrixTerms;
pub use options::Options;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Kind of analysis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Equilibrium under loads.
    Static,
    /// Motion in time.
    Transient,
}

/// The parts of an analysis.
#[derive(Clone, Debug)]
pub struct Setup {
    /// Kind.
    pub kind: Kind,
    /// Constraint handler.
    pub handler: Handler,
    /// Solution algorithm.
    pub algorithm: Box<dyn Algorithm>,
    /// Integrator.
    pub integrator: Box<dyn Integrator>,
    /// Convergence test.
    pub test: Test,
    /// Terms of the matrix that OpenSees' system of equations holds.
    pub matrix_terms: MatrixTerms,
}

/// Receiver of committed steps.
pub trait Observer {
    /// A step has been committed.
    ///
    /// # Errors
    /// The observer cannot go on (a recorder that cannot write); this ends the analysis.
    fn committed(&mut self, engine: &mut Engine) -> Result<(), String>;

    /// Returns true to stop before the next step.
    fn interrupted(&self) -> bool {
        false
    }
}

/// An observer that does nothing.
pub struct Quiet;

impl Observer for Quiet {
    fn committed(&mut self, _: &mut Engine) -> Result<(), String> {
        Ok(())
    }
}

/// The largest unbalanced force left by a step that counted as converged.
#[derive(Clone, Debug, PartialEq)]
pub struct Imbalance {
    /// Domain time.
    pub time: f64,
    /// Largest unbalanced force over the largest force in the model, now or at an earlier step.
    pub ratio: f64,
    /// Its place in words.
    pub place: String,
    /// Steps so far that were out of balance by more than [`Imbalance::LIMIT`].
    pub steps: usize,
}

impl Imbalance {
    /// Unbalanced forces beyond this fraction of the largest force are reported.
    pub const LIMIT: f64 = 1e-2;
}

/// Results between steps that scripts ask for.
#[derive(Debug, Default)]
pub(super) struct Results {
    /// Modes of the last `eigen`.
    pub modes: Option<super::modes::Modes>,
    /// Buffer of the last `reactions`.
    pub reaction_words: Vec<f64>,
    /// Reactions that OpenSees keeps until they are asked for.
    pub kept_reactions: Vec<f64>,
}

/// A model, its state, and the steps that advance it.
#[derive(Debug)]
pub struct Engine {
    model: Model,
    committed: State,
    trial: State,
    pub(super) step_start: StepStart,
    /// Degrees of freedom whose velocity a static analysis imposed: it ends with the motion.
    pub(super) led: Vec<bool>,
    /// Elements that depend on velocities, and whether they have had one.
    speeds: rates::Speeds,
    /// The first response beyond what means something that was let pass.
    pub excess: Option<Excess>,
    setup: Option<Setup>,
    prepared: Option<(u64, PrepareOptions, Workspace)>,
    /// The parts of the analysis have not been prepared for the model yet.
    fresh: bool,
    /// Settings.
    pub options: Options,
    /// The worst step that counted as converged.
    pub imbalance: Option<Imbalance>,
    /// A force of an earlier step, which a force left over is compared with once the loads have gone.
    largest_force: f64,
    /// Number of steps committed.
    pub steps: u64,
    /// Number of iterations of all steps.
    pub iterations: u64,
    /// The last failure.
    pub failure: Option<Failure>,
    /// Constraint handler where no analysis is set up (for modes and reactions).
    pub default_handler: Handler,
    /// Set this, from any thread, to stop an analysis before its next iteration.
    pub interrupt: Option<Arc<AtomicBool>>,
    pub(super) results: Results,
    /// Work done with plans that have been dropped.
    pub(super) earlier_work: WorkCounts,
    derivatives: Derivatives,
    /// Grows with every change of the parts of the analysis.
    setup_revision: u64,
}

impl Engine {
    /// An engine without a model.
    pub fn new(options: Options) -> Self {
        Self {
            model: Model::new(),
            committed: State::default(),
            trial: State::default(),
            step_start: StepStart::default(),
            led: vec![],
            speeds: rates::Speeds::default(),
            excess: None,
            setup: None,
            prepared: None,
            fresh: true,
            options,
            imbalance: None,
            largest_force: 0.0,
            steps: 0,
            iterations: 0,
            failure: None,
            default_handler: Handler::Transformation,
            interrupt: None,
            results: Results::default(),
            earlier_work: WorkCounts::default(),
            derivatives: Derivatives::default(),
            setup_revision: 0,
        }
    }

    /// The model.
    pub fn model(&self) -> &Model {
        &self.model
    }
    /// The committed state.
    pub fn state(&self) -> &State {
        &self.committed
    }
    /// The parts of the analysis, if there is one.
    pub fn setup(&self) -> Option<&Setup> {
        self.setup.as_ref()
    }

    /// Forget model and analysis; settings and counts stay.
    pub fn wipe(&mut self) {
        let options = std::mem::take(&mut self.options);
        let imbalance = self.imbalance.take();
        self.drop_prepared();
        let (steps, iterations, earlier_work) = (self.steps, self.iterations, self.earlier_work);
        let interrupt = self.interrupt.take();
        let (speeds, excess) = (std::mem::take(&mut self.speeds), self.excess.take());
        *self = Self { imbalance, steps, iterations, earlier_work, interrupt, speeds, excess, ..Self::new(options) };
    }

    /// Forget the analysis.
    pub fn wipe_analysis(&mut self) {
        self.setup = None;
        self.drop_prepared();
    }

    /// Drop plan and factors; the work done with them still counts.
    fn drop_prepared(&mut self) {
        self.earlier_work = self.work_counts();
        self.prepared = None;
    }

    /// Take the parts of the analysis out, to set up another with them.
    pub fn take_setup(&mut self) -> Option<Setup> {
        self.setup.take()
    }

    /// Handler of the analysis, or the default one.
    pub(super) fn workspace(&self) -> Option<&Workspace> {
        self.prepared.as_ref().map(|(_, _, work)| work)
    }

    pub(super) fn handler(&self) -> Handler {
        self.setup.as_ref().map_or(self.default_handler, |s| s.handler)
    }

    /// Returns true if no step has been made since the analysis or the model was changed.
    pub(super) fn is_fresh(&self) -> bool {
        self.fresh
    }

    /// Set up an analysis.
    pub fn set_up(&mut self, setup: Setup) {
        self.setup = Some(setup);
        self.setup_revision += 1;
        self.fresh = true;
    }

    /// Change parts of the analysis.
    pub fn change_setup(&mut self, change: impl FnOnce(&mut Setup)) {
        if let Some(s) = &mut self.setup {
            change(s);
            self.setup_revision += 1;
            self.fresh = true;
        }
    }

    /// Change the model: constraints, loads, masses, damping. Nodes and elements have methods of their own.
    pub fn change_model<T>(&mut self, change: impl FnOnce(&mut Model) -> T) -> T {
        let result = change(&mut self.model);
        self.model.touch();
        self.grow();
        result
    }

    /// Room for what has been added. The trial state becomes the committed one where the changed model gets its plan.
    fn grow(&mut self) {
        self.committed.grow(&self.model);
        self.trial.grow(&self.model);
    }

    /// Add a node.
    pub fn add_node(&mut self, tag: Tag, coords: &[f64], ndf: usize) -> NodeId {
        let id = self.model.add_node(tag, coords, ndf);
        // The node takes no part in the modes that are known.
        for shape in self.results.modes.iter_mut().flat_map(|m| &mut m.shapes) {
            shape.resize(shape.len() + ndf, 0.0);
        }
        self.grow();
        id
    }

    /// Add an element.
    pub fn add_element(&mut self, tag: Tag, nodes: Vec<NodeId>, element: Arc<dyn Element>) -> ElementId {
        let id = self.model.add_element(tag, nodes, element);
        self.grow();
        id
    }

    /// Remove an element.
    pub fn remove_element(&mut self, id: ElementId) {
        self.rearrange(|m| m.remove_element(id));
    }

    /// Put other elements around or in the places of some, each between the same nodes. The state moves once for all.
    pub fn replace_elements(&mut self, elements: impl IntoIterator<Item = (ElementId, Arc<dyn Element>)>) {
        self.rearrange(|m| m.replace_elements(elements));
    }

    /// Remove a node.
    ///
    /// # Errors
    /// The tag of an element that it belongs to.
    pub fn remove_node(&mut self, id: NodeId) -> Result<(), Tag> {
        self.rearrange(|m| m.remove_node(id))
    }

    fn rearrange<T>(&mut self, change: impl FnOnce(&mut Model) -> T) -> T {
        self.stop_led(&[]);
        self.led.clear();
        let before = self.model.clone();
        let result = change(&mut self.model);
        self.committed = self.committed.rearranged(&before, &self.model);
        self.step_start.forget();
        self.trial.clone_from(&self.committed);
        result
    }

    /// Set the domain time.
    pub fn set_time(&mut self, time: f64) {
        self.adopt(|s, _| s.time = time);
    }

    /// Change the committed state by hand: displacements, velocities.
    pub fn change_state(&mut self, change: impl FnOnce(&mut State, &Model)) {
        self.step_start.forget();
        if !self.led.is_empty()
            && let Ok(work) = self.prepare(self.handler())
        {
            let led = work.led.clone();
            self.stop_led(&led);
        }
        self.adopt(change);
    }

    fn adopt(&mut self, change: impl FnOnce(&mut State, &Model)) {
        change(&mut self.committed, &self.model);
        if let Some((_, _, p)) = &mut self.prepared {
            // A state from before the preparation has no multipliers.
            self.committed.multipliers.resize(p.plan.multipliers, 0.0);
            p.loads.invalidate();
            p.motion_changed();
        }
        self.trial.clone_from(&self.committed);
    }

    /// The state, to be gone back to. What follows from here and what follows [`Engine::restore`] is the same to the
    /// bit: factors of earlier steps are forgotten both times, and nothing else is remembered. Derivatives begin anew.
    pub fn checkpoint(&mut self) -> State {
        self.forget_work();
        self.committed.clone()
    }

    /// Go back to a state that [`Engine::checkpoint`] gave.
    pub fn restore(&mut self, state: &State) {
        self.derivatives = Derivatives::default();
        self.change_state(|s, _| s.clone_from(state));
        self.forget_work();
        self.note_led();
    }

    /// Back to the undeformed, virgin model at time zero.
    pub fn reset(&mut self) {
        self.committed = State::default();
        self.derivatives = Derivatives::default();
        self.led.clear();
        self.step_start.forget();
        self.committed.grow(&self.model);
        self.trial.clone_from(&self.committed);
        self.fresh = true;
        self.drop_prepared();
    }

    /// Data of the committed state from which a recorder reads the responses of an element.
    pub fn snapshot<'a>(&'a self, id: ElementId, disp: &'a mut Vec<f64>) -> Snapshot<'a> {
        let e = &self.model.elements[id.0];
        disp.clear();
        disp.extend(e.dofs.iter().map(|&d| self.committed.disp[d as usize]));
        Snapshot {
            disp,
            state: &self.committed.history[e.state.clone()],
            force: &self.committed.force[e.force.clone()],
            load: &self.committed.element_load[e.load.clone()],
        }
    }

    /// The first element that does not carry its axial load in the committed state, and that load.
    pub fn overload(&self) -> Option<(&ElementEntry, Overload)> {
        let of = |e: &ElementEntry| e.element.overload(&self.committed.history[e.state.clone()]);
        self.model.elements.iter().find_map(|e| of(e).map(|load| (e, load)))
    }

    /// Tags of the elements that left the range of their law, with the steps up to the committed state.
    pub fn outside_range(&self) -> Vec<(i32, OutsideRange)> {
        let of = |e: &ElementEntry| Some((e.tag, e.element.outside_range(&self.committed.history[e.state.clone()])?));
        self.model.elements.iter().filter_map(of).collect()
    }

    /// The ends of the backbone of an element that softens, and its committed deformation.
    pub fn softening(&self, id: ElementId) -> Option<Softening> {
        let e = &self.model.elements[id.0];
        e.element.softening(&self.committed.history[e.state.clone()])
    }

    /// The resisting force of an element in the committed state as recorders show it, added to `out`.
    #[inline]
    pub fn element_force(&self, id: ElementId, out: &mut Vec<f64>) {
        let e = &self.model.elements[id.0];
        let start = out.len();
        out.extend_from_slice(&self.committed.force[e.force.clone()]);
        if let Some(damping) = e.element.roles().own_damping {
            let mut disp = vec![];
            damping.add_own_damping(&self.snapshot(id, &mut disp), -1.0, &mut out[start..]);
        }
        if let Some((_, _, work)) = &self.prepared {
            work.loads.report(id, &mut out[start..]);
        }
    }

    #[inline]
    fn prepare_options(&self, handler: Handler) -> PrepareOptions {
        let compat = self.options.compat;
        let scope = match handler {
            Handler::Transformation if compat => MpScope::FirstOfNode,
            Handler::Plain if compat => MpScope::Identities,
            _ => MpScope::All,
        };
        PrepareOptions {
            handler,
            scope,
            homogeneous: compat && handler == Handler::Plain,
            compat,
            dense: self.options.dense,
        }
    }

    /// Returns true if there is a plan for the model as it is. Every step calls it, so that nothing else is worked out that
    /// follows from the handler and the options.
    #[inline]
    fn is_prepared(&self, handler: &Handler) -> bool {
        let Options { compat, dense, .. } = &self.options;
        let matches_options = |o: &PrepareOptions| o.handler == *handler && o.compat == *compat && o.dense == *dense;
        matches!(&self.prepared, Some((revision, o, _)) if *revision == self.model.revision() && matches_options(o))
    }

    /// Make sure that there is a plan for the model as it is.
    #[inline]
    pub(super) fn prepare(&mut self, handler: Handler) -> Result<&mut Workspace, Failure> {
        if !self.is_prepared(&handler) {
            self.prepare_anew(self.prepare_options(handler))?;
        }
        match &mut self.prepared {
            Some((_, _, p)) => Ok(p),
            None => unreachable!("made above"),
        }
    }

    #[cold]
    fn prepare_anew(&mut self, options: PrepareOptions) -> Result<(), Failure> {
        let time = self.committed.time;
        let mut prepared = Workspace::new(&self.model, &options, &self.options.threads)
            .map_err(|cause| Failure::new(cause, time, -1))?;
        prepared.interrupt.clone_from(&self.interrupt);
        let multipliers = prepared.plan.multipliers;
        self.committed.multipliers.resize(multipliers, 0.0);
        self.stop_led(&prepared.led);
        self.speeds.prepare(&self.model);
        self.trial.clone_from(&self.committed);
        self.drop_prepared();
        self.prepared = Some((self.model.revision(), options, prepared));
        self.fresh = true;
        Ok(())
    }

    /// Time of the last given value of the excitations that go on, where there are any.
    pub fn excitation_end(&self) -> Option<f64> {
        let going = self.model.patterns.values().filter(|p| p.held.is_none());
        let end = |p: &Pattern| match &p.kind {
            PatternKind::Plain { series, .. } => series.end(),
            PatternKind::Uniform(e) => e.accel.end(),
            PatternKind::MultipleSupport(all) => all.values().filter_map(GroundMotion::end).max_by(f64::total_cmp),
        };
        going.filter_map(end).max_by(f64::total_cmp)
    }

    /// The smallest pivot that was nearly zero: where it was, and the fraction of the stiffness that was left.
    pub fn weak_pivot(&self) -> Option<(String, f64)> {
        let (_, _, work) = self.prepared.as_ref()?;
        let p = work.matrix.weak_pivot?;
        Some((work.plan.equation_name(&self.model, p.equation), p.ratio))
    }

    /// The plan and the factors, where there are any.
    pub fn prepared(&self) -> Option<&Workspace> {
        self.prepared.as_ref().map(|(_, _, p)| p)
    }

    /// Model, committed state and work, borrowed apart.
    pub(super) fn parts(&mut self) -> (&Model, &State, Option<&mut Workspace>) {
        (&self.model, &self.committed, self.prepared.as_mut().map(|(_, _, p)| p))
    }

    /// The equations at the committed state, outside of a step.
    pub(super) fn system(&mut self) -> Option<System<'_>> {
        let (_, _, work) = self.prepared.as_mut()?;
        work.enter(Stage::Outside);
        Some(System::new(&self.model, &self.committed, &mut self.trial, work))
    }
}

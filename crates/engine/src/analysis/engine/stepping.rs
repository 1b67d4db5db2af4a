//! Steps of an analysis.

use super::{Engine, Imbalance, Kind, MatrixTerms, Observer, Setup};
use crate::analysis::algorithm::Iteration;
use crate::analysis::failure::Cause;
use crate::analysis::failure::Failure;
use crate::analysis::integrator::Adaptive;
use crate::analysis::opensees::{Parts, Phase, Stage};
use crate::analysis::system::System;
use crate::analysis::workspace::TangentMix;
use crate::model::Model;
use crate::numeric::largest;
use crate::solve::Use;

impl Engine {
    /// Make `steps` steps of length `dt` (which a static analysis takes from its integrator). What is committed stays
    /// committed when a step fails.
    ///
    /// # Errors
    /// Why a step failed.
    pub fn analyze(&mut self, steps: usize, dt: f64, observer: &mut dyn Observer) -> Result<(), Failure> {
        for _ in 0..steps {
            if observer.interrupted() {
                let cause = Cause::Interrupted;
                return Err(Failure::new(cause, self.committed.time, -3));
            }
            let length = self.length(dt);
            let done = match self.step_in_parts(length) {
                Err(failure) if self.options.ladder.is_some() => self.recover(length, failure, observer),
                done => done,
            };
            if let Err(failure) = done {
                self.failure = Some(failure.clone());
                return Err(failure);
            }
            self.steps += 1;
            self.step_derivatives(length);
            if let Err(message) = observer.committed(self) {
                let cause = Cause::Model(message);
                return Err(Failure::new(cause, self.committed.time, -4));
            }
        }
        Ok(())
    }

    /// Steps of a length that follows the iterations of the last one, until the time that `steps` steps of `dt` take has
    /// passed. A step that fails is made again with a shorter one, down to the smallest.
    ///
    /// # Errors
    /// Why the smallest step failed.
    pub fn analyze_variable(
        &mut self,
        steps: usize,
        dt: f64,
        lengths: Adaptive,
        observer: &mut dyn Observer,
    ) -> Result<(), Failure> {
        let total = steps as f64 * dt;
        let (mut gone, mut now) = (0.0, dt);
        while gone < total {
            let before = self.steps;
            let done = self.analyze(1, now, observer);
            let iterations = self.setup.as_ref().map_or(1, |s| s.test.iteration);
            match done {
                Ok(()) => {
                    gone += now;
                    now = lengths.next(now, iterations);
                }
                Err(f) if self.steps > before || now <= lengths.min || f.cause == Cause::Interrupted => return Err(f),
                Err(_) => {
                    self.failure = None;
                    now = lengths.shorter(now, iterations);
                }
            }
        }
        Ok(())
    }

    /// Impose displacements on the degrees of freedom and commit what the elements make of them. The time stays, and nothing
    /// is balanced.
    ///
    /// # Errors
    /// The model has no plan, or an element has no response.
    pub fn impose(&mut self, change: impl FnOnce(&mut [f64], &Model)) -> Result<(), Failure> {
        let handler = self.handler();
        self.prepare(handler)?;
        change(&mut self.trial.disp, &self.model);
        let Some(mut system) = self.system() else { unreachable!("prepared above") };
        system.work.enter(Stage::End);
        let done = system.respond(false);
        system.work.loads.invalidate();
        self.step_start.forget();
        match done {
            Ok(()) => self.committed.commit(&self.trial, &self.model, false),
            Err(_) => self.trial.copy_from(&self.committed),
        }
        done
    }

    /// Begin a step and form its equations, to find what is wrong with them, and let the prediction stand for `steps`
    /// steps: what [`Engine::analyze`] would do to the time and to controlled displacements.
    ///
    /// # Errors
    /// Why no step can be made.
    pub fn rehearse(&mut self, steps: usize, dt: f64) -> Result<(), Failure> {
        let handler = self.handler();
        self.prepare(handler)?;
        let length = self.length(dt);
        let (Some(setup), Some((_, _, work))) = (&mut self.setup, &mut self.prepared) else { return Ok(()) };
        let mut system = System {
            dynamic: setup.kind == Kind::Transient,
            elapses: setup.integrator.elapses(),
            moved: false,
            ..System::new(&self.model, &self.committed, &mut self.trial, work)
        };
        if self.fresh {
            prepare(&mut system, setup)?;
            self.fresh = false;
        }
        setup.integrator.begin(&mut system, length)?;
        system.form_unbalance(true)?;
        system.form_tangent(TangentMix::CURRENT, Use::Often)?;
        system.work.loads.invalidate();
        let (transient, elapses) = (system.dynamic, system.elapses);
        let work = &*system.work;
        self.speeds.note(&self.model, |i| work.may_move(&self.model, i, transient, elapses));
        let n = steps as f64;
        let old = &mut self.committed;
        old.time += n * if setup.kind == Kind::Static { self.trial.time - old.time } else { dt };
        for (u, trial) in old.disp.iter_mut().zip(&self.trial.disp) {
            *u += n * (trial - *u);
        }
        self.trial.copy_from(&self.committed);
        Ok(())
    }

    /// Length of a step, as integrators are given it: of time, or as a part of their own step where they are static.
    #[inline]
    fn length(&self, dt: f64) -> f64 {
        if self.setup.as_ref().is_some_and(|s| s.kind == Kind::Static) { 1.0 } else { dt }
    }

    /// One step of the script, in the number of parts of [`Options::refine`](super::Options) where it can be divided.
    #[inline]
    pub(in crate::analysis) fn step_in_parts(&mut self, length: f64) -> Result<(), Failure> {
        let divides = self.setup.as_ref().is_some_and(|s| s.integrator.divides());
        match self.options.refine {
            parts @ 2.. if divides => self.in_parts(length, parts),
            _ => self.step(length),
        }
    }

    /// One step in so many parts; commits all of them, or leaves the committed state as it was.
    pub(in crate::analysis) fn in_parts(&mut self, length: f64, parts: u32) -> Result<(), Failure> {
        let start = self.committed.clone();
        for _ in 0..parts {
            if let Err(failure) = self.step(length / f64::from(parts)) {
                self.change_state(|s, _| s.revert_to(&start));
                return Err(failure);
            }
        }
        Ok(())
    }

    /// One step of a [`length`](Engine::length); commits it or leaves the committed state as it was.
    pub(in crate::analysis) fn step(&mut self, length: f64) -> Result<(), Failure> {
        let Some(setup) = &self.setup else {
            let cause = Cause::Model("there is no analysis: the command \"analysis\" is missing".into());
            return Err(Failure::new(cause, self.committed.time, -1));
        };
        if !self.is_prepared(&setup.handler) {
            self.prepare(setup.handler)?;
        }
        let (Some(setup), Some((_, _, work))) = (&mut self.setup, &mut self.prepared) else {
            unreachable!("prepared above")
        };
        let still = setup.kind == Kind::Static && work.stands_still(&self.committed.vel);
        let mut system = System {
            dynamic: setup.kind == Kind::Transient,
            elapses: setup.integrator.elapses(),
            moved: false,
            still,
            ..System::new(&self.model, &self.committed, &mut self.trial, work)
        };
        setup.test.tightened = self.options.refine > 1;
        system.work.elements.keep_start();
        let result = advance(&mut system, setup, self.fresh, length);
        let result = result.and_then(|iterations| {
            let Some(excess) = system.work.excess(&self.model, system.new, system.dynamic) else {
                return Ok(iterations);
            };
            let is_let_pass = self.options.compat;
            if excess.is_refused && !is_let_pass {
                return Err(excess.failure(system.new.time));
            }
            self.excess.get_or_insert(excess);
            Ok(iterations)
        });
        system.leave_phases(result.is_err());
        match result {
            Ok(iterations) => {
                self.fresh = false;
                self.iterations += iterations as u64;
                if setup.integrator.balances() {
                    note_imbalance(&system, &mut self.imbalance, &mut self.largest_force);
                }
                let keeps_rates = system.still && !system.work.loads.moves;
                let duration = if system.elapses { system.new.time - system.old.time } else { 0.0 };
                self.step_start.keep(&mut self.committed, duration);
                self.committed.commit(&self.trial, &self.model, keeps_rates);
                match setup.kind {
                    Kind::Static if self.led != work.led => self.led.clone_from(&work.led),
                    Kind::Static => {}
                    Kind::Transient => self.led.clear(),
                }
                self.speeds.note_step(&self.model, &self.committed);
                work.renew_tangents(&self.model, &self.committed);
                work.elements.has_stepped = true;
                Ok(())
            }
            Err(mut failure) => {
                if setup.kind == Kind::Static {
                    failure.exhausted = system.exhausted();
                }
                system.work.loads.invalidate();
                system.work.elements.revert_to_start();
                self.committed.shared.copy_from_slice(&self.trial.shared);
                self.trial.copy_from(&self.committed);
                Err(failure)
            }
        }
    }
}

/// Make integrator and algorithm ready for a model, or an integrator, that is new.
fn prepare(system: &mut System<'_>, setup: &mut Setup) -> Result<(), Failure> {
    system.work.two_end_residual = None;
    system.work.elements.multiplies = setup.integrator.multiplies_tangents();
    setup.integrator.prepare(system)?;
    setup.algorithm.prepare(system);
    Ok(())
}

/// Begin, solve and end a step.
fn advance(system: &mut System<'_>, setup: &mut Setup, fresh: bool, length: f64) -> Result<usize, Failure> {
    if let Some(counts) = &mut system.work.opensees {
        counts.set_schedule(setup.kind, setup.integrator.name(), setup.handler);
    }
    if fresh {
        system.work.enter(Stage::Preparation);
        system.enter_phase(Phase::Preparation);
        prepare(system, setup)?;
        system.work.enter(Stage::Outside);
        system.work.elements.is_current = false;
        if system.work.wants_committed_tangent() {
            system.respond(true)?;
            system.work.commit_tangents(true);
        }
    }
    system.enter_phase(Phase::Begin(begin_parts(system, setup)?));
    setup.integrator.begin(system, length)?;
    system.work.enter(Stage::Begin);
    let mut iteration = Iteration { system, integrator: setup.integrator.as_mut(), test: &mut setup.test };
    let iterations = setup.algorithm.solve(&mut iteration)?;
    system.work.enter(Stage::End);
    system.enter_phase(Phase::End);
    setup.integrator.commit(system, iterations).map_err(|f| f.with_code(-4))?;
    system.work.enter(Stage::Outside);
    if system.work.wants_committed_tangent() {
        if !system.work.elements.is_current {
            system.respond(true)?;
        }
        system.work.commit_tangents(false);
    }
    Ok(iterations)
}

/// Parts of the motion that OpenSees sets when a step begins.
///
/// # Errors
/// Constrained nodes are moved late, and how the integrator moves them, or how they go on after a failed step, is not known. Or OpenSees makes one correction with a
/// matrix that drops terms of the mass, and which ones depends on its numbering.
fn begin_parts(system: &System<'_>, setup: &Setup) -> Result<Parts, Failure> {
    let Some(nodes) = system.work.transformed.as_ref() else { return Ok([false; 3]) };
    let refuse = |message| Err(system.failure(Cause::Model(message)));
    let loses_terms = system.dynamic && setup.matrix_terms != MatrixTerms::All && !setup.algorithm.iterates();
    if let Some(dof) = nodes.first_joined_alone().filter(|_| loses_terms) {
        return refuse(format!(
            "--compat opensees does not follow algorithm {} here: the mass at {} joins degrees of freedom that no element joins, and \
             OpenSees drops such terms in every system but FullGeneral; use algorithm Newton or system FullGeneral",
            setup.algorithm.name(),
            system.model.dof_name(dof)
        ));
    }
    if let Some(dof) = nodes.first_astray().filter(|_| system.dynamic) {
        return refuse(format!(
            "--compat opensees does not follow constraints Transformation after a step that has failed, where a node follows one that \
             is constrained or held itself, as {} does",
            system.model.dof_name(dof)
        ));
    }
    match (setup.integrator.opensees_begin(), nodes.first_late()) {
        (Some(parts), _) => Ok(parts),
        (None, None) => Ok([false; 3]),
        (None, Some(dof)) => refuse(format!(
            "--compat opensees does not follow integrator {} with constraints Transformation where a node follows one that is \
             constrained or held itself, as {} does",
            setup.integrator.name(),
            system.model.dof_name(dof)
        )),
    }
}

/// Keep the imbalance of a step that counted as converged though forces were left over.
#[inline]
fn note_imbalance(system: &System<'_>, worst: &mut Option<Imbalance>, largest_force: &mut f64) {
    let unbalanced = largest(&system.work.b);
    // Mostly one of the first forces is large enough to show that there is nothing to report.
    let dwarfs = |f: &&f64| Imbalance::LIMIT * f.abs() >= unbalanced;
    if unbalanced == 0.0 {
        return;
    }
    match system.new.force.iter().find(dwarfs).or_else(|| system.work.loads.nodal.iter().find(dwarfs)) {
        Some(force) => *largest_force = largest_force.max(force.abs()),
        None => measure_imbalance(system, unbalanced, worst, *largest_force),
    }
}

#[cold]
fn measure_imbalance(system: &System<'_>, unbalanced: f64, worst: &mut Option<Imbalance>, earlier: f64) {
    let force = largest(&system.new.force).max(largest(&system.work.loads.nodal)).max(earlier);
    let ratio = unbalanced / force;
    if ratio > Imbalance::LIMIT {
        let steps = worst.as_ref().map_or(0, |w| w.steps) + 1;
        match worst {
            Some(w) if w.ratio >= ratio => w.steps = steps,
            _ => {
                let place = system.worst(&system.work.b).unwrap_or_default();
                *worst = Some(Imbalance { time: system.new.time, ratio, place, steps });
            }
        }
    }
}

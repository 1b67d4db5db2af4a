//! Evaluation of the elements: none is evaluated twice at the same motion.

use super::element_call::{Call, Nodes, Places};
use super::{Cause, Failure, System};
use crate::analysis::opensees::{CountedElement, Updates};
use crate::analysis::workspace::ElementWorkspace;
use crate::element::{ElementError, Histories, OpenSeesCall};
use crate::model::ElementEntry;
use std::cell::Cell;
use std::sync::atomic::Ordering;

/// Displacements that differ by no more than this fraction differ by the round-off of a correction.
pub(in crate::analysis) const ROUND_OFF: f64 = 2.0 * f64::EPSILON;

/// Displacements that are compared at once.
const SIDE_BY_SIDE: usize = 6;

/// An evaluation of the elements.
#[derive(Clone, Copy, Debug)]
pub(super) struct Request {
    /// Tangents are asked for.
    pub(super) tangent: bool,
    /// Tangents are asked for, and those at hand are of another motion.
    pub(super) lacks_tangents: bool,
    /// All elements are meant; else those whose forces depend on rates.
    pub(super) all: bool,
    /// There was an evaluation at this time: an element that has not moved since is not evaluated again.
    pub(super) evaluated_before: bool,
    /// Nothing has moved since the committed state, and the histories hold what its evaluation has written.
    pub(super) at_rest: bool,
}

/// Part of an element's answer that is not at hand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Lack {
    Nothing,
    /// The tangent, which its history holds.
    KeptTangent,
    Everything,
}

impl Request {
    /// Returns true for an element that is meant, but for those that count their calls.
    #[inline]
    fn concerns(self, m: &ElementWorkspace) -> bool {
        (self.all || m.rates) && !m.counts_calls
    }

    /// Part of an element's answer that is to be found, where `last` is the motion of its last evaluation.
    #[inline]
    pub(super) fn lack(
        self,
        nodes: Nodes<'_>,
        e: &ElementEntry,
        m: &ElementWorkspace,
        last: &[f64],
        settled: bool,
    ) -> Lack {
        if !self.concerns(m) {
            return Lack::Nothing;
        }
        if self.lacks_tangents && !m.keeps_tangent {
            return Lack::Everything;
        }
        let rests = self.at_rest && !m.rates || self.evaluated_before && nodes.have_not_moved(e, m, last, settled);
        match (rests, self.lacks_tangents) {
            (false, _) => Lack::Everything,
            (true, true) => Lack::KeptTangent,
            (true, false) => Lack::Nothing,
        }
    }
}

impl System<'_> {
    /// Evaluate the forces of all elements, and their tangents with `want_tangent`.
    #[inline]
    pub fn respond(&mut self, want_tangent: bool) -> Result<(), Failure> {
        if self.work.interrupt.as_ref().is_some_and(|i| i.load(Ordering::Relaxed)) {
            return Err(self.failure(Cause::Interrupted));
        }
        if self.evaluation_is_current(want_tangent) {
            return Ok(());
        }
        self.evaluate(want_tangent)
    }

    /// Returns true if an evaluation would repeat the last one.
    #[inline]
    pub(super) fn evaluation_is_current(&self, want_tangent: bool) -> bool {
        let tangents = (want_tangent || self.work.elements.residual_needs_tangent) && !self.work.elements.is_current;
        self.evaluated_at == Some(self.new.time) && !tangents && !self.work.counts_updates() && self.no_node_has_moved()
    }

    fn evaluate(&mut self, want_tangent: bool) -> Result<(), Failure> {
        let passed = self.passed.unwrap_or(self.new.time - self.old.time);
        let dt = if self.elapses { passed } else { 0.0 };
        let want_tangent = want_tangent || self.work.elements.residual_needs_tangent;
        // Without motion, the forces of the committed state are still there, but for those that depend on rates.
        let tangents = want_tangent && !self.work.elements.is_current;
        let all = self.moved || tangents;
        let evaluated_before = self.evaluated_at.take() == Some(self.new.time);
        let at_rest = !self.moved && self.work.elements.has_stepped;
        let mut evaluated = false;
        if all && self.work.small_beams.count > 0 {
            let work = &mut *self.work;
            let matrices = &mut work.elements;
            let tangents = want_tangent.then_some((&mut matrices.tangent[..], &mut matrices.axial[..]));
            work.small_beams.respond(self.new, tangents);
            work.evaluated.calls += work.small_beams.count;
            evaluated = true;
        }
        let asked = Request { tangent: want_tangent, lacks_tangents: tangents, all, evaluated_before, at_rest };
        evaluated |= match self.work.side_by_side() {
            true => self.respond_side_by_side(asked, dt)?,
            false => self.respond_in_turn(asked, dt)?,
        };
        if self.work.counts_updates() {
            self.respond_counted(dt)?;
        }
        let work = &mut *self.work;
        work.elements.is_current = want_tangent || (work.elements.is_current && !(all && evaluated));
        self.summed &= !evaluated && !work.counts_updates();
        if all {
            self.evaluated_at = Some(self.new.time);
            work.evaluated.disp.copy_from_slice(&self.new.disp);
        }
        Ok(())
    }

    /// Evaluate the elements one after the other; `true` if there was one to be evaluated.
    fn respond_in_turn(&mut self, asked: Request, dt: f64) -> Result<bool, Failure> {
        let mut evaluated = false;
        for at in 0..self.work.small_beams.others.len() {
            let i = self.work.small_beams.others[at];
            match self.lack(asked, i) {
                Lack::Nothing => continue,
                Lack::KeptTangent => self.take_kept_tangent(i),
                Lack::Everything => {
                    self.respond_one(i, asked.tangent, dt, None)?;
                    evaluated = true;
                }
            }
        }
        Ok(evaluated)
    }

    /// Returns true if no node has moved since the last evaluation. It is the common end of a step, found without a loop over
    /// the elements.
    #[inline]
    fn no_node_has_moved(&self) -> bool {
        let slack = if self.settled { ROUND_OFF } else { 0.0 };
        let near = |all: bool, (new, old): (&f64, &f64)| all & ((new - old).abs() <= slack * old.abs());
        if !self.still {
            return false;
        }
        // The compiler makes one vector operation of each chunk.
        let (new, new_left) = self.new.disp.as_chunks::<SIDE_BY_SIDE>();
        let (old, old_left) = self.work.evaluated.disp.as_chunks::<SIDE_BY_SIDE>();
        let few = |(new, old): (&[f64; SIDE_BY_SIDE], &[f64; SIDE_BY_SIDE])| new.iter().zip(old).fold(true, near);
        new.iter().zip(old).all(few) && new_left.iter().zip(old_left).fold(true, near)
    }

    /// Part of an element's answer that is to be found.
    #[inline]
    fn lack(&self, asked: Request, i: usize) -> Lack {
        let (e, m) = (&self.model.elements[i], &self.work.elements.entries[i]);
        let last = &self.work.evaluated.elements[m.motion..m.motion + 2 * e.dofs.len()];
        let new = &*self.new;
        let nodes = Nodes { disp: &new.disp, vel: &new.vel, accel: &[], still: self.still };
        asked.lack(nodes, e, m, last, self.settled)
    }

    /// Take the tangent of an element at rest from its history.
    fn take_kept_tangent(&mut self, i: usize) {
        let (e, work) = (&self.model.elements[i], &mut *self.work);
        let m = &work.elements.entries[i];
        let n = e.dofs.len();
        let nodes = Nodes { disp: &self.new.disp, vel: &self.new.vel, accel: &[], still: self.still };
        let motion = &mut work.evaluated.elements[m.motion..m.motion + 2 * n];
        let tangent = &mut work.elements.tangent[m.at..m.at + n * n];
        nodes.take_kept_tangent(e, &self.new.history[e.state.clone()], motion, tangent);
    }

    /// Evaluate the elements that depend on the number of calls as often as OpenSees does, then their tangents.
    fn respond_counted(&mut self, dt: f64) -> Result<(), Failure> {
        let Some(mut counts) = self.work.opensees.take() else { return Ok(()) };
        let updates = std::mem::take(&mut counts.due);
        let result = self.update_counted(&counts.elements, updates, dt);
        for counted in &counts.elements {
            if updates.all == 0 && (updates.constrained == 0 || !counted.constrained) {
                self.take_last_force(counted.index);
            }
            self.take_last_tangent(counted.index);
        }
        self.work.opensees = Some(counts);
        result
    }

    fn update_counted(&mut self, elements: &[CountedElement], updates: Updates, dt: f64) -> Result<(), Failure> {
        for round in 0..updates.constrained + updates.all {
            for counted in elements {
                let first = if counted.constrained { 0 } else { updates.constrained };
                if round >= first {
                    let call = (round > first, counted.last_of_class);
                    self.respond_one(counted.index, false, dt, Some(call))?;
                }
            }
        }
        Ok(())
    }

    /// Bring the force of an element that was not called up to date with its loads.
    fn take_last_force(&mut self, i: usize) {
        let e = &self.model.elements[i];
        if let Some(calls) = e.element.opensees().calls {
            let load = &self.new.element_load[e.load.clone()];
            calls.last_force(&self.new.history[e.state.clone()], load, &mut self.new.force[e.force.clone()]);
        }
    }

    fn take_last_tangent(&mut self, i: usize) {
        let e = &self.model.elements[i];
        let m = &self.work.elements.entries[i];
        let part = self.work.part(m);
        let k = &mut self.work.elements.tangent[m.at..m.at + e.dofs.len().pow(2)];
        k.fill(0.0);
        if let Some(calls) = e.element.opensees().calls {
            let shared = Cell::from_mut(&mut self.new.shared[e.shared.clone()]).as_slice_of_cells();
            calls.last_tangent(&self.new.history[e.state.clone()], shared, k, part);
        }
    }

    /// Evaluate an element. For one that depends on the number of calls, `counted` holds the first fields of its
    /// [`OpenSeesCall`].
    #[inline]
    fn respond_one(
        &mut self,
        i: usize,
        want_tangent: bool,
        dt: f64,
        counted: Option<(bool, bool)>,
    ) -> Result<(), Failure> {
        let (e, work) = (&self.model.elements[i], &mut *self.work);
        work.evaluated.calls += 1;
        let m = &work.elements.entries[i];
        let part = work.part(m);
        let n = e.dofs.len();
        let time = self.passed.map_or(self.new.time, |passed| self.old.time + passed);
        let new = &mut *self.new;
        let opensees = counted.map(|(repeated, last_of_class)| {
            let shared = Cell::from_mut(&mut new.shared[e.shared.clone()]).as_slice_of_cells();
            OpenSeesCall { repeated, last_of_class, shared }
        });
        let nodes = Nodes { disp: &new.disp, vel: &new.vel, accel: &new.accel, still: self.still };
        let call = Call { nodes, load: &new.element_load[e.load.clone()], dt, time, dynamic: self.dynamic, part };
        let places = Places {
            motion: &mut work.evaluated.elements[m.motion..m.motion + 2 * n],
            force: &mut new.force[e.force.clone()],
            tangent: (want_tangent && !m.linear).then(|| &mut work.elements.tangent[m.at..m.at + n * n]),
            damping: m.damping.map(|at| &mut work.elements.damping[at..at + n * n]),
            histories: Histories {
                committed: &self.old.history[e.state.clone()],
                trial: &mut new.history[e.state.clone()],
            },
        };
        call.make(e, m, opensees, places).map_err(|error| self.element_failed(i, error))
    }

    #[cold]
    pub(super) fn element_failed(&self, i: usize, error: ElementError) -> Failure {
        let e = &self.model.elements[i];
        let element = format!("{} {}", e.element.class().name, e.tag);
        self.failure(Cause::Element { element, message: error.0.into() })
    }
}

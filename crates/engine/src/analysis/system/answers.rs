//! Asking the elements, as seldom as their answers allow.

use super::{Cause, Failure, System};
use crate::element::{ElementError, ElementInput, ElementOutput, MAX_DOFS};

/// Velocities where nothing moves.
static AT_REST: [f64; MAX_DOFS] = [0.0; MAX_DOFS];

/// Displacements that differ by no more than this fraction differ by the round-off of a correction.
const ROUND_OFF: f64 = 2.0 * f64::EPSILON;

/// Displacements that are compared at once.
const SIDE_BY_SIDE: usize = 6;

impl System<'_> {
    /// Ask all elements for forces, and for tangents if they are wanted.
    #[inline]
    pub fn respond(&mut self, want_tangent: bool) -> Result<(), Failure> {
        if self.answers_stand(want_tangent) {
            return Ok(());
        }
        self.ask(want_tangent)
    }

    /// Whether all elements have answered the question that they would be asked.
    #[inline]
    pub(super) fn answers_stand(&self, want_tangent: bool) -> bool {
        let tangents = (want_tangent || self.work.residual_needs_tangent) && !self.work.tangent_is_current;
        self.asked == Some(self.new.time) && !tangents && self.work.counting.is_empty() && self.nothing_has_moved()
    }

    fn ask(&mut self, want_tangent: bool) -> Result<(), Failure> {
        let passed = self.passed.unwrap_or(self.new.time - self.old.time);
        let dt = if self.elapses { passed } else { 0.0 };
        let want_tangent = want_tangent || self.work.residual_needs_tangent;
        // Where nothing has moved the answers are those of the committed state, which are there still, but for what
        // depends on rates.
        let tangents = want_tangent && !self.work.tangent_is_current;
        let all = self.moved || tangents;
        let asked_before = self.asked.take() == Some(self.new.time) && !tangents;
        let mut asked = false;
        for i in 0..self.model.elements.len() {
            let m = &self.work.matrices[i];
            if (all || m.rates) && !m.counts_calls && !(asked_before && self.has_not_moved(i)) {
                self.respond_one(i, want_tangent, dt)?;
                asked = true;
            }
        }
        if !self.work.counting.is_empty() {
            self.respond_counting(dt)?;
        }
        let work = &mut *self.work;
        work.tangent_is_current = want_tangent || (work.tangent_is_current && !(all && asked));
        self.summed &= !asked && work.counting.is_empty();
        if all {
            self.asked = Some(self.new.time);
            work.asked_at.copy_from_slice(&self.new.disp);
        }
        Ok(())
    }

    /// Whether all nodes are where the elements were asked last, and no element has loads of its own: the common end of a
    /// step, found without going through the elements.
    #[inline]
    fn nothing_has_moved(&self) -> bool {
        let slack = if self.settled { ROUND_OFF } else { 0.0 };
        let near = |all: bool, (new, old): (&f64, &f64)| all & ((new - old).abs() <= slack * old.abs());
        if !self.still || !self.new.element_load.is_empty() {
            return false;
        }
        // A few side by side, which the compiler does at once.
        let (new, new_left) = self.new.disp.as_chunks::<SIDE_BY_SIDE>();
        let (old, old_left) = self.work.asked_at.as_chunks::<SIDE_BY_SIDE>();
        let few = |(new, old): (&[f64; SIDE_BY_SIDE], &[f64; SIDE_BY_SIDE])| new.iter().zip(old).fold(true, near);
        new.iter().zip(old).all(few) && new_left.iter().zip(old_left).fold(true, near)
    }

    /// Whether an element without loads of its own is where it was asked last.
    fn has_not_moved(&self, i: usize) -> bool {
        let (e, at) = (&self.model.elements[i], self.work.matrices[i].motion);
        let (disp, vel) = self.work.motions[at..at + 2 * e.dofs.len()].split_at(e.dofs.len());
        let slack = if self.settled { ROUND_OFF } else { 0.0 };
        let same = |new: &[f64], old: &[f64]| {
            let near = |(d, old): (&u32, &f64)| (new[*d as usize] - old).abs() <= slack * old.abs();
            e.dofs.iter().zip(old).all(near)
        };
        e.load.is_empty() && same(&self.new.disp, disp) && (self.still || same(&self.new.vel, vel))
    }

    /// Ask the elements that count their calls as often as OpenSees does, then for the tangents that they have come to.
    fn respond_counting(&mut self, dt: f64) -> Result<(), Failure> {
        let all = std::mem::take(&mut self.work.counting);
        let calls = std::mem::take(&mut self.work.updates);
        let mut rounds = (0..calls.constrained + calls.all).flat_map(|round| all.iter().map(move |&i| (round, i)));
        let asked = rounds.try_for_each(|(round, i)| {
            let first = if self.work.matrices[i].constrained { 0 } else { calls.constrained };
            self.again = round > first;
            if round >= first { self.respond_one(i, false, dt) } else { Ok(()) }
        });
        self.again = false;
        for &i in &all {
            let e = &self.model.elements[i];
            let m = &self.work.matrices[i];
            if calls.all == 0 && (calls.constrained == 0 || !m.constrained) {
                let load = &self.new.element_load[e.load.clone()];
                let force = &mut self.new.force[e.force.clone()];
                e.element.last_force(&self.new.history[e.state.clone()], load, force);
            }
            let part = self.work.part(m);
            let k = &mut self.work.tangent[m.at..m.at + e.dofs.len().pow(2)];
            k.fill(0.0);
            e.element.last_tangent(&self.new.history[e.state.clone()], k, part);
        }
        self.work.counting = all;
        asked
    }

    #[inline]
    fn respond_one(&mut self, i: usize, want_tangent: bool, dt: f64) -> Result<(), Failure> {
        let (e, work) = (&self.model.elements[i], &mut *self.work);
        work.element_calls += 1;
        let m = &work.matrices[i];
        let part = work.part(m);
        let n = e.dofs.len();
        let (disp, vel) = work.motions[m.motion..m.motion + 2 * n].split_at_mut(n);
        e.dofs.iter().zip(&mut *disp).for_each(|(&d, u)| *u = self.new.disp[d as usize]);
        if !self.still {
            e.dofs.iter().zip(&mut *vel).for_each(|(&d, v)| *v = self.new.vel[d as usize]);
        }
        let force = &mut self.new.force[e.force.clone()];
        force.fill(0.0);
        let tangent = if want_tangent && !m.linear {
            let k = &mut work.tangent[m.at..m.at + n * n];
            part.clear(k, n);
            Some(k)
        } else {
            None
        };
        let damping = m.damping.map(|at| {
            let c = &mut work.damping[at..at + n * n];
            c.fill(0.0);
            c
        });
        let load = &self.new.element_load[e.load.clone()];
        let vel = if self.still { &AT_REST[..n] } else { &*vel };
        let time = self.passed.map_or(self.new.time, |passed| self.old.time + passed);
        let motion = ElementInput { disp, vel, load, still: self.still, again: self.again, dt, time };
        let answer = ElementOutput { force, tangent, damping, part };
        let committed = &self.old.history[e.state.clone()];
        let trial = &mut self.new.history[e.state.clone()];
        e.element.respond(&motion, committed, trial, answer).map_err(|error| self.element_failed(i, error))
    }

    #[cold]
    fn element_failed(&self, i: usize, error: ElementError) -> Failure {
        let e = &self.model.elements[i];
        let element = format!("{} {}", e.element.class(), e.tag);
        self.failure(Cause::Element { element, message: error.0.into() })
    }
}

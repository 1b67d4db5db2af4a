//! The equations of a step: unbalance, tangent, correction, for a trial state.

use super::failure::{Cause, Failure};
use super::loads::Loads;
use super::prepared::{Prepared, TangentMix};
use super::state::State;
use crate::element::{Answer, ElementError, MAX_DOFS, Motion};
use crate::model::Model;
use crate::solve::{Pivots, SINGULAR, SolveError, Use};

/// Share of stiffness, damping and mass in the tangent of an integrator.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Coefficients {
    /// Of the stiffness.
    pub k: f64,
    /// Of the damping.
    pub c: f64,
    /// Of the mass.
    pub m: f64,
}

/// The equations of a step, for whoever solves them: integrators and algorithms.
pub struct System<'a> {
    /// The model.
    pub model: &'a Model,
    /// The committed state.
    pub old: &'a State,
    /// The trial state.
    pub new: &'a mut State,
    /// Plan, factors and work vectors.
    pub work: &'a mut Prepared,
    /// Share of stiffness, damping and mass in the tangent.
    pub coefficients: Coefficients,
    /// Inertia and damping count.
    pub dynamic: bool,
    /// Time passes with the domain time: not where a load factor stands for it.
    pub elapses: bool,
    /// The time that counts as passed for the elements where it is not that of the domain.
    pub passed: Option<f64>,
    /// Elements that count their calls are asked once more where they were asked last.
    pub again: bool,
    /// Displacements or element loads differ from the committed ones, or may.
    pub moved: bool,
    /// The time that all elements have been asked at in this step, if they have: those that have not moved since are not
    /// asked again, for the same question has the same answer.
    pub asked: Option<f64>,
    /// Nothing has a velocity in this step.
    pub still: bool,
    /// The unbalance in `work.b` is that of the answers of the elements and of the loads as they are: it is not summed again.
    pub summed: bool,
    /// The test is passed whatever the last correction has done to the forces: an element that it has moved by no more than
    /// round-off has not moved.
    pub settled: bool,
}

/// Velocities where nothing moves.
static AT_REST: [f64; MAX_DOFS] = [0.0; MAX_DOFS];

/// Displacements that differ by no more than this fraction differ by the round-off of a correction.
const ROUND_OFF: f64 = 2.0 * f64::EPSILON;

/// Displacements that are compared at once.
const SIDE_BY_SIDE: usize = 6;

impl System<'_> {
    /// A failure of this step.
    #[cold]
    pub fn failure(&self, cause: Cause) -> Failure {
        Failure::new(cause, self.new.time, -3)
    }

    /// A failure that names an equation.
    #[cold]
    fn failure_at(&self, cause: Cause, equation: usize) -> Failure {
        self.failure(cause).at(Some(self.work.plan.equation_name(self.model, equation)))
    }

    /// A failure for an equation without a pivot.
    pub(super) fn singular(&self, equation: usize) -> Failure {
        self.failure_at(Cause::Singular, equation)
    }

    /// Set the time, and with it loads and imposed displacements.
    #[inline]
    pub fn apply_loads(&mut self, time: f64) -> Result<(), Failure> {
        self.new.time = time;
        self.summed = false;
        let applied = self.work.loads.apply(self.model, time, &mut self.new.element_load);
        self.moved |= applied.map_err(|(element, message)| self.failure(Cause::Element { element, message }))?;
        self.impose();
        Ok(())
    }

    /// Move the imposed degrees of freedom, and those that follow them.
    #[inline]
    fn impose(&mut self) {
        let work = &mut *self.work;
        if work.loads.imposed.is_empty() {
            return;
        }
        self.moved = true;
        if work.plan.map.dependents.is_empty() {
            for i in &work.loads.imposed {
                self.new.disp[i.dof] = work.loads.imposed_value(i);
            }
        } else {
            for i in &work.loads.imposed {
                let value = work.loads.imposed_value(i);
                work.spread[i.dof] = value - self.new.disp[i.dof];
                self.new.disp[i.dof] = value;
            }
            for d in &work.plan.map.dependents {
                let step: f64 = d.terms.iter().map(|&(from, c)| c * work.spread[from]).sum();
                work.spread[d.dof] = step;
                self.new.disp[d.dof] += step;
            }
            work.clear_imposed();
        }
        if work.loads.moves {
            self.impose_rates();
        }
    }

    /// Give the degrees of freedom that follow the ground its velocity and acceleration, and those that follow them.
    fn impose_rates(&mut self) {
        let work = &mut *self.work;
        for part in [0, 1] {
            let field = if part == 0 { &mut self.new.vel } else { &mut self.new.accel };
            for i in &work.loads.imposed {
                if let Some((vel, accel)) = Loads::imposed_rates(i) {
                    let value = if part == 0 { vel } else { accel };
                    work.spread[i.dof] = value - field[i.dof];
                    field[i.dof] = value;
                }
            }
            for d in &work.plan.map.dependents {
                let step: f64 = d.terms.iter().map(|&(from, c)| c * work.spread[from]).sum();
                work.spread[d.dof] = step;
                field[d.dof] += step;
            }
            work.clear_imposed();
        }
    }

    /// Spread a correction of the equations to all degrees of freedom, into `work.spread`.
    pub fn spread(&mut self, correction: &[f64]) {
        let work = &mut *self.work;
        let n = work.plan.map.equations;
        work.plan.map.spread(&correction[..n], &mut work.spread);
        for (l, x) in self.new.multipliers.iter_mut().zip(&correction[n..]) {
            *l += x;
        }
    }

    /// Add a correction of the equations to the trial motion as the unknown of an integrator: only the degrees of freedom
    /// that it moves are touched.
    #[inline]
    pub fn add_correction(&mut self, correction: &[f64], c: Coefficients) {
        let map = &self.work.plan.map;
        if !map.dependents.is_empty() {
            self.spread(correction);
            return self.add_motion(c);
        }
        self.moved = true;
        let new = &mut *self.new;
        let (own, multipliers) = correction.split_at(map.equations);
        for (x, &dof) in own.iter().zip(&map.dof_of) {
            new.disp[dof] += c.k * x;
            if self.dynamic {
                new.vel[dof] += c.c * x;
                new.accel[dof] += c.m * x;
            }
        }
        new.multipliers.iter_mut().zip(multipliers).for_each(|(l, x)| *l += x);
    }

    /// Add `work.spread` times a factor to the trial displacements.
    pub fn add_disp(&mut self, factor: f64) {
        self.moved = true;
        for (u, d) in self.new.disp.iter_mut().zip(&self.work.spread) {
            *u += factor * d;
        }
    }

    /// Add `work.spread` to the trial motion as the unknown of an integrator, and clear it.
    pub fn add_motion(&mut self, c: Coefficients) {
        self.moved = true;
        let new = &mut *self.new;
        for (i, d) in self.work.spread.iter().enumerate() {
            new.disp[i] += c.k * d;
            new.vel[i] += c.c * d;
            new.accel[i] += c.m * d;
        }
        self.work.spread.fill(0.0);
    }

    /// Stiffness of the elements, initial or as last answered by the choice of the last tangent, times displacements of
    /// all degrees of freedom, as forces of the equations.
    pub fn stiffness_times(&mut self, disp: &[f64], out: &mut [f64]) -> Result<(), Failure> {
        if !self.work.tangent_is_current {
            self.respond(true)?;
        }
        self.work.stiffness_times(self.model, disp, out);
        Ok(())
    }

    /// Load of the equations per unit of load factor, from `factor` on: what one more of it adds to the unbalance. Loads
    /// on elements, imposed displacements and series with factors count as they are.
    pub fn reference_load(&mut self, factor: f64, out: &mut [f64]) -> Result<(), Failure> {
        self.apply_loads(factor + 1.0)?;
        self.form_unbalance(false)?;
        out.copy_from_slice(&self.work.b);
        self.apply_loads(factor)?;
        self.form_unbalance(false)?;
        out.iter_mut().zip(&self.work.b).for_each(|(p, b)| *p -= b);
        Ok(())
    }

    /// Apply the loads of the end of a step that has been solved at another time. In OpenSees loads and imposed motions stay
    /// those of that time.
    pub fn apply_loads_at_end(&mut self, end: f64) -> Result<(), Failure> {
        let solved_at = self.new.time;
        self.apply_loads(if self.work.compat { solved_at } else { end })?;
        self.new.time = end;
        Ok(())
    }

    /// The same, and ask all elements. In OpenSees no more time has passed for them than when the step was solved.
    pub fn respond_at_end(&mut self, end: f64) -> Result<(), Failure> {
        let passed = self.new.time - self.old.time;
        self.moved = true;
        self.apply_loads_at_end(end)?;
        self.passed = self.work.compat.then_some(passed);
        // The clock is that of this answer alone: who needs the tangent of the committed state takes it from here.
        let done = self.respond(self.work.wants_committed_tangent());
        self.passed = None;
        done
    }

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
    fn answers_stand(&self, want_tangent: bool) -> bool {
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
        let motion = Motion { disp, vel, load, still: self.still, again: self.again, dt, time };
        let answer = Answer { force, tangent, damping, part };
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

    /// Work out the unbalance b = P - R - C v - M a at the trial state; with the element tangents, if they are going
    /// to be needed.
    #[inline]
    pub fn form_unbalance(&mut self, want_tangent: bool) -> Result<(), Failure> {
        if self.answers_stand(want_tangent) && self.summed && !self.dynamic {
            return Ok(());
        }
        self.form_unbalance_anew(want_tangent)
    }

    fn form_unbalance_anew(&mut self, want_tangent: bool) -> Result<(), Failure> {
        self.respond(want_tangent)?;
        if self.summed && !self.dynamic {
            return Ok(());
        }
        self.sum_unbalance();
        // What constraints in the equations add depends on the displacements themselves.
        self.summed = self.work.plan.map.links.is_empty();
        if self.work.b.iter().any(|b| !b.is_finite()) {
            let at = self.work.b.iter().position(|b| !b.is_finite()).unwrap_or(0);
            return Err(self.failure_at(Cause::NotFinite, at));
        }
        Ok(())
    }

    #[inline]
    fn sum_unbalance(&mut self) {
        match self.work.trapezoid.take() {
            Some(mut trapezoid) => {
                self.sum_weighted(&mut trapezoid);
                self.work.trapezoid = Some(trapezoid);
            }
            None => self.sum_forces(1.0),
        }
        let work = &mut *self.work;
        let loads = &work.loads;
        work.plan.add_link_forces(
            |link| link.imposed.map_or(0.0, |i| loads.link_value(self.model, &i, self.new.time)),
            &self.new.disp,
            &self.new.multipliers,
            &mut work.b,
        );
    }

    /// Sum loads, resisting forces, damping and a share of the inertia, but not the forces of constraints, into `work.b`.
    #[inline]
    pub(super) fn sum_forces(&mut self, inertia: f64) {
        let work = &mut *self.work;
        let n = work.plan.map.equations;
        if self.dynamic {
            work.full.copy_from_slice(&work.loads.nodal);
            work.subtract_nodal_inertia(self.new, inertia);
            work.subtract_modal_damping(self.new);
            work.plan.map.condense(&work.full, &mut work.b[..n]);
        } else {
            work.plan.map.condense(&work.loads.nodal, &mut work.b[..n]);
        }
        work.b[n..].fill(0.0);
        work.condense_elements(self.model, self.new, self.dynamic, inertia);
    }

    /// Whether no force is left over, not even round-off, so that the correction is zero whatever the tangent: a device on
    /// an imposed path without other loads. Not before there has been a tangent to see a mechanism by, and not where elements
    /// count how often they are asked.
    #[inline]
    pub fn is_balanced(&self) -> bool {
        let work = &self.work;
        work.solver.is_factored() && work.counting.is_empty() && work.b.iter().all(|b| *b == 0.0)
    }

    /// Assemble the tangent of the integrator, to be solved with once or often.
    pub fn form_tangent(&mut self, mix: TangentMix, how: Use) -> Result<(), Failure> {
        if mix.current != 0.0 && !self.work.tangent_is_current {
            self.respond(true)?;
        }
        let work = &mut *self.work;
        work.last = Some(self.coefficients);
        work.last_mix = mix;
        work.assemble(self.model, self.coefficients, mix);
        work.add_modal_damping(self.coefficients.c);
        if work.solver.is_factored() && work.values == work.factored {
            return Ok(());
        }
        work.factored.copy_from_slice(&work.values);
        let result = work.solver.prepare(&work.plan.pattern, &work.values, how);
        self.check(result)
    }

    /// Turn what a factorisation found into a failure, or remember it.
    fn check(&mut self, result: Result<Option<Pivots>, SolveError>) -> Result<(), Failure> {
        let work = &mut *self.work;
        match result {
            Ok(None) => Ok(()),
            Err(SolveError::Singular { equation }) => Err(self.failure_at(Cause::Singular, equation)),
            Err(SolveError::OutOfMemory) => Err(self.failure(Cause::OutOfMemory)),
            Ok(Some(p)) if p.ratio <= SINGULAR && work.plan.handler.eliminates() => {
                work.solver.forget();
                Err(self.failure_at(Cause::Singular, p.equation))
            }
            Ok(Some(p)) => {
                work.note_pivot(p);
                Ok(())
            }
        }
    }

    /// Solve for the correction: x = A⁻¹ b.
    pub fn solve(&mut self) -> Result<(), Failure> {
        let mut x = std::mem::take(&mut self.work.x);
        x.copy_from_slice(&self.work.b);
        let result = self.solve_for(&mut x);
        self.work.x = x;
        result
    }

    /// Solve with the tangent for another right-hand side, in place.
    pub fn solve_for(&mut self, x: &mut [f64]) -> Result<(), Failure> {
        let work = &mut *self.work;
        let result = work.solver.solve(&work.plan.pattern, &work.values, x);
        self.check(result)?;
        match x.iter().position(|x| !x.is_finite()) {
            Some(at) => Err(self.failure_at(Cause::NotFinite, at)),
            None => Ok(()),
        }
    }

    /// The equation with the largest entry of a vector, in words.
    pub fn worst(&self, vector: &[f64]) -> Option<String> {
        let (i, _) = vector.iter().enumerate().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))?;
        Some(self.work.plan.equation_name(self.model, i))
    }
}

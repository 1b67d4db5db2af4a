//! The equations of a step: unbalance, tangent, correction, for a trial state.

mod element_call;
mod end_of_step;
mod evaluation;
mod plateau;
mod side_by_side;

pub(super) use evaluation::ROUND_OFF;
pub(super) use side_by_side::are_worth_threads;

use super::failure::{Cause, Failure};
use super::loads::Loads;
use super::state::State;
use super::workspace::{TangentMix, Workspace};
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

/// The equations of a step, for integrators and algorithms.
pub struct System<'a> {
    /// The model.
    pub model: &'a Model,
    /// The committed state.
    pub old: &'a State,
    /// The trial state.
    pub new: &'a mut State,
    /// Plan, factors and work vectors.
    pub work: &'a mut Workspace,
    /// Share of stiffness, damping and mass in the tangent.
    pub coefficients: Coefficients,
    /// Inertia and damping count.
    pub dynamic: bool,
    /// Time passes with the domain time: not where a load factor stands for it.
    pub elapses: bool,
    /// The time that counts as passed for the elements where it is not that of the domain.
    pub passed: Option<f64>,
    /// Displacements or element loads differ from the committed ones, or may.
    pub moved: bool,
    /// Time of the last evaluation of all elements in this step. Elements that have not moved since are not evaluated again.
    pub evaluated_at: Option<f64>,
    /// Nothing has a velocity in this step.
    pub still: bool,
    /// The unbalance in `work.b` belongs to the forces of the elements and the loads as they are: it is not summed again.
    pub summed: bool,
    /// The test is passed whatever the last correction has done to the forces: an element that it has moved by no more than
    /// round-off has not moved.
    pub settled: bool,
}

/// Work out degrees of freedom that follow others.
fn follow(followers: &[(usize, Vec<(usize, f64)>)], field: &mut [f64]) {
    for (dof, terms) in followers {
        field[*dof] = terms.iter().map(|&(from, c)| c * field[from]).sum();
    }
}

impl<'a> System<'a> {
    /// The equations at a committed state, outside of a step.
    #[inline]
    pub(super) fn new(model: &'a Model, old: &'a State, new: &'a mut State, work: &'a mut Workspace) -> Self {
        Self {
            model,
            old,
            new,
            work,
            coefficients: Coefficients::default(),
            dynamic: false,
            elapses: false,
            passed: None,
            moved: true,
            evaluated_at: None,
            still: false,
            summed: false,
            settled: false,
        }
    }
}

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
        if applied.map_err(|(element, message)| self.failure(Cause::Element { element, message }))? {
            self.moved = true;
            self.evaluated_at = None;
        }
        self.impose();
        self.impose_linked();
        self.follow_loads();
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
            for d in work.plan.map.dependents.iter().filter(|d| !d.held) {
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

    /// Give the degrees of freedom whose motion is imposed its velocity and acceleration, and those that follow them.
    fn impose_rates(&mut self) {
        let elapses = self.elapses;
        let work = &mut *self.work;
        for part in [0, 1] {
            let field = if part == 0 { &mut self.new.vel } else { &mut self.new.accel };
            for i in &work.loads.imposed {
                if let Some(rates) = Loads::imposed_rates(i, elapses) {
                    work.spread[i.dof] = rates[part] - field[i.dof];
                    field[i.dof] = rates[part];
                }
            }
            for d in work.plan.map.dependents.iter().filter(|d| !d.held) {
                let step: f64 = d.terms.iter().map(|&(from, c)| c * work.spread[from]).sum();
                work.spread[d.dof] = step;
                field[d.dof] += step;
            }
            // The predictor of a step knows nothing of what they follow.
            follow(&work.followers, field);
            work.clear_imposed();
        }
    }

    /// Move the imposed degrees of freedom that constraints in the equations hold, and those that follow them alone. In a
    /// dynamic analysis the displacements are imposed too: a correction would become a velocity, and ring from step to step.
    fn impose_linked(&mut self) {
        let work = &*self.work;
        if work.loads.linked.is_empty() {
            return;
        }
        if self.dynamic {
            self.moved = true;
            for i in &work.loads.linked {
                self.new.disp[i.dof] = work.loads.imposed_value(i);
            }
            follow(&work.followers, &mut self.new.disp);
        }
        self.impose_linked_rates();
    }

    /// Give them velocity and acceleration of their motion, which corrections do not change.
    pub(super) fn impose_linked_rates(&mut self) {
        let work = &*self.work;
        for i in &work.loads.linked {
            if let Some([vel, accel]) = Loads::imposed_rates(i, self.elapses) {
                (self.new.vel[i.dof], self.new.accel[i.dof]) = (vel, accel);
            }
        }
        follow(&work.followers, &mut self.new.vel);
        follow(&work.followers, &mut self.new.accel);
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

    /// Stiffness of the elements times displacements of all degrees of freedom, as forces of the equations. The stiffness is
    /// the initial or the last one, as in the last tangent.
    pub fn stiffness_times(&mut self, disp: &[f64], out: &mut [f64]) -> Result<(), Failure> {
        if !self.work.elements.is_current {
            self.respond(true)?;
        }
        self.work.stiffness_times(self.model, disp, out);
        Ok(())
    }

    /// Find the load of the equations per unit of load factor. OpenSees keeps that of the same integrator and model, when
    /// another algorithm or test takes over after a step that failed.
    ///
    /// # Errors
    /// Loads or elements that make no sense.
    pub fn renew_reference_load(&mut self, revision: &mut Option<u64>, out: &mut [f64]) -> Result<(), Failure> {
        let now = Some(self.model.revision());
        if self.work.opensees.is_none() || *revision != now {
            self.reference_load(self.old.time, out)?;
            *revision = now;
        }
        Ok(())
    }

    /// Load of the equations per unit of load factor, from `factor` on: what one more of it adds to the unbalance. Loads
    /// on elements, imposed displacements and series with factors count as they are. OpenSees takes the whole unbalance
    /// at one more of it: a state out of equilibrium counts.
    fn reference_load(&mut self, factor: f64, out: &mut [f64]) -> Result<(), Failure> {
        self.apply_loads(factor + 1.0)?;
        self.form_unbalance(false)?;
        out.copy_from_slice(&self.work.b);
        self.apply_loads(factor)?;
        self.form_unbalance(false)?;
        if self.work.opensees.is_none() {
            out.iter_mut().zip(&self.work.b).for_each(|(p, b)| *p -= b);
        }
        Ok(())
    }

    /// Work out the unbalance b = P - R - C v - M a at the trial state; with the element tangents, if they are going
    /// to be needed.
    #[inline]
    pub fn form_unbalance(&mut self, want_tangent: bool) -> Result<(), Failure> {
        if self.evaluation_is_current(want_tangent) && self.summed && !self.dynamic {
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
        // Forces of constraints in the equations depend on the displacements themselves.
        self.summed = self.work.plan.map.links.is_empty();
        if self.work.b.iter().any(|b| !b.is_finite()) {
            let at = self.work.b.iter().position(|b| !b.is_finite()).unwrap_or(0);
            return Err(self.failure_at(Cause::NotFinite, at));
        }
        Ok(())
    }

    #[inline]
    fn sum_unbalance(&mut self) {
        match self.work.two_end_residual.take() {
            Some(mut two_end_residual) => {
                self.sum_weighted(&mut two_end_residual);
                self.work.two_end_residual = Some(two_end_residual);
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

    /// Returns true if no force is left over, not even round-off, as of a device on an imposed path without other loads. The
    /// correction is zero then whatever the tangent. False before the first tangent, which shows a mechanism, and where
    /// elements depend on the number of their updates.
    #[inline]
    pub fn is_balanced(&self) -> bool {
        let work = &self.work;
        work.solver.is_factored() && !work.counts_updates() && work.b.iter().all(|b| *b == 0.0)
    }

    /// Assemble the tangent of the integrator, to be solved with once or often.
    ///
    /// # Errors
    /// Coefficients that are not finite, as of a step so short that its inverse overflows; what the factorisation finds.
    pub fn form_tangent(&mut self, mix: TangentMix, how: Use) -> Result<(), Failure> {
        let Coefficients { k, c, m } = self.coefficients;
        if !(k.is_finite() && c.is_finite() && m.is_finite()) {
            return Err(self.failure(Cause::NotFinite));
        }
        if mix.current != 0.0 && !self.work.elements.is_current {
            self.respond(true)?;
        }
        let work = &mut *self.work;
        work.matrix.coefficients = Some(self.coefficients);
        work.matrix.mix = mix;
        work.assemble(self.model, self.coefficients, mix);
        work.add_modal_damping(self.coefficients.c);
        if work.solver.is_factored() && work.matrix.values == work.matrix.factored {
            return Ok(());
        }
        work.matrix.factored.copy_from_slice(&work.matrix.values);
        work.matrix.plateau = false;
        let result = work.solver.prepare(&work.plan.pattern, &work.matrix.values, how);
        let result = if work.opensees.is_some() { self.past_mechanisms(result) } else { result };
        let result = self.past_plateau(result);
        self.check(result)
    }

    /// Stiffens the tangent where an equation that carries no load has no pivot. The residual does not change, so that a load
    /// on the mechanism lets no iteration converge.
    fn past_mechanisms(
        &mut self,
        mut result: Result<Option<Pivots>, SolveError>,
    ) -> Result<Option<Pivots>, SolveError> {
        /// Share of the largest unbalance that is no load.
        const NO_LOAD: f64 = 1e-8;
        let work = &mut *self.work;
        if !work.plan.handler.eliminates() {
            return result;
        }
        let largest = |values: &[f64]| values.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        let (unloaded, stiffness) = (NO_LOAD * largest(&work.b), largest(&work.matrix.values));
        let (mut stiffened, mut held): (Vec<f64>, Vec<usize>) = (vec![], vec![]);
        for _ in 0..work.plan.pattern.n {
            let equation = match &result {
                Err(SolveError::Singular { equation }) => *equation,
                Ok(Some(p)) if p.ratio <= SINGULAR => p.equation,
                _ => break,
            };
            let Some(place) = work.plan.pattern.place(equation, equation) else { return result };
            if held.is_empty() {
                stiffened.clone_from(&work.matrix.values);
            }
            held.push(equation);
            stiffened[place] += stiffness;
            result = work.solver.factor(&work.plan.pattern, &stiffened).map(Some);
        }
        let Some(&first) = held.first() else { return result };
        // The force of a spring that holds a mechanism is the load on it.
        let mut motion = work.b.clone();
        work.solver.solve(&work.plan.pattern, &stiffened, &mut motion)?;
        if held.iter().any(|&e| stiffness * motion[e].abs() > unloaded) {
            work.solver.forget();
            return Err(SolveError::Singular { equation: first });
        }
        work.note_pivot(Pivots { equation: first, ratio: 0.0 });
        result
    }

    /// Turn the result of a factorisation into a failure, or keep its smallest pivot.
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
        // Factors that are made on the way may turn out singular when the right-hand side is gone.
        let may_end = !self.elapses && work.solver.is_outdated();
        if may_end {
            work.matrix.right_side.copy_from_slice(x);
        }
        let mut result = work.solver.solve(&work.plan.pattern, &work.matrix.values, x);
        if may_end && self.is_singular(&result) {
            result = self.past_plateau(result);
            if !self.is_singular(&result) {
                x.copy_from_slice(&self.work.matrix.right_side);
                self.work.solver.back_substitute(x);
            }
        }
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

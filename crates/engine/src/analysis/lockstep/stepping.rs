//! Steps of models side by side.
//!
//! Each model takes the way that it takes by itself: the same evaluations with and without tangents, to the same bits. The
//! flags of a model say what [`System`](crate::analysis::System) and [`Newton`](crate::analysis::algorithm::Newton) would.

// Loops over vectors: the compiler makes vector instructions of them, which it does not of some iterators.
#![allow(clippy::needless_range_loop)]

use super::{ALL, Flags, LockstepRows, Measure, Models, Norm, Recorded, Work};
use crate::analysis::system::ROUND_OFF;
use crate::element::{LockstepMotion, LockstepOutput};
use crate::numeric::lanes::{Lanes, in_lanes};
use crate::numeric::real::Real;
use crate::numeric::wide::{WIDTH, Wide, is_set};
use std::sync::atomic::Ordering;

/// Steps between two looks at the interrupt, whose recorded numbers are taken together.
const STEPS_AT_ONCE: usize = 64;

/// Steps as a loop.
struct Steps<'a> {
    models: &'a mut Models,
    count: usize,
    recorded: &'a [Recorded],
    rows: &'a mut LockstepRows,
}

impl Lanes for Steps<'_> {
    #[inline(always)]
    fn evaluate(&mut self) {
        for _ in 0..self.count {
            self.models.step();
            self.models.commit();
            self.rows.times.push(self.models.time);
            for number in self.recorded {
                self.rows.numbers.push(match *number {
                    Recorded::Disp(i) => self.models.committed.disp[i],
                    Recorded::Vel(i) => self.models.committed.vel[i],
                    Recorded::Accel(i) => self.models.committed.accel[i],
                    Recorded::Force(i) => self.models.trial.force[i],
                });
            }
        }
    }
}

/// Keep numbers of models as they were where `new` is not 1. The saved ones lie one after the other.
#[inline(always)]
fn restore(new: Wide, saved: &mut std::slice::Iter<'_, Wide>, numbers: &mut [Wide]) {
    for (number, old) in numbers.iter_mut().zip(saved) {
        *number = new.where_equal(Wide::all(1.0), *number, *old);
    }
}

impl Models {
    /// Make the steps of all models that do not fail. All fail where they are interrupted.
    pub(super) fn analyze(&mut self, steps: usize, recorded: &[Recorded], take: &mut dyn FnMut(&LockstepRows)) {
        let mut rows = LockstepRows::default();
        let mut made = 0;
        while made < steps && self.failed != ALL {
            if self.interrupt.as_ref().is_some_and(|i| i.load(Ordering::Relaxed)) {
                self.failed = ALL;
                return;
            }
            rows.times.clear();
            rows.numbers.clear();
            let count = STEPS_AT_ONCE.min(steps - made);
            in_lanes(&mut Steps { models: self, count, recorded, rows: &mut rows });
            take(&rows);
            made += count;
        }
    }

    /// Bring all models to balance at the end of the next step by Newton's method.
    #[inline(always)]
    fn step(&mut self) {
        let mut waits = self.failed;
        let wants = !self.flags.balanced;
        self.start = self.time;
        self.begin();
        self.apply_loads(self.start + self.increment);
        self.flags.evaluated = 0;
        self.work.slack = Wide::all(0.0);
        self.respond(waits, wants, !self.imposed.is_empty());
        self.sum_forces();
        self.note_balance();
        for iteration in 1.. {
            let none = if iteration == 1 { self.flags.balanced } else { 0 };
            self.solve(waits | none);
            // Newmark's method evaluates the elements after a correction of zero too.
            let idle = if self.dynamics.is_some() { 0 } else { none };
            self.correct(iteration, waits | idle);
            self.judge(iteration, &mut waits);
            if waits == ALL {
                return;
            }
        }
    }

    /// Set the loads and the imposed displacements of a time.
    #[inline(always)]
    fn apply_loads(&mut self, time: f64) {
        let mut changed = false;
        for ((factor, drive), loaded) in self.factors.iter_mut().zip(&self.drives).zip(&self.loaded) {
            let new = drive.factor(time);
            changed |= *loaded && new != *factor;
            *factor = new;
        }
        let factor = |pattern: usize, constant: bool| if constant { 1.0 } else { self.factors[pattern] };
        if changed {
            self.work.nodal.fill(Wide::all(0.0));
            for l in &self.loads {
                self.work.nodal[l.dof] += l.value * factor(l.pattern, l.constant);
            }
            if let Some(dynamics) = &self.dynamics {
                dynamics.add_ground(&self.factors, &mut self.work.nodal);
            }
        }
        for i in &self.imposed {
            self.trial.disp[i.dof] = i.initial + i.value * factor(i.pattern, i.constant);
            if self.dynamics.is_some() && i.rates {
                let [vel, accel] = if i.constant { [0.0; 2] } else { self.drives[i.pattern].derivatives(time) };
                (self.trial.vel[i.dof], self.trial.accel[i.dof]) = (i.value * vel, i.value * accel);
            }
        }
        self.time = time;
    }

    /// Evaluate the elements at the trial displacements, where they may have `moved`, in all models that do not wait; with
    /// tangents in those that want them.
    #[inline(always)]
    fn respond(&mut self, waits: Flags, wants: Flags, moved: bool) {
        let tangents = wants & !self.flags.is_current;
        let considered = !waits & if moved { ALL } else { tangents };
        let mut evaluated = 0;
        let mut at = 0;
        for i in 0..self.elements.len() {
            let e = &self.elements[i];
            let n = e.dofs.len();
            let tangent_at = at;
            at += n * n;
            for (k, &dof) in e.dofs.iter().enumerate() {
                self.work.disp[k] = self.trial.disp[dof as usize];
            }
            if self.dynamics.is_some() {
                for (k, &dof) in e.dofs.iter().enumerate() {
                    self.work.vel[k] = self.trial.vel[dof as usize];
                }
            }
            let mut lanes = if e.rates { !waits } else { considered };
            if self.flags.evaluated != 0 {
                lanes &= !(self.flags.evaluated & !tangents & self.has_not_moved(i));
            }
            if lanes != 0 {
                self.respond_one(i, tangent_at, lanes, wants);
                evaluated |= lanes;
            }
        }
        let flags = &mut self.flags;
        let is_current = wants | (flags.is_current & !(considered & evaluated));
        flags.is_current = flags.is_current & waits | is_current & !waits;
        flags.evaluated = flags.evaluated & waits | considered & !waits;
    }

    /// Models in which an element has not moved since its last evaluation, or by round-off that the test accepts.
    #[inline(always)]
    fn has_not_moved(&self, i: usize) -> Flags {
        let mut near = ALL;
        let e = &self.elements[i];
        // Within a step the others stay where they are.
        for k in e.part.rows.among(e.dofs.len()) {
            near &= self.is_near(self.work.disp[k], self.work.evaluated[0][e.force.start + k]);
            if self.dynamics.is_some() {
                near &= self.is_near(self.work.vel[k], self.work.evaluated[1][e.force.start + k]);
            }
        }
        near
    }

    /// Models in which a number is what it was, or differs by round-off that the test accepts.
    #[inline(always)]
    fn is_near(&self, new: Wide, old: Wide) -> Flags {
        (new - old).abs().at_most(self.work.slack * old.abs())
    }

    /// Evaluate an element in some models, with tangents where it is in models that want them.
    #[inline(always)]
    fn respond_one(&mut self, i: usize, tangent_at: usize, lanes: Flags, wants: Flags) {
        let (e, work) = (&self.elements[i], &mut self.work);
        let n = e.dofs.len();
        let want_tangent = wants != 0 && !e.linear;
        let force = &mut self.trial.force[e.force.clone()];
        let trial = &mut self.trial.history[e.state.clone()];
        let tangent = &mut work.tangents[tangent_at..tangent_at + n * n];
        // Elsewhere a tangent that nobody wants is made anew before it is used.
        let new_tangents = if e.rates { wants } else { ALL };
        let partly = lanes != ALL || want_tangent && new_tangents != ALL;
        if partly {
            work.saved.clear();
            work.saved.extend_from_slice(force);
            work.saved.extend_from_slice(trial);
            work.saved.extend(e.damping.iter().flat_map(|at| &work.damping[at.clone()]));
        }
        if want_tangent {
            for row in e.part.rows.among(n) {
                let row = &mut tangent[row * n..(row + 1) * n];
                if partly {
                    work.saved.extend_from_slice(row);
                }
                row.fill(Wide::all(0.0));
            }
        }
        force.fill(Wide::all(0.0));
        if let Some(at) = &e.damping {
            work.damping[at.clone()].fill(Wide::all(0.0));
        }
        let committed = &self.committed.history[e.state.clone()];
        let (time, dt) = (self.time, self.time - self.start);
        let vel = self.dynamics.is_some().then_some(&work.vel[..n]);
        let damping = e.damping.as_ref().map(|at| &mut work.damping[at.clone()]);
        let motion = LockstepMotion { disp: &work.disp[..n], vel, committed, dt, time, lanes };
        let tangent = want_tangent.then_some(&mut *tangent);
        let output = LockstepOutput { trial, force, tangent, damping, part: e.part };
        e.element.respond(motion, output);
        // Displacements, and in time velocities.
        let parts = 1 + usize::from(self.dynamics.is_some());
        if partly {
            let mut saved = work.saved.iter();
            let new = Wide::of_flags(lanes);
            restore(new, &mut saved, &mut self.trial.force[e.force.clone()]);
            restore(new, &mut saved, &mut self.trial.history[e.state.clone()]);
            if let Some(at) = &e.damping {
                restore(new, &mut saved, &mut work.damping[at.clone()]);
            }
            let with_tangents = Wide::of_flags(lanes & new_tangents);
            for row in e.part.rows.among(if want_tangent { n } else { 0 }) {
                let row = tangent_at + row * n..tangent_at + (row + 1) * n;
                restore(with_tangents, &mut saved, &mut work.tangents[row]);
            }
            for (old, motion) in work.evaluated.iter_mut().zip([&work.disp, &work.vel]).take(parts) {
                for (old, motion) in old[e.force.clone()].iter_mut().zip(motion) {
                    *old = new.where_equal(Wide::all(1.0), *motion, *old);
                }
            }
        } else {
            for (old, motion) in work.evaluated.iter_mut().zip([&work.disp, &work.vel]).take(parts) {
                old[e.force.clone()].copy_from_slice(&motion[..n]);
            }
        }
    }

    /// Note the models in which no force is left over.
    #[inline(always)]
    fn note_balance(&mut self) {
        let flags = &mut self.flags;
        flags.balanced = flags.is_factored;
        for b in &self.work.b {
            flags.balanced &= b.abs().at_most(Wide::all(0.0));
        }
    }

    /// Find the corrections, which are zero in `idle` models.
    #[inline(always)]
    fn solve(&mut self, idle: Flags) {
        self.work.x.fill(Wide::all(0.0));
        if idle == ALL {
            return;
        }
        let lack = !idle & !self.flags.is_current;
        if lack != 0 {
            self.respond(!lack, lack, true);
        }
        self.assemble();
        let work = &mut self.work;
        work.x.copy_from_slice(&work.b);
        if !work.wide_factors.solve(&work.matrix, &mut work.x, !idle) {
            self.solve_one_by_one(idle);
        }
        for x in &mut self.work.x {
            *x = x.where_flag(!idle, Wide::all(0.0));
        }
        self.flags.is_factored |= !idle;
    }

    /// Assemble the tangent.
    #[inline(always)]
    fn assemble(&mut self) {
        let work = &mut self.work;
        let c = self.dynamics.as_ref().map_or(0.0, |d| d.coefficients.c);
        work.matrix.copy_from_slice(&work.base);
        let mut at = 0;
        for (i, e) in self.elements.iter().enumerate() {
            let len = e.dofs.len().pow(2);
            if !e.linear {
                self.plan.add_element(i, &work.tangents[at..at + len], 1.0, &mut work.matrix);
                if !e.damping_in_tangent.is_empty() {
                    self.plan.add_element(i, &e.damping_in_tangent, 1.0, &mut work.matrix);
                }
                if let Some(damping) = e.damping.clone().filter(|_| c != 0.0) {
                    self.plan.add_element(i, &work.damping[damping], c, &mut work.matrix);
                }
            }
            at += len;
        }
    }

    /// Find the corrections model by model: rows are exchanged in some and not in others.
    fn solve_one_by_one(&mut self, idle: Flags) {
        let Work { matrix, b, x, factors, values, solution, .. } = &mut self.work;
        for lane in (0..WIDTH).filter(|lane| !is_set(idle, *lane)) {
            values.iter_mut().zip(&*matrix).for_each(|(own, all)| *own = all.0[lane]);
            solution.iter_mut().zip(&*b).for_each(|(own, all)| *own = all.0[lane]);
            match factors.factor(values) {
                Ok(_) => factors.solve(solution),
                Err(_) => solution.fill(f64::NAN),
            }
            x.iter_mut().zip(&*solution).for_each(|(all, own)| all.0[lane] = *own);
        }
    }

    /// Add the corrections and evaluate the elements after them, in models that are not `idle`.
    #[inline(always)]
    fn correct(&mut self, iteration: usize, idle: Flags) {
        if idle == ALL {
            return;
        }
        let mut expected = 0;
        for (lane, n) in self.flags.expected.iter().enumerate() {
            expected |= u8::from(*n == iteration) << lane;
        }
        if self.measure == Measure::DispIncr {
            let accepted = self.norm_of(&self.work.x).at_most(Wide::all(self.tolerance));
            self.work.slack = Wide::all(ROUND_OFF).where_flag(accepted, Wide::all(0.0));
        }
        for (x, &dof) in self.work.x.iter().zip(&self.plan.map.dof_of) {
            self.trial.disp[dof] += *x;
            if let Some(dynamics) = &self.dynamics {
                self.trial.vel[dof] += *x * dynamics.coefficients.c;
                self.trial.accel[dof] += *x * dynamics.coefficients.m;
            }
        }
        self.respond(idle, !idle & !expected, true);
        self.sum_forces();
    }

    /// Norm of a vector of each model.
    #[inline(always)]
    fn norm_of(&self, vector: &[Wide]) -> Wide {
        let mut sum = Wide::all(0.0);
        match (self.norm, vector) {
            (_, [x]) => sum = x.abs(),
            (Norm::Max, _) => {
                for x in vector {
                    sum = x.abs().larger(sum);
                }
            }
            _ => {
                for x in vector {
                    sum += *x * *x;
                }
                sum = sum.sqrt();
            }
        }
        sum
    }

    /// Let the models wait that pass the test, and those that fail.
    #[inline(always)]
    fn judge(&mut self, iteration: usize, waits: &mut Flags) {
        let work = &self.work;
        let norm = match self.measure {
            Measure::Unbalance => self.norm_of(&work.b),
            Measure::Energy => {
                let mut sum = Wide::all(0.0);
                for (x, b) in work.x.iter().zip(&work.b) {
                    sum += *x * *b;
                }
                sum.abs() * 0.5
            }
            _ => self.norm_of(&work.x),
        };
        let passed = norm.at_most(Wide::all(self.tolerance)) & !*waits;
        for (lane, n) in self.flags.expected.iter_mut().enumerate() {
            *n = if is_set(passed, lane) { iteration } else { *n };
        }
        *waits |= passed;
        let ends = if iteration >= self.max_iterations { ALL } else { norm.is_no_number() };
        self.failed |= ends & !*waits;
        *waits |= ends;
    }

    /// Commit the trial motion.
    #[inline(always)]
    fn commit(&mut self) {
        // Forces on supports that are no numbers are in no unbalance.
        let mut sum = Wide::all(0.0);
        for f in &self.trial.force {
            sum += *f * 0.0;
        }
        self.failed |= sum.is_no_number();
        if self.safe_displacement < f64::INFINITY {
            let limit = Wide::all(self.safe_displacement);
            for u in &self.trial.disp {
                self.failed |= !u.abs().at_most(limit);
            }
        }
        self.committed.disp.copy_from_slice(&self.trial.disp);
        if self.dynamics.is_some() {
            self.committed.vel.copy_from_slice(&self.trial.vel);
            self.committed.accel.copy_from_slice(&self.trial.accel);
        }
        self.committed.history.copy_from_slice(&self.trial.history);
    }
}

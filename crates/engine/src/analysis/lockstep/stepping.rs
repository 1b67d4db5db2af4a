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
        self.apply_loads(self.start + self.increment);
        self.flags.evaluated = 0;
        self.work.slack = Wide::all(0.0);
        self.respond(waits, wants, !self.imposed.is_empty());
        self.sum_forces();
        self.note_balance();
        for iteration in 1.. {
            let none = if iteration == 1 { self.flags.balanced } else { 0 };
            self.solve(waits | none);
            self.correct(iteration, waits | none);
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
        }
        for i in &self.imposed {
            self.trial.disp[i.dof] = i.initial + i.value * factor(i.pattern, i.constant);
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
            let mut lanes = if e.rates { !waits } else { considered };
            if self.flags.evaluated != 0 {
                lanes &= !(self.flags.evaluated & !tangents & self.has_not_moved(i));
            }
            if lanes != 0 {
                self.respond_one(i, tangent_at, lanes, wants != 0);
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
            let (new, old) = (self.work.disp[k], self.work.evaluated[e.force.start + k]);
            let limit = self.work.slack * old.abs();
            let by = (new - old).abs();
            near &= by.at_most(limit);
        }
        near
    }

    /// Evaluate an element in some models.
    #[inline(always)]
    fn respond_one(&mut self, i: usize, tangent_at: usize, lanes: Flags, want_tangent: bool) {
        let (e, work) = (&self.elements[i], &mut self.work);
        let n = e.dofs.len();
        let force = &mut self.trial.force[e.force.clone()];
        let trial = &mut self.trial.history[e.state.clone()];
        let tangent = &mut work.tangents[tangent_at..tangent_at + n * n];
        let partly = lanes != ALL;
        if partly {
            work.saved.clear();
            work.saved.extend_from_slice(force);
            work.saved.extend_from_slice(trial);
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
        let committed = &self.committed.history[e.state.clone()];
        let (time, dt) = (self.time, self.time - self.start);
        let motion = LockstepMotion { disp: &work.disp[..n], committed, dt, time, lanes };
        let output = LockstepOutput { trial, force, tangent: want_tangent.then_some(&mut *tangent), part: e.part };
        e.element.respond(motion, output);
        let evaluated = &mut work.evaluated[e.force.clone()];
        if partly {
            let mut saved = work.saved.iter();
            let new = Wide::of_flags(lanes);
            restore(new, &mut saved, &mut self.trial.force[e.force.clone()]);
            restore(new, &mut saved, &mut self.trial.history[e.state.clone()]);
            for row in e.part.rows.among(if want_tangent { n } else { 0 }) {
                let row = tangent_at + row * n..tangent_at + (row + 1) * n;
                restore(new, &mut saved, &mut work.tangents[row]);
            }
            for (old, disp) in evaluated.iter_mut().zip(&work.disp) {
                *old = new.where_equal(Wide::all(1.0), *disp, *old);
            }
        } else {
            evaluated.copy_from_slice(&work.disp[..n]);
        }
    }

    /// Sum loads and resisting forces to the unbalance.
    #[inline(always)]
    fn sum_forces(&mut self) {
        let map = &self.plan.map;
        for (b, &dof) in self.work.b.iter_mut().zip(&map.dof_of) {
            *b = self.work.nodal[dof];
        }
        self.plan.subtract_forces(&self.trial.force, &mut self.work.b);
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
        self.work.matrix.fill(Wide::all(0.0));
        let mut at = 0;
        for (i, e) in self.elements.iter().enumerate() {
            let len = e.dofs.len().pow(2);
            self.plan.add_element(i, &self.work.tangents[at..at + len], 1.0, &mut self.work.matrix);
            at += len;
        }
        if self.work.b.len() == 1 {
            let correction = self.work.b[0] / self.work.matrix[0];
            self.work.x[0] = correction.where_flag(!idle, Wide::all(0.0));
        } else {
            self.solve_one_by_one(idle);
        }
        self.flags.is_factored |= !idle;
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
                    sum = x.abs().max(sum);
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
        self.committed.history.copy_from_slice(&self.trial.history);
    }
}

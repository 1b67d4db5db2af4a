//! Steps of models side by side.

use super::{LockstepRows, Measure, Models, Norm, Recorded};
use crate::element::{LockstepMotion, LockstepOutput};
use crate::numeric::lanes::{Lanes, in_lanes};
use crate::numeric::wide::{WIDTH, Wide};
use std::sync::atomic::Ordering;

/// Displacements that differ by no more than this fraction differ by the round-off of a correction.
const ROUND_OFF: Wide = Wide::all(2.0 * f64::EPSILON);

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
                    Recorded::Force(i) => self.models.committed.force[i],
                });
            }
        }
    }
}

/// Factor matrices of `n` equations in place, in the order of the dense LU of the engine. A model whose rows are to be
/// exchanged fails: the others need not.
#[inline(always)]
fn eliminate(n: usize, a: &mut [Wide], failed: &mut [bool; WIDTH]) {
    for k in 0..n {
        let pivot = a[k * n + k];
        let inverse = Wide::all(1.0) / pivot;
        for i in k + 1..n {
            let first = a[i * n + k];
            for lane in 0..WIDTH {
                failed[lane] |= first.0[lane].abs() > pivot.0[lane].abs();
            }
            let f = first * inverse;
            a[i * n + k] = f;
            for j in k + 1..n {
                let p = a[k * n + j];
                a[i * n + j] -= f * p;
            }
        }
    }
}

/// Solve with the factors.
#[inline(always)]
fn substitute(n: usize, a: &[Wide], x: &mut [Wide]) {
    for i in 1..n {
        let mut sum = a[i * n] * x[0];
        for j in 1..i {
            sum += a[i * n + j] * x[j];
        }
        x[i] -= sum;
    }
    for i in (0..n).rev() {
        if i + 1 < n {
            let mut sum = a[i * n + i + 1] * x[i + 1];
            for j in i + 2..n {
                sum += a[i * n + j] * x[j];
            }
            x[i] -= sum;
        }
        x[i] = x[i] / a[i * n + i];
    }
}

impl Models {
    /// Make the steps of all models that do not fail. All fail where they are interrupted.
    pub(super) fn analyze(&mut self, steps: usize, recorded: &[Recorded], take: &mut dyn FnMut(&LockstepRows)) {
        let mut rows = LockstepRows::default();
        let mut made = 0;
        while made < steps && !self.failed.iter().all(|f| *f) {
            if self.interrupt.as_ref().is_some_and(|i| i.load(Ordering::Relaxed)) {
                self.failed = [true; WIDTH];
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

    /// Bring all models to balance at the end of the next step, as [`Newton`](crate::analysis::algorithm::Newton) does.
    #[inline(always)]
    fn step(&mut self) {
        self.start = self.time;
        self.apply_loads(self.start + self.increment);
        self.respond(!self.work.balanced);
        self.sum_forces();
        self.work.balanced = self.is_balanced();
        let mut waits = self.failed;
        for iteration in 1.. {
            if self.work.balanced && iteration == 1 {
                self.work.x.fill(Wide::all(0.0));
            } else {
                if !self.work.is_current {
                    self.respond(true);
                }
                self.solve(&waits);
                self.correct(iteration != self.work.expected);
            }
            self.judge(iteration, &mut waits);
            if waits.iter().all(|w| *w) {
                self.work.expected = iteration;
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

    /// Evaluate the elements at the trial displacements.
    #[inline(always)]
    fn respond(&mut self, want_tangent: bool) {
        let work = &mut self.work;
        let mut at = 0;
        for e in &self.elements {
            let n = e.dofs.len();
            for (own, &dof) in work.disp.iter_mut().zip(&e.dofs) {
                *own = self.trial.disp[dof as usize];
            }
            let force = &mut self.trial.force[e.force.clone()];
            force.fill(Wide::all(0.0));
            let tangent = &mut work.tangents[at..at + n * n];
            at += n * n;
            if want_tangent {
                for i in e.part.rows.among(n) {
                    tangent[i * n..(i + 1) * n].fill(Wide::all(0.0));
                }
            }
            let committed = &self.committed.history[e.state.clone()];
            let (time, dt) = (self.time, self.time - self.start);
            let motion = LockstepMotion { disp: &work.disp[..n], committed, dt, time };
            let trial = &mut self.trial.history[e.state.clone()];
            let tangent = want_tangent.then_some(tangent);
            e.element.respond(motion, LockstepOutput { trial, force, tangent, part: e.part });
        }
        work.is_current = want_tangent;
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

    /// Returns true if no force is left over in any model.
    #[inline(always)]
    fn is_balanced(&self) -> bool {
        let mut all = true;
        for b in &self.work.b {
            for x in b.0 {
                all &= x == 0.0;
            }
        }
        all
    }

    /// Find the corrections, which are zero for models that wait.
    #[inline(always)]
    fn solve(&mut self, waits: &[bool; WIDTH]) {
        let n = self.work.b.len();
        self.work.matrix.fill(Wide::all(0.0));
        let mut at = 0;
        for (i, e) in self.elements.iter().enumerate() {
            let len = e.dofs.len().pow(2);
            self.plan.add_element(i, &self.work.tangents[at..at + len], 1.0, &mut self.work.matrix);
            at += len;
        }
        let mut active = Wide::all(1.0);
        for (active, waits) in active.0.iter_mut().zip(waits) {
            *active = if *waits { 0.0 } else { 1.0 };
        }
        self.work.x.copy_from_slice(&self.work.b);
        let (a, x) = (&mut self.work.matrix[..n * n], &mut self.work.x[..n]);
        eliminate(n, a, &mut self.failed);
        substitute(n, a, x);
        // A model that waits may have no finite correction any more.
        for x in x {
            *x = active.where_equal(Wide::all(0.0), Wide::all(0.0), *x);
        }
    }

    /// Add the corrections, and evaluate the elements where they are more than round-off that the test accepts.
    #[inline(always)]
    fn correct(&mut self, want_tangent: bool) {
        let settled = self.measure == Measure::DispIncr && self.all_within(self.norm_of(&self.work.x));
        let slack = if settled { ROUND_OFF } else { Wide::all(0.0) };
        let mut moved = false;
        for (x, &dof) in self.work.x.iter().zip(&self.plan.map.dof_of) {
            let old = self.trial.disp[dof];
            let new = old + *x;
            let limit = slack * old.abs();
            let by = (new - old).abs();
            for (by, limit) in by.0.iter().zip(limit.0) {
                moved |= *by > limit;
            }
            self.trial.disp[dof] = new;
        }
        if moved {
            self.respond(want_tangent);
            self.sum_forces();
        }
    }

    /// Norm of a vector of each model.
    #[inline(always)]
    fn norm_of(&self, vector: &[Wide]) -> Wide {
        let mut sum = Wide::all(0.0);
        match (self.norm, vector) {
            (_, [x]) => return x.abs(),
            (Norm::Max, _) => vector.iter().for_each(|x| sum = x.abs().max(sum)),
            _ => {
                vector.iter().for_each(|x| sum += *x * *x);
                return sum.sqrt();
            }
        }
        sum
    }

    /// Returns true if a norm is within the tolerance in all models.
    #[inline(always)]
    fn all_within(&self, norm: Wide) -> bool {
        let mut all = true;
        for x in norm.0 {
            all &= x <= self.tolerance;
        }
        all
    }

    /// Let the models wait that pass the test, and those that fail.
    #[inline(always)]
    fn judge(&mut self, iteration: usize, waits: &mut [bool; WIDTH]) {
        let work = &self.work;
        let norm = match self.measure {
            Measure::Unbalance => self.norm_of(&work.b),
            Measure::Energy => {
                let mut sum = Wide::all(0.0);
                work.x.iter().zip(&work.b).for_each(|(x, b)| sum += *x * *b);
                sum.abs() * 0.5
            }
            _ => self.norm_of(&work.x),
        };
        for lane in 0..WIDTH {
            let passed = norm.0[lane] <= self.tolerance;
            let failed = !waits[lane] && !passed && (iteration >= self.max_iterations || norm.0[lane].is_nan());
            self.failed[lane] |= failed;
            waits[lane] |= passed | failed;
        }
    }

    /// Commit the trial motion.
    #[inline(always)]
    fn commit(&mut self) {
        // Forces on supports that are no numbers are in no unbalance.
        let mut sum = Wide::all(0.0);
        for f in &self.trial.force {
            sum += *f * 0.0;
        }
        for (failed, x) in self.failed.iter_mut().zip(sum.0) {
            *failed |= x != 0.0;
        }
        self.committed.disp.copy_from_slice(&self.trial.disp);
        self.committed.history.copy_from_slice(&self.trial.history);
        self.committed.force.copy_from_slice(&self.trial.force);
    }
}

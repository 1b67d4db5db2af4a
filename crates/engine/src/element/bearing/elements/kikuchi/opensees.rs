//! OpenSees' scheme for the inner nodes of a Kikuchi bearing, extrapolated on demand only.
//!
//! In each call, the inner nodes make one Newton step from the committed position. Stiffnesses and forces of the springs are
//! those of the last call, the geometry is that of the committed state. So the force depends on the number of calls and on the
//! size of the steps. With several bearings in a model, all take their geometry and their tangent from the last one: in
//! OpenSees, displacements and condensed stiffness are static members of the class.

use super::condensation::{Condensed, InnerSolution, condense, extrapolated, join, no_inner_stiffness, solution};
use super::kinematics::{INNER, Matrix, Motion, OUTER, Springs};
use super::{Balance, Factors, KikuchiBearing};
use crate::element::{CallDependent, ElementResult, Histories, MatrixMask, OpenSeesCall, SharedState};
use crate::material::MaterialError;
use crate::state_struct;
use crate::state_struct::StateStruct;

state_struct! {
    /// Springs and inner nodes after a call.
    pub(super) struct SpringState {
        /// Forces of the springs; those of the shear springs not yet multiplied by their factors.
        springs: Springs,
        /// Displacements of the inner nodes.
        inner: [f64; INNER],
    }
}

state_struct! {
    /// State variables besides the histories of the springs and the solution of the last call.
    struct Trace {
        /// Displacements of the ends in local axes.
        outer: [f64; 12],
        /// State at the begin of the next step.
        settled: SpringState,
        /// State at the begin of the next call of this step.
        last: SpringState,
        /// Number of steps; the trial state has one more after a call in this step.
        steps: f64,
        /// Factors of the shear springs in this step: of forces and of stiffnesses.
        factors: [f64; 2],
    }
}

state_struct! {
    /// Solution of a call.
    struct Solved {
        /// Solution for the inner nodes.
        solution: InnerSolution,
        /// Stiffness of the bearing, by rows.
        stiffness: [[f64; 12]; 12],
    }
}

state_struct! {
    /// Variables that OpenSees keeps once for all bearings of a model, as its last bearing leaves them.
    struct SharedVariables {
        /// Numbers of the step before and of the last one; zero where there is none.
        steps: [f64; 2],
        /// Displacements of ends and inner nodes at the end of these steps.
        motions: [[f64; 18]; 2],
        /// Condensed stiffness of the last call.
        stiffness: [[f64; 12]; 12],
    }
}

impl SharedVariables {
    /// The variables of a model; zero for a bearing outside of one.
    fn of(shared: &SharedState) -> Self {
        let mut words = [0.0; Self::LEN];
        words.iter_mut().zip(shared).for_each(|(word, cell)| *word = cell.get());
        Self::read(&words)
    }

    fn write_to(&self, shared: &SharedState) {
        let mut words = [0.0; Self::LEN];
        self.write(&mut words);
        shared.iter().zip(&words).for_each(|(cell, word)| cell.set(*word));
    }

    /// Take over a call of a step.
    fn set(&mut self, step: f64, motion: &Motion, stiffness: &[[f64; OUTER]; OUTER]) {
        if self.steps[1] != step {
            (self.steps[0], self.motions[0]) = (self.steps[1], self.motions[1]);
        }
        (self.steps[1], self.motions[1]) = (step, (*motion).into());
        self.stiffness = *stiffness;
    }

    /// Displacements at the end of a step.
    fn motion(&self, step: f64) -> Option<Motion> {
        let at = self.steps.iter().position(|s| *s == step && step > 0.0)?;
        Some(Motion::from_column_slice(&self.motions[at]))
    }

    /// Stiffness of the last call, after the first one.
    fn stiffness(&self) -> Option<[[f64; OUTER]; OUTER]> {
        (self.steps[1] > 0.0).then_some(self.stiffness)
    }
}

/// Axial deformation at mid-height in a committed state.
pub(super) fn axial_deformation(state: &[f64]) -> f64 {
    Trace::read(state).settled.springs.axial
}

/// Number of state variables besides the histories of the springs.
pub(super) const HEADER: usize = <Trace as StateStruct>::LEN + <Solved as StateStruct>::LEN;

/// The solution lies behind the trace.
const SOLVED_AT: usize = <Trace as StateStruct>::LEN;

impl KikuchiBearing {
    /// Write the state at rest.
    pub(super) fn write_virgin_trace(&self, state: &mut [f64]) {
        let factors = self.virgin_factors;
        let call = SpringState { springs: self.virgin_springs(1.0), inner: [0.0; INNER] };
        Trace { settled: call, last: call, factors: [factors.force, factors.stiffness], ..Trace::default() }
            .write(state);
        // OpenSees works out its first stiffness before it knows the height.
        let mut flat = self.clone();
        flat.kinematics.half = 0.0;
        let stiffness = flat.virgin_condensed(factors.stiffness).map_or_else(Default::default, |c| c.stiffness);
        Solved { stiffness, ..Solved::default() }.write(&mut state[SOLVED_AT..]);
    }

    /// Forces at the ends and OpenSees' tangent, in local axes, for displacements of the ends.
    ///
    /// # Errors
    /// The springs hold the inner nodes no longer, or a spring finds no force.
    pub(super) fn follow_opensees(
        &self,
        outer: [f64; OUTER],
        h: &mut Histories<'_>,
        dt: f64,
        (balance, call): (Balance, Option<OpenSeesCall<'_>>),
    ) -> ElementResult<([f64; OUTER], [[f64; OUTER]; OUTER])> {
        let old = Trace::read(h.committed);
        let now = Trace::read(h.trial);
        let begin = old.settled;
        let from = join(&old.outer, &begin.inner);
        let mut shared = call.map(|c| SharedVariables::of(c.shared)).unwrap_or_default();
        let geometry = shared.motion(old.steps).unwrap_or(from);
        let row = self.kinematics.axial_row(&geometry);

        // The inner nodes are extrapolated from the committed state and corrected for the residual of the last call. The solution
        // of a call in this step belongs to the next call.
        let first = now.steps == old.steps;
        let (factors, InnerSolution { follow, correction }) = if first {
            let factors = self.factors_of_step(&old, h)?;
            let (forces, stiffness) = self.equations(&from, &self.scaled(&begin, factors), &row);
            (factors, solution(&forces, &stiffness, &self.hold).ok_or_else(no_inner_stiffness)?)
        } else {
            let factors = Factors { force: now.factors[0], stiffness: now.factors[1], slope: 0.0 };
            (factors, InnerSolution::read(&h.trial[SOLVED_AT..]))
        };
        let step: [f64; OUTER] = std::array::from_fn(|i| outer[i] - old.outer[i]);
        let inner =
            extrapolated(follow.as_flattened(), &std::array::from_fn(|i| begin.inner[i] + correction[i]), &step);

        let q = join(&outer, &inner);
        let axial = begin.springs.axial + row.dot(&(q - from));
        let springs = self.springs(h, &q, Factors::ONE, axial, dt)?;
        let springs = SpringState { springs, inner };
        let c = self.condensed(&q, &self.scaled(&springs, factors), &row)?;
        let mut force = c.force;
        if let Some(shares) = self.shares {
            take_off_p_delta(&(geometry + join(&step, &[0.0; INNER])), shares, &mut force);
        }

        let settled = self.settle(&outer, springs, factors, balance, h, dt)?;
        if let Some(call) = call.filter(|c| c.last_of_class) {
            shared.set(old.steps + 1.0, &join(&outer, &settled.inner), &c.stiffness);
            shared.write_to(call.shared);
        }
        let factors = [factors.force, factors.stiffness];
        Trace { outer, settled, last: springs, steps: old.steps + 1.0, factors }.write(h.trial);
        Solved { solution: c.solution, stiffness: c.stiffness }.write(&mut h.trial[SOLVED_AT..]);
        Ok((force, c.stiffness))
    }

    /// Factors of the shear springs in the step from a committed state.
    fn factors_of_step(&self, old: &Trace, h: &mut Histories<'_>) -> Result<Factors, MaterialError> {
        if old.steps == 0.0 {
            return Ok(self.virgin_factors);
        }
        let [v, w] = self.offset(&old.outer);
        self.shear.factors(v.hypot(w), h)
    }

    /// Corrections of `-doBalance` when the step of a call is committed.
    fn settle(
        &self,
        outer: &[f64; OUTER],
        mut call: SpringState,
        factors: Factors,
        balance: Balance,
        h: &mut Histories<'_>,
        dt: f64,
    ) -> ElementResult<SpringState> {
        for _ in 0..balance.rounds {
            let q = join(outer, &call.inner);
            let row = self.kinematics.axial_row(&q);
            let c = self.condensed(&q, &self.scaled(&call, factors), &row)?;
            let inner: [f64; INNER] = std::array::from_fn(|i| call.inner[i] + c.solution.correction[i]);
            let to = join(outer, &inner);
            let axial = call.springs.axial + row.dot(&(to - q));
            let springs = self.springs(h, &to, Factors::ONE, axial, dt)?;
            call = SpringState { springs, inner };
            let left = self.kinematics.forces(&to, &self.scaled(&call, factors), &row);
            if left.fixed_rows::<INNER>(OUTER).iter().all(|f| f.abs() <= balance.tolerance) {
                break;
            }
        }
        Ok(call)
    }

    /// The springs of a call, those in shear multiplied by their factors.
    fn scaled(&self, call: &SpringState, factors: Factors) -> Springs {
        let mut s = call.springs;
        s.shear = s.shear.map(|f| f * factors.force);
        s.shear_stiffness = s.shear_stiffness.map(|k| k * factors.stiffness);
        s
    }

    fn condensed(&self, q: &Motion, springs: &Springs, row: &Motion) -> ElementResult<Condensed> {
        let (forces, stiffness) = self.equations(q, springs, row);
        condense(&forces, &stiffness, &self.hold).ok_or_else(no_inner_stiffness)
    }

    /// Forces and stiffness of all degrees of freedom.
    fn equations(&self, q: &Motion, springs: &Springs, row: &Motion) -> (Motion, Matrix) {
        (self.kinematics.forces(q, springs, row), self.kinematics.stiffness(springs, row, row))
    }
}

impl CallDependent for KikuchiBearing {
    fn shared_len(&self) -> usize {
        SharedVariables::LEN
    }
    fn last_tangent(&self, history: &[f64], shared: &SharedState, tangent: &mut [f64], part: MatrixMask) {
        let shared = SharedVariables::of(shared).stiffness();
        let stiffness = shared.unwrap_or_else(|| Solved::read(&history[SOLVED_AT..]).stiffness);
        self.add_global(&stiffness, tangent, part.rows);
    }
}

/// Take the P-Delta moments off the end moments as OpenSees does: each at the axis of the other displacement.
fn take_off_p_delta(q: &Motion, shares: [f64; 2], force: &mut [f64; OUTER]) {
    let pressure = -force[6];
    for (end, share) in shares.into_iter().enumerate() {
        force[6 * end + 4] -= share * pressure * (q[7] - q[1]);
        force[6 * end + 5] += share * pressure * (q[8] - q[2]);
    }
}

//! OpenSees' scheme for the inner nodes of a Kikuchi bearing, followed on demand only.
//!
//! Each time the element is asked, its inner nodes make one Newton step from the committed position, with stiffnesses and
//! forces of the springs as the last call left them and with the geometry of the committed state. So the answer depends
//! on how often it is asked, and on the size of the steps; with several bearings, on the one that is asked last.

use super::condensation::{Condensed, Yielding, condense, followed, held_by_nothing, join, yielding};
use super::kinematics::{INNER, Matrix, Motion, OUTER, Springs};
use super::{Balance, Common, Factors, KikuchiBearing};
use crate::element::ElementError;
use crate::material::MaterialError;
use crate::state_struct;
use crate::state_struct::StateStruct;

state_struct! {
    /// Springs and inner nodes as a call left them.
    pub(super) struct Call {
        /// Forces of the springs; those of the shear springs not yet multiplied by their factors.
        springs: Springs,
        /// Displacements of the inner nodes.
        inner: [f64; INNER],
    }
}

state_struct! {
    /// What a bearing keeps besides the histories of its springs and what it has solved for.
    struct Trace {
        /// Displacements of the ends in local axes.
        outer: [f64; 12],
        /// What the next step begins with.
        settled: Call,
        /// What the next call of this step begins with.
        last: Call,
        /// Number of steps made: those of the trial state are one more if it has been asked in this step.
        steps: f64,
        /// Factors of the shear springs in this step: of forces and of stiffnesses.
        factors: [f64; 2],
    }
}

state_struct! {
    /// Equations that a call has solved.
    struct Solved {
        /// What the inner nodes do.
        yielding: Yielding,
        /// Stiffness of the bearing, by rows.
        stiffness: [[f64; 12]; 12],
    }
}

/// Axial deformation at mid-height in a committed state.
pub(super) fn axial_deformation(state: &[f64]) -> f64 {
    Trace::read(state).settled.springs.axial
}

/// Number of words that a bearing keeps besides the histories of its springs.
pub(super) const HEADER: usize = <Trace as StateStruct>::LEN + <Solved as StateStruct>::LEN;

/// What has been solved begins behind the trace.
const SOLVED_AT: usize = <Trace as StateStruct>::LEN;

impl KikuchiBearing {
    /// Write the state at rest.
    pub(super) fn write_virgin_trace(&self, state: &mut [f64]) {
        let factors = self.virgin_factors;
        let call = Call { springs: self.virgin_springs(1.0), inner: [0.0; INNER] };
        Trace { settled: call, last: call, factors: [factors.force, factors.stiffness], ..Trace::default() }
            .write(state);
        // OpenSees works out its first stiffness before it knows the height.
        let mut flat = self.clone();
        flat.kinematics.half = 0.0;
        let stiffness = flat.virgin_condensed(factors.stiffness).map_or_else(Default::default, |c| c.stiffness);
        Solved { stiffness, ..Solved::default() }.write(&mut state[SOLVED_AT..]);
    }

    /// Forces at the ends and the tangent that OpenSees uses, in local axes, for displacements of the ends.
    ///
    /// # Errors
    /// The springs hold the inner nodes no longer, or a spring has no answer.
    pub(super) fn follow_opensees(
        &self,
        outer: [f64; OUTER],
        committed: &[f64],
        dt: f64,
        (balance, common): (Balance, &Common),
        trial: &mut [f64],
    ) -> Result<([f64; OUTER], [[f64; OUTER]; OUTER]), ElementError> {
        let old = Trace::read(committed);
        let now = Trace::read(trial);
        let begin = old.settled;
        let from = join(&old.outer, &begin.inner);
        let row = self.kinematics.axial_row(&common.motion(old.steps).unwrap_or(from));

        // The inner nodes follow the ends, and yield to what the last call left over. What a call of this step has solved
        // is what the next one begins with.
        let first = now.steps == old.steps;
        let (factors, Yielding { follow, correction }) = if first {
            let factors = self.factors_of_step(&old, committed, trial)?;
            let (forces, stiffness) = self.equations(&from, &self.scaled(&begin, factors), &row);
            (factors, yielding(&forces, &stiffness, &self.hold).ok_or_else(held_by_nothing)?)
        } else {
            let factors = Factors { force: now.factors[0], stiffness: now.factors[1], slope: 0.0 };
            (factors, Yielding::read(&trial[SOLVED_AT..]))
        };
        let step: [f64; OUTER] = std::array::from_fn(|i| outer[i] - old.outer[i]);
        let inner = followed(follow.as_flattened(), &std::array::from_fn(|i| begin.inner[i] + correction[i]), &step);

        let q = join(&outer, &inner);
        let axial = begin.springs.axial + row.dot(&(q - from));
        let springs = self.springs(committed, &q, Factors::ONE, axial, dt, trial)?;
        let call = Call { springs, inner };
        let c = self.condensed(&q, &self.scaled(&call, factors), &row)?;
        let mut force = c.force;
        if let Some(shares) = self.shares {
            let geometry = common.motion(old.steps).unwrap_or(from);
            take_off_p_delta(&(geometry + join(&step, &[0.0; INNER])), shares, &mut force);
        }

        let settled = self.settle(&outer, call, factors, balance, committed, dt, trial)?;
        common.leave(self.number, old.steps + 1.0, join(&outer, &settled.inner), &c.stiffness);
        let factors = [factors.force, factors.stiffness];
        Trace { outer, settled, last: call, steps: old.steps + 1.0, factors }.write(trial);
        Solved { yielding: c.yielding, stiffness: c.stiffness }.write(&mut trial[SOLVED_AT..]);
        Ok((force, c.stiffness))
    }

    /// Factors of the shear springs in the step from a committed state.
    fn factors_of_step(&self, old: &Trace, committed: &[f64], trial: &mut [f64]) -> Result<Factors, MaterialError> {
        if old.steps == 0.0 {
            return Ok(self.virgin_factors);
        }
        let [v, w] = self.offset(&old.outer);
        self.shear.factors(v.hypot(w), committed, trial)
    }

    /// What `-doBalance` makes of a call when its step is committed.
    #[allow(clippy::too_many_arguments)]
    fn settle(
        &self,
        outer: &[f64; OUTER],
        mut call: Call,
        factors: Factors,
        balance: Balance,
        committed: &[f64],
        dt: f64,
        trial: &mut [f64],
    ) -> Result<Call, ElementError> {
        for _ in 0..balance.rounds {
            let q = join(outer, &call.inner);
            let row = self.kinematics.axial_row(&q);
            let c = self.condensed(&q, &self.scaled(&call, factors), &row)?;
            let inner: [f64; INNER] = std::array::from_fn(|i| call.inner[i] + c.yielding.correction[i]);
            let to = join(outer, &inner);
            let axial = call.springs.axial + row.dot(&(to - q));
            let springs = self.springs(committed, &to, Factors::ONE, axial, dt, trial)?;
            call = Call { springs, inner };
            let left = self.kinematics.forces(&to, &self.scaled(&call, factors), &row);
            if left.fixed_rows::<INNER>(OUTER).iter().all(|f| f.abs() <= balance.tolerance) {
                break;
            }
        }
        Ok(call)
    }

    /// The springs of a call, those in shear multiplied by their factors.
    fn scaled(&self, call: &Call, factors: Factors) -> Springs {
        let mut s = call.springs;
        s.shear = s.shear.map(|f| f * factors.force);
        s.shear_stiffness = s.shear_stiffness.map(|k| k * factors.stiffness);
        s
    }

    fn condensed(&self, q: &Motion, springs: &Springs, row: &Motion) -> Result<Condensed, ElementError> {
        let (forces, stiffness) = self.equations(q, springs, row);
        condense(&forces, &stiffness, &self.hold).ok_or_else(held_by_nothing)
    }

    /// Forces and stiffness of all degrees of freedom.
    fn equations(&self, q: &Motion, springs: &Springs, row: &Motion) -> (Motion, Matrix) {
        (self.kinematics.forces(q, springs, row), self.kinematics.stiffness(springs, row, row))
    }

    /// The tangent that OpenSees has after the last call, from the state that it left.
    pub(super) fn last_stiffness(&self, state: &[f64]) -> [[f64; OUTER]; OUTER] {
        Solved::read(&state[SOLVED_AT..]).stiffness
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

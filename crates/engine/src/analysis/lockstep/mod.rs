//! Analyses of several models that differ in numbers alone, step by step side by side in vector instructions.
//!
//! The models of a calibration come from one script with different parameters. Their analyses make the same steps here: each number of the engine becomes [`WIDTH`] numbers, one a model. A model that has converged waits for the others;
//! one that fails is left to be analysed by itself. The numbers of a model do not depend on the others.

mod dynamics;
mod setup;
mod stepping;

use super::convergence::{Measure, Norm};
use super::engine::Engine;
use crate::assembly::Plan;
use crate::element::{LockstepElement, MatrixMask};
use crate::model::Drive;
use crate::numeric::wide::{ALL, Flags, WIDTH, Wide, is_set};
use crate::solve::{DenseLu, WideLu};
use dynamics::Dynamics;
use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// A number of the committed state that is recorded after each step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Recorded {
    /// Displacement of a degree of freedom.
    Disp(usize),
    /// Velocity of a degree of freedom.
    Vel(usize),
    /// Its acceleration, relative to the ground.
    Accel(usize),
    /// Entry of the forces of all elements, as [`State::force`](super::State) has them.
    Force(usize),
}

/// Recorded numbers of some steps.
#[derive(Debug, Default)]
pub struct LockstepRows {
    /// Domain time after each step.
    pub times: Vec<f64>,
    /// Recorded numbers of all models, step by step.
    pub numbers: Vec<Wide>,
}

/// Make steps of up to [`WIDTH`] models side by side, whose engines come to the end of them. Steps of a transient analysis
/// have the length `dt`. `take` receives the recorded numbers of the steps, some steps at a time; what it receives of a model
/// that fails is worth nothing.
///
/// Returns true for each model that has failed: its engine is left as it was, and its analysis is to be made by itself.
/// `None` where the models or their analyses are not made for it, and nothing has changed then: everything but steps of
/// load control, or of Newmark's method for displacements, by Newton's method under a simple test, single-point constraints,
/// equations few enough for a dense matrix, and elements that have a [`LockstepElement`] and no Rayleigh damping by
/// stiffness that changes.
pub fn lockstep(
    engines: &mut [&mut Engine],
    (steps, dt): (usize, f64),
    recorded: &[Recorded],
    take: &mut dyn FnMut(&LockstepRows),
) -> Option<[bool; WIDTH]> {
    let mut models = Models::new(engines, dt)?;
    models.analyze(steps, recorded, take);
    for (lane, engine) in engines.iter_mut().enumerate().filter(|(lane, _)| !is_set(models.failed, *lane)) {
        models.finish(lane, engine, steps);
    }
    Some(std::array::from_fn(|lane| is_set(models.failed, lane)))
}

/// A force on a degree of freedom.
#[derive(Debug)]
struct LoadTerm {
    dof: usize,
    pattern: usize,
    value: Wide,
    constant: bool,
}

/// A displacement imposed on a degree of freedom.
#[derive(Debug)]
struct ImposedTerm {
    dof: usize,
    pattern: usize,
    initial: Wide,
    value: Wide,
    constant: bool,
    /// Velocity and acceleration are imposed too.
    rates: bool,
}

/// An element of all models.
#[derive(Debug)]
struct Entry {
    element: Box<dyn LockstepElement>,
    dofs: Vec<u32>,
    /// Its part of the histories.
    state: Range<usize>,
    /// Its part of the forces.
    force: Range<usize>,
    part: MatrixMask,
    /// The force depends on velocities or on the time that passes.
    rates: bool,
    /// The tangent never changes, and is part of the constant entries.
    linear: bool,
    /// Place of the damping matrix of viscous materials.
    damping: Option<Range<usize>>,
    /// Constant damping matrix in the tangent, n x n by rows; empty where there is none.
    damping_in_tangent: Vec<Wide>,
}

/// Models side by side, with their analyses.
#[derive(Debug)]
struct Models {
    plan: Plan,
    elements: Vec<Entry>,
    drives: Vec<Drive>,
    factors: Vec<f64>,
    /// Patterns with loads.
    loaded: Vec<bool>,
    loads: Vec<LoadTerm>,
    imposed: Vec<ImposedTerm>,
    measure: Measure,
    norm: Norm,
    tolerance: f64,
    max_iterations: usize,
    /// Step of the load factor, or of time.
    increment: f64,
    /// `None` in a static analysis.
    dynamics: Option<Dynamics>,
    /// Time of the trial state, and of the committed one.
    time: f64,
    start: f64,
    /// Committed motion and histories; the forces are those of the beginning.
    committed: Motion,
    /// Trial motion, histories and forces.
    trial: Motion,
    work: Work,
    flags: Course,
    /// Displacements beyond it may be more than a law bears, which an analysis by itself finds out.
    safe_displacement: f64,
    /// Stops all of them.
    interrupt: Option<Arc<AtomicBool>>,
    failed: Flags,
}

/// Motion, histories and forces of all models.
#[derive(Clone, Debug, Default)]
struct Motion {
    disp: Vec<Wide>,
    vel: Vec<Wide>,
    accel: Vec<Wide>,
    history: Vec<Wide>,
    force: Vec<Wide>,
}

/// Buffers of a step.
#[derive(Debug)]
struct Work {
    /// Loads on all degrees of freedom.
    nodal: Vec<Wide>,
    /// Loads less inertia and damping of the nodes.
    full: Vec<Wide>,
    /// Unbalance.
    b: Vec<Wide>,
    /// Correction.
    x: Vec<Wide>,
    matrix: Vec<Wide>,
    /// Constant entries of the matrix.
    base: Vec<Wide>,
    /// Factors of all models that exchange the same rows.
    wide_factors: WideLu,
    /// Factors, matrix and correction of one model.
    factors: DenseLu,
    values: Vec<f64>,
    solution: Vec<f64>,
    /// Displacements of an element, and its velocities.
    disp: Vec<Wide>,
    vel: Vec<Wide>,
    /// Tangents of the elements, one after the other.
    tangents: Vec<Wide>,
    /// Damping matrices of viscous elements, one after the other.
    damping: Vec<Wide>,
    /// Displacements and velocities at the last evaluation of each element, laid out as the forces.
    evaluated: [Vec<Wide>; 2],
    /// Part of a displacement by which it has not moved.
    slack: Wide,
    /// Numbers of models that are not evaluated with others.
    saved: Vec<Wide>,
}

/// Course of the analysis in each model.
#[derive(Debug)]
struct Course {
    /// The tangents belong to the trial motion.
    is_current: Flags,
    /// The elements have been evaluated in this step.
    evaluated: Flags,
    /// There has been a tangent.
    is_factored: Flags,
    /// The last step was in balance as it began.
    balanced: Flags,
    /// Iterations of the last step: the next is expected to take as many.
    expected: [usize; WIDTH],
}

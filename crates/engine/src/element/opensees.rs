//! Differences between an element and its counterpart in OpenSees that the analysis has to follow.
//!
//! The analysis reads them under `--compat opensees` only.

use super::MatrixMask;
use std::cell::Cell;
use std::fmt;

/// Differences of one element; the default is an element without any.
#[derive(Clone, Copy, Debug, Default)]
pub struct OpenSeesTraits<'a> {
    /// The scheme of an element whose force depends on the number of calls in a step. OpenSees updates such an element a
    /// fixed number of times per iteration, and the analysis repeats that number.
    pub calls: Option<&'a dyn CallDependent>,
    /// The current tangent replaces the initial one in algorithms and in damping.
    pub initial_is_current: bool,
    /// Rayleigh damping is in the forces, and not in the tangent.
    pub damps_in_forces_only: bool,
    /// Damping in proportion to the committed stiffness keeps the tangent of the first step. Without this, the tangent is
    /// taken anew at the end of every step.
    pub keeps_first_damping: bool,
    /// Mass and damping matrix are the current tangent, in tangents and modes but not in forces.
    pub stiffness_as_mass: bool,
    /// Number of times that the equations of motion count the inertia of the element's mass under a uniform ground motion.
    /// OpenSees takes that inertia off the reported force of the element. `None` for an element that does neither.
    pub ground_inertia: Option<f64>,
}

impl OpenSeesTraits<'_> {
    /// Of an element whose mass, if it has any, is counted once.
    pub(crate) fn of_mass(has_mass: bool) -> Self {
        Self { ground_inertia: has_mass.then_some(1.0), ..Self::default() }
    }
}

/// State variables that the elements of a class share: static members of the class in OpenSees. They are zero in a new
/// model, and are empty where an element is evaluated outside of an analysis.
pub type SharedState = [Cell<f64>];

/// A call of a [`CallDependent`] element.
#[derive(Clone, Copy, Debug)]
pub struct OpenSeesCall<'a> {
    /// The call before had the same motion.
    pub repeated: bool,
    /// The element is the last of its class in the model.
    pub last_of_class: bool,
    /// State variables of the class.
    pub shared: &'a SharedState,
}

/// An element whose trial state depends on the trial state of the call before, and so on the number of calls in a step.
pub trait CallDependent: fmt::Debug {
    /// Number of state variables that the elements of the class share.
    fn shared_len(&self) -> usize {
        0
    }

    /// Tangent of the last call, from the trial history of that call. Wanted rows of n x n are added to a zero matrix.
    fn last_tangent(&self, history: &[f64], shared: &SharedState, tangent: &mut [f64], part: MatrixMask);

    /// Update the force of the last call for the load variables `load`, where the loads act without a call.
    fn last_force(&self, _history: &[f64], _load: &[f64], _force: &mut [f64]) {}
}

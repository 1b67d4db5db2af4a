//! Differences between an element and its counterpart in OpenSees that the analysis has to follow.
//!
//! The analysis reads them under `--compat opensees` only.

use super::MatrixMask;

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
    /// Number of times that the equations of motion count the inertia of the element's mass under a uniform ground motion.
    /// OpenSees takes that inertia off the reported force of the element. `None` for an element that does neither.
    pub ground_inertia: Option<f64>,
}

/// An element whose trial state depends on the trial state of the call before, and so on the number of calls in a step.
pub trait CallDependent: std::fmt::Debug {
    /// Tangent of the last call, from the trial history of that call. Wanted rows of n x n are added to a zero matrix.
    fn last_tangent(&self, history: &[f64], tangent: &mut [f64], part: MatrixMask);
}

//! Counts of the work of an engine.

use super::engine::Engine;

/// Counts of the work that an engine has done since it was made, over all its models and analyses.
///
/// They do not depend on the machine's speed, so that tests can pin them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WorkCounts {
    /// Committed steps, those that the script asked for: parts of a step count as one.
    pub steps: u64,
    /// Iterations of the solution algorithms in converged steps.
    pub iterations: u64,
    /// Factorisations of the system matrix, those for eigenvalues included.
    pub factorizations: u64,
    /// State determinations: calls of [`Element::respond`](crate::element::Element::respond).
    pub element_calls: u64,
}

impl Engine {
    /// Counts of the work so far. Neither `wipe` nor `reset` sets them back.
    pub fn work_counts(&self) -> WorkCounts {
        let mut counts = WorkCounts { steps: self.steps, iterations: self.iterations, ..self.earlier_work };
        if let Some(prepared) = self.prepared() {
            counts.factorizations += prepared.solver.factorizations;
            counts.element_calls += prepared.evaluated.calls;
        }
        counts
    }
}

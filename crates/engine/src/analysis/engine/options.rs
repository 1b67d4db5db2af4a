//! Settings of an engine.

use crate::analysis::recovery::RecoveryStrategy;
use crate::solve::Threads;

/// Settings that hold for all analyses of an engine.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Reproduce the known errors of OpenSees.
    pub compat: bool,
    /// Strategy for a step that fails.
    pub ladder: Option<RecoveryStrategy>,
    /// Force a dense matrix, or a sparse one.
    pub dense: Option<bool>,
    /// Parts that each step of an analysis is made in, for the error of its steps to be seen. With more than one, tests are
    /// to be passed with a hundredth of their tolerance too. 0 is 1.
    pub refine: u32,
    /// Threads that work on a large model.
    pub threads: Threads,
}

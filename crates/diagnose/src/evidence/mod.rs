//! How much recordings speak for candidates.

pub(crate) mod holdout;
pub mod likelihood;
pub(crate) mod parametric_bootstrap;
pub(crate) mod probabilities;

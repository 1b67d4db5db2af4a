//! What a fit leaves.

pub(crate) mod drift;
pub mod noise;
pub(crate) mod recurrence;
pub(crate) mod regression;
pub(crate) mod surrogates;
pub(crate) mod unmodelled_structure;

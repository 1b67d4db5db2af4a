//! Fits of candidates to the recordings.

pub(crate) mod alternative_forms;
pub(crate) mod checkpoint;
pub(crate) mod evaluator;
pub(crate) mod projection;
pub(crate) mod scheduler;
pub(crate) mod screening;
pub(crate) mod step_error;
pub(crate) mod two_effect_search;

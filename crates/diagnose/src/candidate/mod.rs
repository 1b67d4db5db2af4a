//! Changes of a model or of a channel that are tried.

pub(crate) mod repaired_script;
pub mod sensor_fault;
pub mod variant;

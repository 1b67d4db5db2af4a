//! Candidates: changes of the model or of a recorded channel that may explain a misfit.
//!
//! - [`proposal`]: commands or channel faults with their parameters, as a hypothesis proposes them
//! - [`channel_fault`]: gain, offset, delay, drift and clipping of a channel
//! - [`variant`]: a study with a proposal in it, and its simulator
//! - [`repaired_script`]: the script with fitted values
//! - [`opensees_form`]: the same in OpenSees' standard commands

pub(crate) mod channel_fault;
pub(crate) mod opensees_form;
pub(crate) mod proposal;
pub(crate) mod repaired_script;
pub(crate) mod variant;

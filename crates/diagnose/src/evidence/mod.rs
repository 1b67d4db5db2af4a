//! Evidence of recordings for fitted hypotheses.
//!
//! - [`likelihood`]: log evidence from whitened held-out residuals
//! - [`ranking`]: prior odds, and the order of hypotheses
//! - [`parametric_bootstrap`]: gains on simulated recordings of a known cause
//! - [`holdout`]: the judgement of runs held out
//! - `look_alike_limits`: a fault of a sensor beside an effect that explains as much, and causes that are one model
//! - [`memory_evidence`]: kinds of memory of a device, and the noise of the recordings
//! - [`repeated_motion`]: log evidence from what differs where a motion repeats
//! - [`repair_limits`]: limits by the share of the error that a repair takes, and by kinds of memory
//! - [`second_effect`]: the second effect of a pair
//! - [`verdict_evidence`]: everything that the verdict weighs, as it is written down
//! - [`verdict_model`]: probabilities from that evidence
//! - `verdict_weights`: the fitted weights
//!
//! Constants stand in `prior.rs`; scales of features stand beside them.

pub(crate) mod holdout;
pub(crate) mod likelihood;
mod look_alike_limits;
pub(crate) mod memory_evidence;
pub(crate) mod parametric_bootstrap;
pub(crate) mod ranking;
pub(crate) mod repair_limits;
pub(crate) mod repeated_motion;
pub(crate) mod second_effect;
pub(crate) mod verdict_evidence;
pub mod verdict_model;
mod verdict_weights;

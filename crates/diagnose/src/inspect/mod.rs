//! Inspection of a model and its recordings before anything is fitted.
//!
//! - [`inventory`]: devices, supports, masses and frame members of the model
//! - [`device_axes`]: axial and lateral directions of devices
//! - [`frame_members`]: columns and girders
//! - [`adjacent_structures`]: structures and spans that could collide
//! - [`heights`]: heights that count as one
//! - [`response`]: motion and force of devices, and their ranges
//! - [`probe`]: the runs that give inventory and responses
//! - [`insertion`]: the place of further commands in a script
//! - [`conditions`]: temperatures, axial loads and amplitudes of the runs
//! - [`auxiliary_channels`]: recorded temperatures and axial forces that no channel observes
//! - [`dominant_period`]: the period in which most of what a model leaves swings
//! - [`saturation`]: channels that stay at their ends

pub(crate) mod adjacent_structures;
pub(crate) mod auxiliary_channels;
pub(crate) mod conditions;
pub(crate) mod device_axes;
pub(crate) mod dominant_period;
pub(crate) mod frame_members;
pub(crate) mod heights;
pub(crate) mod insertion;
pub(crate) mod inventory;
pub(crate) mod levels;
pub(crate) mod probe;
pub(crate) mod response;
pub(crate) mod saturation;

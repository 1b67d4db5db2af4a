//! Commands that set up and run an analysis.

pub(crate) mod algorithm;
pub(crate) mod analyze;
pub(crate) mod damping;
mod failure;
pub(crate) mod integrator;
mod massless_floors;
pub(crate) mod matrix;
pub(crate) mod modal_damping;
pub(crate) mod modal_properties;
mod numerics;
pub(crate) mod plausibility;
pub(crate) mod response_spectrum;
pub(crate) mod single_degree;
pub(crate) mod solution;
pub(crate) mod speeds;
mod unloaded_bearings;

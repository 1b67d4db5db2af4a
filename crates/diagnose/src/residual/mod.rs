//! Structure of residuals: the part that no steady sensor noise has.
//!
//! - [`spectral_lines`]: lines of a spectrum
//! - [`bursts`]: stretches of excess power
//! - [`surrogates`]: comparison with steady noise of the same spectrum
//! - [`regression`]: cross-validated regression
//! - [`recurrence`]: forces that recur at the same deformation
//! - `sensor_noise`: noise that grows with the reading, and rounding
//! - [`motion_regressors`]: functions of the motion of devices
//! - [`unmodelled_structure`]: all of these for the fitted runs
//! - [`drift`]: drift of a channel against slow noise

pub(crate) mod bursts;
pub(crate) mod drift;
pub(crate) mod motion_regressors;
pub(crate) mod recurrence;
pub(crate) mod regression;
mod sensor_noise;
pub(crate) mod spectral_lines;
pub(crate) mod surrogates;
pub(crate) mod unmodelled_structure;

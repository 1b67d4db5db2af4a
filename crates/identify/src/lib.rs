//! Identification: studies, calibration, measures of hysteresis loops, and test protocols of single bearings.

#![forbid(unsafe_code)]

pub mod autoregressive;
pub mod calibrate;
pub mod checks;
pub mod fourier;
pub mod halton;
pub mod measure;
pub mod noise;
pub mod preflight;
pub mod protocol;
pub mod report;
pub mod study;

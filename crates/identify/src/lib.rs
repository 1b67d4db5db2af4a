//! Identification: studies, calibration, measures of hysteresis loops, and protocols of tests of a single bearing.

#![forbid(unsafe_code)]

pub mod calibrate;
pub mod measure;
pub mod protocol;
pub mod report;
pub mod study;

//! The isolation engineer's work around a script: ground motions, prototype tests, bounds of bearings, checks of codes.
//!
//! Motions, spectra and prototype tests know no script; [`isolate`] runs one, [`batch`] lists runs of many.

#![forbid(unsafe_code)]

pub mod batch;
pub mod check;
pub mod codes;
pub mod fragility;
pub mod incremental;
pub mod inelastic;
pub mod isolate;
pub mod lateral_force;
pub mod mistake;
pub mod motion;
pub mod multimode;
pub mod performance;
pub mod prototype;
pub mod review;
pub mod scaling;
pub mod spectrum;
pub mod suite;
pub mod supports;
pub mod target;

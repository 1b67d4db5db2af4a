//! Structural analysis of buildings and bridges on seismic isolation.

#![forbid(unsafe_code)]

pub mod diagnostic;
pub mod script;

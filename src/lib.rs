//! Structural analysis of buildings and bridges on seismic isolation.

#![forbid(unsafe_code)]

pub mod analysis;
pub mod assembly;
pub mod diagnostic;
pub mod element;
pub mod material;
pub mod model;
pub mod numeric;
pub mod probe;
pub mod script;
pub mod series;
pub mod solve;
pub mod words;

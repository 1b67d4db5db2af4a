//! Structural analysis of buildings and bridges on seismic isolation.

#![forbid(unsafe_code)]

pub mod analysis;
pub mod assembly;
pub mod command;
pub mod diagnostic;
pub mod element;
pub mod io;
pub mod material;
pub mod model;
pub mod numeric;
pub mod probe;
pub mod record;
pub mod report;
pub mod run;
pub mod script;
pub mod series;
pub mod solve;
pub mod words;

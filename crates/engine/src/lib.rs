//! The engine: laws, sections, elements, model, assembly, solution, analysis and recorders. It knows no script.
//!
//! # Units and signs
//! Numbers have the units of the model; any consistent set will do, and nothing is converted. Angles are in radians,
//! times in the unit of the time series.
//!
//! Coordinates, displacements, loads and reactions are global and positive along the axes; rotations and moments follow
//! the right hand. Axial strain and force are positive in tension. End forces of an element are those that the nodes
//! exert on it; accelerations under a uniform excitation are relative to the ground.

#![forbid(unsafe_code)]

pub mod analysis;
pub mod assembly;
pub mod bytes;
pub mod element;
pub mod material;
pub mod model;
pub mod number_format;
pub mod numeric;
pub mod parameter;
pub mod probe;
pub mod record;
pub mod rules;
pub mod section;
pub mod series;
pub mod shared;
pub mod solve;
pub mod state_struct;

//! Beam-columns.

mod elastic;

pub use elastic::{Bending, ElasticBeam, Release};

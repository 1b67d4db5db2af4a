//! Beam-columns.

mod elastic;

pub use elastic::{Bending, ElasticBeam, ElasticSection, Release};

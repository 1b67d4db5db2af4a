//! Beam-columns.

mod elastic;
mod timoshenko;

pub use elastic::{Bending, ElasticBeam, ElasticOptions, Release};
pub use timoshenko::{TimoshenkoBeam, TimoshenkoOptions};

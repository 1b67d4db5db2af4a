//! Beam-columns.

mod elastic;
mod timoshenko;

pub use elastic::{Bending, ElasticBeam, ElasticSection, Release};
pub use timoshenko::{TimoshenkoBeam, TimoshenkoOptions};

//! Elastic and piecewise linear laws.

mod cable;
#[allow(clippy::module_inception)]
mod elastic;
mod elastic_multi_linear;
mod elastic_power;
mod elastic_pp;
mod multi_linear;
mod no_tension;

pub use cable::Cable;
pub use elastic::Elastic;
pub use elastic_multi_linear::{ElasticBilin, ElasticMultiLinear};
pub use elastic_power::ElasticPower;
pub use elastic_pp::ElasticPP;
pub use multi_linear::MultiLinear;
pub use no_tension::NoTension;

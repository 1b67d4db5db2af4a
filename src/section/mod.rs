//! Cross-sections of beams.

mod elastic;

pub use elastic::ElasticSection;

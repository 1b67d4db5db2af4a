//! The triple friction pendulum: three pairs of sliding surfaces in series.
//!
//! [`Chain`] is the law of the shear, [`TriplePendulum`] the element around it.

mod bearing;
mod chain;
mod segment;
mod substeps;

pub use bearing::{TriplePendulum, TripleSetting};
pub use chain::{Chain, ChainState};
pub use segment::Segment;

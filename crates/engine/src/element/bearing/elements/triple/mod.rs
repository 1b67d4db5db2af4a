//! The triple friction pendulum: three pairs of sliding surfaces in series.
//!
//! [`Chain`] is the shear law, [`TriplePendulum`] the element, [`Heated`] the friction with frictional heating.

mod bearing;
mod chain;
mod conduction;
mod heated;
pub mod history;
mod opensees;
mod rules;
mod segment;

pub use bearing::{TriplePendulum, TripleSetting};
pub use chain::{Chain, ChainState};
pub use conduction::{Body, Conduction};
pub use heated::{Heated, HeatedSetting, Softening};
pub use opensees::Increments;
pub use segment::Segment;

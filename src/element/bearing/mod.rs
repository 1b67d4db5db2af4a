//! Bearings of seismic isolation: two-node elements that join a shear law to axial and rotational materials.
//!
//! To add one of this family: a [`ShearLaw`] in a file of its own. [`ShearBearing`] is the element around it.

mod bouc_wen;
mod link;
mod plasticity;
mod shear;
mod shear_bearing;
pub mod sliding;

pub use bouc_wen::ShearParameters;
pub use link::Link;
pub use plasticity::PlasticShear;
pub use shear::{Shear, ShearLaw};
pub use shear_bearing::{PlaneBearing, ShearBearing, SpaceBearing};

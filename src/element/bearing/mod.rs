//! Bearings of seismic isolation: two-node elements that join a shear law to axial and rotational materials.
//!
//! To add one of this family: a [`ShearLaw`] in a file of its own. [`ShearBearing`] is the element around it.

mod bouc_wen;
mod link;
mod multiple_shear_spring;
mod plasticity;
mod responses;
mod shear;
mod shear_bearing;
mod shear_springs;
pub mod sliding;
pub mod triple;
mod ufrp;
mod yamamoto;

pub use bouc_wen::ShearParameters;
pub use link::Link;
pub use multiple_shear_spring::MultipleShearSpring;
pub use plasticity::PlasticShear;
pub use shear::{Shear, ShearLaw};
pub use shear_bearing::{PlaneBearing, ShearBearing, SpaceBearing};
pub use shear_springs::{Bundle, Factors, ShearSprings};
pub use ufrp::UfrpShear;
pub use yamamoto::YamamotoShear;

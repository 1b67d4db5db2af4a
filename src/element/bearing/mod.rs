//! Bearings of seismic isolation: two-node elements that join a shear law to axial and rotational materials.
//!
//! To add one of this family: a [`ShearLaw`] in a file of its own. [`ShearBearing`] is the element around it.

mod bouc_wen;
mod kikuchi;
mod link;
mod multiple_normal_spring;
mod multiple_shear_spring;
mod normal_springs;
mod plasticity;
mod responses;
mod shear;
mod shear_bearing;
mod shear_springs;
pub mod sliding;
mod yamamoto;

pub use bouc_wen::ShearParameters;
pub use kikuchi::{Balance, Common, KikuchiBearing, KikuchiParameters, Scheme};
pub use link::Link;
pub use multiple_normal_spring::MultipleNormalSpring;
pub use multiple_shear_spring::MultipleShearSpring;
pub use normal_springs::{Distribution, Layout, MAX_LAMBDA, Mean, NormalSprings, Section, Shape};
pub use plasticity::PlasticShear;
pub use shear::{Shear, ShearLaw};
pub use shear_bearing::{PlaneBearing, ShearBearing, SpaceBearing};
pub use shear_springs::{Bundle, Factors, ShearSprings};
pub use yamamoto::YamamotoShear;

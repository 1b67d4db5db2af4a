//! Bearings of seismic isolation: two-node elements that join a shear law to axial and rotational materials.
//!
//! To add one of this family: a [`ShearLaw`] in a file of its own. [`ShearBearing`] is the element around it.
//! A [`RubberShear`] stands beside the axial law of layered rubber, in a [`RubberBearing`].

mod axial;
mod bouc_wen;
mod grant;
mod kikuchi;
mod lead;
mod link;
mod multiple_normal_spring;
mod multiple_shear_spring;
mod normal_layout;
mod normal_springs;
mod overlap;
mod plasticity;
mod responses;
mod rheology;
mod rubber;
mod rubber_bearing;
mod rubber_bouc_wen;
mod rubber_shear;
mod shear;
mod shear_bearing;
mod shear_springs;
pub mod sliding;
pub mod triple;
mod ufrp;
mod yamamoto;

pub use axial::{Axial, AxialLaw, AxialStep};
pub use bouc_wen::BoucWenShear;
pub use grant::{Damage, GrantShear};
pub use kikuchi::{Balance, KikuchiBearing, KikuchiParameters, Scheme};
pub use lead::LeadCore;
pub use link::Link;
pub use multiple_normal_spring::MultipleNormalSpring;
pub use multiple_shear_spring::MultipleShearSpring;
pub use normal_layout::{Distribution, Layout, MAX_LAMBDA, Mean, Shape};
pub use normal_springs::{NormalSprings, Section};
pub use overlap::overlap;
pub use plasticity::PlasticShear;
pub use rheology::RheologyShear;
pub use rubber::{Layers, PI, Rubber};
pub use rubber_bearing::RubberBearing;
pub use rubber_bouc_wen::{RubberBoucWen, Warmth};
pub use rubber_shear::{RubberShear, ShearStep, Shearing};
pub use shear::{Shear, ShearLaw};
pub use shear_bearing::{PlaneBearing, ShearBearing, SpaceBearing};
pub use shear_springs::{Bundle, Factors, ShearSprings};
pub use ufrp::UfrpShear;
pub use yamamoto::YamamotoShear;

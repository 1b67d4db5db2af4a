//! Seismic isolation bearings: two-node elements of a shear law with axial and rotational materials.
//!
//! A new bearing of this family is a [`ShearLaw`] in a file of its own, with [`ShearBearing`] as the element. A
//! [`RubberShear`] is combined with the axial law of layered rubber in a [`RubberBearing`].

mod elements;
mod kinematics;
mod laws;

pub use elements::kikuchi::{Balance, KikuchiBearing, KikuchiParameters, Scheme};
pub use elements::multiple_normal_spring::MultipleNormalSpring;
pub use elements::multiple_shear_spring::MultipleShearSpring;
pub use elements::rubber_bearing::RubberBearing;
pub use elements::shear_bearing::{PlaneBearing, ShearBearing, SpaceBearing};
pub use elements::{sliding, triple};
pub use kinematics::link::Link;
pub use kinematics::overlap::overlap;
pub use laws::axial::{Axial, AxialLaw, AxialStep};
pub use laws::bouc_wen::BoucWenShear;
pub use laws::grant::{Damage, GrantShear};
pub use laws::lead::LeadCore;
pub use laws::normal_layout::{Distribution, Layout, MAX_LAMBDA, Mean, Shape};
pub use laws::normal_springs::{NormalSprings, Section};
pub use laws::plasticity::PlasticShear;
pub use laws::rheology::RheologyShear;
pub use laws::rubber::{Layers, PI, Rubber};
pub use laws::rubber_bouc_wen::{RubberBoucWen, Warmth};
pub use laws::rubber_shear::{RubberShear, ShearInput, ShearStep};
pub use laws::shear::{Shear, ShearLaw};
pub use laws::shear_springs::{Bundle, Factors, ShearSprings};
pub use laws::ufrp::UfrpShear;
pub use laws::yamamoto::YamamotoShear;

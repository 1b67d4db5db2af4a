//! Bearings that slide: a flat or spherical surface with friction between two nodes.
//!
//! [`Surface`] is the law of the surface, [`SlidingBearing`] the element around it.

mod bearing;
mod surface;

pub use bearing::{Kind, PlaneSlider, Setting, SlidingBearing, SpaceSlider, Substitution};
pub use surface::{Dish, Pose, Slide, Surface};

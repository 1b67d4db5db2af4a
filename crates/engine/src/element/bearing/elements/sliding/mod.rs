//! Sliding bearings: a flat or spherical surface with friction between two nodes.
//!
//! [`Surface`] is the law of the surface, [`SlidingBearing`] the element, [`Heat`] the friction with frictional
//! heating.

mod bearing;
mod early;
mod heat;
mod surface;

pub use bearing::{Kind, PlaneSlider, Setting, SlidingBearing, SpaceSlider, Substitution};
pub use heat::{Heat, HeatSetting};
pub use surface::{Dish, Pose, Slide, Surface};

//! Sliding bearings: a flat or spherical surface with friction between two nodes.
//!
//! [`Surface`] is the law of the surface, [`SlidingBearing`] the element, [`Heat`] the friction with frictional
//! heating.

mod bearing;
mod heat;
mod opensees;
mod rules;
mod surface;

pub use bearing::{Kind, PlaneSlider, Setting, SlidingBearing, SpaceSlider};
pub use heat::{Heat, HeatSetting};
pub use opensees::Substitution;
pub use surface::{Dish, Pose, Slide, Surface};
